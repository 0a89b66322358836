"""The page of a robot: complete, harmless, and with the kinematics of the rest of the program."""

from __future__ import annotations

import json
import re
import shutil
import subprocess
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import sdfcheck
from sdfcheck.cli.main import main
from sdfcheck.robot.motion.flatten import mechanism_of
from sdfcheck.robot.motion.mechanism import link_poses
from sdfcheck.robot.root import root_of
from sdfcheck.view.meshes import Meshes
from sdfcheck.view.scene import MOST_SHAPES, scene

ROOT = Path(__file__).parents[3]
ROBOTS = ROOT / "fixtures" / "robots"
VIEWER = ROOT / "viewer"


def data_of(page: str) -> Any:
    (text,) = re.findall(r'<script type="application/json" id="data">(.*?)</script>', page, re.DOTALL)
    return json.loads(text)


def shown(tmp_path: Path, *arguments: str) -> str:
    out = tmp_path / "out.html"
    assert main(["view", *arguments, "-o", str(out), "--isolated"]) == 0
    return out.read_text(encoding="utf-8")


def test_a_page_holds_the_robot_and_loads_nothing(tmp_path: Path) -> None:
    page = shown(tmp_path, str(ROBOTS / "desk_arm" / "desk_arm.urdf"))
    (model,) = data_of(page)["scenes"][0]["models"]
    assert [link["name"] for link in model["links"]][:3] == ["base_link", "column", "upper_arm"]
    assert sum(len(link["shapes"]) for link in model["links"]) >= 7
    assert any(link["inertia"] for link in model["links"])
    followers = [joint for joint in model["joints"] if joint["axes"] and joint["axes"][0]["mimic"]]
    assert [joint["name"] for joint in followers] == ["right_grip"]
    head = page.partition("<body>")[0]
    assert "default-src 'none'" in head
    assert not re.search(r'(?:src|href)="(?!data:)', page.partition("<script>")[0])


def test_names_are_text(tmp_path: Path) -> None:
    name = "</script><script>alert(1)</script><img src=x onerror=alert(1)>"
    file = tmp_path / "evil.sdf"
    escaped = name.replace("&", "&amp;").replace("<", "&lt;")
    file.write_text(f'<sdf version="1.12"><model name="{escaped}"><link name="{escaped}"/></model></sdf>')
    page = shown(tmp_path, str(file))
    assert "alert(1)</script>" not in page
    assert "<img" not in page
    assert data_of(page)["scenes"][0]["models"][0]["links"][0]["name"] == name


def test_findings_and_differences_name_their_parts(tmp_path: Path) -> None:
    arm = ROBOTS / "desk_arm" / "desk_arm.urdf"
    text = arm.read_text()
    other = tmp_path / "other.urdf"
    other.write_text(text.replace('<axis xyz="0 1 0"/>', '<axis xyz="0 -2 0"/>', 1))
    data = data_of(shown(tmp_path, str(other), str(arm)))
    assert len(data["scenes"]) == 2
    assert {finding["part"] for finding in data["findings"] if finding["code"].startswith("JNT")} == {"bend"}
    assert any(difference["part"] == "bend" for difference in data["differences"])


@pytest.mark.parametrize(
    "file", sorted((ROBOTS / "with_mistakes").glob("*.[suw]*[fd]")), ids=lambda file: file.name
)
def test_broken_robots_give_a_page(file: Path, tmp_path: Path) -> None:
    assert "canvas" in shown(tmp_path, str(file))


def test_numbers_that_are_none_can_be_drawn() -> None:
    text = (
        '<sdf version="1.12"><model name="m"><link name="l"><inertial><mass>nan</mass></inertial>'
        "<visual name='v'><geometry><sphere><radius>inf</radius></sphere></geometry></visual></link></model></sdf>"
    )
    json.dumps(scene(sdfcheck.parse(text).document, Meshes()), allow_nan=False)


def test_meshes_are_embedded_once_and_up_to_a_size(tmp_path: Path) -> None:
    (tmp_path / "a.stl").write_bytes(bytes(80) + b"\1\0\0\0" + bytes(50))
    (tmp_path / "text.stl").write_bytes(b"x" * 100)
    (tmp_path / "big.stl").write_bytes(b"x" * 1001)
    uris = ("a.stl", "a.stl", "big.stl", "gone.dae", "a.xyz", "text.stl")
    links = "".join(
        f'<link name="l{i}"><visual name="v"><geometry><mesh><uri>{uri}</uri></mesh></geometry></visual></link>'
        for i, uri in enumerate(uris)
    )
    (tmp_path / "a.xyz").write_text("")
    file = tmp_path / "m.sdf"
    file.write_text(f'<sdf version="1.12"><model name="m">{links}</model></sdf>')
    meshes = Meshes(one=1000)
    scene(sdfcheck.load(file).document, meshes)
    assert [entry.get("missing") for entry in meshes.entries] == [
        None,
        "too large to embed (0 MB)",
        "not found",
        "a format that is not shown",
        "not a mesh",
    ]


def test_colors_beside_meshes_are_embedded_by_name(tmp_path: Path) -> None:
    (tmp_path / "materials" / "textures").mkdir(parents=True)
    (tmp_path / "meshes").mkdir()
    (tmp_path / "materials" / "textures" / "a.png").write_bytes(b"\x89PNG")
    (tmp_path / "meshes" / "b.jpg").write_bytes(b"secret")
    (tmp_path / "meshes" / "a.mtl").write_text(
        "newmtl m\nmap_Kd a.png\nmap_Kd -clamp on b.jpg\nmap_Kd c.png\n"
    )
    (tmp_path / "meshes" / "a.obj").write_text("mtllib a.mtl\nmtllib b.jpg\nv 0 0 0\n")
    file = tmp_path / "m.sdf"
    uri = "<uri>meshes/a.obj</uri>"
    file.write_text(
        f'<sdf version="1.12"><model name="m"><link name="l"><visual name="v"><geometry><mesh>{uri}</mesh></geometry>'
        "</visual></link></model></sdf>"
    )
    meshes = Meshes()
    scene(sdfcheck.load(file).document, meshes)
    (entry,) = meshes.entries
    assert sorted(entry["files"]) == ["a.mtl", "a.png"]
    assert entry["files"]["a.png"].startswith("data:image/png;base64,")
    assert entry["notes"] == [
        "material library b.jpg is not found",
        "texture b.jpg is not a picture that is shown",
        "texture c.png is not found",
    ]


def test_the_page_is_opened_and_never_written_to_a_terminal(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    arm = str(ROBOTS / "desk_arm" / "desk_arm.urdf")
    opened: list[str] = []
    monkeypatch.setattr("click.launch", opened.append)
    monkeypatch.setattr("sys.stdout.isatty", lambda: True)
    monkeypatch.setattr("sys.platform", "linux")
    for name in ("WAYLAND_DISPLAY", "BROWSER", "WSL_DISTRO_NAME"):
        monkeypatch.delenv(name, raising=False)
    monkeypatch.setenv("DISPLAY", ":1")
    assert main(["view", arm, "--isolated"]) == 0
    (page,) = opened
    assert "desk_arm" in Path(page).read_text(encoding="utf-8")
    monkeypatch.delenv("DISPLAY")
    assert main(["view", arm, "--isolated"]) == 2
    said = capsys.readouterr()
    assert "-o desk_arm.html" in said.err
    assert said.out == ""
    assert main(["view", arm, "--isolated", "-o", str(tmp_path / "out.html")]) == 0
    monkeypatch.setattr("sys.stdout.isatty", lambda: False)
    assert main(["view", arm, "--isolated"]) == 0
    assert capsys.readouterr().out.startswith("<!doctype html>")
    assert len(opened) == 1


def test_a_wrong_inertia_is_marked() -> None:
    text = (
        '<robot name="r"><link name="l"><inertial><mass value="1"/>'
        '<inertia ixx="1" iyy="1" izz="{}" ixy="0" ixz="0" iyz="0"/></inertial></link></robot>'
    )
    for moment, possible in (("1", True), ("3", False)):
        drawn = scene(sdfcheck.parse(text.format(moment)).document, Meshes())
        assert drawn["models"][0]["links"][0]["inertia"]["isPossible"] is possible


def test_large_worlds_are_drawn_as_boxes() -> None:
    visual = "<visual name='v{}'><geometry><sphere><radius>1</radius></sphere></geometry></visual>"
    many = "".join(visual.format(number) for number in range(MOST_SHAPES + 1))
    text = f'<sdf version="1.12"><model name="m"><link name="l">{many}</link></model></sdf>'
    assert scene(sdfcheck.parse(text).document, Meshes())["notes"] == [
        f"{MOST_SHAPES + 1} shapes: drawn with few corners, and meshes as boxes"
    ]


def test_a_conversion_is_shown_before_and_after(tmp_path: Path) -> None:
    source = ROOT / "fixtures" / "convert" / "sdf-to-urdf" / "shapes-without-equal" / "input.sdf"
    out, page = tmp_path / "out.urdf", tmp_path / "page.html"
    assert (
        main(["convert", "sdf-to-urdf", str(source), "-o", str(out), "--report", str(page), "--isolated"])
        == 0
    )
    data = data_of(page.read_text(encoding="utf-8"))
    before, after = (scene["models"][0]["links"][0]["shapes"] for scene in data["scenes"])
    assert len(before) > len(after)
    losses = [finding for finding in data["findings"] if finding["code"] == "CNV008"]
    assert any(loss["part"] == "a" and loss["layer"] == "visuals" for loss in losses)


def test_a_page_shows_one_conversion(tmp_path: Path) -> None:
    robots = [str(ROBOTS / "desk_arm" / "desk_arm.urdf")] * 2
    options = ["--output-dir", str(tmp_path), "--report", str(tmp_path / "page.html")]
    assert main(["convert", "urdf-to-sdf", *robots, *options]) == 2
    assert not (tmp_path / "page.html").exists()


@pytest.mark.peers
@pytest.mark.skipif(not (VIEWER / "node_modules").is_dir(), reason="the viewer's packages are not installed")
@pytest.mark.parametrize(
    ("entry", "committed"),
    [("src/main.ts", "view/data/viewer.js"), ("src/report/main.ts", "report/data/report.js")],
)
def test_committed_scripts_are_up_to_date(entry: str, committed: str) -> None:
    options = ("--bundle", "--minify", "--format=iife", "--target=es2020", "--legal-comments=none")
    command = ["npx", "--no", "esbuild", entry, *options]
    done = subprocess.run(command, cwd=VIEWER, capture_output=True, check=True)
    assert done.stdout == (ROOT / "sdfcheck" / committed).read_bytes(), "run `make viewer`"


@pytest.mark.peers
@pytest.mark.skipif(shutil.which("node") is None, reason="node is not installed")
@pytest.mark.skipif(not (VIEWER / "node_modules").is_dir(), reason="the viewer's packages are not installed")
@pytest.mark.parametrize(
    "robot", ["desk_arm/desk_arm.urdf", "diff_drive/model.sdf", "two_link_arm/model.sdf"]
)
def test_the_page_moves_links_as_we_do(robot: str, tmp_path: Path) -> None:
    module = tmp_path / "kinematics.mjs"
    command = ["npx", "--no", "esbuild", "src/kinematics.ts", "--format=esm", f"--outfile={module}"]
    subprocess.run(command, cwd=VIEWER, capture_output=True, check=True)
    document = sdfcheck.load(ROBOTS / robot).document
    (model,) = scene(document, Meshes())["models"]
    mechanism = mechanism_of(root_of(document).models[0], vendors=True)
    random = np.random.default_rng(1)
    positions = {
        joint["name"]: random.uniform(-1, 1, len(joint["axes"])).tolist() for joint in model["joints"]
    }
    script = (
        f"import {{linkPoses}} from {json.dumps(module.as_uri())};"
        f"const model = {json.dumps(model)}; const given = new Map(Object.entries({json.dumps(positions)}));"
        "console.log(JSON.stringify(Object.fromEntries(linkPoses(model, given))));"
    )
    done = subprocess.run(
        ["node", "--input-type=module", "-e", script], capture_output=True, text=True, check=True
    )
    theirs = json.loads(done.stdout)
    given = {name: np.array([values]) for name, values in positions.items() if values}
    for name, poses in link_poses(mechanism, given).items():
        assert np.allclose(np.array(theirs[name]).reshape(4, 4).T, poses[0], atol=1e-6), name
