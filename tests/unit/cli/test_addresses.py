"""``--uri-style`` and ``--copy-meshes``: a result names its files in one style, or has them beside it."""

from __future__ import annotations

import time
from pathlib import Path

import pytest

from sdfcheck.cli.main import main
from sdfcheck.robot.load import load

URDF = """<robot name="r"><link name="l">
  <visual><geometry><mesh filename="package://bot/meshes/seen/a.obj"/></geometry></visual>
  <collision><geometry><mesh filename="package://bot/meshes/gone.stl"/></geometry></collision>
  <inertial><mass value="1"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial>
</link></robot>
"""
FILES = {
    "package.xml": "<package><name>bot</name></package>\n",
    "urdf/r.urdf": URDF,
    "meshes/seen/a.obj": "mtllib ../../materials/a.mtl\nmtllib ../../../secret.mtl\n"
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n",
    "materials/a.mtl": "newmtl a\nmap_Kd -s 1 1 1 a.png\n",
    "materials/a.png": "picture\n",
}


@pytest.fixture
def package(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    for name, text in FILES.items():
        file = tmp_path / "bot" / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text)
    (tmp_path / "secret.mtl").write_text("newmtl s\n")
    monkeypatch.chdir(tmp_path)
    return tmp_path / "bot"


def convert(*words: str, kind: str = "urdf-to-sdf", source: str = "bot/urdf/r.urdf") -> int:
    return main(["convert", kind, source, "--isolated", *words])


def uris(text: str) -> list[str]:
    return [line.split(">")[1].split("<")[0] for line in text.splitlines() if "<uri>" in line]


@pytest.mark.parametrize(
    ("style", "expected"),
    [
        ("keep", "model://bot/meshes/seen/a.obj"),
        ("package", "package://bot/meshes/seen/a.obj"),
        ("model", "model://bot/meshes/seen/a.obj"),
        ("relative", "bot/meshes/seen/a.obj"),
        ("file", "file://{}/meshes/seen/a.obj"),
    ],
)
def test_addresses_are_written_in_one_style(
    package: Path, capsys: pytest.CaptureFixture[str], style: str, expected: str
) -> None:
    assert convert("--uri-style", style) == 0
    out, err = capsys.readouterr()
    assert uris(out) == [expected.format(package), "model://bot/meshes/gone.stl"]
    assert ("stay as they are: 1, such as model://bot/meshes/gone.stl" in err) == (style != "keep")


def test_meshes_are_copied_with_what_they_name(package: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert convert("-o", "out/r.sdf", "--copy-meshes") == 0
    written = {path.relative_to("out").as_posix() for path in Path("out").rglob("*") if path.is_file()}
    assert written == {"r.sdf", "model.config", "meshes/seen/a.obj", "materials/a.mtl", "materials/a.png"}
    assert uris(Path("out/r.sdf").read_text()) == ["meshes/seen/a.obj", "model://bot/meshes/gone.stl"]
    assert "3 files copied to out" in capsys.readouterr().err
    mesh = load("out/r.sdf").models[0].link("l").visuals[0].geometry.mesh
    assert mesh is not None
    assert main(["lint", "--isolated", "out/model.config"]) == 0


def test_copying_again_changes_nothing(package: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert convert("-o", "out/r.sdf", "--copy-meshes") == 0
    Path("out/model.config").write_text("<model><name>mine</name><sdf>r.sdf</sdf></model>\n")
    assert convert("-o", "out/r.sdf", "--copy-meshes", "--uri-style", "model") == 0
    assert "0 files copied to out, 3 there already" in capsys.readouterr().err
    assert uris(Path("out/r.sdf").read_text())[0] == "model://out/meshes/seen/a.obj"
    assert "mine" in Path("out/model.config").read_text()


def test_another_file_is_not_written_over(package: Path, capsys: pytest.CaptureFixture[str]) -> None:
    Path("out/materials").mkdir(parents=True)
    Path("out/materials/a.png").write_text("somebody's picture\n")
    assert convert("-o", "out/r.sdf", "--copy-meshes") == 2
    assert "is there already" in capsys.readouterr().err
    assert Path("out/materials/a.png").read_text() == "somebody's picture\n"
    assert not Path("out/r.sdf").exists()


def test_links_that_lead_out_are_not_copied(package: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (package / "materials" / "a.png").unlink()
    (package / "materials" / "a.png").symlink_to("/etc/hostname")
    assert convert("-o", "out/r.sdf", "--copy-meshes") == 2
    assert "a.png cannot be read" in capsys.readouterr().err
    assert not Path("out/materials/a.png").exists()


@pytest.mark.parametrize(
    ("name", "text"),
    [
        ("meshes/seen/a.obj", "\n" * 300_000),
        ("meshes/seen/a.obj", "mtllib a" + " " * 300_000 + "b\n"),
        ("materials/a.mtl", "\n" * 300_000 + "map_Kd " + "a " * 100_000),
        ("meshes/seen/a.dae", "<ref>" + " " * 300_000),
        ("meshes/seen/a.gltf", "[" * 300_000),
    ],
)
def test_names_in_meshes_are_found_in_time(package: Path, name: str, text: str) -> None:
    urdf = package / "urdf" / "r.urdf"
    urdf.write_text(URDF.replace("a.obj", f"a{Path(name).suffix.replace('.mtl', '.obj')}"))
    (package / name).write_text(text)
    begin = time.process_time()
    assert convert("-o", "out/r.sdf", "--copy-meshes", "--no-verify") == 0
    assert time.process_time() - begin < 5
    assert (Path("out") / name).read_text() == text


def test_names_with_blanks_and_options_are_followed(package: Path) -> None:
    (package / "materials" / "my picture.png").write_text("picture\n")
    (package / "materials" / "a.mtl").write_text("map_Kd my picture.png\nmap_Ks -s 1 1 1 a.png\n")
    assert convert("-o", "out/r.sdf", "--copy-meshes") == 0
    copied = {path.name for path in Path("out/materials").iterdir()}
    assert copied == {"a.mtl", "a.png", "my picture.png"}


def test_packages_of_one_folder_name_do_not_mix(package: Path) -> None:
    other = package.parent / "more" / "bot"
    (other / "meshes" / "seen").mkdir(parents=True)
    (other / "package.xml").write_text("<package><name>other</name></package>\n")
    (other / "meshes" / "seen" / "a.obj").write_text("v 0 0 0\nv 2 0 0\nv 0 2 0\nf 1 2 3\n")
    urdf = package / "urdf" / "r.urdf"
    urdf.write_text(URDF.replace("package://bot/meshes/gone.stl", "package://other/meshes/seen/a.obj"))
    assert convert("-o", "out/r.sdf", "--copy-meshes", "--package-path", ".") == 0
    first, second = uris(Path("out/r.sdf").read_text())
    assert Path("out", first).read_text() != Path("out", second).read_text()


def test_several_models_in_one_folder_share_no_configuration(package: Path) -> None:
    (package / "urdf" / "s.urdf").write_text(URDF.replace('name="r"', 'name="s"'))
    assert convert("bot/urdf/s.urdf", "--output-dir", "out", "--copy-meshes") == 0
    assert not Path("out/model.config").exists()


def test_included_files_are_found_from_the_new_place(package: Path) -> None:
    model = '<sdf version="1.9"><model name="b"><link name="l"/></model></sdf>'
    (package / "box").mkdir()
    (package / "box" / "box.sdf").write_text(model)
    world = '<sdf version="1.9"><world name="w"><include>\n<uri>box/box.sdf</uri>\n</include></world></sdf>'
    (package / "w.sdf").write_text(world)
    options = ("-o", "out/w.sdf", "--uri-style", "model", "--sdf-version", "1.10")
    assert convert(*options, kind="sdf-to-sdf", source="bot/w.sdf") == 0
    assert uris(Path("out/w.sdf").read_text()) == ["../bot/box/box.sdf"]


BODY = "<inertial><mass>1</mass><inertia><ixx>1</ixx><iyy>1</iyy><izz>1</izz></inertia></inertial>"
PICTURES = (
    "<material><diffuse>1 1 1 1</diffuse><pbr><metal>\n<albedo_map>materials/a.png</albedo_map>\n"
    "<normal_map>b.png</normal_map>\n</metal></pbr></material>"
)
TEXTURED = (
    f'<sdf version="1.9"><model name="m"><link name="l">{BODY}<visual name="v">'
    f"<geometry><box><size>1 1 1</size></box></geometry>{PICTURES}</visual></link></model></sdf>"
)
AROUND = (
    f'<sdf version="1.9"><model name="top"><link name="base">{BODY}</link><include><uri>m</uri></include>'
    '<joint name="j" type="fixed"><parent>base</parent><child>m::l</child></joint></model></sdf>'
)


@pytest.mark.parametrize("source", ["m/model.sdf", "top.sdf"])
@pytest.mark.parametrize("target", ["out/r.urdf", "r.urdf"])
def test_pictures_beside_a_model_are_found_from_a_robot_elsewhere(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, source: str, target: str
) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "m" / "materials").mkdir(parents=True)
    for picture in ("materials/a.png", "b.png"):
        (tmp_path / "m" / picture).write_text("picture")
    config = "<model><name>m</name><version>1.0</version><sdf>model.sdf</sdf></model>"
    (tmp_path / "m" / "model.config").write_text(config)
    (tmp_path / "m" / "model.sdf").write_text(TEXTURED)
    (tmp_path / "top.sdf").write_text(AROUND)
    assert convert("-o", target, kind="sdf-to-urdf", source=source) == 0
    place = "../m" if target.startswith("out") else "m"
    text = Path(target).read_text()
    assert f"<albedo_map>{place}/materials/a.png</albedo_map>" in text
    assert f"<normal_map>{place}/b.png</normal_map>" in text


@pytest.mark.parametrize("style", ["keep", "relative", "file"])
def test_addresses_hold_any_character(package: Path, style: str) -> None:
    folder = package / "a b%20&c"
    folder.mkdir()
    (folder / "a.obj").write_text(FILES["meshes/seen/a.obj"])
    text = URDF.replace("package://bot/meshes/seen/a.obj", "../a b%20&amp;c/a.obj")
    (package / "urdf" / "r.urdf").write_text(text)
    assert convert("-o", "o&t/r.sdf", "--uri-style", style) == 0
    assert convert("-o", "o/r.urdf", kind="sdf-to-urdf", source="o&t/r.sdf") == 0
    for result in ("o&t/r.sdf", "o/r.urdf"):
        found = next(iter(load(Path(result)).resources))
        assert found.location is not None
        assert found.location.path is not None, f"libsdformat cuts off the scheme of {found.uri}, no more"
        assert found.location.path.samefile(folder / "a.obj")


def test_a_folder_takes_results_under_their_own_names(package: Path) -> None:
    Path("out").mkdir()
    assert convert("-o", "out") == 0
    assert convert("-o", "out", kind="sdf-to-urdf", source="out/r.sdf") == 0
    assert sorted(path.name for path in Path("out").iterdir()) == ["r.sdf", "r.urdf"]


def test_copies_need_a_place(package: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert convert("--copy-meshes") == 2
    assert "needs a place" in capsys.readouterr().err
