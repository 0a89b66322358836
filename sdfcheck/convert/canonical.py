"""The canonical form of a description: the same robot, written one way."""

from __future__ import annotations

import math
from dataclasses import dataclass, field

import numpy as np

from sdfcheck.convert.file_difference import compare_files
from sdfcheck.convert.migrate.migrate import written_out
from sdfcheck.convert.new_errors import refuse_broken
from sdfcheck.convert.result import with_text
from sdfcheck.convert.writer import number, render
from sdfcheck.formats.schema import Definition
from sdfcheck.formats.sdf.schema import schema
from sdfcheck.formats.sdf.survey import version_of
from sdfcheck.formats.sdf.values import floats
from sdfcheck.formats.urdf.schema import urdf
from sdfcheck.formats.version import Version
from sdfcheck.robot.graph import Link
from sdfcheck.robot.motion.mass import MassProperties
from sdfcheck.robot.motion.origin import PoseError
from sdfcheck.robot.root import root_of
from sdfcheck.source.altered import Altered, Xml
from sdfcheck.source.document import Document, Element
from sdfcheck.source.errors import DescriptionError, WrongUsage
from sdfcheck.source.sniff import Kind

# Numbers of a description in canonical form: shortest exact texts, poses in one unit.


_NUMERIC = frozenset(
    ("angle", "color", "double", "float", "pose", "quaternion", "vector2d", "vector2i", "vector3")
)
_MOST_ROUNDS = 8


@dataclass(frozen=True, slots=True)
class NumberStyle:
    """How numbers are written.

    ``degrees``: whether the angles of poses are; None leaves each as it is. ``snap``:
    angles this near to a whole degree (in degrees) become one. ``precision``:
    significant digits, None for as many as it takes.
    """

    degrees: bool | None = None
    snap: float | None = None
    precision: int | None = None

    def number(self, value: float) -> str:
        return number(value if self.precision is None else float(f"{value:.{self.precision}g}"))

    def numbers(self, text: str) -> str:
        """A list of numbers in canonical form; any other text as it is."""
        values = floats(text)
        if values is None or len(values) != len(text.split()):
            return text
        return " ".join(self.number(value) for value in values)

    def angles(self, text: str) -> str:
        """Angles in radians; a text that is not made of three numbers stays as it is."""
        values = floats(text)
        if values is None or len(values) != 3:
            return text
        return " ".join(self.angle(value, degrees=False) for value in values)

    def angle(self, value: float, *, degrees: bool) -> str:
        """An angle in degrees or radians, snapped; what comes out stays as it is when it goes in again."""
        text = self.number(value)
        for _ in range(_MOST_ROUNDS):
            following = self.number(self._snapped(float(text), degrees))
            if following == text:
                break
            text = following
        return text

    def _snapped(self, value: float, degrees: bool) -> float:
        if self.snap is None or not math.isfinite(value):
            return value
        in_degrees = value if degrees else math.degrees(value)
        whole = round(in_degrees)
        if abs(in_degrees - whole) > self.snap:
            return value
        return float(whole) if degrees else math.radians(whole)


def _tidy(root: Xml, definition: Definition, style: NumberStyle) -> None:
    """Rewrite the numbers of a tree where its format has numbers; none in plugins, extensions and custom elements."""
    waiting = [(root, definition)]
    while waiting:
        element, definition = waiting.pop()
        for name, value in element.attributes.items():
            attribute = definition.attributes.get(name)
            if attribute is not None and attribute.type in _NUMERIC:
                element.attributes[name] = style.angles(value) if name == "rpy" else style.numbers(value)
        if definition.type == "pose":
            _tidy_pose(element, definition, style)
        elif definition.type in _NUMERIC and element.content:
            element.write(style.numbers(element.content))
        if not definition.open:
            inner = ((child, definition.children.get(child.name)) for child in element.children())
            waiting += [(child, found) for child, found in inner if found is not None]


def _tidy_pose(pose: Xml, definition: Definition, style: NumberStyle) -> None:
    values = floats(pose.content)
    if values is None:
        return
    if len(values) != 6 or pose.attributes.get("rotation_format", "euler_rpy").strip() != "euler_rpy":
        pose.write(style.numbers(pose.content))
        return
    has_degrees = pose.attributes.get("degrees", "").strip().lower() in {"true", "1"}
    wants_degrees = has_degrees if style.degrees is None else style.degrees
    angles = list(values[3:])
    if wants_degrees and not has_degrees and any(angles) and "degrees" in definition.attributes:
        angles = [math.degrees(angle) for angle in angles]
        pose.attributes["degrees"] = "true"
        has_degrees = True
    elif has_degrees and not wants_degrees:
        angles = [math.radians(angle) for angle in angles]
        del pose.attributes["degrees"]
        has_degrees = False
    texts = [style.number(value) for value in values[:3]]
    pose.write(" ".join((*texts, *(style.angle(angle, degrees=has_degrees) for angle in angles))))


_DEGREES_SINCE = Version(1, 9)
_DUST = 1e-15
_COMPUTED = frozenset(("auto_inertia_params", "density", "inertia", "mass", "pose"))


@dataclass(frozen=True, slots=True)
class CanonicalStyle:
    """The choices for the canonical form."""

    numbers: NumberStyle = field(default_factory=NumberStyle)
    expand_includes: bool = False
    expand_auto_inertials: bool = False


@dataclass(frozen=True, slots=True)
class CanonicalText:
    """The canonical text; ``notes`` list the requests that were not fulfilled, and why."""

    text: str
    notes: tuple[str, ...] = ()


def canonical(document: Document, style: CanonicalStyle) -> CanonicalText:
    """Write an SDF or URDF document in canonical form, and make sure that it is the same robot.

    Raises:
        WrongUsage: the text is broken, the format cannot hold what is asked for, or the
            result is another robot.
    """
    refuse_broken(document)
    is_sdf = document.kind is Kind.SDF
    if style.numbers.degrees and (not is_sdf or version_of(document) < _DEGREES_SINCE):
        what = f"SDFormat {version_of(document)}" if is_sdf else "URDF"
        raise WrongUsage(f"{what} has no poses in degrees (SDFormat has from {_DEGREES_SINCE} on)")
    notes: list[str] = []
    current = document
    if is_sdf and style.expand_includes:
        current, expansion = written_out(current)
        notes += expansion.notes
    if is_sdf and style.expand_auto_inertials:
        current, computed = _without_automatic_inertias(current)
        notes += computed
    made = Altered(current)
    assert made.root is not None
    if is_sdf:
        _tidy(made.root, schema(version_of(current)).root, style.numbers)
    else:
        _tidy(made.root, urdf(), style.numbers)
    result = with_text(document, render(made.root, made.prolog, made.epilog, keeps_lines=True))
    if style.numbers.snap is None and style.numbers.precision is None:
        _verify(document, result)
    return CanonicalText(result.source.text, tuple(notes))


def _verify(document: Document, result: Document) -> None:
    try:
        # A file of an included model is found by another uri from the including one.
        found = compare_files(document, result, across_formats=True)
    except (DescriptionError, PoseError):
        return  # no robot can be read from the source, so there is nothing to keep
    for model, changes in found.changes:
        first = changes[0]
        what = " ".join(
            filter(None, (first.part, f"`{first.name}`", first.what, first.before, "→", first.after))
        )
        raise WrongUsage(
            f"{document.path}: the canonical form would be another robot (model `{model}`: {what})"
        )


def _without_automatic_inertias(document: Document) -> tuple[Altered, list[str]]:
    frames = {
        link.element: link
        for scope in root_of(document).all_scopes()
        for link in scope.nodes.values()
        if isinstance(link, Link)
    }
    notes: list[str] = []
    made = Altered(document)
    assert made.root is not None
    for element in made.root.walk():
        frame = frames.get(element.origin) if element.origin is not None else None
        inertial = element.find("inertial") if frame is not None else None
        if inertial is None or frame is None or not _is_automatic(inertial):
            continue
        body = _computed(frame, notes)
        if body is not None:
            _write_inertial(inertial, body)
    made.number()
    return made, notes


def _is_automatic(inertial: Xml) -> bool:
    return inertial.attributes.get("auto", "").strip().lower() in {"true", "1"}


def _computed(frame: Link, notes: list[str]) -> MassProperties | None:
    try:
        return frame.automatic_mass()
    except (DescriptionError, PoseError) as error:
        notes.append(f"{_place(frame.element)}: link `{frame.name}` keeps its automatic inertia: {error}")
        return None


def _place(element: Element) -> str:
    return f"{element.document.path}:{element.span.begin.line}"


def _write_inertial(inertial: Xml, body: MassProperties) -> None:
    """Written out: pose, mass and moments; comments and other elements stay."""
    del inertial.attributes["auto"]
    inertial.drop(_COMPUTED)
    largest = float(np.abs(body.moments).max())
    inertia = Xml("inertia")
    pairs = (("ixx", 0, 0), ("ixy", 0, 1), ("ixz", 0, 2), ("iyy", 1, 1), ("iyz", 1, 2), ("izz", 2, 2))
    for name, row, column in pairs:
        inertia.add(name, _clean(float(body.moments[row, column]), largest))
    size = float(np.abs(body.center).max())
    center = " ".join(_clean(float(value), max(size, 1.0)) for value in body.center)
    computed = [Xml("mass", number(body.mass)), inertia]
    if size > _DUST:
        computed.insert(0, Xml("pose", f"{center} 0 0 0"))
    inertial.extend(*computed)


def _clean(value: float, scale: float) -> str:
    """A computed number without the dust of rounding."""
    return number(0.0 if abs(value) < _DUST * scale else value)
