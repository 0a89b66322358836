"""The shared state of the writers of links, joints and extensions."""

from __future__ import annotations

import os
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path

from sdfcheck.convert.ledger import Ledger
from sdfcheck.convert.loss import LossKind
from sdfcheck.convert.sdf_to_urdf.options import Options
from sdfcheck.convert.sdf_to_urdf.plan import Arrangement, Layout, Naming
from sdfcheck.convert.writer import PACKAGES
from sdfcheck.files.uris import scheme_of
from sdfcheck.lint.diagnostic import Severity
from sdfcheck.robot.graph import Model
from sdfcheck.robot.motion.mechanism import Mechanism
from sdfcheck.robot.motion.poses import Poses
from sdfcheck.robot.part import Node as RobotNode
from sdfcheck.robot.resources import names_file
from sdfcheck.source.altered import Xml
from sdfcheck.source.document import Element
from sdfcheck.source.text import relative_path


@dataclass(slots=True)
class Context:
    """One conversion under way."""

    scope: Model
    poses: Poses
    read: Mechanism
    """The model as it was read."""
    robot: Mechanism
    """The model as it is understood."""
    frames: Mapping[str, RobotNode]
    """Links, joints, frames and nested models of the model, by name."""
    made: Arrangement
    layout: Layout
    naming: Naming
    links: Mapping[str, str]
    """Source name → name in the URDF."""
    joints: Mapping[str, str]
    frame_names: Mapping[str, str]
    options: Options
    folder: Path
    """That of the source, from where relative addresses of the result lead."""
    ledger: Ledger
    root: Xml
    between: set[str] = field(default_factory=set)
    """Links of the URDF that are no more than a place between two joints, with a mass that is given to them."""
    heavier: set[str] = field(default_factory=set)
    """Source links whose mass is written as one that libsdformat takes for a mass."""
    begins_in_world: bool = False
    """Is the URDF's root a link for the world?"""
    blobs: dict[str, Xml] = field(default_factory=dict)
    """The ``gazebo`` elements by what they refer to, written last."""
    namespaces: dict[str, str] = field(default_factory=dict)
    """Prefix → what it is at the root of the result."""
    parts: dict[str, tuple[str, ...]] = field(default_factory=dict)
    """Source joint → the joints for each of its axes."""
    kept: set[str] = field(default_factory=set)
    """Source joints that are kept as SDFormat, with all that is in them."""
    floating: set[str] = field(default_factory=set)
    """Source joints whose positions have no equal in the result."""
    unmimicked: set[str] = field(default_factory=set)
    """Source joints that follow another, which URDF cannot say."""
    natives: frozenset[str] = frozenset()
    """Shapes that only Drake has, and that the description is written for."""
    actuators: dict[str, list[Xml]] = field(default_factory=dict)
    """Joint of the URDF → what vendors say of its actuator."""
    drake_frames: dict[str, str] = field(default_factory=dict)
    """Source link or frame → the frame that is written for Drake."""
    colors: dict[str, str] = field(default_factory=dict)
    """Color → the material that has it."""

    def link_name(self, name: str) -> str:
        return self.links.get(name, name)

    def blob(self, reference: str = "") -> Xml:
        """The ``gazebo`` element for a link or joint, or for the whole robot."""
        if reference not in self.blobs:
            self.blobs[reference] = Xml("gazebo", reference=reference) if reference else Xml("gazebo")
        return self.blobs[reference]


# Uris of meshes and textures, as they lead from beside the source.


def mesh_uri(context: Context, uri: str, element: Element) -> str:
    """The uri to write for a mesh or texture that an element of the source names."""
    package = uri.removeprefix("model://").partition("/")[0]
    given_back = package in context.scope.element.attributes.get(PACKAGES, "").split()
    if (context.options.package_uris or given_back) and uri.startswith("model://"):
        written = f"package://{uri.removeprefix('model://')}"
        context.ledger.note(
            LossKind.CHANGED_URI, element, f"`{uri}` is written as `{written}`", Severity.INFO
        )
        return written
    return _seen_from_source(context, uri, element)


def _seen_from_source(context: Context, uri: str, element: Element) -> str:
    """A relative path is meant from the file that it is in, which may be an included one."""
    here = element.document.path.parent
    if (
        not uri
        or scheme_of(uri)
        or uri.startswith("/")
        or os.path.realpath(here) == os.path.realpath(context.folder)
    ):
        return uri
    return Path(relative_path(here / uri, context.folder)).as_posix()


def find_files(context: Context) -> None:
    """Let copies of elements of included files lead to the files beside those."""
    for node in context.root.walk():
        if node.origin is not None and names_file(node):
            beside = os.path.join(node.origin.document.path.parent, node.content)
            if os.path.exists(beside):
                node.write(_seen_from_source(context, node.content, node.origin))
