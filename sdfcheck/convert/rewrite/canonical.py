"""The canonical form of a description: the same robot, written one way."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from sdfcheck.convert.broken_text import refuse_broken
from sdfcheck.convert.file_difference import compare_files
from sdfcheck.convert.migrate.migrate import to_sdf
from sdfcheck.convert.result import with_text
from sdfcheck.convert.rewrite.include_expansion import expanded
from sdfcheck.convert.rewrite.tidy import Branch, NumberStyle, branch_of, render, tidy_sdf, tidy_urdf
from sdfcheck.convert.writer import number
from sdfcheck.formats.sdf.survey import survey
from sdfcheck.formats.version import Version
from sdfcheck.robot.errors import DescriptionError
from sdfcheck.robot.motion.mass import automatic
from sdfcheck.robot.motion.mass_properties import MassProperties
from sdfcheck.robot.motion.poses import PoseError
from sdfcheck.robot.parts.link import Link
from sdfcheck.robot.root import root_of
from sdfcheck.source.document import Document, Element
from sdfcheck.source.sniff import Kind
from sdfcheck.source.wrong_usage import WrongUsage

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
    if style.numbers.degrees and (not is_sdf or survey(document).version < _DEGREES_SINCE):
        what = f"SDFormat {survey(document).version}" if is_sdf else "URDF"
        raise WrongUsage(f"{what} has no poses in degrees (SDFormat has from {_DEGREES_SINCE} on)")
    notes: list[str] = []
    current = document
    if is_sdf and style.expand_includes:
        current, expanded = _without_includes(current)
        notes += expanded
    if is_sdf and style.expand_auto_inertials:
        current, computed = _without_automatic_inertias(current)
        notes += computed
    assert current.root is not None
    root = branch_of(current.root)
    if is_sdf:
        tidy_sdf(root, survey(current).version, style.numbers)
    else:
        tidy_urdf(root, style.numbers)
    result = with_text(document, render(root, current))
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


def _without_includes(document: Document) -> tuple[Document, list[str]]:
    root, expansion = expanded(document, to_sdf)
    if not expansion.expanded:
        return document, expansion.notes
    return with_text(document, render(root, document)), expansion.notes


def _without_automatic_inertias(document: Document) -> tuple[Document, list[str]]:
    assert document.root is not None
    frames = {
        link.element: link
        for scope in root_of(document).all_scopes()
        for link in scope.nodes.values()
        if isinstance(link, Link)
    }
    notes: list[str] = []
    root, changed = branch_of(document.root), False
    for branch in root.walk():
        frame = frames.get(branch.origin) if branch.origin is not None else None
        inertial = branch.find("inertial") if frame is not None else None
        if inertial is None or frame is None or not _is_automatic(inertial):
            continue
        body = _computed(frame, notes)
        if body is not None:
            _write_inertial(inertial, body)
            changed = True
    return (with_text(document, render(root, document)) if changed else document), notes


def _is_automatic(inertial: Branch) -> bool:
    return inertial.attributes.get("auto", "").strip().lower() in {"true", "1"}


def _computed(frame: Link, notes: list[str]) -> MassProperties | None:
    try:
        return automatic(frame)
    except (DescriptionError, PoseError) as error:
        notes.append(f"{_place(frame.element)}: link `{frame.name}` keeps its automatic inertia: {error}")
        return None


def _place(element: Element) -> str:
    return f"{element.document.path}:{element.span.begin.line}"


def _write_inertial(inertial: Branch, body: MassProperties) -> None:
    """Written out: pose, mass and moments; comments and other elements stay."""
    del inertial.attributes["auto"]
    inertial.parts = [
        part for part in inertial.parts if not (isinstance(part, Branch) and part.name in _COMPUTED)
    ]
    largest = float(np.abs(body.moments).max())
    inertia = Branch("inertia")
    pairs = (("ixx", 0, 0), ("ixy", 0, 1), ("ixz", 0, 2), ("iyy", 1, 1), ("iyz", 1, 2), ("izz", 2, 2))
    for name, row, column in pairs:
        inertia.parts.append(Branch(name, _clean(float(body.moments[row, column]), largest)))
    size = float(np.abs(body.center).max())
    center = " ".join(_clean(float(value), max(size, 1.0)) for value in body.center)
    computed: list[Branch] = [Branch("mass", number(body.mass)), inertia]
    if size > _DUST:
        computed.insert(0, Branch("pose", f"{center} 0 0 0"))
    inertial.parts += computed


def _clean(value: float, scale: float) -> str:
    """A computed number without the dust of rounding."""
    return number(0.0 if abs(value) < _DUST * scale else value)
