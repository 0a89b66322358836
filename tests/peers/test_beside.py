"""The robot beside its text, in headless Chromium: it follows, keeps what a person has set, and leads back."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from sdfcheck.view.page import live_page
from tests.peers import chromium
from tests.peers.editor import Editor, editor, waited

pytestmark = [
    pytest.mark.peers,
    pytest.mark.skipif(chromium.missing() is not None, reason=chromium.missing() or ""),
]

ROBOT = """\
<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:arg name="side" default="left"/>
  <xacro:arg name="tall" default="false"/>
  <link name="base">
    <visual><geometry><box size="0.4 0.4 ${2 if '$(arg tall)' == 'true' else 0.2}"/></geometry></visual>
    <inertial><mass value="-1"/><inertia ixx="0.0167" ixy="0" ixz="0" iyy="0.0167" iyz="0" izz="0.0267"/></inertial>
  </link>
  <link name="$(arg side)_arm">
    <visual><origin xyz="0.5 0 0"/><geometry><mesh filename="arm.obj"/></geometry></visual>
  </link>
  <joint name="turn" type="revolute">
    <parent link="base"/><child link="$(arg side)_arm"/>
    <origin xyz="0 0 0.2"/><axis xyz="0 0 1"/><limit lower="-1" upper="1" effort="1" velocity="1"/>
  </joint>
</robot>
"""
MESH = "v 0 -0.1 0\nv 1 0 0\nv 0 0.1 0\nv 0 0 0.1\nf 1 2 3\nf 1 2 4\nf 2 3 4\nf 1 3 4\n"


IMAGE = """new Promise(done => {
    const image = new Image();
    image.onerror = () => done('refused');
    image.onload = () => done('sent');
    image.src = 'http://127.0.0.1:9/x.png';
})"""


class Beside:
    """An editor with a text, and the page of its robot."""

    def __init__(self, tab: chromium.Tab, with_text: Editor, path: Path) -> None:
        self.tab, self.editor, self.path = tab, with_text, path
        self.text = ROBOT
        with_text.open(path, ROBOT)
        self.address = tab.server = with_text.command("sdfcheck.showRobot", path)
        tab.errors.clear()
        tab.page.goto("about:blank")
        tab.page.goto(self.address)
        self.waited("window.viewer && viewer.poses().r.left_arm")
        self.waited("!document.body.textContent.includes('arm.obj')")

    def waited(self, script: str) -> None:
        """Come back when an expression is true on the page; what it asks for may not be there yet."""
        waited(
            lambda: self.tab.run(
                f"(() => {{ try {{ return Boolean({script}) }} catch {{ return false }} }})()"
            )
        )

    def type(self, before: str, after: str) -> None:
        assert before in self.text
        self.text = self.text.replace(before, after, 1)
        self.editor.change(self.path, self.text)

    def run(self, script: str) -> Any:
        return self.tab.run(script)


@pytest.fixture(scope="module")
def tab() -> Iterator[chromium.Tab]:
    with chromium.tab() as opened:
        yield opened


@pytest.fixture
def beside(tab: chromium.Tab, tmp_path: Path) -> Iterator[Beside]:
    (tmp_path / "arm.obj").write_text(MESH)
    with editor(tmp_path) as session:
        made = Beside(tab, session, tmp_path / "r.urdf.xacro")
        yield made
        tab.page.goto("about:blank")
    assert tab.errors == []


def test_the_client_is_asked_to_open_the_page(beside: Beside) -> None:
    waited(lambda: beside.editor.shown)
    assert beside.editor.shown[0] == {"uri": beside.address, "external": True}


def test_it_follows_and_keeps_camera_sliders_and_layers(beside: Beside) -> None:
    page = beside.tab.page
    box = page.locator("canvas").bounding_box()
    page.mouse.move(box["x"] + 300, box["y"] + 300)
    page.mouse.down()
    page.mouse.move(box["x"] + 380, box["y"] + 340, steps=4)
    page.mouse.up()
    page.check("#show-frames")
    page.locator("input[data-joint=turn]").fill("0.5")
    page.click("summary:has-text('Joints of r')")
    camera = beside.run("viewer.camera()")
    turned = beside.run("viewer.poses().r.left_arm")
    beside.type('xyz="0 0 0.2"', 'xyz="0 0 0.3"')
    beside.waited("Math.abs(viewer.poses().r.left_arm[14] - 0.3) < 1e-6")
    assert beside.run("viewer.camera()") == pytest.approx(camera)
    moved = beside.run("viewer.poses().r.left_arm")
    assert moved[:12] == pytest.approx(turned[:12])
    assert moved[0] == pytest.approx(0.87758, abs=1e-4)
    assert page.locator("input[data-joint=turn]").input_value() == "0.5"
    assert page.is_checked("#show-frames")
    assert page.locator("details:has(> summary:has-text('Joints of r'))").get_attribute("open") is None


def test_a_broken_text_leaves_the_last_robot_with_a_note(beside: Beside) -> None:
    beside.type('<link name="base">', '<link name="base"')
    beside.waited("!document.getElementById('note').hidden")
    assert "robot from before" in beside.run("document.getElementById('note').textContent")
    assert "base" in beside.run("viewer.poses().r")
    beside.type('<link name="base"', '<link name="base">')
    beside.waited("document.getElementById('note').hidden")


def test_a_click_leads_to_the_line(beside: Beside) -> None:
    beside.editor.shown.clear()
    beside.tab.page.click("#tree [data-part=left_arm]")
    waited(lambda: beside.editor.shown)
    (shown,) = beside.editor.shown
    assert shown["uri"] == beside.path.as_uri()
    line = ROBOT[: ROBOT.index('<link name="$(arg side)')].count("\n")
    assert shown["selection"] == {
        "start": {"line": line, "character": 3},
        "end": {"line": line, "character": 7},
    }
    assert "external" not in shown or not shown["external"]


def test_a_click_in_the_picture_leads_to_the_line(beside: Beside) -> None:
    beside.editor.shown.clear()
    x, y = beside.run("viewer.onScreen('base')")
    beside.tab.page.mouse.click(x, y)
    waited(lambda: beside.editor.shown)
    assert beside.editor.shown[0]["selection"]["start"]["line"] == 3


def test_the_cursor_marks_its_part(beside: Beside) -> None:
    line = ROBOT[: ROBOT.index("arm.obj")].count("\n")
    beside.editor.command("sdfcheck.cursor", beside.path, position={"line": line, "character": 20})
    beside.waited("document.querySelector('[aria-selected=true]')?.dataset.part === 'left_arm'")
    assert beside.run("viewer.size()") == pytest.approx([1, 0.2, 0.1], abs=1e-3)


def test_findings_are_marked_on_their_bodies(beside: Beside) -> None:
    beside.waited("viewer.findingMarks().includes('base')")
    beside.editor.shown.clear()
    beside.tab.page.click("button.entry.error:has-text('mass')")
    waited(lambda: beside.editor.shown)
    start = beside.editor.shown[0]["selection"]["start"]
    assert ROBOT.split("\n")[start["line"]][start["character"] :].startswith("-1")
    beside.type('value="-1"', 'value="1"')
    beside.waited("!viewer.findingMarks().includes('base')")


def test_arguments_are_chosen_in_the_view(beside: Beside) -> None:
    page = beside.tab.page
    page.locator("#argument-side").fill("right")
    page.locator("#argument-side").press("Enter")
    beside.waited("viewer.poses().r.right_arm")
    page.locator("#argument-tall").select_option("true")
    page.click("#tree [data-part=base]")
    beside.waited("Math.abs(viewer.size()[2] - 2) < 1e-6")
    assert page.locator("#argument-side").input_value() == "right"


def test_the_page_talks_to_nothing_but_its_server(beside: Beside) -> None:
    for script in (
        "fetch('http://127.0.0.1:9/').then(() => 'sent', () => 'refused')",
        "fetch('https://sdfcheck.example/').then(() => 'sent', () => 'refused')",
        IMAGE,
    ):
        assert beside.run(script) == "refused"
    refused = [each for each in beside.tab.errors if "Content Security Policy" in each]
    assert len(refused) >= 3
    beside.tab.errors.clear()


def test_the_end_of_the_session_is_noted(beside: Beside) -> None:
    beside.editor.ask("shutdown")
    beside.editor.notify("exit")
    beside.waited("document.getElementById('note').textContent.includes('ended the connection')")
    beside.tab.errors.clear()


def test_the_page_of_an_editor_talks_to_the_editor_alone(tab: chromium.Tab, tmp_path: Path) -> None:
    page = live_page("r.urdf", "editor").replace(
        "<script type", "<script>window.x = 1</script><script type", 1
    )
    (tmp_path / "page.html").write_text(page)
    tab.page.add_init_script(
        "window.said = []; window.acquireVsCodeApi = () => ({postMessage: each => said.push(each)})"
    )
    tab.open(tmp_path / "page.html")
    tab.page.wait_for_selector("h1")
    assert tab.run("said") == [{"kind": "ready"}]
    assert tab.run("window.x ?? null") is None  # no script but the page's own
    scene = {"file": "r.urdf", "models": [], "lights": [], "notes": []}
    robot = {
        "scenes": [scene],
        "meshes": [],
        "findings": [],
        "heading": "Findings",
        "differences": [],
        "mostShapes": 9,
    }
    tab.run("news => postMessage(news, '*')", {"kind": "robot", "note": "a note", "page": robot})
    tab.page.wait_for_selector("html[data-ready]")
    assert tab.run("document.getElementById('note').textContent") == "a note"
