"""Names in the URDF: one scope, in which links and joints share no name."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from sdfcheck.robot.motion.mechanism import Mechanism


class Naming:
    """Hands out names that nobody has."""

    def __init__(self, taken: Iterable[str] = ()) -> None:
        self._taken = set(taken)

    def unique(self, wanted: str, otherwise: str = "") -> str:
        """The wanted name, or else the other one, or else a numbered one."""
        name = plain = wanted.replace("::", "__")
        if name in self._taken and otherwise:
            name = plain = otherwise.replace("::", "__")
        number = 2
        while name in self._taken:
            name = f"{plain}_{number}"
            number += 1
        self._taken.add(name)
        return name


def named(
    robot: Mechanism, frames: Iterable[str], kept: Iterable[str] = ()
) -> tuple[Naming, Mapping[str, str], Mapping[str, str], Mapping[str, str]]:
    """The names of links, of joints and of frames, by those of the source; ``kept`` are further joints.

    Names without a scope are given out first: they stay what they are.
    """
    naming = Naming({"world"})
    links = {name: naming.unique(name) for name in sorted(robot.links, key=_depth)}
    joints = {
        name: naming.unique(name, f"{name}_joint") for name in sorted([*robot.joints, *kept], key=_depth)
    }
    places = {name: naming.unique(name) for name in sorted(frames, key=_depth)}
    return naming, links, joints, places


def _depth(name: str) -> int:
    return name.count("::")
