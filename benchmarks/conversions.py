"""URDF to SDFormat, measured: one file as a process, and a folder of files in one run."""

from __future__ import annotations

import statistics
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

from benchmarks.process import installed, measure

CONVERT = [installed("sdfcheck"), "convert", "urdf-to-sdf", "--isolated", "--quiet"]
FILES = 100
SIZE = 20_000

LINK = """\
  <link name="link_{number}">
    <inertial>
      <origin xyz="0 0.01 0.12" rpy="0 0 0"/>
      <mass value="{mass}"/>
      <inertia ixx="0.012" ixy="0" ixz="0.001" iyy="0.011" iyz="0" izz="0.004"/>
    </inertial>
    <visual>
      <origin xyz="0 0 0.125" rpy="0 0.3 0"/>
      <geometry>
        <cylinder radius="0.05" length="0.25"/>
      </geometry>
      <material name="grey"/>
    </visual>
    <collision>
      <origin xyz="0 0 0.125" rpy="0 0.3 0"/>
      <geometry>
        <box size="0.1 0.1 0.25"/>
      </geometry>
    </collision>
  </link>
"""
JOINT = """\
  <joint name="joint_{number}" type="{kind}">
    <origin xyz="0.02 0 0.25" rpy="{tilt} 0 0.2"/>
    <parent link="link_{parent}"/>
    <child link="link_{number}"/>
    <axis xyz="0 {across} 1"/>
    <limit lower="-1.5" upper="1.5" effort="40" velocity="2"/>
    <dynamics damping="0.1" friction="0.02"/>
  </joint>
"""
BLOCK = """\
  <gazebo reference="link_{number}">
    <mu1>0.8</mu1>
    <mu2>0.8</mu2>
  </gazebo>
"""


class Timing(NamedTuple):
    """Seconds: the median and the shortest of the runs."""

    name: str
    files: int
    size: int
    median: float
    shortest: float


def urdf(name: str, size: int) -> str:
    """A tree of links with all that is usual, of about ``size`` characters."""
    parts = [f'<?xml version="1.0"?>\n<robot name="{name}">\n']
    parts.append('  <material name="grey">\n    <color rgba="0.5 0.5 0.5 1"/>\n  </material>\n')
    number, written = 0, 0
    while written < size:
        mass = 0.5 + number % 5 / 10
        kind = "fixed" if number % 4 == 3 else "revolute"
        made = LINK.format(number=number, mass=mass) + BLOCK.format(number=number)
        if number:
            parent = number - 1 if number % 3 else number // 2
            joint = JOINT.format(
                number=number, kind=kind, parent=parent, tilt=number % 7 / 10, across=number % 2
            )
            # On a fixed joint they would mean nothing.
            lines = joint.splitlines(keepends=True)
            made += "".join(lines[:4] + lines[-1:]) if kind == "fixed" else joint
        parts.append(made)
        written += len(made)
        number += 1
    return "".join(parts) + "</robot>\n"


def write_urdfs(folder: Path, files: int) -> list[Path]:
    """Robots of 3 to 32 kB, as sizes usually are: many small, a few large."""
    folder.mkdir(parents=True)
    made = []
    for number in range(files):
        path = folder / f"robot_{number}.urdf"
        path.write_text(urdf(path.stem, 3_000 + 29_000 * (number % 10) ** 2 // 81))
        made.append(path)
    return made


def timings(folder: Path, factor: float) -> Iterator[Timing]:
    """Measure below a folder; ``factor`` scales the number of runs."""
    single = folder / "single.urdf"
    single.write_text(urdf("single", SIZE))
    target = ["-o", str(folder / "single.sdf")]
    yield _timing("one URDF file", [single], [*CONVERT, str(single), *target], folder, round(15 * factor))
    robots = write_urdfs(folder / "urdf", FILES)
    target = ["--output-dir", str(folder / "sdf")]
    command = [*CONVERT, *map(str, robots), *target]
    yield _timing(f"a folder of {FILES} URDF files", robots, command, folder, round(5 * factor))


def _timing(name: str, files: list[Path], command: list[str], folder: Path, runs: int) -> Timing:
    measure(command, folder)
    seconds = [measure(command, folder).seconds for _ in range(max(3, runs))]
    size = sum(file.stat().st_size for file in files)
    return Timing(name, len(files), size, statistics.median(seconds), min(seconds))


def table(results: list[Timing]) -> Iterator[str]:
    """The results as a Markdown table."""
    yield "| conversion, verified | size | median | shortest | a file |"
    yield "|---|--:|--:|--:|--:|"
    for one in results:
        cells = [one.name, f"{one.size / 1e3:.0f} kB"]
        cells += [
            f"{seconds * 1000:.0f} ms" for seconds in (one.median, one.shortest, one.median / one.files)
        ]
        yield f"| {' | '.join(cells)} |"
