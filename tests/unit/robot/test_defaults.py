"""The values of a robot's parts, and what they are where a file says nothing."""

from __future__ import annotations

from collections import defaultdict

import pytest

import sdfcheck
from sdfcheck.robot.part import Part

TEXT = """<sdf version="1.12"><world name="w">{world}<physics type="ode">{physics}</physics>
  <light name="i" type="spot">{light}</light>
  <model name="m"><link name="a">
    <inertial>{inertial}</inertial><collision name="c">{collision}</collision>
    <sensor name="s" type="imu">{sensor}</sensor></link><link name="b"/>
  <joint name="lead" type="continuous"><parent>a</parent><child>b</child></joint>
  <joint name="j" type="screw">{joint}<parent>a</parent><child>b</child>
    <axis>{axis}<limit>{limit}</limit><dynamics>{dynamics}</dynamics>
    <mimic joint="lead">{mimic}</mimic></axis></joint></model></world></sdf>"""


def part(place: str, inside: str = "") -> Part:
    """The part at a place of the world above, with something in it."""
    world = sdfcheck.parse(TEXT.format_map(defaultdict(str, {place: inside}))).world("w")
    model = world.model("m")
    link, joint = model.link("a"), model.joint("j")
    parts: dict[str, Part | None] = {
        "world": world,
        "physics": world.physics[0],
        "light": world.lights[0],
        "inertial": link.inertial,
        "collision": link.collisions[0],
        "sensor": link.sensors[0],
        "joint": joint,
        "axis": joint.axis,
        "limit": joint.axis.limit,
        "dynamics": joint.axis.dynamics,
        "mimic": joint.axis.mimic,
    }
    found = parts[place]
    assert found is not None
    return found


@pytest.mark.parametrize(
    ("place", "name"),
    [
        ("world", "gravity"),
        ("physics", "max_step_size"),
        ("physics", "real_time_factor"),
        ("light", "direction"),
        ("light", "diffuse"),
        ("light", "specular"),
        ("light", "intensity"),
        ("inertial", "mass"),
        ("inertial", "density"),
        ("collision", "density"),
        ("sensor", "update_rate"),
        ("joint", "screw_thread_pitch"),
        ("joint", "thread_pitch"),
        ("joint", "gearbox_ratio"),
        ("axis", "xyz"),
        ("limit", "lower"),
        ("limit", "upper"),
        ("limit", "effort"),
        ("limit", "velocity"),
        ("limit", "stiffness"),
        ("limit", "dissipation"),
        ("dynamics", "damping"),
        ("dynamics", "friction"),
        ("dynamics", "spring_reference"),
        ("dynamics", "spring_stiffness"),
        ("mimic", "multiplier"),
        ("mimic", "offset"),
        ("mimic", "reference"),
    ],
)
def test_a_value_is_what_is_written_or_that_of_the_specification(place: str, name: str) -> None:
    silent = part(place)
    assert getattr(silent, name) == silent.setting(name)
    written, number = (
        ("0.25 0.5 1", (0.25, 0.5, 1)) if isinstance(getattr(silent, name), tuple) else ("0.25", 0.25)
    )
    assert getattr(part(place, f"<{name}>{written}</{name}>"), name) == number
