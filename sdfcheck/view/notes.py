"""The list beside a scene: findings and differences, and the part that each is about."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Iterable, Iterator, Mapping
from pathlib import Path
from types import MappingProxyType

from sdfcheck.convert.comparison import Change
from sdfcheck.convert.file_difference import compare_files
from sdfcheck.lint.diagnostic import Diagnostic
from sdfcheck.robot.graph import Joint, Link, Model, World
from sdfcheck.robot.motion.flatten import mechanism_of
from sdfcheck.robot.part import Part
from sdfcheck.robot.root import root_of
from sdfcheck.source.document import Document, Element
from sdfcheck.source.errors import DescriptionError
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.text import Span
from sdfcheck.view.meshes import Json

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
    parts = document.view(Parts)
    return [
        {
            "severity": one.severity.value,
            "code": one.code,
            "name": one.name,
            "message": one.message,
            "place": f"{one.span.source.path.name}:{one.span.begin.line}",
            "url": pages.get(one.code),
            **parts.around(one.span),
            **_moment(one),
        }
        for one in found
    ]


def _moment(found: Diagnostic) -> Json:
    if found.moment is None:
        return {}
    return {"moment": {"positions": dict(found.moment.positions), "points": found.moment.points}}


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

    element: Element
    whole: Span
    layer: str | None
    model: str | None
    name: str | None
    """Its link or joint, as it is called from the outermost model; None: the model itself."""


def _parts(document: Document) -> Iterator[_Part]:
    root = root_of(document)
    for kind, layer in _LAYERS.items():
        for part in root.each(kind):
            yield _Part(part.element, document.spans.whole(part.element), layer, *_address(part))


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


class _Nested:
    """The parts in one text, of which each is inside of another one or beside it; the outer ones come first."""

    def __init__(self, parts: Iterable[_Part]) -> None:
        self._rows: list[tuple[_Part, int]] = []
        """Each part in the order of the text, with the row of the part around it, or -1."""
        outer = -1
        for row, part in enumerate(sorted(parts, key=lambda part: part.whole.start)):
            while outer >= 0 and self._rows[outer][0].whole.end <= part.whole.start:
                outer = self._rows[outer][1]
            self._rows.append((part, outer))
            outer = row
        self._starts = [part.whole.start for part, _ in self._rows]

    def around(self, offset: int) -> _Part | None:
        """The innermost part around a place."""
        row = bisect_right(self._starts, offset) - 1
        while row >= 0 and self._rows[row][0].whole.end <= offset:
            row = self._rows[row][1]
        return self._rows[row][0] if row >= 0 else None


class Parts:
    """The parts that a file writes, by place and by name."""

    def __init__(self, document: Document) -> None:
        self._document = document
        self._parts = sorted(_parts(document), key=lambda part: part.whole.end - part.whole.start)
        by_text: dict[Path, list[_Part]] = {}
        for part in reversed(self._parts):
            by_text.setdefault(part.whole.source.path, []).append(part)
        self._nested = {path: _Nested(parts) for path, parts in by_text.items()}
        self._written: dict[_Tag, list[_Part]] = {}
        self._made: dict[_Tag, list[_Part]] = {}
        """The name of a macro's call → the links that it made."""

    def around(self, span: Span) -> Json:
        """The innermost part around a place; of what a macro made, the part that it was made for."""
        nested = self._nested.get(span.source.path)
        part = None if nested is None else nested.around(span.start)
        if part is None:
            return {"model": None, "part": None, "layer": None}
        return {"model": part.model, "part": part.name, "layer": part.layer}

    def at(self, element: Element) -> list[Json]:
        """The parts that an element of one of the files is or makes, or those of the nearest element around it."""
        if not self._written:
            self._list_tags()
        for each in (element, *element.around):
            tag = _tag(each.span)
            if found := self._written.get(tag) or self._made.get(tag):
                known = dict.fromkeys((part.model, part.name) for part in found)
                return [{"model": model, "part": name} for model, name in known]
        return []

    def _list_tags(self) -> None:
        for part in self._parts:
            self._written.setdefault(_tag(part.element.span), []).append(part)
            if part.element.name == "link":
                for step in self._document.origins(part.element):
                    self._made.setdefault(_tag(step.span), []).append(part)

    def place(self, model: str | None, name: str | None) -> Span | None:
        """Where a link, a joint or a model (``name`` is None) is written, also in an included file."""
        for part in self._parts:
            if part.layer in {None, "axes"} and (part.model, part.name) == (model, name):
                return part.element.span
        root = root_of(self._document)
        for one in (*root.models, *(model for world in root.worlds for model in world.models)):
            if one.name == model:
                return _place(one, name)
        return None


_Tag = tuple[str, int]
"""The path of a file, and where the name of a start tag begins in it."""


def _tag(span: Span) -> _Tag:
    return span.source.real_path, span.start


def _place(model: Model, name: str | None) -> Span | None:
    try:
        made = mechanism_of(model, vendors=True)
    except (DescriptionError, ValueError):
        return model.element.span
    part = made.links.get(name or "") or made.joints.get(name or "")
    return (model if part is None else part).element.span
