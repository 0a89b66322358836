"""Drake's limits in SDF documents: what it refuses, passes over, or takes in its own way.

Source: Drake's parser (multibody/parsing), checked with pydrake 1.51.1.
"""

from __future__ import annotations

from collections.abc import Iterator

from sdfcheck.consumers.drake_ignored import ignored_parts
from sdfcheck.consumers.drake_meshes import unsupported_meshes
from sdfcheck.consumers.drake_problems import (
    CrashesDrake,
    FrictionOrder,
    SpecialValue,
    UnactuatedJoint,
    UnsupportedJoint,
)
from sdfcheck.formats.sdf.survey import Survey, survey
from sdfcheck.formats.sdf.values import number
from sdfcheck.formats.vendor.definitions import PASSED_OVER, REFUSED, Effect, Outcome
from sdfcheck.source.document import Document
from sdfcheck.source.element import Element, Value

_ABORTS = Effect(Outcome.ABORT)
_REFUSED_TYPES = frozenset(("gearbox", "revolute2"))
_OF_ACTUATORS = ("drake:rotor_inertia", "drake:gear_ratio", "drake:controller_gains")
_FRICTIONS = ("drake:mu_dynamic", "drake:mu_static")
_NOT_MADE = ("heightmap", "polyline", "image", "cone", "empty")
_SPRUNG = frozenset(("continuous", "prismatic", "revolute"))


def problems(document: Document) -> Iterator[object]:
    """Everything that Drake does not take as it is meant, in no particular order."""
    surveyed = survey(document)
    index = surveyed.index
    unread = list(_contents(surveyed))
    yield from unread
    yield from (part for part in ignored_parts(index, "sdf") if not unread or not _is_at_root(part.target))
    yield from unsupported_meshes(mesh for mesh in index.get("mesh", ()) if _is_shape(mesh))
    for joint in index.get("joint", ()):
        yield from _joint_type(joint)
        yield from _actuation(joint)
        yield from _axis(joint)
    yield from _frictions(surveyed)
    for normal in index.get("normal", ()):
        # That of a texture is a picture.
        of_plane = normal.parent is not None and normal.parent.name == "plane"
        if of_plane and normal.content and not any(map(number, normal.content.split())):
            yield CrashesDrake(normal.own_value, "a plane without direction", _ABORTS)
    for inertial in index.get("inertial", ()):
        yield from _automatic(inertial)


def _contents(surveyed: Survey) -> Iterator[CrashesDrake]:
    """A file is read for one model or one world; that several models are too many is told by the format."""
    root = surveyed.document.root
    if root is None or root.name != "sdf":
        return
    models, worlds = list(root.children("model")), list(root.children("world"))
    if not models and not worlds:
        yield CrashesDrake(root, "a file with neither model nor world", REFUSED)
    elif worlds and len(models) + len(worlds) > 1:
        what = "a model beside a world" if models else "a second world"
        yield CrashesDrake(models[0] if models else worlds[1], what, REFUSED)


def _is_at_root(part: Element | Value) -> bool:
    element = part.element if isinstance(part, Value) else part
    return element.parent is not None and element.parent.name == "sdf"


def _is_shape(mesh: Element) -> bool:
    geometry = mesh.parent
    return geometry is not None and geometry.name == "geometry"


def _joint_type(joint: Element) -> Iterator[UnsupportedJoint]:
    kind, parent = joint.attribute("type"), joint.parent
    if kind is None or parent is None:
        return
    word = kind.text.strip()
    if word in _REFUSED_TYPES:
        instead = "two revolute joints" if word == "revolute2" else None
        yield UnsupportedJoint(kind, REFUSED, instead)
    elif word != "fixed":
        static = parent.find("static")
        if parent.name == "world":
            yield UnsupportedJoint(kind, REFUSED, "fixed", "a world")
        elif static is not None and static.content.lower() in {"true", "1"}:
            yield UnsupportedJoint(kind, REFUSED, "fixed", "a static model")


def _actuation(joint: Element) -> Iterator[UnactuatedJoint]:
    kind = joint.attributes.get("type", "").strip()
    idle = next((found for name in _OF_ACTUATORS if (found := joint.find(name)) is not None), None)
    name = joint.attributes.get("name", "")
    if kind in {"fixed", "ball", "universal"}:
        if idle is not None:
            yield UnactuatedJoint(idle, name, f"its type is {kind}", PASSED_OVER, idle)
        return
    effort = _in_axis(joint, "limit", "effort")
    if effort is not None and number(effort.text) == 0:
        yield UnactuatedJoint(effort, name, "its effort is 0", PASSED_OVER, idle)


def _axis(joint: Element) -> Iterator[object]:
    kind = joint.attributes.get("type", "").strip()
    velocity = _in_axis(joint, "limit", "velocity")
    if (
        velocity is not None
        and (number(velocity.text) or 0) < 0
        and velocity.text.strip() not in {"-1", "-1.0"}
    ):
        yield SpecialValue(velocity, "no limit")
    damping = _in_axis(joint, "dynamics", "damping")
    if damping is not None and kind != "fixed" and (number(damping.text) or 0) < 0:
        yield CrashesDrake(damping, "a negative damping", REFUSED)
    stiffness = _in_axis(joint, "dynamics", "spring_stiffness")
    if stiffness is not None and kind in _SPRUNG and (number(stiffness.text) or 0) < 0:
        yield CrashesDrake(
            stiffness, "a negative spring stiffness", REFUSED if kind == "prismatic" else _ABORTS
        )


def _in_axis(joint: Element, part: str, name: str) -> Value | None:
    axis = joint.find("axis")
    inner = None if axis is None else axis.find(part)
    found = None if inner is None else inner.find(name)
    return None if found is None or not found.content else found.own_value


def _frictions(surveyed: Survey) -> Iterator[object]:
    for friction in surveyed.index.get("friction", ()):
        surface = friction.parent
        collision = None if surface is None else surface.parent
        if collision is None or collision.name != "collision" or not _is_made(collision):
            continue
        properties = collision.find("drake:proximity_properties")
        own = next(
            (f for n in _FRICTIONS if properties is not None and (f := properties.find(n)) is not None), None
        )
        ode = friction.find("ode")
        if own is not None:
            if ode is None:
                yield CrashesDrake(friction, f"a friction without `ode` beside `{own.name}`", _ABORTS)
        elif ode is not None:
            yield from _ode(ode)


def _is_made(collision: Element) -> bool:
    """Does Drake make a geometry of a collision? What it makes nothing of it does not look at."""
    geometry = collision.find("geometry")
    return geometry is None or not any(geometry.has(shape) for shape in _NOT_MADE)


def _ode(ode: Element) -> Iterator[FrictionOrder]:
    """``mu`` is the static friction, ``mu2`` the dynamic one; each is 1 where it is not given."""
    static, dynamic = ode.value("mu"), ode.value("mu2")
    low = number(static.text) if static is not None else 1.0
    high = number(dynamic.text) if dynamic is not None else 1.0
    if low is not None and high is not None and high > low >= 0:
        if static is not None:
            yield FrictionOrder(static, dynamic)
        elif dynamic is not None:
            yield FrictionOrder(dynamic, None)


def _automatic(inertial: Element) -> Iterator[CrashesDrake]:
    auto, link = inertial.attribute("auto"), inertial.parent
    if auto is None or link is None or auto.text.strip().lower() not in {"true", "1"}:
        return
    for collision in link.children("collision"):
        geometry = collision.find("geometry")
        mesh = None if geometry is None else geometry.find("mesh")
        uri = None if mesh is None else mesh.find("uri")
        if uri is not None and uri.content and "://" not in uri.content:
            yield CrashesDrake(
                uri.own_value, "an automatic inertia from a mesh with a relative path", _ABORTS
            )
