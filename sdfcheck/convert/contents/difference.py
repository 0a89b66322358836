"""The changes in the settings of a robot."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from pathlib import PurePosixPath

from sdfcheck.convert.change import Change, ChangeKind
from sdfcheck.convert.contents.entry import Contents, Divergence, Entry, divergences, same_text
from sdfcheck.convert.rewrite.renaming import Names
from sdfcheck.robot.motion.mechanism import Geometry
from sdfcheck.robot.motion.rotations import Array

_ONE_COLOR = ("material/ambient", "material/specular", "material/emissive")
"""What URDF, which has one color, leaves to the others."""


class Settings:
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
