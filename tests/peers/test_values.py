"""The values that our object model has are those of libsdformat's own, one by one, on real files."""

from __future__ import annotations

import math
import shutil
import subprocess
from collections import defaultdict
from collections.abc import Iterable, Iterator
from pathlib import Path

import numpy as np
import pytest

from sdfcheck.files.library import Library
from sdfcheck.formats.version import Version
from sdfcheck.robot.graph import Joint, Link, Model, Sensor, Shape, Visual, World
from sdfcheck.robot.motion import mass
from sdfcheck.robot.motion.flatten import direction_of
from sdfcheck.robot.motion.origin import PoseError
from sdfcheck.robot.motion.poses import Array, written_pose
from sdfcheck.robot.part import Node
from sdfcheck.robot.root import root_of
from sdfcheck.source.errors import DescriptionError
from tests.peers.findings import SHARED

SOURCE = Path(__file__).with_name("values.cc")
PACKAGE = "sdformat12"
NEWEST_KNOWN = Version(1, 9)
TOLERANCE = 1e-9
COLOR_TOLERANCE = 1e-6
"""Colors are single floats in libsdformat."""
ENDLESS = 1e15
"""Bounds from here on mean none."""
LEAST_FILES, LEAST_VALUES = 150, 12_000
MOST_BYTES = 1_000_000
"""Larger files are left out: libsdformat 12 takes half a minute for one, which repeats what others hold."""
CALLED = {
    "depth": "depth_camera",
    "gpu_ray": "gpu_lidar",
    "multicamera": "multi_camera",
    "ray": "lidar",
    "rgbd": "rgbd_camera",
    "thermal": "thermal_camera",
    "wideanglecamera": "wide_angle_camera",
}
"""Types of sensors that libsdformat calls otherwise than files do."""
LIGHTS = ("ambient", "diffuse", "specular", "emissive")
Value = str | tuple[float, ...]


def is_installed() -> bool:
    if not (shutil.which("g++") and shutil.which("pkg-config")):
        return False
    return subprocess.run(["pkg-config", "--exists", PACKAGE], check=False).returncode == 0


pytestmark = [
    pytest.mark.peers,
    pytest.mark.skipif(not is_installed(), reason="libsdformat cannot be compiled with"),
]


@pytest.fixture(scope="module")
def program(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The program that writes what libsdformat reads."""
    made = tmp_path_factory.mktemp("values") / "values"
    flags = subprocess.run(
        ["pkg-config", "--cflags", "--libs", PACKAGE], capture_output=True, text=True, check=True
    ).stdout.split()
    subprocess.run(["g++", "-std=c++17", "-o", str(made), str(SOURCE), *flags], check=True)
    return made


def theirs(program: Path, paths: Iterable[Path]) -> dict[Path, dict[str, Value]]:
    """The values that libsdformat reads of each file that it takes without a crash."""
    command = [str(program), *map(str, paths)]
    lines = subprocess.run(command, capture_output=True, text=True, check=True).stdout.splitlines()
    found: dict[Path, dict[str, Value]] = defaultdict(dict)
    for line in lines:
        path, key, *rest = line.split("\t")
        found[Path(path)][key] = rest[0][1:] if rest[0].startswith("=") else tuple(map(float, rest))
    return {path: values for path, values in found.items() if values.pop("errors", None) == (0.0,)}


class Ours:
    """The values in our object model of one file, under the same keys."""

    def __init__(self, path: Path) -> None:
        document = Library().document(path)
        assert document is not None
        self.root = root_of(document)
        self.values: dict[str, Value] = {}
        for top in self.root.scopes:
            for model in top.models if isinstance(top, World) else (top,):
                assert isinstance(model, Model)
                self.model("", model)

    def model(self, prefix: str, model: Model) -> None:
        key = prefix + model.name
        self.values[f"{key}/static"] = (float(model.is_static),)
        for link in model.links:
            if not link.is_urdf:
                self.link(f"{key}/link:{link.name}", link)
        for joint in model.joints:
            if not joint.is_urdf:
                self.joint(f"{key}/joint:{joint.name}", joint)
        for inner in model.models:
            self.model(f"{key}::", inner)

    def link(self, key: str, link: Link) -> None:
        self.pose(key, self.root.poses.in_scope(link))
        body = link.mass_properties or mass.default_mass()
        pose = written_pose(link.inertial.find("pose")) if link.inertial.is_given else np.eye(4)
        own = link.inertial.tensor
        self.values[f"{key}/mass"] = (body.mass,)
        self.values[f"{key}/moments"] = (own.ixx, own.iyy, own.izz, own.ixy, own.ixz, own.iyz)
        self.values[f"{key}/center"] = tuple(pose[:3, 3])
        self.values[f"{key}/moi"] = upper(body.moments)
        for shape in link.shapes:
            self.shape(f"{key}/{shape.kind}:{shape.name}", shape, link)
        self.sensors(key, link, link.sensors)

    def shape(self, key: str, shape: Shape, link: Link) -> None:
        self.pose(key, self.root.poses.of_part(shape.element, link))
        kind = shape.geometry.shape
        if kind in {"box", "sphere", "cylinder", "capsule", "ellipsoid", "mesh"}:
            self.values[f"{key}/{kind}"] = tuple(map(float, shape.geometry.measures))
        if kind == "mesh":
            self.values[f"{key}/uri"] = shape.geometry.uri
        for name in LIGHTS:
            if isinstance(shape, Visual) and (light := shape.material.light(name)) is not None:
                self.values[f"{key}/{name}"] = tuple(light)

    def sensors(self, key: str, holder: Node, sensors: Iterable[Sensor]) -> None:
        for sensor in sensors:
            own = f"{key}/sensor:{sensor.name}"
            self.values[f"{own}/type"] = CALLED.get(sensor.type, sensor.type)
            self.values[f"{own}/update_rate"] = (float(sensor.update_rate),)
            self.pose(own, self.root.poses.of_part(sensor.element, holder))

    def joint(self, key: str, joint: Joint) -> None:
        self.pose(key, self.root.poses.in_scope(joint))
        for name, axis in (("axis", joint.axis), ("axis2", joint.axis2)):
            if axis.is_given:
                limit, dynamics = axis.limit, axis.dynamics
                own = f"{key}/{name}"
                self.values[f"{own}/xyz"] = tuple(direction_of(axis))
                bounds = (*limit.range, limit.greatest_effort, limit.greatest_velocity)
                self.values[f"{own}/limits"] = tuple(map(float, bounds))
                self.values[f"{own}/dynamics"] = tuple(
                    map(
                        float,
                        (
                            dynamics.damping,
                            dynamics.friction,
                            dynamics.spring_reference,
                            dynamics.spring_stiffness,
                        ),
                    )
                )
        self.sensors(key, joint, joint.sensors)

    def pose(self, key: str, pose: Array) -> None:
        self.values[f"{key}/pose"] = tuple(pose[:3].ravel())


def upper(moments: Array) -> tuple[float, ...]:
    return tuple(float(moments[row, column]) for row in range(3) for column in range(row, 3))


def same(key: str, their: Value, our: Value) -> bool:
    if isinstance(their, str) or isinstance(our, str):
        return their == our
    if key.endswith("/pose"):
        their = (*_matrix(their),)
    if key.endswith("/limits"):
        their = tuple(math.copysign(math.inf, bound) if abs(bound) >= ENDLESS else bound for bound in their)
    allowed = COLOR_TOLERANCE if key.rpartition("/")[2] in LIGHTS else TOLERANCE
    return len(their) == len(our) and all(
        a == b or math.isclose(a, b, rel_tol=allowed, abs_tol=allowed)
        for a, b in zip(their, our, strict=True)
    )


def _matrix(pose: tuple[float, ...]) -> Iterator[float]:
    """The three upper rows of a transform from position and quaternion, x y z w."""
    *at, x, y, z, w = pose
    rows = (
        (1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)),
        (2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)),
        (2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)),
    )
    for row, place in zip(rows, at, strict=True):
        yield from (*row, place)


def disagreements(program: Path, paths: Iterable[Path]) -> tuple[int, dict[str, int], list[str]]:
    """How many files and values (by what they are) were compared, and which differ."""
    counts: dict[str, int] = defaultdict(int)
    wrong = []
    read = theirs(program, paths)
    for path, values in read.items():
        try:
            ours = Ours(path).values
        except (DescriptionError, PoseError) as error:
            wrong.append(f"{path}: {error}")
            continue
        for key, their in values.items():
            counts[key.rpartition("/")[2]] += 1
            if key not in ours:
                wrong.append(f"{path}: {key} is missing")
            elif not same(key, their, ours[key]):
                wrong.append(f"{path}: {key}: {their} and not {ours[key]}")
    return len(read), counts, wrong


def is_known(path: Path) -> bool:
    """Whether a file is of a version that this libsdformat has: it takes newer ones, and ignores what is new."""
    document = Library().document(path)
    version = Version.parse(document.version or "") if document is not None else None
    return version is not None and version <= NEWEST_KNOWN


@pytest.mark.skipif(not SHARED.is_dir(), reason="the files to compare on are not here")
def test_values_of_real_models(program: Path) -> None:
    paths = [
        path
        for kind in ("*.sdf", "*.world")
        for path in (SHARED / "corpus").rglob(kind)
        if path.stat().st_size <= MOST_BYTES and is_known(path)
    ]
    files, counts, wrong = disagreements(program, sorted(paths))
    assert not wrong, "\n".join(wrong)
    assert files >= LEAST_FILES
    assert sum(counts.values()) >= LEAST_VALUES
    assert {
        "mass",
        "moments",
        "center",
        "pose",
        "limits",
        "dynamics",
        "diffuse",
        "update_rate",
        "mesh",
    } <= set(counts)


ODD = """\
<sdf version="1.9" xmlns:x="urn:x"><model name="odd">
  <link name="attribute"><inertial><mass value="500"/></inertial></link>
  <link name="blank"><inertial><mass> 2 </mass><inertia><ixx>0.5</ixx></inertia></inertial></link>
  <link name="joined"><pose>1 2 3 0.1 0.2 0.3</pose>
    <inertial><pose>0 0 1 1 0 0</pose></inertial>
    <visual name="v"><geometry><x:y/><box size="1 2 3"/></geometry>
      <material><diffuse>1 0 0.5</diffuse></material></visual>
    <collision name="c"><geometry><cylinder><radius>0.5</radius></cylinder></geometry></collision>
    <sensor name="s" type="imu"><update_rate> 30 </update_rate></sensor>
  </link>
  <joint name="j" type="revolute"><parent>attribute</parent><child>joined</child>
    <axis><xyz>0 0 3</xyz><limit><lower>-1</lower></limit><dynamics/></axis></joint>
</model></sdf>
"""


def test_values_that_are_written_oddly(program: Path, tmp_path: Path) -> None:
    path = tmp_path / "odd.sdf"
    path.write_text(ODD, encoding="utf-8")
    files, counts, wrong = disagreements(program, [path])
    assert not wrong, "\n".join(wrong)
    assert files == 1
    assert counts["mass"] == 3
