"""Numbers at the edge of what floating point holds, and texts that only look like numbers."""

from __future__ import annotations

from pathlib import Path

import pytest

from sdfcheck.cli.main import main

EXTREME = ["1e308", "-1e308", "1e-320", "1e400", "inf", "nan", "0x10", "-0", "9" * 40, "", "1 2"]
COMMANDS = (["lint", "--select", "ALL"], ["inertia"], ["graph", "poses"], ["graph", "joints"], ["print"])

SDF = (
    '<sdf version="1.9" xmlns:drake="http://drake.mit.edu"><model name="m"><link name="a"><pose>0 0 {0} 0 0 {0}</pose>'
    "<inertial><mass>{0}</mass><inertia><ixx>{0}</ixx><iyy>1</iyy><izz>1</izz><ixy>{0}</ixy></inertia></inertial>"
    '<collision name="c"><geometry><capsule><radius>{0}</radius><length>1</length></capsule></geometry>'
    "<drake:proximity_properties><drake:mesh_resolution_hint>{0}</drake:mesh_resolution_hint>"
    '</drake:proximity_properties></collision></link><link name="b"/><joint name="j" type="revolute">'
    "<parent>a</parent><child>b</child><axis><xyz>0 0 {0}</xyz><limit><lower>{0}</lower></limit></axis></joint>"
    "</model></sdf>"
)
URDF = (
    '<robot name="r"><link name="a"><inertial><origin xyz="0 {0} 0" rpy="0 {0} 0"/><mass value="{0}"/>'
    '<inertia ixx="{0}" ixy="{0}" ixz="0" iyy="1" iyz="0" izz="1"/></inertial><visual>'
    '<origin rpy="0 {0} 0"/><geometry><cylinder radius="{0}" length="1"/></geometry></visual></link>'
    '<link name="b"/><joint name="j" type="revolute"><origin xyz="{0} 0 0"/><parent link="a"/>'
    '<child link="b"/><axis xyz="0 {0} 0"/><limit lower="{0}" effort="1" velocity="1"/></joint></robot>'
)


@pytest.mark.filterwarnings("ignore::RuntimeWarning")
@pytest.mark.parametrize("number", EXTREME)
@pytest.mark.parametrize(("name", "text"), [("m.sdf", SDF), ("r.urdf", URDF)])
def test_no_number_breaks_a_command(
    name: str, text: str, number: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = tmp_path / name
    places = text.count("{0}")
    whole = ["1"] * places
    for at in [*range(places), None]:
        given = [number] * places if at is None else [*whole[:at], number, *whole[at + 1 :]]
        file.write_text(text.replace("{0}", "{}").format(*given))
        for command in COMMANDS:
            main([*command, str(file)])
            output = capsys.readouterr()
            assert "internal error" not in output.err
            assert "INT001" not in output.out
