"""Links: pose, mass, shapes."""

from __future__ import annotations

import numpy as np

from sdfcheck.convert.loss import LossKind, refusal
from sdfcheck.convert.urdf_to_sdf.context import (
    Context,
    comments_in,
    is_quaternion,
    pose_of,
    pose_text,
)
from sdfcheck.convert.urdf_to_sdf.materials import Materials
from sdfcheck.convert.urdf_to_sdf.naming import legal
from sdfcheck.convert.urdf_to_sdf.options import PackageUris
from sdfcheck.convert.writer import Node, comment_of, number, spaced
from sdfcheck.formats.sdf.values import floats
from sdfcheck.lint.diagnostic import Severity
from sdfcheck.robot.motion.mass import MassProperties
from sdfcheck.robot.motion.poses import origin_of
from sdfcheck.robot.motion.rotations import Array
from sdfcheck.source.element import Element

_MOMENTS = ("ixx", "ixy", "ixz", "iyy", "iyz", "izz")
_SHAPES = {
    "box": ("size",),
    "capsule": ("radius", "length"),
    "cylinder": ("radius", "length"),
    "sphere": ("radius",),
}
_PACKAGE = "package://"


class Links:
    """Writes the content of links."""

    def __init__(self, context: Context, materials: Materials) -> None:
        self.context = context
        self.materials = materials
        self._names: dict[tuple[str, str], set[str]] = {}

    def fill(self, element: Element, survivor: str, offset: Array) -> None:
        """Write what is in a link into the node of the link that survives, at a 4×4 pose in it."""
        node = self.context.links[survivor]
        plan = self.context.plan
        merged = plan.is_merged(element.attributes.get("name", ""))
        for child in element:
            if (comment := comment_of(child)) is not None:
                node.children.append(comment)
            elif not isinstance(child.tag, str):
                continue
            elif child.name == "inertial":
                node.children += comments_in(child)
                if not merged and survivor not in plan.supplied and plan.bodies.get(survivor) is None:
                    node.append(_inertial(child))
            elif child.name in {"visual", "collision"}:
                self._shape(child, node, survivor, offset)
            else:
                self.context.keep(child, node)
        if merged:
            return
        body = plan.bodies.get(survivor)
        if survivor in plan.automatic:
            node.append(Node("inertial", None, auto="true"))
        elif body is not None:
            node.append(inertial_of(body))

    def _shape(self, part: Element, link: Node, survivor: str, offset: Array) -> None:
        context = self.context
        geometry = part.find("geometry")
        shape = next(geometry.children(), None) if geometry is not None else None
        if shape is None or not (shape.name == "mesh" or shape.name in _SHAPES):
            context.dropped_shapes.add(shape.name if shape is not None else "")
            kind = f"<{shape.name}>" if shape is not None else "no shape"
            text = f"the {part.name} of link `{survivor}` has {kind}, which is none of URDF's shapes"
            context.lose(part, LossKind.UNSUPPORTED_GEOMETRY, text)
            return
        if not context.allows(f"link/{part.name}/geometry/{shape.name}"):
            context.dropped_shapes.add(shape.name)
            text = f"SDFormat {context.options.version} has no <{shape.name}>; the {part.name} is left out"
            context.lose(shape, LossKind.UNSUPPORTED_GEOMETRY, text)
            return
        node = link.add(part.name, None, name=self._name(part, survivor))
        context.came_from[id(node)] = link_of(part)
        node.children += comments_in(part)
        pose = pose_text(part)
        if is_quaternion(part) or not np.array_equal(offset, np.eye(4)):
            pose = pose_of(offset @ origin_of(part))
        if pose is not None:
            node.add("pose", pose)
        self._geometry(shape, node.add("geometry").add(shape.name))
        for child in part.children():
            if child.name == "material" and part.name == "visual":
                self.materials.write(child, node)
            elif child.name not in {"origin", "geometry", "material"}:
                context.keep(child, node)

    def _geometry(self, shape: Element, node: Node) -> None:
        if shape.name != "mesh":
            for name in _SHAPES[shape.name]:
                text = shape.attributes.get(name, "")
                if floats(text) is None:
                    raise refusal(shape, f"the {shape.name} has no {name}")
                node.add(name, spaced(text))
            return
        node.add("uri", self.uri(shape, shape.attributes.get("filename", "").strip()))
        scale = spaced(shape.attributes.get("scale", ""))
        if scale:
            node.add("scale", scale)

    def uri(self, element: Element, text: str) -> str:
        """A file's address as the options want it."""
        context = self.context
        if not text.startswith(_PACKAGE) or context.options.package_uris is PackageUris.KEEP:
            return text
        rest = text.removeprefix(_PACKAGE)
        package = rest.partition("/")[0]
        if context.once(f"package {package}"):
            message = (
                f"`package://{package}` is written `model://{package}`: its folder must be found as a model"
            )
            context.lose(element, LossKind.CHANGED_URI, message, Severity.INFO)
        return f"model://{rest}"

    def _name(self, part: Element, survivor: str) -> str:
        """The author's name, or the link's with a number; unique within the link."""
        own = part.attributes.get("name", "").strip()
        names = self._names.setdefault((survivor, part.name), set())
        wished = legal(own) if own else f"{self.context.plan.names.links[link_of(part)]}_{part.name}"
        name, number_ = wished, 0
        while name in names:
            number_ += 1
            name = f"{wished}_{number_}"
        names.add(name)
        if own and name != own:
            text = f"{part.name} `{own}` is named `{name}`"
            self.context.lose(part, LossKind.RENAMED, text, Severity.INFO)
        return name


def link_of(part: Element) -> str:
    """The name of the link that something is in."""
    return part.parent.attributes.get("name", "") if part.parent is not None else ""


def _inertial(element: Element) -> Node:
    """The author's own numbers."""
    node = Node("inertial")
    pose = pose_of(origin_of(element)) if is_quaternion(element) else pose_text(element)
    if pose is not None:
        node.add("pose", pose)
    mass, inertia = element.find("mass"), element.find("inertia")
    node.add("mass", spaced(mass.attributes.get("value", "0")) if mass is not None else "0")
    moments = node.add("inertia")
    for name in _MOMENTS:
        moments.add(name, spaced(inertia.attributes.get(name, "0")) if inertia is not None else "0")
    return node


def inertial_of(body: MassProperties) -> Node:
    """Computed mass properties, in the axes of the link."""
    node = Node("inertial")
    if body.center.any():
        node.add("pose", " ".join((*(number(float(value)) for value in body.center), "0 0 0")))
    node.add("mass", number(float(body.mass)))
    moments = node.add("inertia")
    for name, (row, column) in zip(_MOMENTS, ((0, 0), (0, 1), (0, 2), (1, 1), (1, 2), (2, 2)), strict=True):
        moments.add(name, number(float(body.moments[row, column])))
    return node
