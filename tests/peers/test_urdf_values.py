"""The values of URDF that conversions compute with are those of libsdformat, which reads URDF with urdfdom."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator
from pathlib import Path

import pytest

from sdfcheck.files.library import Library
from sdfcheck.robot.motion.flatten import mechanism_of
from sdfcheck.robot.motion.mechanism import Geometry, Joint, Link
from sdfcheck.robot.root import root_of
from sdfcheck.source.errors import DescriptionError
from tests.peers.findings import SHARED
from tests.peers.test_values import Value, is_installed, program, same, theirs, upper

__all__ = ["program"]

LEAST_FILES, LEAST_VALUES = 40, 3_500
NEAR_POLE = 0.99999
"""Sine of a pitch from which on libsdformat takes it for a quarter turn."""
SHAPES = frozenset({"box", "sphere", "cylinder", "mesh"})

pytestmark = [
    pytest.mark.peers,
    pytest.mark.skipif(not is_installed(), reason="libsdformat cannot be compiled with"),
]


def ours(path: Path) -> dict[str, Value] | None:
    """Our mechanism of a robot, by libsdformat's keys; None without one."""
    document = Library().document(path)
    if document is None or document.root is None or not root_of(document).models:
        return None
    try:
        robot = mechanism_of(root_of(document).models[0])
    except DescriptionError:
        return None
    values: dict[str, Value] = {}
    for link in robot.links.values():
        values.update(_link(f"{robot.name}/link:{link.name}", link))
    for joint in robot.joints.values():
        values.update(_joint(f"{robot.name}/joint:{joint.name}", joint))
    return values


def _link(key: str, link: Link) -> Iterator[tuple[str, Value]]:
    yield f"{key}/pose", tuple(link.pose[:3].ravel())
    if link.body is not None:
        yield f"{key}/mass", (link.body.mass,)
        yield f"{key}/center", tuple(link.body.center)
        yield f"{key}/moi", upper(link.body.moments)
    count: dict[str, int] = defaultdict(int)
    for shape in link.geometries:
        number = count[shape.role]
        count[shape.role] += 1
        yield f"{key}/{_shape(shape, number)}/pose", tuple(shape.pose[:3].ravel())
        if shape.kind in SHAPES:
            yield f"{key}/{_shape(shape, number)}/{shape.kind}", shape.size


def _shape(shape: Geometry, number: int) -> str:
    return f"{shape.role}:{number}"


def _joint(key: str, joint: Joint) -> Iterator[tuple[str, Value]]:
    for axis in joint.axes:
        yield f"{key}/axis/xyz", tuple(axis.direction)
        if joint.kind != "planar":
            yield f"{key}/axis/limits", (axis.lower, axis.upper, axis.effort, axis.velocity)
            yield f"{key}/axis/dynamics", (axis.damping, axis.friction, 0.0, 0.0)


def numbered(values: dict[str, Value]) -> dict[str, Value]:
    """Shapes by their number among those of the link, since URDF does not ask for names."""
    numbers: dict[tuple[str, str], dict[str, int]] = defaultdict(dict)
    found: dict[str, Value] = {}
    for key, value in values.items():
        parts = key.split("/")
        for at, part in enumerate(parts):
            role, colon, name = part.partition(":")
            if colon and role in {"visual", "collision"}:
                known = numbers["/".join(parts[:at]), role]
                parts[at] = f"{role}:{known.setdefault(name, len(known))}"
        found["/".join(parts)] = value
    return found


def is_argued(key: str, value: Value) -> bool:
    """Whether libsdformat changes a value on its way into SDFormat, so that it is not urdfdom's any more.

    Near a pitch of a quarter turn it loses digits of all angles, and a negative effort or velocity
    means none in SDFormat.
    """
    if isinstance(value, str):
        return False
    if key.endswith("/pose"):
        return abs(value[8]) > NEAR_POLE
    return key.endswith("/limits") and min(value[2:]) < 0


def kept_apart(path: Path, folder: Path) -> Path:
    """A copy in which all fixed joints are to be kept, so that libsdformat does not merge their links."""
    text = path.read_text(encoding="utf-8", errors="replace")
    document = Library().document(path)
    models = root_of(document).models if document is not None and document.root is not None else ()
    blocks = "".join(
        f'<gazebo reference="{joint.name}"><preserveFixedJoint>true</preserveFixedJoint></gazebo>'
        for model in models
        for joint in model.joints
        if joint.type == "fixed"
    )
    copy = folder / f"{len(list(folder.iterdir()))}-{path.name}"
    head, end, tail = text.rpartition("</robot>")
    copy.write_text(f"{head}{blocks}{end}{tail}", encoding="utf-8")
    return copy


def disagreements(program: Path, paths: list[Path]) -> tuple[int, int, list[str]]:
    """How many files and values were compared, and which differ."""
    files, count, wrong = 0, 0, []
    for path, values in theirs(program, paths).items():
        mine = ours(path)
        if mine is None:
            continue
        files += 1
        for key, their in numbered(values).items():
            if key in mine and not is_argued(key, mine[key]):
                count += 1
                if not same(key, their, mine[key]):
                    wrong.append(f"{path}: {key}: {their} and not {mine[key]}")
    return files, count, wrong


@pytest.mark.skipif(not SHARED.is_dir(), reason="the files to compare on are not here")
def test_values_of_real_robots(program: Path, tmp_path: Path) -> None:
    paths = [kept_apart(path, tmp_path) for path in sorted((SHARED / "corpus").rglob("*.urdf"))]
    files, count, wrong = disagreements(program, paths)
    assert not wrong, "\n".join(wrong)
    assert files >= LEAST_FILES
    assert count >= LEAST_VALUES
