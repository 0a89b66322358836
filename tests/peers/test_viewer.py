"""The page of a robot in headless Chromium: no errors, no foreign script, links where our kinematics has them."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import sdfcheck
from sdfcheck.robot.motion.flatten import mechanism_of
from sdfcheck.robot.motion.mechanism import link_poses
from sdfcheck.robot.root import root_of
from sdfcheck.view.scene import MOST_SHAPES
from tests.peers import chromium
from tests.peers.viewed import panel, sdf, show

pytestmark = [
    pytest.mark.peers,
    pytest.mark.skipif(chromium.missing() is not None, reason=chromium.missing() or ""),
]

FIXTURES = Path(__file__).parents[2] / "fixtures"
WHOLE = sorted(
    file
    for pattern in ("robots/**/*.*", "api/*.*", "tutorial/*.urdf")
    for file in FIXTURES.glob(pattern)
    if file.suffix in {".sdf", ".urdf", ".world", ".xacro"}
    and "macros" not in file.parts
    and file.name != "gripper.urdf.xacro"  # cannot be expanded
)
ROBOTS = [*WHOLE, *sorted(FIXTURES.glob("convert/*/*/input.*f"))[::6]]
ARM = FIXTURES / "robots" / "desk_arm" / "desk_arm.urdf"


@pytest.fixture(scope="module")
def tab() -> Iterator[chromium.Tab]:
    with chromium.tab() as opened:
        yield opened


def test_robots_and_worlds_without_an_error(tab: chromium.Tab, tmp_path: Path) -> None:
    assert len(ROBOTS) >= 20
    errors = {}
    for file in ROBOTS:
        show(tab, tmp_path, file)
        tab.run("document.querySelectorAll('fieldset input[type=checkbox]').forEach(box => box.click())")
        tab.run("viewer.draw()")
        if tab.errors:
            errors[str(file.relative_to(FIXTURES))] = list(tab.errors)
    assert not errors


@pytest.mark.parametrize(
    "robot",
    ["desk_arm/desk_arm.urdf", "diff_drive/model.sdf", "two_link_arm/model.sdf", "workcell/workcell.world"],
)
def test_sliders_move_links_as_our_kinematics_does(robot: str, tab: chromium.Tab, tmp_path: Path) -> None:
    file = FIXTURES / "robots" / robot
    show(tab, tmp_path, file)
    set_all = """part => [...document.querySelectorAll('input[data-joint]')].map((input, index) => {
        input.value = Number(input.min) + (input.max - input.min) * ((part + index * 0.37) % 1);
        input.dispatchEvent(new Event('input'));
        return [input.dataset.joint, Number(input.value)];
    })"""
    root = root_of(sdfcheck.load(file).document)
    models = root.models or root.worlds[0].models
    for part in (0.0, 0.21, 0.77):
        positions = {name: np.array([[value]]) for name, value in tab.run(set_all, part)}
        drawn = tab.run("viewer.poses()")
        for model in models:
            mechanism = mechanism_of(model, vendors=True)
            own = {name: value for name, value in positions.items() if name in mechanism.joints}
            for name, pose in link_poses(mechanism, own).items():
                seen = np.array(drawn[model.name][name]).reshape(4, 4).T
                assert np.allclose(seen, pose[0], atol=1e-6), (part, name)
    assert positions


@pytest.mark.skipif(chromium.missing_axe() is not None, reason=chromium.missing_axe() or "")
@pytest.mark.parametrize("files", [[ARM.parents[1] / "with_mistakes" / "warehouse.world"], [ARM, ARM]])
def test_accessible(files: list[Path], tab: chromium.Tab, tmp_path: Path) -> None:
    for colors in ("light", "dark"):
        tab.page.emulate_media(color_scheme=colors)
        show(tab, tmp_path, *files)
        assert tab.faults() == [], colors


def test_names_bring_no_script(tab: chromium.Tab, tmp_path: Path) -> None:
    name = (
        "&lt;/script>&lt;img src=x onerror=alert(1)>&lt;svg onload=alert(2)>&lt;script>alert(3)&lt;/script>"
    )
    file = sdf(
        tmp_path,
        f'<link name="{name}"><visual name="{name}"><geometry><mesh><uri>{name}.stl</uri></mesh></geometry></visual>'
        f'</link><link name="b"/><joint name="{name}_" type="revolute"><parent>b</parent><child>{name}</child>'
        "<axis><xyz>0 0 1</xyz></axis></joint>",
    )
    show(tab, tmp_path, file, file)
    tab.page.click("text=onerror=alert(1)")
    assert tab.dialogs == []
    assert tab.errors == []
    assert tab.run("document.querySelectorAll('img, svg').length") == 0
    assert "onerror=alert(1)" in panel(tab)


def test_a_thousand_links(tab: chromium.Tab, tmp_path: Path) -> None:
    shape = "<visual name='v'><geometry><box><size>.1 .1 .1</size></box></geometry></visual>"
    links = "".join(
        f'<link name="l{number}"><pose>0 0 {number / 10} 0 0 0</pose>{shape}</link>' for number in range(1000)
    )
    joints = "".join(
        f'<joint name="j{number}" type="revolute"><parent>l{number - 1}</parent>'
        f"<child>l{number}</child><axis><xyz>0 1 0</xyz></axis></joint>"
        for number in range(1, 1000)
    )
    show(tab, tmp_path, sdf(tmp_path, links, joints))
    assert tab.errors == []
    assert tab.page.locator("[role=treeitem].link").count() == 1000
    assert tab.page.locator("[role=treeitem].joint").count() == 999
    tab.page.click("summary:has-text('Joints of m (999)')")
    tab.page.locator("input[data-joint]").nth(998).wait_for(state="attached")
    assert tab.page.locator(".slider").count() == 999


@pytest.mark.parametrize("pose", ["nan nan nan nan nan nan", "1e300 0 0 0 0 0", "inf 0 0 0 0 0", "a b c"])
def test_poses_that_are_not_numbers(pose: str, tab: chromium.Tab, tmp_path: Path) -> None:
    shape = "<geometry><sphere><radius>nan</radius></sphere></geometry>"
    file = sdf(
        tmp_path,
        f"<link name='a'><pose>{pose}</pose><visual name='v'><pose>{pose}</pose>{shape}</visual>"
        f"<inertial><pose>{pose}</pose><mass>nan</mass></inertial></link><link name='b'/>",
    )
    show(tab, tmp_path, file)
    tab.run("viewer.draw()")
    assert tab.errors == []
    assert "m" in panel(tab)


def test_an_inertia_that_means_infinity(tab: chromium.Tab, tmp_path: Path) -> None:
    moments = "".join(f"<{name}>1e40</{name}>" for name in ("ixx", "iyy", "izz"))
    show(
        tab,
        tmp_path,
        sdf(tmp_path, f"<link name='l'><inertial><inertia>{moments}</inertia></inertial></link>"),
    )
    if not tab.page.is_checked("#show-inertias"):
        tab.page.click("#show-inertias")
    tab.page.click("text=Fit")
    grid = tab.run("document.getElementById('legend').textContent")
    assert float(grid.removeprefix("grid: ").removesuffix(" m")) < 1e6
    assert tab.errors == []


def test_many_shapes_take_few_drawing_calls(tab: chromium.Tab, tmp_path: Path) -> None:
    shapes = ("<box><size>1 1 1</size></box>", "<sphere><radius>.5</radius></sphere>")
    links = (
        f"<link name='l{number}'><pose>{number} 0 0 0 0 0</pose><visual name='v'><geometry>{shapes[number % 2]}"
        "</geometry></visual></link>"
        for number in range(MOST_SHAPES + 1)
    )
    show(tab, tmp_path, sdf(tmp_path, *links))
    assert tab.errors == []
    assert f"{MOST_SHAPES + 1} shapes: drawn with few corners" in panel(tab)
    assert tab.run("viewer.draw()") < 20
    tab.page.click("[data-part=l6]")
    assert tab.run("viewer.size()") == pytest.approx([1, 1, 1])


@pytest.mark.parametrize("axis", ["0 0 1", "0 -1 0"])
def test_where_two_robots_differ_most(axis: str, tab: chromium.Tab, tmp_path: Path) -> None:
    other = tmp_path / "other.urdf"
    other.write_text(ARM.read_text().replace('<axis xyz="0 1 0"/>', f'<axis xyz="{axis}"/>', 1))
    show(tab, tmp_path, ARM, other)
    assert tab.run("viewer.marked(0)") == []  # at zero all links are in the same places
    tab.page.click("button.most")
    said = tab.run("document.querySelector('.said').textContent")
    drawn = [tab.run("number => viewer.poses(number)", number)["desk_arm"] for number in (0, 1)]
    seen = max(apart(*(np.array(robot[name]).reshape(4, 4).T for robot in drawn)) for name in drawn[0])
    assert f"{seen:.3g} m apart" in said
    assert seen > 0.97 * best(ARM, other)
    assert "visual forearm" in tab.run("viewer.marked(0)")
    assert tab.errors == []


def apart(a: np.ndarray[Any, Any], b: np.ndarray[Any, Any]) -> float:
    """The largest distance between the origins and the points at 0.1 m along the axes."""
    points = np.c_[np.zeros(3), 0.1 * np.eye(3)]
    shift = (a[:3, :3] - b[:3, :3]) @ points + (a[:3, 3] - b[:3, 3])[:, None]
    return float(np.linalg.norm(shift, axis=0).max())


def best(a: Path, b: Path) -> float:
    """The largest distance in random configurations, by our kinematics."""
    robots = [mechanism_of(root_of(sdfcheck.load(file).document).models[0]) for file in (a, b)]
    random = np.random.default_rng(3)
    positions = {
        joint.name: random.uniform(max(joint.axes[0].lower, -4), min(joint.axes[0].upper, 4), (300, 1))
        for joint in robots[0].joints.values()
        if joint.moves and joint.axes[0].mimic is None
    }
    first, second = (link_poses(robot, positions) for robot in robots)
    return max(
        apart(*pair)
        for name in first
        for pair in zip(*np.broadcast_arrays(first[name], second[name]), strict=True)
    )


def test_a_lost_shape_is_marked(tab: chromium.Tab, tmp_path: Path) -> None:
    text = ARM.read_text()
    start = text.index("<collision", text.index('<link name="column"'))
    end = text.index("</collision>", start) + len("</collision>")
    other = tmp_path / "other.urdf"
    other.write_text(text[:start] + text[end:])
    show(tab, tmp_path, ARM, other)
    assert tab.run("viewer.marked(0)") == ["collision column"]
    assert tab.run("viewer.marked(1)") == []
    assert tab.page.is_checked("#show-collisions")


def test_the_fragment_selects_a_part(tab: chromium.Tab, tmp_path: Path) -> None:
    show(tab, tmp_path, ARM)
    tab.page.click("[data-part=forearm]")
    fragment = tab.run("location.hash")
    tab.open(tmp_path / "out.html", fragment)
    tab.page.wait_for_selector("html[data-ready]")
    assert tab.run("document.querySelector('[aria-selected=true] .name').textContent") == "forearm"
