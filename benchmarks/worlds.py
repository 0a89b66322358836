"""Documents to measure with: deterministic, of any size, correct by construction."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

SHAPES = (
    ("<box>\n              <size>0.6 0.4 0.5</size>\n            </box>", (0.034, 0.051, 0.043)),
    (
        (
            "<cylinder>\n              <radius>0.3</radius>\n"
            "              <length>0.8</length>\n            </cylinder>"
        ),
        (0.076, 0.076, 0.045),
    ),
    ("<sphere>\n              <radius>0.4</radius>\n            </sphere>", (0.064, 0.064, 0.064)),
)
"""Shapes of solids of 1 kg, with their principal moments of inertia."""

MODEL = """\
    <model name="solid_{number}">
      <pose>{x:.3f} {y:.3f} 0.5 0 0 {yaw:.3f}</pose>
      <link name="body">
        <inertial>
          <mass>1</mass>
          <inertia>
            <ixx>{ixx}</ixx>
            <iyy>{iyy}</iyy>
            <izz>{izz}</izz>
          </inertia>
        </inertial>
        <collision name="shell_collision">
          <geometry>
            {shape}
          </geometry>
        </collision>
        <visual name="shell_visual">
          <cast_shadows>true</cast_shadows>
          <geometry>
            {shape}
          </geometry>
          <material>
            <ambient>0.{red} 0.4 0.{blue} 1</ambient>
            <diffuse>0.{red} 0.4 0.{blue} 1</diffuse>
            <specular>0.{red} 0.4 0.{blue} 1</specular>
          </material>
        </visual>
      </link>
    </model>
"""

LINK = """\
    <link name="link_{number}">
      <pose relative_to="joint_{number}"/>
      <inertial>
        <pose>0 0 0.1 0 0 0</pose>
        <mass>0.8</mass>
        <inertia>
          <ixx>0.003</ixx>
          <iyy>0.003</iyy>
          <izz>0.0004</izz>
        </inertia>
      </inertial>
      <collision name="tube_collision">
        <pose>0 0 0.1 0 0 0</pose>
        <geometry>
          <cylinder>
            <radius>0.03</radius>
            <length>0.2</length>
          </cylinder>
        </geometry>
      </collision>
    </link>
    <joint name="joint_{number}" type="revolute">
      <pose relative_to="{parent}">0 0 0.2 0 0 0</pose>
      <parent>{parent}</parent>
      <child>link_{number}</child>
      <axis>
        <xyz>0 1 0</xyz>
        <limit>
          <lower>-1.5</lower>
          <upper>1.5</upper>
          <effort>20</effort>
          <velocity>2</velocity>
        </limit>
      </axis>
    </joint>
"""

BASE = """\
    <link name="base">
      <inertial>
        <mass>5</mass>
        <inertia>
          <ixx>0.05</ixx>
          <iyy>0.05</iyy>
          <izz>0.05</izz>
        </inertia>
      </inertial>
    </link>
"""


def write_world(path: Path, models: int) -> Path:
    """A world of solids on a grid, some 930 bytes each."""
    with path.open("w", encoding="utf-8") as file:
        file.write('<?xml version="1.0"?>\n<sdf version="1.9">\n  <world name="solids">\n')
        file.writelines(_solids(models))
        file.write("  </world>\n</sdf>\n")
    return path


def write_robots(folder: Path, robots: int) -> list[Path]:
    """A folder of arms of 1 to 12 joints, one file each."""
    paths = []
    for number in range(robots):
        path = folder / f"arm_{number:04}" / "model.sdf"
        path.parent.mkdir(parents=True)
        links = "".join(
            LINK.format(number=link, parent=f"link_{link - 1}" if link else "base")
            for link in range(number % 12 + 1)
        )
        head = f'<?xml version="1.0"?>\n<sdf version="1.9">\n  <model name="arm_{number}">\n'
        path.write_text(f"{head}{BASE}{links}  </model>\n</sdf>\n", encoding="utf-8")
        paths.append(path)
    return paths


def _solids(models: int) -> Iterator[str]:
    for number in range(models):
        shape, (ixx, iyy, izz) = SHAPES[number % len(SHAPES)]
        row, column = divmod(number, 100)
        yield MODEL.format(
            number=number,
            x=column * 1.25,
            y=row * 1.25,
            yaw=number % 628 / 100,
            shape=shape,
            ixx=ixx,
            iyy=iyy,
            izz=izz,
            red=number % 9,
            blue=number % 7,
        )
