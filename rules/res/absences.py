"""Files that are missing, put together by what is lacked as a whole."""

from __future__ import annotations

import os
from collections.abc import Iterable, Sequence

from sdfcheck import Consumer, Missing, MissingKind, Reaction, Resource, accepts, warns
from sdfcheck_rules.res.places import expected, names_file


class Absences:
    """Missing resources by what is not there, each once with all that needs it, in the order of the file."""

    def __init__(self, missing: Iterable[Resource]) -> None:
        self.files: dict[tuple[str, str], list[Resource]] = {}
        """URI and what it is → resources."""
        self.owners: dict[tuple[str, str], list[Resource]] = {}
        """Scheme and name of a model or package → resources."""
        self.folders: dict[str, list[Resource]] = {}
        self.submodules: dict[str, list[Resource]] = {}
        """Folders without content, as those of submodules that are not checked out → resources."""
        self.ignored: dict[str, list[Resource]] = {}
        """Folders of what git ignores → resources."""
        known: dict[tuple[str, str], list[Resource]] = {}
        for resource in missing:
            named = resource.uri, resource.what
            if named not in known:
                known[named] = self._with(resource, named)
            known[named].append(resource)

    def _with(self, resource: Resource, named: tuple[str, str]) -> list[Resource]:
        """Those that lack the same as a resource."""
        location = resource.location
        if location is not None and location.is_searched_for and location.owner is None:
            return self.owners.setdefault((location.scheme, location.name), [])
        if empty := resource.empty_folder:
            return self.submodules.setdefault(empty, [])
        path = expected(resource)
        if resource.is_ignored and path is not None:
            return self.ignored.setdefault(os.path.dirname(path), [])
        folder = None if path is None else os.path.dirname(path) or os.curdir
        if folder is None or (folder not in self.folders and os.path.isdir(folder)):
            return self.files.setdefault(named, [])
        return self.folders.setdefault(folder, [])


def elsewhere(uses: Sequence[Resource]) -> tuple[str, str, Missing | None]:
    """The message about a model or package that is not found, the advice, and what another computer may have."""
    location = uses[0].location
    assert location is not None, "what is missing was looked for"
    if names_file(location.name):
        message = f"`{uses[0].uri}` names a file and no {location.scheme}"
        return message, f"; write `{location.scheme}://NAME/{location.name}`", None
    setting = "model-paths" if location.scheme == "model" else "package-paths"
    message = f"{location.scheme} `{location.name}` is not on the search path"
    meant = [use.meant_uri for use in uses]
    owners = {uri and uri.split("/")[2] for uri in meant}
    if len(owners) == 1 and (owner := owners.pop()):
        return f"{message}, and `{owner}` has what is asked of it", f"; write `{meant[0]}`", None
    advice = f"; set `{setting}` in the configuration if it is elsewhere"
    return message, advice, Missing(MissingKind(location.scheme), location.name, len(uses))


def reactions(uses: Sequence[Resource], missing: Reaction) -> dict[Consumer, Reaction]:
    """The reactions where a file that some elements name is missing: the one that goes farthest counts."""
    looking = {consumer for use in uses for consumer in looking_for(use)}
    unread = accepts("does not look for it")
    every = (Consumer.DRAKE, Consumer.PYBULLET, Consumer.MUJOCO)
    found = {consumer: missing if consumer in looking else unread for consumer in every}
    return found | ({Consumer.ISAAC: warns("leaves it out")} if uses[0].root.is_urdf else {})


def looking_for(resource: Resource) -> set[Consumer]:
    """Drake and PyBullet look for the meshes of links, MuJoCo for those of collisions that are paths.

    Drake looks for the textures of URDF, too.
    """
    roles = {each.name for each in resource.element.around}
    is_mesh = (resource.element.name == "mesh" or "mesh" in roles) and "gazebo" not in roles
    found: set[Consumer] = set()
    if is_mesh and roles & {"visual", "collision"}:
        found |= {Consumer.DRAKE, Consumer.PYBULLET}
    if is_mesh and "collision" in roles and ":/" not in resource.uri:
        found.add(Consumer.MUJOCO)
    if resource.element.name == "texture" and resource.root.is_urdf:
        found.add(Consumer.DRAKE)
    return found
