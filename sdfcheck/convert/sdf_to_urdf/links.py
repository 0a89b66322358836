"""Links, with their shapes and masses, and what they mean to those who read URDF."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import replace

import numpy as np

from sdfcheck.consumers.gazebo import LEAST
from sdfcheck.convert.ledger import TEXT
from sdfcheck.convert.loss import LossKind
from sdfcheck.convert.sdf_to_urdf.extensions import (
    carry_comments,
    carry_custom,
    carry_inside,
    carry_parts,
    has_custom,
    link_extensions,
)
from sdfcheck.convert.sdf_to_urdf.plan import Context, Planes, add_origin, mesh_uri
from sdfcheck.convert.writer import NOTHING, SCRIPTS, number, numbers, settled
from sdfcheck.formats.sdf.values import floats
from sdfcheck.lint.diagnostic import Severity
from sdfcheck.robot.graph import Inertial
from sdfcheck.robot.graph import Link as LinkPart
from sdfcheck.robot.motion.mass import MassProperties, default_mass
from sdfcheck.robot.motion.mechanism import Axis, Geometry, Joint, Link, Mechanism, Mimic
from sdfcheck.robot.motion.poses import Array, transform, written_pose, z_towards
from sdfcheck.robot.shapes import shape_in
from sdfcheck.source.altered import Xml, copied
from sdfcheck.source.document import Element

# Shapes that URDF can hold, and what the others are made of.


HELD = frozenset({"box", "cylinder", "sphere", "mesh"})
"""The shapes that every consumer of URDF knows."""
DRAKE_SHAPES = frozenset({"capsule", "ellipsoid"})
"""Those that Drake has in addition, by names of its own."""


_THICKNESS = {"visual": 0.001, "collision": 0.1}
"""Of a box that replaces a plane, m: a thinner one would be passed through."""
_ENDLESS = 100.0
"""The least length of such a box where it collides, m: there a plane has no end."""


def pieces(geometry: Geometry, planes: Planes) -> list[Geometry]:
    """The shapes that together fill what one fills."""
    if geometry.kind == "capsule":
        return list(_capsule(geometry))
    if geometry.kind == "ellipsoid" and len(set(geometry.size)) == 1:
        return [replace(geometry, kind="sphere", size=geometry.size[:1])]
    if geometry.kind == "plane" and planes is Planes.BOX:
        return [_slab(geometry)]
    return [geometry]


def _capsule(geometry: Geometry) -> Iterator[Geometry]:
    """A cylinder with a sphere at either end."""
    radius, length = geometry.size
    yield replace(geometry, kind="cylinder", size=(radius, length))
    for end, where in (("top", length / 2), ("bottom", -length / 2)):
        pose = geometry.pose @ transform(np.eye(3), (0.0, 0.0, where))
        name = f"{geometry.name}_{end}" if geometry.name else ""
        yield replace(geometry, kind="sphere", size=(radius,), pose=pose, name=name)


def _slab(geometry: Geometry) -> Geometry:
    """A box with its upper face in a plane."""
    normal, (x, y) = np.array(geometry.size[:3]), geometry.size[3:]
    height = _THICKNESS[geometry.role]
    if geometry.role == "collision":
        x, y = max(x, _ENDLESS), max(y, _ENDLESS)
    turn = z_towards(normal / (np.linalg.norm(normal) or 1.0))
    pose = geometry.pose @ transform(turn, turn @ (0.0, 0.0, -height / 2))
    return replace(geometry, kind="box", size=(x, y, height), pose=pose)


def merged_frame(written: list[Geometry]) -> tuple[str, str]:
    """A shape that URDF does not have, and what is written for it; empty if it has it."""
    shape = written[0].element.find("geometry")
    own = shape_in(shape) if shape is not None else None
    if own is None or own.name.removeprefix("drake:") == written[0].kind:
        return "", ""
    return own.name, "a cylinder and two spheres" if len(written) > 1 else f"a {written[0].kind}"


def add_shape(context: Context, node: Xml, geometry: Geometry, scope: str) -> None:
    """Write the geometry of a visual or collision."""
    element = geometry.element.find("geometry")
    shape = shape_in(element) if element is not None else None
    if shape is None:
        return
    context.ledger.take_parts(shape, "size", "radius", "radii", "length", "normal", "uri", "scale", *"abc")
    name, attributes = geometry.kind, {}
    if geometry.kind == "mesh":
        uri = shape.find("uri")
        attributes["filename"] = mesh_uri(context, geometry.uri, shape if uri is None else uri)
        if geometry.size != (1.0, 1.0, 1.0):
            attributes["scale"] = numbers(geometry.size)
        if shape.attributes.get("optimization"):
            message = f"URDF has no mesh optimization (`{shape.attributes['optimization']}`)"
            context.ledger.note(LossKind.DROPPED_ELEMENT, shape, message)
    elif geometry.kind == "box":
        attributes["size"] = numbers(geometry.size)
    elif geometry.kind == "sphere":
        attributes["radius"] = number(geometry.size[0])
    elif geometry.kind == "ellipsoid":
        attributes = dict(zip("abc", map(number, geometry.size), strict=True))
    else:
        attributes["radius"], attributes["length"] = (number(size) for size in geometry.size)
    if geometry.kind in context.natives:
        name = f"drake:{name}"
        message = (
            f"the {geometry.kind} of {geometry.element.title} is written as `{name}`, which Drake alone reads"
        )
        context.ledger.note(LossKind.UNSUPPORTED_GEOMETRY, shape, message)
    carry_custom(context, node.add("geometry").add(name, **attributes), shape, scope)


# Values of a model that its text leaves to defaults, and those that URDF writes otherwise.
#
# The robot that comes out moves and weighs as the model does, and is what the URDF is compared with: every
# link has its mass, every moving joint its axis.


ONE_AXIS = frozenset({"revolute", "continuous", "prismatic", "screw", "planar"})
TWO_AXES = frozenset({"universal", "revolute2"})
_UP = (0.0, 0.0, 1.0)


def understood(
    robot: Mechanism, planes: Planes = Planes.DROP, natives: frozenset[str] = frozenset()
) -> Mechanism:
    """The robot with defaults filled in, without gearboxes: those are a coupling of two other joints.

    ``natives`` are shapes that stay what they are.
    """
    links = {name: _link(link, planes, natives) for name, link in robot.links.items()}
    joints = {name: _joint(joint) for name, joint in robot.joints.items()}
    for gearbox in robot.joints.values():
        if gearbox.kind == "gearbox":
            _couple(joints, gearbox)
    kept = {name: joint for name, joint in joints.items() if joint.kind != "gearbox"}
    return Mechanism(robot.name, links, kept, robot.frames)


def _link(link: Link, planes: Planes, natives: frozenset[str]) -> Link:
    body = default_mass() if link.body is None else link.body
    shown = [
        piece
        for geometry in link.geometries
        for piece in ([geometry] if geometry.kind in natives else pieces(geometry, planes))
    ]
    return Link(link.name, link.pose, link.element, body, shown)


def _joint(joint: Joint) -> Joint:
    wanted = 1 if joint.kind in ONE_AXIS else 2 if joint.kind in TWO_AXES else 0
    axes = list(joint.axes[:wanted])
    axes += [Axis(np.array(_UP)) for _ in range(wanted - len(axes))]
    kind = joint.kind
    if kind == "continuous":
        axes[0] = replace(axes[0], lower=-math.inf, upper=math.inf)
    elif kind == "revolute" and math.isinf(axes[0].lower) and math.isinf(axes[0].upper):
        kind = "continuous"
    return replace(joint, kind=kind, axes=tuple(axes))


def _couple(joints: dict[str, Joint], gearbox: Joint) -> None:
    """Let the output turn as the gearbox makes it, where both its joints start at the reference body."""
    found = coupling(list(joints.values()), gearbox)
    if found is not None:
        joint, mimic = found
        joints[joint.name] = replace(joint, axes=(replace(joint.axes[0], mimic=mimic),))


def coupling(joints: list[Joint], gearbox: Joint) -> tuple[Joint, Mimic] | None:
    """The joint that a gearbox drives, and how it follows; None where URDF cannot say it."""
    body = gearbox.element.find("gearbox_reference_body")
    ratio = gearbox.element.number("gearbox_ratio")
    if body is None or len(gearbox.axes) < 1:
        return None
    scope = gearbox.name.rpartition("::")[0]
    reference = f"{scope}::{body.content}" if scope else body.content

    def turning(child: str) -> Joint | None:
        ends = (reference, child)
        kinds = {"revolute", "continuous"}
        return next((j for j in joints if (j.parent, j.child) == ends and j.kind in kinds), None)

    driver, driven = turning(gearbox.parent), turning(gearbox.child)
    if driver is None or driven is None or driven.axes[0].mimic is not None:
        return None
    first = gearbox.axes[0].direction
    second = gearbox.axes[1].direction if len(gearbox.axes) > 1 else first
    sign = _agreement(gearbox, first, driver) * _agreement(gearbox, second, driven)
    if sign == 0:
        return None
    return driven, Mimic(driver.name, -sign * (ratio.number if ratio is not None else 1.0))


def _agreement(gearbox: Joint, direction: Array, joint: Joint) -> int:
    """Do the axes of a gearbox and of a joint point the same way (1), against each other (-1) or apart (0)?"""
    cosine = float((gearbox.pose[:3, :3] @ direction) @ (joint.pose[:3, :3] @ joint.axes[0].direction))
    return 0 if abs(abs(cosine) - 1) > 1e-6 else 1 if cosine > 0 else -1


# Colors: the one part of a material that URDF has.


_TEXTURE = "drake:diffuse_map"


def add_color(context: Context, node: Xml, visual: Element, scope: str) -> None:
    """Let a visual have the material of its diffuse color, or else of its ambient one."""
    material = visual.find("material")
    if material is None:
        return
    is_kept = context.ledger.is_entered(material)
    context.ledger.take(material)
    diffuse, ambient = material.find("diffuse"), material.find("ambient")
    chosen = diffuse if diffuse is not None else ambient
    color = _rgba(chosen)
    texture = material.find(_TEXTURE)
    if chosen is None or color is None:
        if texture is not None:
            carry_custom(context, node.add("material", name=_own_name(context)), material, scope)
        return
    context.ledger.take(chosen, TEXT)
    if ambient is None or diffuse is None:
        lacking = "diffuse" if diffuse is None else "ambient"
        message = (
            f"the {chosen.name} color of {visual.title} is the {lacking} one as well: URDF has one color"
        )
        context.ledger.note(LossKind.CHANGED_COLOR, chosen, message, Severity.INFO)
    elif not context.ledger.is_entered(ambient):
        if _rgba(ambient) == color:
            context.ledger.take(ambient, TEXT)
        else:
            message = f"the ambient color {ambient.content} of {visual.title} is left out: URDF has one color"
            context.ledger.lose(LossKind.CHANGED_COLOR, ambient, message)
    if texture is None:
        written = node.add("material", name=context.colors[color])
    else:
        written = node.add("material", name=_own_name(context))
        written.add("color", rgba=color)
    if is_kept and texture is None:
        return
    carry_custom(context, written, material, scope)
    if has_custom(chosen):
        # A color of its own, where the definition is shared.
        carry_custom(context, written.add("color", rgba=color), chosen, scope)


def _own_name(context: Context) -> str:
    """A name that no other material has: there may be several of a color with different textures."""
    number = len(context.colors) + 1
    context.colors[f"texture {number}"] = name = f"color_{number}"
    return name


def define_colors(context: Context) -> None:
    """Write the materials of all visuals; the same color is one material."""
    for link in context.robot.links.values():
        for geometry in link.geometries:
            material = geometry.element.find("material") if geometry.role == "visual" else None
            if material is None:
                continue
            diffuse = material.find("diffuse")
            color = _rgba(diffuse if diffuse is not None else material.find("ambient"))
            if color is not None and color not in context.colors:
                context.colors[color] = f"color_{len(context.colors) + 1}"
                context.root.add("material", name=context.colors[color]).add("color", rgba=color)


def _rgba(element: Element | None) -> str | None:
    values = floats(element.content) if element is not None else None
    if values is None or len(values) not in {3, 4}:
        return None
    return numbers((*values, 1.0)[:4])


# Settings that all visuals or all collisions of a link share, and URDF does not have: surfaces,
# textures, flags.
#
# libsdformat lays a ``visual`` or ``collision`` in a link's ``gazebo`` element over all that have no
# name.


_SAID = frozenset({"auto_inertia_params", "density", "geometry", "pose"})
"""The settings that are written otherwise: density is in the inertia, if it is used at all."""
_COLOR = frozenset({"diffuse", "ambient"})


def keep_extras(context: Context, link: Link, role: str, parts: list[Element]) -> bool:
    """Keep what the parts have beyond URDF as an extension, if it is the same for all and nothing needs names.

    True if it is kept: then the parts must be written without names.
    """
    each = [list(_extras(part)) for part in parts]
    if not each or not each[0] or _names_matter(link.element, role):
        return False
    meant = [[_canonical(extra) for extra in extras] for extras in each]
    if any(other != meant[0] for other in meant[1:]):
        return False
    kept = ", ".join(f"`{extra.name}`" for extra in each[0])
    if script := _script(each[0]):
        kept = f"material `{script}`"
        context.blob(context.links[link.name]).add("material", script)
        for extra in (extra for extras in each for extra in extras):
            context.ledger.take(extra)
            for one in extra.children("script"):
                context.ledger.take_whole(one)
    else:
        context.blob(context.links[link.name]).add(role).extend(*map(copied, each[0]))
        for extra in (extra for extras in each for extra in extras):
            context.ledger.copy(extra)
    message = (
        f"{kept} of the {role}s of {link.element.title} is kept for libsdformat alone, and costs their names"
    )
    context.ledger.note(LossKind.KEPT_AS_EXTENSION, each[0][0], message, Severity.INFO)
    return True


def _script(extras: Sequence[Element]) -> str:
    """The name of a script of classic Gazebo, where the extras are no more than that; else nothing."""
    material = extras[0]
    said = [part for part in material.children() if part.name not in _COLOR]
    is_script = material.name == "material" and [part.name for part in said] == ["script"]
    if len(extras) > 1 or not is_script or material.attributes:
        return ""
    texts = {part.name: part.content for part in said[0].children()}
    return texts["name"] if texts.keys() == {"name", "uri"} and texts["uri"] == SCRIPTS else ""


def _extras(part: Element) -> Iterator[Element]:
    for child in part.children():
        if child.name == "material":
            if any(inner.name not in _COLOR for inner in child.children()):
                yield child
        elif child.name not in _SAID and not child.is_custom:
            yield child


def _names_matter(link: Element, role: str) -> bool:
    """Does a contact sensor of the link name a collision?"""
    return role == "collision" and any(sensor.has("contact") for sensor in link.children("sensor"))


def _canonical(element: Element) -> tuple[object, ...]:
    inner = tuple(_canonical(child) for child in element.children())
    return (element.name, tuple(sorted(element.attributes.items())), " ".join(element.content.split()), inner)


_KEPT = 2 * LEAST
"""The mass (kg) of a link for which libsdformat does not drop it, and no more."""
_COMPONENTS = ("ixx", "ixy", "ixz", "iyy", "iyz", "izz")


def add_link(context: Context, name: str) -> None:
    """Write a link of the source, and what it has that only ``gazebo`` elements can hold."""
    link = context.robot.links[name]
    carry_comments(context, context.root, link.element)
    node = context.root.add("link", name=context.links[name])
    context.ledger.take_parts(link.element, "pose")
    _add_inertial(context, node, link)
    for role in ("visual", "collision"):
        _add_parts(context, node, link, role)
    carry_custom(context, node, link.element, name.rpartition("::")[0])
    link_extensions(context, name)
    carry_inside(context, node, link.element)


def _add_inertial(context: Context, node: Xml, link: Link) -> None:
    inertial = _inertial(context, link)
    if NOTHING in inertial.element.attributes:
        context.ledger.take_whole(inertial.element)
        return
    if not inertial.is_given:
        if link.body is not None:
            message = (
                f"{link.element.title} has no inertial: 1 kg and unit moments are written, as simulators take"
            )
            context.ledger.note(LossKind.CHANGED_DEFAULT, link.element, message, Severity.INFO)
            _write_body(context, node, link, link.body)
        return
    carry_comments(context, node, inertial.element)
    context.ledger.take_parts(inertial.element, "pose", "mass", "inertia")
    if inertial.is_automatic and link.body is not None:
        for part in (inertial.element, *link.element.children("collision")):
            _enter_automatic(context, part)
        message = f"the inertia of {link.element.title} is computed from its collisions and written"
        context.ledger.note(LossKind.CHANGED_INERTIA, inertial.element, message, Severity.INFO)
        _write_body(context, node, link, link.body)
    else:
        _write_inertial(context, node, link, inertial)


def _enter_automatic(context: Context, part: Element) -> None:
    """The shapes that an automatic inertia is computed from."""
    context.ledger.take(part.find("density"), TEXT)
    for parameters in part.children("auto_inertia_params"):
        context.ledger.take_whole(parameters)


def _inertial(context: Context, link: Link) -> Inertial:
    part = context.frames[link.name]
    assert isinstance(part, LinkPart), "the mechanism has the names of the model"
    return part.inertial


def _write_inertial(context: Context, node: Xml, link: Link, inertial: Inertial) -> None:
    """As its author wrote it, in the frame in which it was written."""
    tensor = inertial.tensor._asdict()
    mass = float(inertial.mass)
    if 0 < mass <= LEAST:
        message = (
            f"{link.element.title} has {number(mass)} kg, for which libsdformat drops it when it reads URDF: "
            f"{number(_KEPT)} kg are written"
        )
        context.ledger.note(LossKind.CHANGED_INERTIA, inertial.element, message)
        context.heavier.add(link.name)
        mass = _KEPT
    pose = link.pose @ written_pose(inertial.element.find("pose"))
    _write(context, node, link, context.layout.within(link.name, pose), mass, tensor)
    moments = (inertial.moments[name] for name in ("ixx", "iyy", "izz"))
    given = {"mass": inertial.mass.is_given, "moments": all(moment.is_given for moment in moments)}
    missing = [what for what, is_given in given.items() if not is_given]
    if missing:
        message = f"{link.element.title} is written with {' and '.join(missing)} of 1, which its inertial leaves out"
        context.ledger.note(LossKind.CHANGED_DEFAULT, inertial.element, message, Severity.INFO)


def _write_body(context: Context, node: Xml, link: Link, body: MassProperties) -> None:
    places = {"x": 0, "y": 1, "z": 2}
    tensor = {name: float(body.moments[places[name[1]], places[name[2]]]) for name in _COMPONENTS}
    pose = link.pose @ transform(np.eye(3), body.center)
    _write(context, node, link, context.layout.within(link.name, pose), body.mass, tensor)


def _write(
    context: Context, node: Xml, link: Link, pose: Array, mass: float, tensor: dict[str, float]
) -> None:
    inertial, source = node.add("inertial"), link.element.find("inertial")
    if source is not None:
        carry_inside(context, inertial, source)
    add_origin(inertial, pose, None if source is None else source.find("pose"))
    inertial.add("mass", value=number(mass))
    largest = max(map(abs, tensor.values()))
    inertial.add("inertia", **{name: number(settled(tensor[name], largest)) for name in _COMPONENTS})
    if source is not None:
        scope = link.name.rpartition("::")[0]
        carry_parts(context, inertial, source, scope, "pose=origin", "mass", "inertia")


def _add_parts(context: Context, node: Xml, link: Link, role: str) -> None:
    shapes: dict[Element, list[Geometry]] = {}
    for geometry in link.geometries:
        if geometry.role == role:
            shapes.setdefault(geometry.element, []).append(geometry)
    parts = [part for part in link.element.children(role) if _is_held(context, part, shapes.get(part, []))]
    scope = link.name.rpartition("::")[0]
    nameless = keep_extras(context, link, role, parts)
    for part in parts:
        context.ledger.take_parts(part, "pose")
        context.ledger.take(part.find("geometry"))
        shape, written_as = merged_frame(shapes[part])
        if shape:
            message = f"the {shape} of {part.title} of {link.element.title} is written as {written_as}"
            severity = Severity.WARNING if shape == "plane" else Severity.INFO
            context.ledger.note(LossKind.UNSUPPORTED_GEOMETRY, part, message, severity)
        for geometry in shapes[part]:
            carry_comments(context, node, part)
            written = node.add(role)
            if geometry.name and not nameless:
                written.attributes["name"] = geometry.name
            pose = context.layout.within(link.name, link.pose @ geometry.pose)
            add_origin(written, pose, part.find("pose"))
            add_shape(context, written, geometry, scope)
            if role == "visual":
                add_color(context, written, part, scope)
            carry_parts(context, written, part, scope, "pose=origin", "geometry")
            if role == "collision":
                carry_friction(context, written, part)
            carry_inside(context, written, part)


def _is_held(context: Context, part: Element, shapes: list[Geometry]) -> bool:
    """Can URDF hold it? If not, it is entered as lost."""
    kinds = sorted({geometry.kind for geometry in shapes if geometry.kind not in HELD | context.natives})
    if shapes and not kinds:
        return True
    holder = part.parent
    whose = f" of {holder.title}" if holder is not None else ""
    what = f"URDF has no {kinds[0]}" if kinds else "it has no shape, or one of size 0"
    message = f"{part.title}{whose} is left out: {what}"
    kind = LossKind.UNSUPPORTED_GEOMETRY if kinds else LossKind.DROPPED_ELEMENT
    context.ledger.lose(kind, part, message, Severity.ERROR if kinds else Severity.WARNING)
    context.dropped_shapes.add(part)
    return False


_PROPERTIES = "drake:proximity_properties"
_FRICTIONS = {"mu": "drake:mu_static", "mu2": "drake:mu_dynamic"}
_DEFAULT = "1"


def carry_friction(context: Context, collision: Xml, element: Element) -> None:
    """Write the friction of a collision for Drake, where the description is written for it."""
    at: Element | None = element
    for name in ("surface", "friction", "ode"):
        at = at.find(name) if at is not None else None
    own = collision.find(_PROPERTIES)
    if not context.natives or at is None or (own is not None and any(map(own.find, _FRICTIONS.values()))):
        return
    values = {name: part.content for name in _FRICTIONS if (part := at.find(name)) is not None}
    if values:
        properties = collision.reach(_PROPERTIES)
        for name, tag in _FRICTIONS.items():
            properties.add(tag, value=values.get(name, _DEFAULT))
