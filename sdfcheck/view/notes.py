"""The list beside a scene: findings and differences, and the part that each is about."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from types import MappingProxyType

from sdfcheck.convert.change import Change
from sdfcheck.convert.file_difference import compare_files
from sdfcheck.lint.diagnostic import Diagnostic
from sdfcheck.robot.errors import DescriptionError
from sdfcheck.robot.model import Model
from sdfcheck.robot.part import Part
from sdfcheck.robot.parts.joint import Joint
from sdfcheck.robot.parts.link import Link
from sdfcheck.robot.root import root_of
from sdfcheck.robot.world import World
from sdfcheck.source.document import Document
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.text import Span
from sdfcheck.view.numbers import Json

_LAYERS = {
    "Inertial": "inertias",
    "Collision": "collisions",
    "Visual": "visuals",
    "Sensor": "sensors",
    "Light": "lights",
    "Frame": "frames",
    "Joint": "axes",
    "Link": None,
    "Model": None,
}
"""Class of a part → the layer of the page that shows it."""


def findings(
    found: Iterable[Diagnostic], document: Document, pages: Mapping[str, str] = MappingProxyType({})
) -> list[Json]:
    """Diagnostics, with the model and the link or joint in which each is, and the layer that shows what it is about.

    ``pages`` are the addresses of the pages about the rules, by code.
    """
    parts = sorted(_parts(document), key=lambda part: part.whole.end - part.whole.start)
    return [
        {
            "severity": one.severity.value,
            "code": one.code,
            "name": one.name,
            "message": one.message,
            "place": f"{one.span.source.path.name}:{one.span.begin.line}",
            "url": pages.get(one.code),
            **_around(one.span, parts),
        }
        for one in found
    ]


def differences(before: Document, after: Document) -> list[Json]:
    """The changes from one description to another, as in ``sdfcheck diff``."""
    try:
        changes = compare_files(before, after).changes
    except DescriptionError as error:
        return [{"text": f"not compared: {error}", "model": None, "part": None}]
    return [_difference(model, change) for model, found in changes for change in found]


def _difference(model: str, change: Change) -> Json:
    what = f", {change.what}" if change.what else ""
    values = f": {change.before} → {change.after}" if change.before or change.after else ""
    is_whole = change.part in {"model", "world"}
    return {
        "text": f"{change.kind.value} {change.part} {change.name}{what}{values}",
        "model": None if change.part == "world" else model,
        "part": None if is_whole else change.name,
    }


class _Part(NamedTuple):
    """A part that the file writes, with all that is in it."""

    whole: Span
    layer: str | None
    model: str | None
    name: str | None
    """Its link or joint, as it is called from the outermost model; None: the model itself."""


def _parts(document: Document) -> Iterator[_Part]:
    root = root_of(document)
    for kind, layer in _LAYERS.items():
        for part in root.each(kind):
            yield _Part(document.spans.whole(part.element), layer, *_address(part))


def _address(part: Part) -> tuple[str | None, str | None]:
    """The outermost model around a part, and its link or joint in that."""
    names: list[str] = []
    at: Part | None = part
    while at is not None and not isinstance(at, World):
        if isinstance(at, Link | Joint | Model):
            names.append(at.name)
        at = at.holder
    model = names.pop() if names else None
    return model, "::".join(reversed(names)) or None


def _around(span: Span, parts: Iterable[_Part]) -> Json:
    """The innermost part around a place; of what a macro made, the part that it was made for."""
    for part in parts:
        whole = part.whole
        if whole.source.path == span.source.path and whole.start <= span.start < whole.end:
            return {"model": part.model, "part": part.name, "layer": part.layer}
    return {"model": None, "part": None, "layer": None}
