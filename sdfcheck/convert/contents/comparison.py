"""The settings of two robots compared: what has arrived, and what differs."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from pathlib import PurePosixPath

from sdfcheck.convert.comparison import Change, ChangeKind
from sdfcheck.convert.contents.entry import Contents, Divergence, Entry, divergences, same_text
from sdfcheck.convert.contents.vendor import seen_from_links
from sdfcheck.convert.loss import Loss, LossKind
from sdfcheck.convert.rewrite.matching import Names
from sdfcheck.robot.motion.mechanism import Geometry
from sdfcheck.robot.motion.rotations import Array
from sdfcheck.source.document import Element
from sdfcheck.source.record import NamedTuple

# Proof that settings have arrived: each that the source has is in the result, or is reported as a loss.


_NO_EXCUSE = frozenset({LossKind.KEPT_AS_EXTENSION})
"""Parts that are listed must exist."""
_NOT_COMPARED = ("/pose", "material/ambient", "material/script", "material/pbr")
"""Where the formats differ: what a merged link carries moves, and URDF has one color and one texture."""

_QUOTED = re.compile("`([^`]*)`")


class Counterparts(NamedTuple):
    """A shape of a link of the source, and the shapes of the result that are as large and in the same place."""

    link: str
    shape: Geometry
    equal: Sequence[Geometry]


class SettingsProof(NamedTuple):
    """The settings of source and result, and what was reported."""

    source: Contents
    result: Contents
    losses: Sequence[Loss]
    translated: frozenset[Element] = frozenset()
    """Elements of the source that the result says in another place or in other words."""
    copies: frozenset[tuple[Element, str]] = frozenset()
    """Custom elements and attributes, by element and name, of which the ledger knows that they are in the result."""

    def unequal(
        self, links: Mapping[str, str], joints: Mapping[str, str], shapes: Iterable[Counterparts]
    ) -> Iterator[tuple[str, Divergence]]:
        """The parts of the source, and what differs; ``links`` and ``joints`` are those compared, and their names."""
        excused = _Excuses(self.losses, self.translated)

        def apart(a: Entry, b: Entry, path: str = "") -> list[Divergence]:
            found = divergences(a, b, same, path, deep=True)
            return [one for one in found if one.before != "none" and not self.arrived(one, excused, a)]

        def same(a: str, b: str) -> bool:
            known = same_text(a, b) or b in {links.get(a), joints.get(a), a.replace("::", "__")}
            return known or (("/" in a or "/" in b) and PurePosixPath(a).name == PurePosixPath(b).name)

        named = [("link", name, other) for name, other in links.items()]
        named += [("joint", name, other) for name, other in joints.items()]
        for kind, name, other in (*named, ("model", "", "")):
            for one in apart(self.source.of(kind, name), self.result.of(kind, other)):
                yield name or self.source.name, one
        for link, shape, equal in shapes:
            mine = self.source.shapes.get(shape.element)
            theirs = [
                found for other in equal if (found := self.result.shapes.get(other.element)) is not None
            ]
            if mine is not None and theirs:
                # Of several shapes in one place any may be the one.
                best = apart(mine, theirs[0], shape.role)
                for one_more in theirs[1:]:
                    if not best:
                        break
                    best = min(best, apart(mine, one_more, shape.role), key=len)
                yield from ((link, one) for one in best)

    def arrived(self, one: Divergence, excused: _Excuses, part: Entry) -> bool:
        """Is a part that differs proven to be in the result, or reported?"""
        return (one.element, one.name) in self.copies or excused.excuse(one, part)


class _Excuses:
    """The places of what was reported."""

    def __init__(self, losses: Sequence[Loss], translated: frozenset[Element]) -> None:
        self.translated = translated
        self.spans = {
            (loss.span.source.path, loss.span.start) for loss in losses if loss.kind not in _NO_EXCUSE
        }
        self.files = {path for path, _ in self.spans}
        self.brought = {
            name for loss in losses if loss.span.text == "include" for name in _QUOTED.findall(loss.message)
        }
        """The names in what is reported at includes."""

    def excuse(self, one: Divergence, part: Entry) -> bool:
        if (
            any(path in one.path for path in _NOT_COMPARED)
            or one.name.rpartition(":")[2] in seen_from_links()
        ):
            return True
        if one.element in self.translated and one.element is not part.element:
            return True
        at = one.element
        while at is not None and at is not part.element:
            if self.knows(at) or self.knows_brought(at):
                return True
            at = at.parent
        return one.element is part.element and part.element is not None and self.knows(part.element)

    def knows_brought(self, element: Element) -> bool:
        """Is it in an included file, and left out? That is reported at the include, with its name."""
        if element.document.source.path in self.files:
            return False
        return element.name in self.brought or element.get("name") in self.brought

    def knows(self, element: Element) -> bool:
        """Is something reported about an element, its attributes or its text?"""
        spans = [element.span, element.own_value.span]
        spans += [
            value.name_span for name in element.attributes if (value := element.attribute(name)) is not None
        ]
        return any((span.source.path, span.start) in self.spans for span in spans)


# The changes in the settings of a robot.


_ONE_COLOR = ("material/ambient", "material/specular", "material/emissive")
"""What URDF, which has one color, leaves to the others."""


class SettingsDiff:
    """Compares the settings of two robots whose links and joints correspond."""

    def __init__(
        self,
        both: tuple[Contents, Contents],
        names: Names,
        tolerance: float,
        *,
        moved: Mapping[str, Array],
        across_formats: bool,
    ) -> None:
        """``moved``: where the frame of a link of the second is in that of its counterpart, where it is elsewhere."""
        self.moved = moved
        self.a, self.b = both
        self.links, self.joints = names.links, names.joints
        self.tolerance = tolerance
        self.across_formats = across_formats

    def run(self, shapes: Iterable[tuple[str, Geometry, Geometry]]) -> Iterator[Change]:
        """The changes; ``shapes`` are the link, and what became of which shape."""
        for name in [
            name for kind, name in self.a.parts if kind == "model" and ("model", name) in self.b.parts
        ]:
            found = divergences(self.a.of("model", name), self.b.of("model", name), self.same)
            yield from self.changes("model", name or self.b.name, found)
        for kind, names in (("link", self.links), ("joint", self.joints)):
            for name, other in names.items():
                yield from self.part(kind, name, other)
        seen: set[Entry] = set()
        for link, mine, theirs in shapes:
            first, second = self.a.shapes.get(mine.element), self.b.shapes.get(theirs.element)
            if first is None or second is None or first in seen:
                continue
            seen.add(first)
            label = f"{theirs.role} `{theirs.name}`" if theirs.name else theirs.role
            yield from self.changes("link", link, divergences(first, second, self.same, label))

    def part(self, kind: str, name: str, other: str) -> Iterator[Change]:
        theirs = self.b.of(kind, other)
        if kind == "link" and (shift := self.moved.get(name)) is not None:
            theirs = theirs.seen_from(shift)
        yield from self.changes(kind, other, divergences(self.a.of(kind, name), theirs, self.same))

    def changes(self, kind: str, name: str, found: Iterable[Divergence]) -> Iterator[Change]:
        for one in found:
            if self.across_formats and one.path.endswith(_ONE_COLOR):
                continue
            yield Change(ChangeKind.CHANGED, kind, name, one.path, one.before, one.after)

    def same(self, a: str, b: str) -> bool:
        """Do two values say the same, names of links and joints included?"""
        if same_text(a, b, self.tolerance) or self.links.get(a) == b or self.joints.get(a) == b:
            return True
        return self.across_formats and "/" in a and PurePosixPath(a).name == PurePosixPath(b).name
