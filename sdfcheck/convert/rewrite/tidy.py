"""Elements, texts and numbers in canonical form."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from dataclasses import dataclass

from sdfcheck.convert.writer import INDENT, declared_prefixes, has_mixed_content, keeps_blanks, number
from sdfcheck.formats.schema import Definition
from sdfcheck.formats.sdf.schema import schema
from sdfcheck.formats.sdf.values import floats
from sdfcheck.formats.version import Version
from sdfcheck.source.document import Aside, Document, Element, Instruction
from sdfcheck.source.references import IN_ATTRIBUTE, escape

# Elements, comments and texts, written with canonical indentation.
#
# Blank lines (one at most) and comments at the end of a line stay where their author put them.


class Remark:
    """A comment, or a processing instruction; ``beside`` something that is before it on its line."""

    __slots__ = ("after_gap", "beside", "target", "text")

    def __init__(self, text: str, *, target: str = "", beside: bool = False) -> None:
        self.text = text
        self.target = target
        self.beside = beside
        self.after_gap = False

    def __str__(self) -> str:
        if self.target:
            return f"<?{self.target} {self.text}?>" if self.text else f"<?{self.target}?>"
        text = re.sub("-(?=-)", "- ", self.text)
        return f"<!--{text} -->" if text.endswith("-") else f"<!--{text}-->"


class Branch:
    """An element that can be changed; ``origin`` is what it was read from.

    ``parts`` are elements, remarks and texts, in order. ``verbatim``: every blank in it is its author's.
    """

    __slots__ = ("after_gap", "attributes", "name", "origin", "parts", "verbatim")

    def __init__(self, name: str, /, *texts: str, **attributes: str) -> None:
        self.name = name
        self.attributes: dict[str, str] = attributes
        self.parts: list[Branch | Remark | str] = list(texts)
        self.origin: Element | None = None
        self.after_gap = False
        self.verbatim = False

    def __repr__(self) -> str:
        return f"Branch({self.name})"

    @property
    def children(self) -> Iterator[Branch]:
        return (part for part in self.parts if isinstance(part, Branch))

    @property
    def text(self) -> str:
        """The first text before any element, as simulators read it."""
        for part in self.parts:
            if isinstance(part, Branch):
                break
            if isinstance(part, str):
                return part
        return ""

    @text.setter
    def text(self, text: str) -> None:
        for at, part in enumerate(self.parts):
            if isinstance(part, Branch):
                break
            if isinstance(part, str):
                self.parts[at] = text
                return
        self.parts.insert(0, text)

    def find(self, name: str) -> Branch | None:
        return next((child for child in self.children if child.name == name), None)

    def put(self, child: Branch) -> None:
        """Replace the first child of that name, or become the first part."""
        old = self.find(child.name)
        if old is None:
            self.parts.insert(0, child)
        else:
            child.after_gap = old.after_gap
            self.parts[self.parts.index(old)] = child

    def walk(self) -> Iterator[Branch]:
        yield self
        for child in self.children:
            yield from child.walk()


def branch_of(element: Element, *, is_free: bool = False) -> Branch:
    """A copy of an element and all in it; ``is_free``: it is in a plugin or custom element.

    Words between elements there, and all in an element that says so (``xml:space``), keep every blank.
    """
    branch = Branch(element.name)
    branch.origin = element
    branch.attributes = {**element.attributes, **declared_prefixes(element)}
    is_free = is_free or element.is_custom or element.name == "plugin"
    if keeps_blanks(element) or (is_free and has_mixed_content(element)):
        return _verbatim(branch, element)
    before = element.text
    for child in element.nodes:
        if before.strip():
            branch.parts.append(before.strip())
        blanks = before[len(before.rstrip()) :]
        beside = "\n" not in blanks
        part = (
            branch_of(child, is_free=is_free) if isinstance(child, Element) else _remark(child, beside=beside)
        )
        part.after_gap = blanks.count("\n") > 1
        branch.parts.append(part)
        before = child.tail
    if before.strip():
        branch.parts.append(before.strip())
    return branch


def _verbatim(branch: Branch, element: Element) -> Branch:
    branch.verbatim = True
    branch.parts += [element.text] if element.text else []
    for child in element.nodes:
        if isinstance(child, Element):
            inner = Branch(child.name)
            inner.origin = child
            inner.attributes = {**child.attributes, **declared_prefixes(child)}
            branch.parts.append(_verbatim(inner, child))
        else:
            branch.parts.append(_remark(child))
        branch.parts += [child.tail] if child.tail else []
    return branch


def render(root: Branch, document: Document) -> str:
    """The whole file: declaration, what is before the root, the root, what is after it."""
    assert document.root is not None
    lines = ['<?xml version="1.0"?>']
    lines += [str(_remark(node)) for node in document.prolog]
    _write(root, "", lines)
    lines += [str(_remark(node)) for node in document.epilog]
    return "\n".join(lines) + "\n"


def text_of(branch: Branch) -> str:
    """An element alone."""
    lines: list[str] = []
    _write(branch, "", lines)
    return "\n".join(lines)


def _remark(node: Aside, *, beside: bool = False) -> Remark:
    return Remark(node.text, target=node.target if isinstance(node, Instruction) else "", beside=beside)


def _write(branch: Branch, indent: str, lines: list[str]) -> None:
    if branch.verbatim:
        lines.append(f"{indent}{_inline(branch)}")
        return
    start, parts = f"{indent}{_start(branch)}", branch.parts
    if not parts:
        lines.append(f"{start}/>")
        return
    if len(parts) == 1 and isinstance(parts[0], str):
        lines.append(f"{start}>{escape(parts[0])}</{branch.name}>")
        return
    lines.append(f"{start}>")
    for place, part in enumerate(parts):
        if place and not isinstance(part, str) and part.after_gap:
            lines.append("")
        if isinstance(part, Branch):
            _write(part, indent + INDENT, lines)
        elif isinstance(part, Remark) and part.beside:
            lines[-1] += f" {part}"
        else:
            lines.append(f"{indent}{INDENT}{escape(part) if isinstance(part, str) else part}")
    lines.append(f"{indent}</{branch.name}>")


def _start(branch: Branch) -> str:
    attributes = "".join(
        f' {key}="{escape(value, IN_ATTRIBUTE)}"' for key, value in branch.attributes.items()
    )
    return f"<{branch.name}{attributes}"


def _inline(part: Branch | Remark | str) -> str:
    """A part with the spaces that it has, and no others."""
    if isinstance(part, str):
        return escape(part)
    if isinstance(part, Remark):
        return str(part)
    inner = "".join(map(_inline, part.parts))
    return f"{_start(part)}>{inner}</{part.name}>" if inner else f"{_start(part)}/>"


# Numbers of a description in canonical form: shortest exact texts, poses in one unit.


_NUMERIC = frozenset(
    ("angle", "color", "double", "float", "pose", "quaternion", "vector2d", "vector2i", "vector3")
)
_URDF_NUMERIC = {
    "axis": ("xyz",),
    "box": ("size",),
    "calibration": ("falling", "rising"),
    "capsule": ("length", "radius"),
    "color": ("rgba",),
    "cylinder": ("length", "radius"),
    "dynamics": ("damping", "friction"),
    "inertia": ("ixx", "ixy", "ixz", "iyy", "iyz", "izz"),
    "limit": ("effort", "lower", "upper", "velocity", "acceleration", "jerk"),
    "mass": ("value",),
    "mesh": ("scale",),
    "mimic": ("multiplier", "offset"),
    "origin": ("xyz", "quat_xyzw"),
    "safety_controller": ("k_position", "k_velocity", "soft_lower_limit", "soft_upper_limit"),
    "sphere": ("radius",),
}
_URDF_FREE = frozenset(("gazebo", "ros2_control", "transmission"))
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


def tidy_sdf(root: Branch, version: Version, style: NumberStyle) -> None:
    """Rewrite the numbers of an SDF tree wherever the format has numbers; nothing in plugins or custom elements."""
    waiting: list[tuple[Branch, Definition]] = [(root, schema(version).root)]
    while waiting:
        branch, definition = waiting.pop()
        for name, value in branch.attributes.items():
            attribute = definition.attributes.get(name)
            if attribute is not None and attribute.type in _NUMERIC:
                branch.attributes[name] = style.numbers(value)
        if definition.type == "pose":
            _tidy_pose(branch, definition, style)
        elif definition.type in _NUMERIC and branch.text:
            branch.text = style.numbers(branch.text)
        if not definition.open:
            inner = ((child, definition.children.get(child.name)) for child in branch.children)
            waiting += [(child, found) for child, found in inner if found is not None]


def tidy_urdf(root: Branch, style: NumberStyle) -> None:
    """Rewrite the numbers of a URDF tree; nothing in extensions."""
    for child in root.children:
        if child.name in _URDF_FREE or ":" in child.name:
            continue
        for name in _URDF_NUMERIC.get(child.name, ()):
            if name in child.attributes:
                child.attributes[name] = style.numbers(child.attributes[name])
        angles = floats(child.attributes.get("rpy", "")) if child.name == "origin" else None
        if angles is not None and len(angles) == 3:
            child.attributes["rpy"] = " ".join(style.angle(angle, degrees=False) for angle in angles)
        tidy_urdf(child, style)


def _tidy_pose(pose: Branch, definition: Definition, style: NumberStyle) -> None:
    values = floats(pose.text)
    if values is None:
        return
    if len(values) != 6 or pose.attributes.get("rotation_format", "euler_rpy").strip() != "euler_rpy":
        pose.text = style.numbers(pose.text)
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
    pose.text = " ".join((*texts, *(style.angle(angle, degrees=has_degrees) for angle in angles)))
