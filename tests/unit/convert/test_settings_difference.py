"""Changes in the settings of a robot: sensors, plugins, materials, surfaces, custom data."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.unit.convert.test_difference import ARM, URDF, changes, edited

FURNISHED = (
    "<sdf version='1.10' xmlns:shop='urn:shop'><world name='w'><physics name='p' type='ode'>"
    "<max_step_size>0.001</max_step_size></physics><light name='sun' type='point'><intensity>1</intensity></light>"
    "<model name='arm' shop:article='17'><plugin name='p' filename='p.so'><gain>1</gain></plugin>"
    "<link name='base'><inertial><mass>1</mass><inertia><ixx>1</ixx></inertia></inertial>"
    "<visual name='v'><geometry><mesh><uri>m.obj</uri><scale>1 1 1</scale></mesh></geometry>"
    "<material><diffuse>1 0 0</diffuse></material></visual>"
    "<collision name='c'><geometry><box><size>1 1 1</size></box></geometry>"
    "<surface><friction><ode><mu>0.5</mu></ode></friction></surface></collision>"
    "<sensor name='cam' type='camera'><update_rate>30</update_rate><pose>0 0 1 0 0 0</pose></sensor>"
    "<light name='lamp' type='spot'><attenuation><range>5</range></attenuation></light></link>"
    "<link name='fore'><inertial><mass>2</mass></inertial></link>"
    "<joint name='elbow' type='revolute'><parent>base</parent><child>fore</child><axis><xyz>0 1 0</xyz>"
    "<limit><lower>-1</lower><upper>1</upper></limit><dynamics><damping>1</damping></dynamics></axis>"
    "<physics><ode><cfm_damping>true</cfm_damping></ode></physics></joint>"
    "<frame name='f' attached_to='base'><pose>0 0 1 0 0 0</pose></frame></model></world></sdf>"
)


@pytest.mark.parametrize(
    ("old", "new", "expected"),
    [
        ("<xyz>0 1 0<", "<xyz>0 -1 0<", ("joint", "elbow", "direction", "0 1 0", "0 -1 0")),
        ("<ixx>1<", "<ixx>2<", ("link", "base", "ixx", "1", "2")),
        ("<upper>1<", "<upper>2<", ("joint", "elbow", "upper", "1", "2")),
        ("<scale>1 1 1<", "<scale>2 2 2<", ("link", "base", "visual `v` size", "1 1 1", "2 2 2")),
        ("<diffuse>1 0 0<", "<diffuse>0 1 0<",
         ("link", "base", "visual `v`/material/diffuse", "1 0 0 1", "0 1 0 1")),
        ("<update_rate>30<", "<update_rate>60<", ("link", "base", "sensor `cam`/update_rate", "30", "60")),
        ("<gain>1<", "<gain>2<", ("model", "arm", "plugin `p`/gain", "1", "2")),
        ("attached_to='base'><pose>0 0 1", "attached_to='base'><pose>0 0 2",
         ("frame", "f", "pose in `base`", "0 0 1 0 0 0", "0 0 2 0 0 0")),
        ("<size>1 1 1<", "<size>1 1 2<", ("link", "base", "collision `c` size", "1 1 1", "1 1 2")),
        ("<damping>1<", "<damping>3<", ("joint", "elbow", "damping", "1", "3")),
        ("<mu>0.5<", "<mu>0.9<", ("link", "base", "collision `c`/surface/friction/ode/mu", "0.5", "0.9")),
        ("'camera'><update_rate>30</update_rate><pose>0 0 1", "'camera'><update_rate>30</update_rate><pose>0 0 2",
         ("link", "base", "sensor `cam`/pose", "0 0 1 0 0 0", "0 0 2 0 0 0")),
        ("<range>5<", "<range>6<", ("link", "base", "light `lamp`/attenuation/range", "5", "6")),
        ("<max_step_size>0.001<", "<max_step_size>0.002<",
         ("world", "w", "physics `p`/max_step_size", "0.001", "0.002")),
        ("<intensity>1<", "<intensity>2<", ("world", "w", "light `sun`/intensity", "1", "2")),
        ("cfm_damping>true", "cfm_damping>false",
         ("joint", "elbow", "physics/ode/cfm_damping", "true", "false")),
        ("<axis>", "<axis shop:side='left'>", ("joint", "elbow", "shop:side", "none", "left")),
        ("shop:article='17'", "shop:article='18'", ("model", "arm", "@shop:article", "17", "18")),
        ("<plugin name='p' filename='p.so'><gain>1</gain></plugin>", "",
         ("model", "arm", "plugin `p`", "p.so", "none")),
    ],
)  # fmt: skip
def test_one_edit_of_a_setting_is_one_change(
    tmp_path: Path, old: str, new: str, expected: tuple[str, ...]
) -> None:
    assert edited(tmp_path, old, new, FURNISHED) == [expected]


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("<update_rate>30<", "<update_rate>30.0<"),
        ("<damping>1<", "<damping>1</damping><spring_stiffness>0</spring_stiffness><damping>1<"),
        ("<gain>1<", "<!-- high --><gain>1<"),
        ("cfm_damping>true", "cfm_damping>1"),
        ("<diffuse>1 0 0<", "<diffuse>1 0 0 1<"),
        ("<mu>0.5</mu>", "<mu>0.5</mu><mu2>1</mu2>"),
        (
            "<sensor name='cam' type='camera'>",
            "<sensor name='cam' type='camera'><always_on>false</always_on>",
        ),
        ("<mesh><uri>", "<mesh optimization=''><uri>"),
        ("<diffuse>1 0 0<", "<shader type='pixel'/><diffuse>1 0 0<"),
    ],
)
def test_other_words_for_a_setting_are_no_change(tmp_path: Path, old: str, new: str) -> None:
    assert old in FURNISHED
    assert changes(tmp_path, FURNISHED, FURNISHED.replace(old, new)) == []


BLOCKS = URDF.replace(
    "</robot>",
    "<gazebo reference='base'><mu1>0.5</mu1><sensor name='cam' type='camera'><update_rate>30</update_rate></sensor>"
    "<turnGravityOff>true</turnGravityOff></gazebo><gazebo><plugin name='p' filename='p.so'><gain>1</gain></plugin>"
    "</gazebo></robot>",
).replace("</visual>", "<material name='red'><color rgba='1 0 0 1'/></material></visual>"
          "<collision><geometry><box size='1 1 1'/></geometry></collision>")  # fmt: skip


@pytest.mark.parametrize(
    ("old", "new", "expected"),
    [
        ("<mu1>0.5", "<mu1>0.6", ("link", "base", "collision/surface/friction/ode/mu", "0.5", "0.6")),
        ("<update_rate>30", "<update_rate>31", ("link", "base", "sensor `cam`/update_rate", "30", "31")),
        ("<gain>1", "<gain>2", ("model", "arm", "plugin `p`/gain", "1", "2")),
        ("rgba='1 0 0 1'", "rgba='1 0 1 1'",
         ("link", "base", "visual/material/diffuse", "1 0 0 1", "1 0 1 1")),
        ("Off>true", "Off>false", ("link", "base", "gravity", "false", "true")),
    ],
)  # fmt: skip
def test_one_edit_of_a_gazebo_block_is_one_change(
    tmp_path: Path, old: str, new: str, expected: tuple[str, ...]
) -> None:
    assert edited(tmp_path, old, new, BLOCKS) == [expected]


@pytest.mark.parametrize(("file", "count"), [("arm.yaml", 0), ("leg.yaml", 1)])
def test_paths_to_one_file_may_differ_between_formats(tmp_path: Path, file: str, count: int) -> None:
    plugin = "<plugin name='p' filename='p.so'><file>{}</file></plugin>"
    urdf = URDF.replace(
        "</robot>", f"<gazebo>{plugin.format('package://arm/config/arm.yaml')}</gazebo></robot>"
    )
    sdf = ARM.replace("</model>", f"{plugin.format('model://arm/' + file)}</model>")
    whats = [change.what for change in changes(tmp_path, urdf, sdf)]
    assert whats.count("plugin `p`/file") == count


def test_settings_of_a_merged_model_are_those_of_the_model_that_it_is_merged_into(tmp_path: Path) -> None:
    model = (
        "<sdf version='1.10'><model name='{}'><plugin name='p' filename='p.so'><gain>{}</gain></plugin>"
        "<link name='l'/></model></sdf>"
    )
    include = (
        "<sdf version='1.10'><model name='m'><include merge='true'><uri>{}.sdf</uri></include></model></sdf>"
    )
    for name, gain in (("one", 1), ("two", 2)):
        (tmp_path / f"{name}.sdf").write_text(model.format("part", gain))
    found = changes(tmp_path, include.format("one"), include.format("two"))
    assert [(change.name, change.what, change.before, change.after) for change in found] == [
        ("m", "plugin `p`/gain", "1", "2")
    ]


@pytest.mark.parametrize(
    ("setting", "part", "what"),
    [
        ("<physics><ode><limit><cfm>{}</cfm></limit></ode></physics>", "joint", "physics/ode/limit/cfm"),
        (
            "<sensor name='s' type='imu'><update_rate>{}</update_rate></sensor>",
            "link",
            "sensor `s`/update_rate",
        ),
    ],
)
def test_where_a_joint_has_the_name_of_a_link_a_setting_is_of_one(
    tmp_path: Path, setting: str, part: str, what: str
) -> None:
    block = f"<gazebo reference='fore'>{setting.format(1)}</gazebo></robot>"
    text = URDF.replace("name='elbow'", "name='fore'").replace("</robot>", block)
    assert edited(tmp_path, setting.format(1), setting.format(2), text) == [(part, "fore", what, "1", "2")]
