"""Files that only includes lead to: linted once, reported with the way there."""

from __future__ import annotations

from pathlib import Path

import pytest

from sdfcheck.lint.config.configuration import Configuration
from sdfcheck.lint.diagnostic import Diagnostic, Severity
from sdfcheck.lint.run import Run
from sdfcheck.lint.session import Options, run

WORLD = '<sdf version="1.12"><world name="w"><include><uri>parts/arm.sdf</uri></include></world></sdf>'
# An error in the static flag, and a warning for the text.
BAD_ARM = '<sdf version="1.12"><model name="arm"><static>maybe</static><link name="l">x</link></model></sdf>'


@pytest.fixture(autouse=True)
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    (tmp_path / "parts").mkdir()
    (tmp_path / "parts/arm.sdf").write_text(BAD_ARM)
    for name in ("one", "two"):
        (tmp_path / f"{name}.sdf").write_text(WORLD)
    monkeypatch.chdir(tmp_path)
    return tmp_path


def lint(*paths: str) -> Run:
    return run([Path(path) for path in paths], Options(Configuration(isolated=True)))


def of_arm(result: Run) -> list[Diagnostic]:
    return [d for d in result.diagnostics if d.span.source.path.name == "arm.sdf"]


def test_its_errors_are_reported_once_with_the_first_way_there() -> None:
    (diagnostic,) = of_arm(lint("one.sdf", "two.sdf"))
    assert diagnostic.severity is Severity.ERROR
    assert [(o.span.source.path.name, o.span.text) for o in diagnostic.origins] == [
        ("one.sdf", "parts/arm.sdf")
    ]
    assert diagnostic.fix is None


@pytest.mark.parametrize("paths", [("one.sdf", "parts/arm.sdf"), ("parts", "one.sdf"), (".",)])
def test_a_file_of_the_run_is_reported_there_alone(paths: tuple[str, ...]) -> None:
    found = of_arm(lint(*paths))
    assert {d.severity for d in found} == {Severity.ERROR, Severity.WARNING}
    assert all(d.origins == () for d in found)
    assert len({(d.code, d.span.start) for d in found}) == len(found)
    assert {d.span.source.path for d in found} == {Path("parts/arm.sdf")}


def test_a_model_that_it_includes_and_is_not_here_is_missing_in_the_world(folder: Path) -> None:
    include = "<include><uri>model://nowhere</uri></include>"
    (folder / "parts/arm.sdf").write_text(
        f'<sdf version="1.12"><model name="arm"><link name="l">x</link>{include}</model></sdf>'
    )
    (diagnostic,) = of_arm(lint("one.sdf", "two.sdf"))
    assert diagnostic.code == "RES002"
    assert diagnostic.missing is not None
    assert [origin.span.source.path.name for origin in diagnostic.origins] == ["one.sdf"]


def test_the_way_may_be_long(folder: Path) -> None:
    middle = '<sdf version="1.12"><model name="m"><include><uri>arm.sdf</uri></include></model></sdf>'
    (folder / "parts/middle.sdf").write_text(middle)
    (folder / "far.sdf").write_text(WORLD.replace("arm.sdf", "middle.sdf"))
    (diagnostic,) = of_arm(lint("far.sdf"))
    assert [o.span.source.path.name for o in diagnostic.origins] == ["middle.sdf", "far.sdf"]


def test_it_can_silence_itself(folder: Path) -> None:
    silenced = BAD_ARM.replace("<static>", "<!-- sdfcheck: ignore[SCH011] --><static>").replace(
        "<link", "<!-- sdfcheck: ignore[SCH010] --><link"
    )
    (folder / "parts/arm.sdf").write_text(silenced)
    result = lint("one.sdf")
    assert of_arm(result) == []


def test_excluded_files_are_left_alone(folder: Path) -> None:
    (folder / "sdfcheck.toml").write_text('exclude = ["parts"]\n')
    result = run([Path("one.sdf")], Options(Configuration()))
    assert of_arm(result) == []


def test_settings_name_folders_of_models(folder: Path) -> None:
    (folder / "far/away/robot").mkdir(parents=True)
    (folder / "far/away/robot/robot.sdf").write_text(BAD_ARM)
    (folder / "main.sdf").write_text(WORLD.replace("parts/arm.sdf", "model://robot/robot.sdf"))
    assert [d.severity for d in run([Path("main.sdf")], Options(Configuration())).diagnostics] == [
        Severity.WARNING
    ]
    (folder / "sdfcheck.toml").write_text('model-paths = ["far/away"]\n')
    (diagnostic,) = run([Path("main.sdf")], Options(Configuration())).diagnostics
    assert diagnostic.span.source.path.name == "robot.sdf"


@pytest.mark.parametrize(
    ("flags", "refused"), [(("true",), False), (("false",), True), (("true", "false"), True)]
)
def test_a_model_without_links_may_be_included_as_static(
    folder: Path, flags: tuple[str, ...], refused: bool
) -> None:
    (folder / "parts/arm.sdf").write_text('<sdf version="1.12"><model name="arm"/></sdf>')
    includes = [
        f"<include><uri>parts/arm.sdf</uri><name>a{number}</name><static>{flag}</static></include>"
        for number, flag in enumerate(flags)
    ]
    (folder / "one.sdf").write_text(f'<sdf version="1.12"><world name="w">{"".join(includes)}</world></sdf>')
    found = of_arm(lint("one.sdf"))
    assert [d.name for d in found] == ["model-without-link"] * refused
    assert all(d.origins[0].span.begin.column > 100 * (len(flags) > 1) for d in found)


@pytest.mark.parametrize("file", ["one.sdf", "parts/arm.sdf"])
def test_it_can_be_silenced_where_it_is_included_and_where_it_is(folder: Path, file: str) -> None:
    text = (folder / file).read_text()
    mark = "<include>" if file == "one.sdf" else "<static>"
    (folder / file).write_text(text.replace(mark, f"<!-- sdfcheck: ignore[malformed-value] -->{mark}"))
    done = lint("one.sdf")
    assert (done.diagnostics, done.suppressed) == ((), 1)


def test_files_for_other_versions_are_not_included(folder: Path) -> None:
    old = '<gazebo version="1.2"><light type="point" name="sun"/></gazebo>'
    (folder / "parts/old.sdf").write_text(old)
    (folder / "parts/new.sdf").write_text(BAD_ARM.replace("maybe", "true"))
    (folder / "parts/model.config").write_text(
        '<model><name>arm</name><sdf version="1.2">old.sdf</sdf><sdf version="1.12">new.sdf</sdf></model>'
    )
    (folder / "one.sdf").write_text(WORLD.replace("parts/arm.sdf", "parts"))
    assert not lint("one.sdf").diagnostics
    assert any(each.span.source.path.name == "old.sdf" for each in lint(".").diagnostics)
