"""The tools on the page of a robot: look, search, select, hide, move, measure, pass on."""

from __future__ import annotations

import math
import struct
import zlib
from collections.abc import Iterator
from pathlib import Path

import pytest

import sdfcheck
from sdfcheck.lint.diagnostic import Diagnostic, Moment, Severity
from sdfcheck.lint.kinds import SimKind
from sdfcheck.robot.root import root_of
from sdfcheck.view.meshes import Meshes
from sdfcheck.view.notes import findings
from sdfcheck.view.page import page
from sdfcheck.view.scene import scene
from tests.peers import chromium
from tests.peers.viewed import panel, sdf, show, with_meshes

pytestmark = [
    pytest.mark.peers,
    pytest.mark.skipif(chromium.missing() is not None, reason=chromium.missing() or ""),
]

ROBOTS = Path(__file__).parents[2] / "fixtures" / "robots"
ARM, ROVER = ROBOTS / "desk_arm" / "desk_arm.urdf", ROBOTS / "diff_drive" / "model.sdf"
CAMERA = """<sensor name="wide" type="camera"><camera><horizontal_fov>2.95</horizontal_fov>
<image><width>640</width><height>480</height></image><clip><near>5</near><far>1</far></clip></camera></sensor>"""
BOX = '<{0} name="{0}"><geometry><box><size>{1}</size></box></geometry></{0}>'


@pytest.fixture(scope="module")
def tab() -> Iterator[chromium.Tab]:
    with chromium.tab() as opened:
        yield opened


def shown(tab: chromium.Tab) -> list[str]:
    return list(
        tab.run("[...document.querySelectorAll('.layers input:checked')].map(box => box.id.slice(5))")
    )


def heading(tab: chromium.Tab) -> str:
    """The part that is inspected; empty for none."""
    return str(tab.run("document.querySelector('#inspector:not([hidden]) h2')?.textContent ?? ''"))


def facts(tab: chromium.Tab) -> dict[str, str]:
    lines = "[...document.querySelectorAll('#inspector dt')]"
    return dict(tab.run(f"{lines}.map(name => [name.textContent, name.nextSibling.textContent])"))


def chosen(tab: chromium.Tab) -> list[str]:
    return list(
        tab.run("[...document.querySelectorAll('[aria-selected=true]')].map(row => row.dataset.part)")
    )


def press(tab: chromium.Tab, *keys: str) -> None:
    for key in keys:
        tab.page.keyboard.press(key)


def center(tab: chromium.Tab, part: str) -> tuple[float, float]:
    x, y = tab.run("part => viewer.onScreen(part)", part)
    return x, y


@pytest.mark.parametrize(
    ("shapes", "expected"),
    [
        (BOX.format("visual", "1 1 1") + BOX.format("collision", "1 1 1") + CAMERA, ["visuals"]),
        (BOX.format("collision", "1 1 1"), ["visuals", "collisions"]),
        ("", ["visuals", "empty-links"]),
    ],
)
def test_nothing_but_shapes_is_shown_at_first(
    shapes: str, expected: list[str], tab: chromium.Tab, tmp_path: Path
) -> None:
    show(tab, tmp_path, sdf(tmp_path, f'<link name="a">{shapes}</link>'))
    assert shown(tab) == expected
    assert heading(tab) == ""
    assert tab.errors == []


def test_findings_switch_nothing_on_for_all_links(tab: chromium.Tab, tmp_path: Path) -> None:
    text = ARM.read_text()
    at = text.index('<mass value="', text.index('<link name="forearm"')) + len('<mass value="')
    (tmp_path / "arm.urdf").write_text(f"{text[:at]}-{text[at:]}")
    show(tab, tmp_path, tmp_path / "arm.urdf")
    tab.page.click(".entry.error:has-text('mass')")
    assert shown(tab) == ["visuals"]
    assert chosen(tab) == ["forearm"]


def test_a_finding_about_a_moment_shows_the_robot_as_it_is_then(tab: chromium.Tab, tmp_path: Path) -> None:
    document = sdfcheck.load(ARM).document
    (model,) = root_of(document).models
    bend = next(joint for joint in model.joints if joint.name == "bend")
    kind = SimKind.COLLIDING_JOINT
    text = "joint `bend` moves one part into another"
    found = Diagnostic(kind.code, kind.title, Severity.WARNING, text, bend.element.span)
    moments = [found._replace(moment=Moment((("bend", 0.5), ("turn", -0.25)), ((0, 0, 0.2),))), found]
    meshes = Meshes()
    out = tmp_path / "out.html"
    drawn = scene(document, meshes)
    out.write_text(
        page("arm", [drawn], meshes.entries, findings=findings(moments, document)), encoding="utf-8"
    )
    tab.open(out)
    tab.page.wait_for_selector("html[data-ready]", timeout=60_000)
    for moment, position, points in ((0, 0.5, [[0, 0, 0.2]]), (1, 0.5, [])):
        tab.page.locator(".entry.warning").nth(moment).click()
        assert tab.run("Number(document.querySelector('input[data-joint=bend]').value)") == position
        assert tab.run("viewer.points()") == points
    assert tab.errors == []


def test_fields_of_view_do_not_change_what_fits(tab: chromium.Tab, tmp_path: Path) -> None:
    link = f'<link name="a">{BOX.format("visual", ".3 .2 .1")}{CAMERA}</link>'
    show(tab, tmp_path, sdf(tmp_path, link))
    before = tab.run("viewer.camera()")
    tab.page.check("#show-sensors")
    assert tab.run("viewer.camera()") == pytest.approx(before)
    (reach,) = tab.run(
        """() => { const found = []; viewer.stage.content.traverse(part => {
            if (part.isLineSegments && part.userData.isAside) {
                part.geometry.computeBoundingBox();
                found.push(part.geometry.boundingBox.getSize(part.position.clone()).length());
            } }); return found; }"""
    )
    assert 0.1 < reach < 4


def test_the_tree_is_searched_and_walked_with_keys(tab: chromium.Tab, tmp_path: Path) -> None:
    show(tab, tmp_path, ARM)
    press(tab, "/")
    tab.page.keyboard.type("finger")
    names = tab.run("[...document.querySelectorAll('.row .name')].map(name => name.textContent)")
    assert [name for name in names if "finger" in name] == ["left_finger", "right_finger"]
    assert "column" in names  # what they hang on is there
    press(tab, "Enter")
    assert (heading(tab), chosen(tab)) == ("left_finger", ["left_finger"])
    tab.page.locator("#search").fill("")
    tab.page.locator("#tree").focus()
    press(tab, "Home", "ArrowDown", "Enter")
    assert heading(tab) == "base_to_column"
    press(tab, "Home", "ArrowLeft")
    assert tab.page.locator(".row").count() == 1
    press(tab, "ArrowRight", "End", "Enter")
    assert heading(tab) == "right_finger"
    press(tab, "Escape")
    assert (heading(tab), chosen(tab)) == ("", [])


def test_the_inspector_has_what_is_known(tab: chromium.Tab, tmp_path: Path) -> None:
    show(tab, tmp_path, ARM)
    tab.page.click("#tree [data-part=forearm]")
    known = facts(tab)
    assert known["mass"] == "0.5 kg"
    assert known["parent"] == "upper_arm"
    assert known["center of mass"] == "0.1 0 0"
    assert known["pose in parent"].startswith("xyz 0.3 0 0")
    assert known["file"].startswith("desk_arm.urdf:")
    assert "material" in known["visual"]
    tab.page.click("#tree [data-part=bend]")
    known = facts(tab)
    assert known["joint"] == "revolute"
    assert known["child"] == "forearm"
    assert "…" in known["limits"]
    assert tab.run("['inertias', 'axes'].map(layer => document.getElementById(`show-${layer}`).checked)") == [
        False,
        False,
    ]


def test_the_pointer_names_parts_and_selects_them(tab: chromium.Tab, tmp_path: Path) -> None:
    show(tab, tmp_path, ARM)
    x, y = center(tab, "column")
    tab.page.mouse.move(x, y)
    tab.page.wait_for_selector("#tip:not([hidden])")
    assert str(tab.run("document.getElementById('tip').textContent")).startswith("column — base_to_column")
    tab.page.mouse.click(x, y)
    assert heading(tab) == "column"


def test_links_are_hidden_isolated_and_faded(tab: chromium.Tab, tmp_path: Path) -> None:
    show(tab, tmp_path, ARM)
    x, y = center(tab, "column")
    tab.page.mouse.click(x, y)
    press(tab, "h")
    assert tab.run("[...document.querySelectorAll('.row.hidden')].map(row => row.dataset.part)") == ["column"]
    assert tab.run("([x, y]) => viewer.stage.hitAt(x, y)?.link.userData.link ?? null", [x, y]) != "column"
    press(tab, "i")
    links = tab.page.locator(".row.link").count()
    assert tab.page.locator(".row.link.hidden").count() == links - 1
    press(tab, "t")
    assert tab.page.locator(".row.faint").count() == 1
    tab.page.click("button:text-is('Show all')")
    assert tab.page.locator(".row.hidden, .row.faint").count() == 0
    tab.page.click("[data-part=column] .eye")
    assert tab.page.locator(".row.hidden").count() == 1
    assert tab.errors == []


def test_many_shapes_are_hidden_and_faded(tab: chromium.Tab, tmp_path: Path) -> None:
    shape = BOX.format("visual", "1 1 1")
    links = [
        f'<link name="l{at}"><pose>{at % 20 * 2} {at // 20 * 2} 0 0 0 0</pose>{shape}</link>'
        for at in range(400)
    ]
    show(tab, tmp_path, sdf(tmp_path, *links))
    tab.page.click("button:text-is('Top')")
    x, y = center(tab, "l210")
    under = "([x, y]) => viewer.stage.hitAt(x, y)?.link.userData.link ?? null"
    assert tab.run(under, [x, y]) == "l210"
    tab.page.mouse.click(x, y)
    press(tab, "t")
    assert tab.run(under, [x, y]) == "l210"
    press(tab, "h")
    assert tab.run(under, [x, y]) is None
    press(tab, "a")
    assert tab.run(under, [x, y]) == "l210"
    assert tab.errors == []


def test_numbers_beside_sliders_stay_in_the_limits(tab: chromium.Tab, tmp_path: Path) -> None:
    show(tab, tmp_path, ARM)
    number = tab.page.locator(".slider:has(input[data-joint=turn]) input[type=number]")
    number.fill("9")
    number.press("Tab")
    assert number.input_value() == "2.8"
    assert tab.run("viewer.kept().positions.get('desk_arm').get('turn')[0]") == 2.8
    tab.page.click("button:text-is('Degrees')")
    assert float(number.input_value()) == pytest.approx(math.degrees(2.8), abs=0.01)
    tab.page.click(".slider:has(input[data-joint=turn]) button:text-is('↺')")
    assert number.input_value() == "0"


def test_joints_are_dragged_in_the_picture(tab: chromium.Tab, tmp_path: Path) -> None:
    show(tab, tmp_path, ARM)
    tab.page.click("button:text-is('Top')")
    press(tab, "p")
    camera = tab.run("viewer.camera()")
    tab.page.click("button:text-is('Move joints')")
    x, y = center(tab, "upper_arm")
    column = center(tab, "column")
    tab.page.mouse.move(x, y)
    tab.page.mouse.down()
    for step in range(1, 9):  # a quarter turn about the column, counted as robots do
        angle = math.atan2(column[1] - y, x - column[0]) + step * math.pi / 16
        far = math.hypot(x - column[0], y - column[1])
        tab.page.mouse.move(column[0] + far * math.cos(angle), column[1] - far * math.sin(angle))
    tab.page.mouse.up()
    assert tab.run("viewer.kept().positions.get('desk_arm').get('turn')[0]") == pytest.approx(
        math.pi / 2, abs=0.06
    )
    assert tab.run("viewer.camera()") == pytest.approx(camera)
    slider = tab.page.locator("input[data-joint=turn]")
    assert float(slider.input_value()) == pytest.approx(math.pi / 2, abs=0.06)


def test_a_follower_moves_its_leader(tab: chromium.Tab, tmp_path: Path) -> None:
    show(tab, tmp_path, ARM)
    tab.page.check("#show-collisions")  # the fingers have nothing else
    tab.page.click("button:text-is('Top')")
    x, y = center(tab, "right_finger")
    tab.page.keyboard.down("Shift")
    tab.page.mouse.move(x, y)
    tab.page.mouse.down()
    tab.page.mouse.move(x + 100, y, steps=6)
    tab.page.mouse.up()
    tab.page.keyboard.up("Shift")
    positions = tab.run("[...viewer.kept().positions.get('desk_arm').keys()]")
    assert "left_grip" in positions
    assert "right_grip" not in positions


def test_the_distance_of_two_points(tab: chromium.Tab, tmp_path: Path) -> None:
    shape = BOX.format("visual", ".2 .2 .2")
    show(
        tab,
        tmp_path,
        sdf(
            tmp_path, f'<link name="a">{shape}</link><link name="b"><pose>1.5 0 0 0 0 0</pose>{shape}</link>'
        ),
    )
    tab.page.click("button:text-is('Top')")
    press(tab, "p", "m")
    for part in "ab":
        tab.page.mouse.click(*center(tab, part))
    words = str(tab.run("document.getElementById('measured').textContent"))
    assert float(words.split(maxsplit=1)[0]) == pytest.approx(1.5, abs=0.02)
    assert heading(tab) == ""
    press(tab, "Escape")
    assert tab.run("viewer.stage.notes.children.length") == 0


def test_perspective_and_sides(tab: chromium.Tab, tmp_path: Path) -> None:
    show(tab, tmp_path, ARM)
    for name, axis in (("Front", 0), ("Left", 1), ("Top", 2)):
        tab.page.click(f"button:text-is('{name}')")
        camera = tab.run("viewer.camera()")
        way = [abs(camera[at] - camera[at + 3]) for at in range(3)]
        assert max(way) == way[axis] > 50 * sorted(way)[1]
    deep = center(tab, "forearm")
    tab.page.click("button:text-is('Orthographic')")
    assert tab.page.get_attribute("button:text-is('Orthographic')", "aria-pressed") == "true"
    assert center(tab, "forearm") == pytest.approx(deep, abs=60)
    tab.page.click("button:text-is('Orthographic')")
    assert center(tab, "forearm") == pytest.approx(deep, abs=1)


def test_the_address_holds_what_is_set(tab: chromium.Tab, tmp_path: Path) -> None:
    show(tab, tmp_path, ARM)
    tab.page.check("#show-frames")
    tab.page.locator("input[data-joint=turn]").fill("0.5")
    tab.page.click("#tree [data-part=forearm]")
    press(tab, "i", "p")
    tab.page.click("button:text-is('Front')")
    tab.page.wait_for_timeout(600)
    state = "({poses: viewer.poses(), camera: viewer.camera(), isFlat: viewer.stage.isFlat})"
    before, fragment = tab.run(state), tab.run("location.hash")
    tab.open(tmp_path / "out.html", fragment)
    tab.page.wait_for_selector("html[data-ready]")
    after = tab.run(state)
    assert after["camera"] == pytest.approx(before["camera"], rel=1e-3, abs=1e-3)
    assert after["isFlat"]
    assert after["poses"]["desk_arm"]["forearm"] == pytest.approx(before["poses"]["desk_arm"]["forearm"])
    assert shown(tab) == ["visuals", "frames"]
    assert heading(tab) == "forearm"
    assert tab.page.locator(".row.link.hidden").count() == tab.page.locator(".row.link").count() - 1
    assert str(tmp_path) not in tab.run("document.documentElement.outerHTML")


def test_findings_and_notes_are_grouped(tab: chromium.Tab, tmp_path: Path) -> None:
    show(tab, tmp_path, with_meshes(tmp_path, *(f"gone{number}.stl" for number in range(15))))
    assert tab.page.locator("summary:has-text('not found (15)')").count() == 1
    group = tab.page.locator(".group:has(summary:has-text('RES'))").first
    assert group.get_attribute("open") is None
    assert "gone14.stl" in panel(tab)


def picture(red: int, green: int, blue: int) -> bytes:
    """A PNG of four pixels of one color."""

    def chunk(kind: bytes, data: bytes) -> bytes:
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    rows = (b"\0" + bytes((red, green, blue)) * 2) * 2
    header = struct.pack(">2I5B", 2, 2, 8, 2, 0, 0, 0)
    return (
        b"\x89PNG\r\n\x1a\n"
        + chunk(b"IHDR", header)
        + chunk(b"IDAT", zlib.compress(rows))
        + chunk(b"IEND", b"")
    )


SQUARE = "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
COLLADA = """<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><unit meter="1"/><up_axis>Z_UP</up_axis></asset>
<library_images><image id="i"><init_from>paint%20a.png</init_from></image></library_images>
<library_effects><effect id="e"><profile_COMMON>
<newparam sid="s"><surface type="2D"><init_from>i</init_from></surface></newparam>
<newparam sid="p"><sampler2D><source>s</source></sampler2D></newparam>
<technique sid="t"><lambert><diffuse><texture texture="p" texcoord="UV"/></diffuse></lambert></technique>
</profile_COMMON></effect></library_effects>
<library_materials><material id="m"><instance_effect url="#e"/></material></library_materials>
<library_geometries><geometry id="g"><mesh>
<source id="a"><float_array id="aa" count="9">-1 -1 0 1 -1 0 0 1 0</float_array><technique_common>
<accessor source="#aa" count="3" stride="3"><param name="X" type="float"/><param name="Y" type="float"/>
<param name="Z" type="float"/></accessor></technique_common></source>
<source id="b"><float_array id="bb" count="6">0 0 1 0 0 1</float_array><technique_common>
<accessor source="#bb" count="3" stride="2"><param name="S" type="float"/><param name="T" type="float"/></accessor>
</technique_common></source><vertices id="v"><input semantic="POSITION" source="#a"/></vertices>
<triangles count="1" material="mm"><input semantic="VERTEX" source="#v" offset="0"/>
<input semantic="TEXCOORD" source="#b" offset="1" set="0"/><p>0 0 1 1 2 2</p></triangles></mesh></geometry>
</library_geometries><library_visual_scenes><visual_scene id="w"><node id="n"><instance_geometry url="#g">
<bind_material><technique_common><instance_material symbol="mm" target="#m">
<bind_vertex_input semantic="UV" input_semantic="TEXCOORD" input_set="0"/></instance_material></technique_common>
</bind_material></instance_geometry></node></visual_scene></library_visual_scenes>
<scene><instance_visual_scene url="#w"/></scene></COLLADA>"""


@pytest.mark.parametrize("form", ["obj", "dae"])
def test_textures_beside_meshes_are_shown(form: str, tab: chromium.Tab, tmp_path: Path) -> None:
    (tmp_path / "paint a.png").write_bytes(picture(255, 20, 20))
    (tmp_path / "a.mtl").write_text("newmtl red\nKd 1 1 1\nmap_Kd -s 1 1 1 paint a.png\n")
    (tmp_path / "a.obj").write_text(f"mtllib a.mtl\n{SQUARE}usemtl red\nf 1/1 2/2 3/3 4/4\n")
    (tmp_path / "a.dae").write_text(COLLADA)
    show(tab, tmp_path, with_meshes(tmp_path, f"a.{form}"))
    tab.page.click("button:text-is('Top')")
    tab.page.wait_for_timeout(300)
    red, green, blue = tab.run(
        """() => { viewer.draw(); const paper = document.createElement('canvas');
            const from = viewer.stage.canvas; [paper.width, paper.height] = [from.width, from.height];
            const pen = paper.getContext('2d'); pen.drawImage(from, 0, 0);
            return [...pen.getImageData(from.width / 2, from.height / 2, 1, 1).data].slice(0, 3); }"""
    )
    assert red > 120
    assert red > 2 * max(green, blue)
    assert tab.page.locator(".note").count() == 0
    assert tab.errors == []


def test_a_missing_texture_is_named(tab: chromium.Tab, tmp_path: Path) -> None:
    (tmp_path / "a.dae").write_text(COLLADA)
    (tmp_path / "b.obj").write_text(f"mtllib /etc/passwd\n{SQUARE}f 1 2 3 4\n")
    show(tab, tmp_path, with_meshes(tmp_path, "a.dae", "b.obj"))
    assert "a.dae: texture paint a.png is not found" in panel(tab)
    assert "b.obj: material library passwd is not found" in panel(tab)
    assert tab.errors == []


def test_paper_has_the_picture(tab: chromium.Tab, tmp_path: Path) -> None:
    show(tab, tmp_path, ARM)
    tab.page.emulate_media(media="print", color_scheme="dark")
    tab.run("dispatchEvent(new Event('beforeprint'))")
    tab.page.wait_for_function("document.querySelector('#stage img')?.complete")
    assert tab.run("document.querySelector('#stage img').naturalWidth") > 100
    assert not tab.page.is_visible("canvas")
    assert not tab.page.is_visible("#tools")
    assert tab.page.is_visible("#tree")
    tab.run("dispatchEvent(new Event('afterprint'))")
    tab.page.emulate_media(media="screen", color_scheme="light")
    assert tab.page.locator("#stage img").count() == 0


def test_the_panel_follows_the_width_until_somebody_folds_it(tab: chromium.Tab, tmp_path: Path) -> None:
    def is_open(width: int) -> bool:
        tab.page.set_viewport_size({"width": width, "height": 600})
        tab.run("new Promise(requestAnimationFrame)")
        return bool(tab.page.is_visible("#panel"))

    tab.page.set_viewport_size({"width": 600, "height": 600})
    show(tab, tmp_path, ROVER)
    assert (is_open(600), is_open(1280), is_open(600)) == (False, True, False)
    tab.page.click("#fold")
    assert (is_open(600), is_open(1280)) == (True, True)
    tab.page.click("#fold")
    assert (is_open(600), is_open(1280)) == (False, False)
    tab.page.set_viewport_size({"width": 1280, "height": 800})


@pytest.mark.skipif(chromium.missing_axe() is not None, reason=chromium.missing_axe() or "")
@pytest.mark.parametrize(("width", "height"), [(1400, 900), (800, 600)])
@pytest.mark.parametrize("colors", ["light", "dark"])
def test_accessible_with_all_that_opens(
    width: int, height: int, colors: str, tab: chromium.Tab, tmp_path: Path
) -> None:
    tab.page.set_viewport_size({"width": width, "height": height})
    tab.page.emulate_media(color_scheme=colors)
    show(tab, tmp_path, ROVER)
    assert tab.page.is_visible("#panel") is (width > 1000)
    assert tab.faults() == []
    if not tab.page.is_visible("#panel"):
        tab.page.click("#fold")
    tab.page.click("#tree [data-part=right_wheel]")
    press(tab, "h")
    tab.page.click("#tree [data-part=right_wheel_joint]")
    press(tab, "m")
    tab.page.click("summary:has-text('Help')")
    assert tab.faults() == []
    assert tab.run("document.documentElement.scrollWidth") <= width
    assert tab.errors == []
    tab.page.emulate_media(color_scheme="light")
    tab.page.set_viewport_size({"width": 1280, "height": 800})
