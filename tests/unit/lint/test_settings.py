"""A setting is declared once: commands, configuration files, programs and editors have it by that declaration."""

from __future__ import annotations

import ast
import json
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import pytest

import sdfcheck
from sdfcheck.cli.lint import lint as command
from sdfcheck.cli.parts.options import taken
from sdfcheck.lint.config import settings
from sdfcheck.lint.config.configuration import load
from sdfcheck.lint.config.reading import read_given
from sdfcheck.lint.config.schema import schema
from sdfcheck.lint.config.settings import FIELDS, GIVEN, UNSET, Field, Settings, Shape
from sdfcheck.lsp.watch import SETTINGS, choices_of

EDITOR = {field.attribute: name for name, field in SETTINGS.items()}


@pytest.fixture
def values(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Mapping[str, Any]:
    """A value of each form, as a configuration has it."""
    monkeypatch.chdir(tmp_path)
    (tmp_path / "here").mkdir()
    here = str(tmp_path / "here")
    return {
        Shape.SELECTORS: ["XML", "NAM001"],
        Shape.TARGETS: ["drake", "gazebo"],
        Shape.STRINGS: ["HOME", "USER"],
        Shape.PATHS: [here],
        Shape.PLACES: {"robot": here},
        Shape.FLAG: True,
    }


def of_command(field: Field, value: Any) -> Settings:
    flag = field.option.partition(" ")[0]
    if field.shape == Shape.FLAG:
        words = [flag]
    else:
        each = [f"{name}={place}" for name, place in value.items()] if isinstance(value, dict) else value
        words = [word for one in each for word in (flag, one)]
    return taken(command.make_context("lint", words).params)


def of_file(field: Field, value: Any) -> Settings:
    table = (
        ", ".join(f"{name} = {json.dumps(each)}" for name, each in value.items())
        if isinstance(value, dict)
        else ""
    )
    Path("one.toml").write_text(f"{field.key} = {'{' + table + '}' if table else json.dumps(value)}\n")
    return load(Path("one.toml"))._replace(files=())


@pytest.mark.parametrize("name", GIVEN)
def test_all_ways_agree(name: str, values: Mapping[str, Any], tmp_path: Path) -> None:
    field = GIVEN[name]
    value = values[field.shape]
    read = of_file(field, value)
    own = {name: getattr(read, name)}
    assert read == Settings()._replace(**own) != Settings()
    found = {
        "command": of_command(field, value),
        "program": read_given({name: value}),
        "editor": choices_of({EDITOR[name]: value}, tmp_path).given,
    }
    assert {*found.values()} == {UNSET._replace(**own)}, found


def test_the_defaults_agree(tmp_path: Path) -> None:
    assert taken(command.make_context("lint", []).params) == UNSET
    assert read_given(dict.fromkeys(GIVEN)) == UNSET
    assert choices_of({}, tmp_path).given == UNSET
    (tmp_path / "all.toml").write_text(
        "\n".join(f"{field.key} = {field.default}" for field in FIELDS if field.default)
    )
    read = load(tmp_path / "all.toml")
    for field in FIELDS[1:]:
        assert getattr(Settings(), field.attribute) == getattr(read, field.attribute) == field.value


def test_every_setting_has_its_words() -> None:
    properties = schema()["properties"]
    for field in FIELDS:
        assert properties[field.key]["description"] == field.summary
    for parameter in command.params:
        if parameter.name in GIVEN:
            field = GIVEN[parameter.name]
            assert parameter.opts == [field.option.partition(" ")[0]]


def test_a_program_cannot_set_what_nobody_declares(tmp_path: Path) -> None:
    with pytest.raises(TypeError, match=r"there is no setting `selct`; did you mean `select`\?"):
        sdfcheck.lint(tmp_path, selct=["XML"])  # type: ignore[call-arg]
    with pytest.raises(sdfcheck.WrongUsage, match="`select` should be a list of rule codes"):
        sdfcheck.lint(tmp_path, select="XML")
    with pytest.raises(sdfcheck.WrongUsage, match="unknown target `drak`"):
        sdfcheck.lint(tmp_path, target=["drak"])


def test_places_of_a_program_are_looked_at(tmp_path: Path) -> None:
    (tmp_path / "robot").mkdir()
    (tmp_path / "robot" / "package.xml").write_text("<package><name>robot</name></package>")
    (tmp_path / "robot" / "m.dae").write_text("<COLLADA/>")
    text = (
        '<robot name="r"><link name="l"><visual><geometry><mesh filename="package://robot/m.dae"/></geometry>'
        "</visual></link></robot>"
    )
    without, place = sdfcheck.lint(text), {"robot": tmp_path / "robot"}
    assert {each.code for each in without.diagnostics} - {
        each.code for each in sdfcheck.lint(text, packages=place).diagnostics
    }


def test_type_checkers_know_what_a_caller_may_set() -> None:
    tree = ast.parse(Path(settings.__file__).read_text())
    (given,) = (each for each in ast.walk(tree) if isinstance(each, ast.ClassDef) and each.name == "Given")
    assert [ast.unparse(each.target) for each in given.body if isinstance(each, ast.AnnAssign)] == list(GIVEN)
