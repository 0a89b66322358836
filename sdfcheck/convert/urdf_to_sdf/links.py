"""Links: pose, mass, shapes, materials."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from sdfcheck.consumers.reaction import Consumer
from sdfcheck.convert.loss import LossKind, refusal
from sdfcheck.convert.urdf_to_sdf.options import PackageUris
from sdfcheck.convert.urdf_to_sdf.plan import Context, has_custom, is_quaternion, legal, pose_of, pose_text
from sdfcheck.convert.vendor_spelling import uses
from sdfcheck.convert.writer import INERTIAL, number, numbers, settled, spaced
from sdfcheck.formats.sdf.values import floats
from sdfcheck.lint.diagnostic import Severity
from sdfcheck.robot.graph import Model
from sdfcheck.robot.motion.mass import MassProperties
from sdfcheck.robot.motion.poses import Array, origin_of
from sdfcheck.source.altered import Xml
from sdfcheck.source.document import Comment, Element

# Materials: colors as they are, textures as albedo maps.


class Materials:
    """The materials of a robot, by name: those that count."""

    def __init__(self, robot: Model, context: Context) -> None:
        self.context = context
        self.uri: Callable[[Element, str], str] = lambda element, text: text
        self.named = {
            name: material.element
            for name, material in robot.material_names.defined.items()
            if material.has_look
        }
        self.defined = [material.element for material in robot.materials]

    def write(self, used: Element, visual: Xml) -> None:
        """The material of a visual."""
        name = used.attributes.get("name", "")
        found = self.named.get(name, used) if name else used
        if not _says_something(found):
            text = f"material `{name}` is not defined; the visual gets no color"
            self.context.lose(used, LossKind.CHANGED_MATERIAL, text)
            return
        if found is not used and _says_something(used):
            self._report_other(used, found)
        node = visual.add("material")
        color, texture = found.find("color"), found.find("texture")
        rgba = self._bounded(color) if color is not None else ""
        if self.context.options.like is Consumer.GAZEBO:
            rgba = self._brightened(rgba, color, used)
        if rgba:
            node.add("ambient", rgba)
            self.context.carry(color, node.add("diffuse", rgba))
        elif color is not None:
            self.context.ledger.take(color)
        if texture is not None:
            self._texture(texture, node)
        for part in dict.fromkeys((used, found)):
            self.context.carry(part, node)
        if not node.nodes and not node.attributes:
            visual.remove(node)

    def _bounded(self, color: Element) -> str:
        """The numbers of a color; those out of range, which libsdformat refuses, are the nearest in it."""
        text = spaced(color.attributes.get("rgba", ""))
        values = floats(text)
        if values is None or len(values) not in _OF_COLORS:
            if text:
                message = f"`{text}` is not a color: red, green, blue and alpha; the visual gets none"
                self.context.lose(color, LossKind.CHANGED_MATERIAL, message)
            return ""
        if all(0 <= value <= 1 for value in values):
            return text
        inside = numbers(min(max(0.0, value), 1.0) for value in values)
        message = f"color {text} becomes {inside}: SDFormat has numbers from 0 to 1 only"
        self.context.note(color, LossKind.CHANGED_MATERIAL, message)
        return inside

    def _brightened(self, rgba: str, *said: Element | None) -> str:
        """The numbers that libsdformat makes of a color: it takes it for what four fifths of the light show."""
        *light, alpha = floats(rgba) or (1.0,)
        found = numbers([*(min(value * _BRIGHTER, 1.0) for value in light), alpha])
        if not light or floats(found) == floats(rgba):
            return rgba
        for element in said:
            message = f"the color {rgba} is written as Gazebo has it: {found}"
            if element is not None:
                self.context.note(element, LossKind.CHANGED_MATERIAL, message, Severity.INFO)
        return found

    def _report_other(self, used: Element, found: Element) -> None:
        """A material that is defined once more."""
        for name, attribute in (("color", "rgba"), ("texture", "filename")):
            part, first = used.find(name), found.find(name)
            texts = [spaced(p.attributes.get(attribute, "")) if p is not None else "" for p in (part, first)]
            if part is not None and texts[0] == texts[1]:
                self.context.ledger.take(part)
            elif part is not None:
                text = (
                    f"<{name}> of {used.title} is left out: its first definition says otherwise, and counts"
                )
                self.context.lose(part, LossKind.CHANGED_MATERIAL, text, Severity.INFO)

    def close(self) -> None:
        """Report the definitions that no visual uses."""
        for material in self.defined:
            if not self.context.ledger.is_entered(material):
                text = f"{material.title} is left out: no visual uses it"
                self.context.lose(material, LossKind.DROPPED_ELEMENT, text, Severity.INFO)

    def _texture(self, texture: Element, node: Xml) -> None:
        file = texture.attributes.get("filename", "").strip()
        context = self.context
        if not file:
            context.ledger.take(texture)
            return
        if not context.allows("link/visual/material/pbr"):
            text = f"SDFormat {context.options.version} has no place for texture `{file}`"
            context.lose(texture, LossKind.CHANGED_MATERIAL, text)
            return
        context.carry(texture, node.reach("pbr", "metal").add("albedo_map", self.uri(texture, file)))
        if uses(context.plan.root, "drake"):
            node.add("drake:diffuse_map", self.uri(texture, file))
        if node.find("diffuse") is None:
            # Without a color of its own the map would be multiplied by black.
            node.add("diffuse", "1 1 1 1")
        if context.once(f"texture {file}"):
            text = f"texture `{file}` becomes an albedo map, which classic Gazebo does not show"
            context.note(texture, LossKind.CHANGED_MATERIAL, text, Severity.INFO)


_OF_COLORS = frozenset({3, 4})
"""Numbers that libsdformat takes for a color."""
_BRIGHTER = 1 / 0.8
"""Source: libsdformat's parser_urdf.cc."""


def _says_something(material: Element) -> bool:
    return material.has("color") or material.has("texture")


# Friction that a ``<gazebo>`` block gives: in URDF Drake does not read it, in SDFormat it does.


_PROPERTIES = "drake:proximity_properties"
_FRICTIONS = ("drake:mu_static", "drake:mu_dynamic")
_DEFAULT = "1"
"""What Drake takes where a file says nothing."""


def keep_frictions_of_drake(context: Context, root: Element) -> None:
    """Write out what Drake takes as friction, where the result says another for Gazebo and the file is Drake's."""
    if not uses(root, "drake"):
        return
    for name, link in context.links.items():
        concerned = list(filter(_is_only_for_gazebo, link.children("collision")))
        for collision in concerned:
            for friction in _FRICTIONS:
                collision.reach(_PROPERTIES).add(friction, _DEFAULT)
        if concerned:
            text = (
                f"the friction of link `{name}` in a <gazebo> block is not for Drake, whose 1 is written out"
            )
            at = context.plan.robot.links[name].element
            context.note(at, LossKind.CHANGED_DEFAULT, text, Severity.INFO)


def _is_only_for_gazebo(collision: Xml) -> bool:
    properties, at = collision.find(_PROPERTIES), collision
    if properties is not None and any(properties.find(friction) is not None for friction in _FRICTIONS):
        return False
    for name in ("surface", "friction", "ode"):
        found = at.find(name)
        if found is None:
            return False
        at = found
    return at.find("mu") is not None or at.find("mu2") is not None


_MOMENTS = ("ixx", "ixy", "ixz", "iyy", "iyz", "izz")
_SHAPES = {
    "box": ("size",),
    "capsule": ("radius", "length"),
    "cylinder": ("radius", "length"),
    "sphere": ("radius",),
}
_OF_VENDORS = {"drake:capsule": "capsule", "drake:ellipsoid": "ellipsoid"}
_PACKAGE = "package://"


class Links:
    """Writes the content of links."""

    def __init__(self, context: Context, materials: Materials) -> None:
        self.context = context
        self.materials = materials
        self._names: dict[tuple[str, str], dict[str, int]] = {}
        self.own_inertials: dict[str, Xml] = {}
        """Link of the source → its own inertial, where that of the link that survives is a sum."""

    def fill(self, element: Element, survivor: str, offset: Array) -> None:
        """Write what is in a link into the node of the link that survives, at a 4×4 pose in it."""
        context, plan = self.context, self.context.plan
        node = context.links[survivor]
        name = element.attributes.get("name", "")
        merged = plan.is_merged(name)
        if not merged:
            context.carry_attributes(element, node)
        inertial = element.find("inertial")
        for child in element.nodes:
            if isinstance(child, Comment):
                if context.ledger.take_comment(child):
                    node.extend(child)
            elif child is inertial:
                self._enter_inertial(child, node)
                self._written(child, node, name, survivor)
            elif isinstance(child, Element) and child.name in {"visual", "collision"}:
                self._shape(child, node, survivor, offset)
            elif isinstance(child, Element) and child.name != "inertial":
                self._keep(child, node, name)
        if not merged:
            self._weigh(inertial, survivor, node)

    def _keep(self, child: Element, node: Xml, name: str) -> None:
        """What SDFormat has no word for, with a mark of its link."""
        count = len(node.nodes)
        self.context.keep(child, node)
        for made in node.nodes[count:]:
            if isinstance(made, Xml):
                self.context.mark(made, name)

    def _written(self, inertial: Element, node: Xml, name: str, survivor: str) -> None:
        """The author's numbers: as they are, or beside the sum that they are part of."""
        plan = self.context.plan
        if name == survivor and survivor not in plan.supplied and plan.bodies.get(survivor) is None:
            self._inertial(inertial, node.add("inertial"))
        elif self.context.options.has_frames and plan.is_summed(name, survivor):
            self.own_inertials[name] = self._inertial(inertial, Xml(INERTIAL))

    def _enter_inertial(self, inertial: Element, node: Xml) -> None:
        self.context.carry_comments(inertial, node)
        for part in (inertial, *map(inertial.find, ("origin", "mass", "inertia"))):
            self.context.ledger.take(part)

    def _weigh(self, inertial: Element | None, survivor: str, node: Xml) -> None:
        """Write mass properties that are not the author's."""
        plan = self.context.plan
        body = plan.bodies.get(survivor)
        if survivor in plan.automatic:
            made = node.add("inertial", None, auto="true")
        elif body is not None:
            made = node.append(inertial_of(body))
        else:
            return
        if inertial is not None:
            self._customs_of(inertial, made)

    def _inertial(self, element: Element, node: Xml) -> Xml:
        """The author's own numbers."""
        origin = element.find("origin")
        pose = pose_of(origin_of(element)) if is_quaternion(element) else pose_text(element)
        if pose is not None or has_custom(origin):
            node.add("pose", pose or "0 0 0 0 0 0")
        mass, inertia = element.find("mass"), element.find("inertia")
        node.add("mass", spaced(mass.attributes.get("value", "0")) if mass is not None else "0")
        moments = node.add("inertia")
        for name in _MOMENTS:
            moments.add(name, spaced(inertia.attributes.get(name, "0")) if inertia is not None else "0")
        if node.name != INERTIAL:
            self._customs_of(element, node)
        return node

    def _customs_of(self, inertial: Element, node: Xml) -> None:
        """Write the custom data of an inertial and its parts where it belongs."""
        self.context.carry(inertial, node)
        for name, counterpart in (("origin", "pose"), ("mass", "mass"), ("inertia", "inertia")):
            there = node.find(counterpart)
            if there is not None:
                self.context.carry(inertial.find(name), there)

    def _held(self, part: Element) -> tuple[Element, str] | None:
        """The shape of a visual or collision, and SDFormat's name for it; reported if that has no such shape."""
        context = self.context
        geometry = part.find("geometry")
        shape = next(geometry.children(), None) if geometry is not None else None
        name = "" if shape is None else _OF_VENDORS.get(shape.name, shape.name)
        if shape is None or not (shape.name in {"mesh", *_OF_VENDORS} or shape.name in _SHAPES):
            kind = f"<{shape.name}>" if shape is not None else "no shape"
            text = f"the {part.name} of link `{link_of(part)}` has {kind}, which is not a shape of URDF"
            context.lose(part, LossKind.UNSUPPORTED_GEOMETRY, text)
        elif not context.allows(f"link/{part.name}/geometry/{name}"):
            text = f"SDFormat {context.options.version} has no <{name}>; the {part.name} is left out"
            context.lose(shape, LossKind.UNSUPPORTED_GEOMETRY, text)
            context.ledger.drop(part)
        elif not self._has_size(shape, name):
            text = f"the {part.name} of link `{link_of(part)}` is left out: SDFormat has no {name} of size 0"
            context.lose(part, LossKind.UNSUPPORTED_GEOMETRY, text)
        else:
            return shape, name
        context.dropped_shapes.add(part)
        return None

    def _shape(self, part: Element, link: Xml, survivor: str, offset: Array) -> None:
        context = self.context
        built = context.plan.shapes
        if built is not None and part not in built:
            text = f"the {part.name} of link `{link_of(part)}` is left out: Gazebo stops reading the link before it"
            context.lose(part, LossKind.UNSUPPORTED_GEOMETRY, text)
            context.dropped_shapes.add(part)
            return
        held = self._held(part)
        if held is None:
            return
        shape, name = held
        node = link.add(part.name, None, name=self._name(part, survivor))
        context.shapes_of.setdefault((link_of(part), part.name), []).append(part)
        context.mark(node, link_of(part))
        context.shapes[part] = link, node
        context.ledger.take(part)
        context.carry_attributes(part, node)
        context.carry_comments(part, node)
        pose = pose_text(part)
        if is_quaternion(part) or not np.array_equal(offset, np.eye(4)):
            pose = pose_of(offset @ origin_of(part))
        origin = part.find("origin")
        if pose is not None or has_custom(origin):
            context.carry(origin, node.add("pose", pose or "0 0 0 0 0 0"))
        elif origin is not None:
            context.ledger.take(origin)
        container = node.add("geometry")
        self._geometry(shape, container.add(name))
        context.carry(part.find("geometry"), container)
        for child in part.children():
            if child.name == "material" and part.name == "visual":
                self.materials.write(child, node)
            elif child.name not in {"origin", "geometry"}:
                context.keep(child, node)

    def _geometry(self, shape: Element, node: Xml) -> None:
        if node.name == "ellipsoid":
            node.add("radii", " ".join(self._size(shape, name) for name in "abc"))
        for name in _SHAPES.get(node.name, ()):
            node.add(name, self._size(shape, name))
        if node.name == "mesh":
            self._mesh(shape, node)
        self.context.carry(shape, node)

    def _mesh(self, shape: Element, node: Xml) -> None:
        node.add("uri", self.uri(shape, shape.attributes.get("filename", "").strip()))
        scale = spaced(shape.attributes.get("scale", ""))
        values = floats(scale) or ()
        if len(values) == len("xyz"):
            node.add("scale", scale)
        elif scale:
            message = f"scale `{scale}` is left out: it is not three numbers, and urdfdom does not read it"
            self.context.ledger.lose_attribute(shape, "scale", message)

    def _has_size(self, shape: Element, name: str) -> bool:
        """Is every size of a shape above 0? libsdformat takes 1 m for any other."""
        attributes = ("a", "b", "c") if name == "ellipsoid" else _SHAPES.get(name, ())
        found = (floats(shape.attributes.get(attribute, "")) or () for attribute in attributes)
        return all(size > 0 for sizes in found for size in sizes)

    def _size(self, shape: Element, name: str) -> str:
        text = shape.attributes.get(name, "")
        if floats(text) is None:
            raise refusal(shape, f"the {shape.name} has no {name}")
        return spaced(text)

    def uri(self, element: Element, text: str) -> str:
        """A file's address in the form that the options choose."""
        context = self.context
        if not text.startswith(_PACKAGE) or context.options.package_uris is PackageUris.KEEP:
            return text
        rest = text.removeprefix(_PACKAGE)
        package = rest.partition("/")[0]
        if context.once(f"package {package}"):
            message = (
                f"`package://{package}` is written `model://{package}`: its folder must be found as a model"
            )
            context.note(element, LossKind.CHANGED_URI, message, Severity.INFO)
            context.packages.append(package)
        return f"model://{rest}"

    def _name(self, part: Element, survivor: str) -> str:
        """The author's name, or the link's with a number; unique within the link. That of a consumer comes first."""
        if self.context.plan.shapes is not None:
            return self.context.plan.shapes[part].name
        own = part.attributes.get("name", "").strip()
        # Each name with the last number that was tried behind it.
        names = self._names.setdefault((survivor, part.name), {})
        wished = legal(own) if own else f"{self.context.plan.names.links[link_of(part)]}_{part.name}"
        name = wished
        while name in names:
            names[wished] += 1
            name = f"{wished}_{names[wished]}"
        names[name] = 0
        if own and name != own:
            text = f"{part.name} `{own}` is named `{name}`"
            self.context.note(part, LossKind.RENAMED, text)
        return name


def link_of(part: Element) -> str:
    """The name of the link that something is in."""
    return part.parent.attributes.get("name", "") if part.parent is not None else ""


def inertial_of(body: MassProperties) -> Xml:
    """Computed mass properties, in the axes of the link."""
    node = Xml("inertial")
    center = numbers(body.center)
    if center != "0 0 0":
        node.add("pose", f"{center} 0 0 0")
    node.add("mass", number(float(body.mass)))
    moments, largest = node.add("inertia"), float(abs(body.moments).max())
    for name, (row, column) in zip(_MOMENTS, ((0, 0), (0, 1), (0, 2), (1, 1), (1, 2), (2, 2)), strict=True):
        moments.add(name, number(settled(float(body.moments[row, column]), largest)))
    return node
