"""How the rules of this family speak of paths."""

from __future__ import annotations

import os
import re
from collections.abc import Sequence
from pathlib import Path

from sdfcheck import Document, Fix, Include, Resource, suggest, write_instead

_SHOWN = 3
_FILE = re.compile(r"[^/]+\.(?:stl|dae|obj|glb|gltf|ply|msh|png|jpe?g)", re.IGNORECASE)


def place(document: Document, path: str | Path) -> str:
    """A path as seen from the folder of the document, if that is shorter."""
    whole = os.path.normpath(path)
    try:
        short = os.path.relpath(path, os.path.abspath(document.path.parent))
    except ValueError:  # another drive
        return whole
    return min(short, whole, key=len)


def looked_for(named: Include | Resource) -> str:
    """Where something was looked for, the first few places."""
    paths = named.location.tried if named.location is not None else ()
    places = list(dict.fromkeys(place(named.document, path) for path in paths))
    left = len(places) - _SHOWN
    more = f" and {left} more {'place' if left == 1 else 'places'}" if left > 0 else ""
    return f"looked for {', '.join(places[:_SHOWN])}{more}"


def expected(resource: Resource) -> str | None:
    """Of the paths that were tried the one in the model or package that was found."""
    location = resource.location
    if location is None:
        return None
    if location.owner is None:
        return location.first or None
    first = location.first
    return first if first.startswith(f"{os.path.normpath(location.owner)}{os.sep}") else None


def near_file(resource: Resource) -> tuple[str | None, bool]:
    """The file that is probably meant, and whether there are any of the kind where it is expected.

    Without any, such files may be kept elsewhere.
    """
    path = expected(resource)
    if path is None:
        return None, False
    folder, own = os.path.split(path)
    beside = names_in(folder or os.curdir, (os.path.splitext(own)[1],))
    alike = [name for name in beside if numbers(name) == numbers(own)]
    return suggest(own, alike), bool(beside)


def names_file(name: str) -> bool:
    """Is the name of a package or model that of a mesh or picture?"""
    return _FILE.fullmatch(name) is not None


def near_model(include: Include) -> str | None:
    """The model that is probably meant by one that is not found, among those where it was looked for.

    Another computer may have the one that is named; a misspelling begins alike.
    """
    location = include.location
    if location is None or location.scheme != "model":
        return None
    folders = {os.path.dirname(path) for path in location.tried if os.path.basename(path) == location.name}
    known = {
        name
        for folder in folders
        for name in names_in(folder or os.curdir, ("",))
        if name[:1] == location.name[:1]
        and numbers(name) == numbers(location.name)
        and os.path.isfile(os.path.join(folder, name, "model.config"))
    }
    return include.nearest(location.name, sorted(known))


def write_model(name: str | None, includes: Sequence[Include]) -> Fix | None:
    """The fix that writes the name of a model in includes of one that is not found, all of the same URI."""
    location = includes[0].location
    if name is None or location is None:
        return None
    inside = includes[0].uri.partition(f"://{location.name}")[2]
    return write_instead(f"model://{name}{inside}", *(each.uri_value or each for each in includes))


def numbers(name: str) -> list[str]:
    """The numbers in a name: the mesh of the first link was not meant to be that of the second."""
    return [digits.lstrip("0") for digits in re.findall(r"[0-9]+", name)]


def descriptions(folder: Path) -> list[str]:
    """The files of a folder that may be meant by who names the folder."""
    return names_in(folder, (".sdf", ".urdf"))


def names_in(folder: str | Path, endings: tuple[str, ...]) -> list[str]:
    try:
        return sorted(name for name in os.listdir(folder) if name.endswith(endings))
    except OSError:
        return []


def needs_no_escape(text: str) -> bool:
    """Can the text be in XML as it is?"""
    return not set(text) & set("<>&\"'")
