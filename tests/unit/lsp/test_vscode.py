"""The manifest of the extension for Visual Studio Code, compared with the server."""

from __future__ import annotations

import json
import re
from pathlib import Path
from typing import Any

import pytest

import sdfcheck
from sdfcheck.consumers.reaction import Consumer
from sdfcheck.lsp.register import make_server
from sdfcheck.lsp.watch import SETTINGS, choices_of
from sdfcheck.lsp.workspace import Choices

EXTENSION = Path(__file__).parents[3] / "editors" / "vscode"
MANIFEST: dict[str, Any] = json.loads((EXTENSION / "package.json").read_text(encoding="utf-8"))
CONTRIBUTED: dict[str, Any] = MANIFEST["contributes"]
SNIPPETS = [
    (each["language"], name, snippet)
    for each in CONTRIBUTED["snippets"]
    for name, snippet in json.loads((EXTENSION / each["path"]).read_text(encoding="utf-8")).items()
]
ROBOTS = {
    "sdformat": '<sdf version="1.10"><model name="m"><link name="parent"/><link name="child"/>{}</model></sdf>',
    "urdf": '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro"><link name="parent"/>'
    '<link name="child"/>{}</robot>',
}
INSIDE = {
    "Camera": '<link name="l">{}</link>',
    "ros2_control joint": '<ros2_control name="c" type="system">{}</ros2_control>',
}
OF_THE_TEXT = re.compile(r"(?:XML|NS|SCH|INR)\d+|URD0(?:01|02|09|19)")
"""Codes about the snippet itself; others may be about what is still to be written around it."""


def test_commands_of_the_extension_and_of_the_server_differ() -> None:
    server = make_server()
    try:
        # The client makes a command of each that the server has.
        own = {each["command"] for each in CONTRIBUTED["commands"]} | {"sdfcheck.references"}
        assert not own & set(server.protocol.fm.commands)
        source = "".join(path.read_text(encoding="utf-8") for path in (EXTENSION / "src").glob("*.ts"))
        asked = set(re.findall(r'ask(?:<[^(]*>)?\(\s*\w+,\s*"([\w.]+)"', source))
        assert asked
        assert asked <= set(server.protocol.fm.commands)
    finally:
        server.ended()


def test_each_setting_is_read(tmp_path: Path) -> None:
    changed: dict[str, Any] = {"boolean": True, "array": ["gazebo"], "string": "x", "object": {"p": "x"}}
    names = set[str]()
    for name, setting in CONTRIBUTED["configuration"]["properties"].items():
        key = name.removeprefix("sdfcheck.")
        names.add(key)
        if key == "command":
            continue  # it says which server is started
        assert choices_of({key: setting["default"]}, tmp_path) == Choices(), key
        value = not setting["default"] if setting["type"] == "boolean" else changed[setting["type"]]
        assert choices_of({key: value}, tmp_path) != Choices(), key
    assert names >= {*SETTINGS}
    target = CONTRIBUTED["configuration"]["properties"]["sdfcheck.target"]
    assert target["items"]["enum"] == [consumer.value for consumer in Consumer]


def test_files_and_commands_of_the_manifest_exist() -> None:
    paths = [MANIFEST["icon"]]
    paths += [each["path"] for part in ("grammars", "snippets") for each in CONTRIBUTED[part]]
    paths += [each["configuration"] for each in CONTRIBUTED["languages"]]
    paths += [step["media"]["markdown"] for each in CONTRIBUTED["walkthroughs"] for step in each["steps"]]
    for path in paths:
        assert (EXTENSION / path).is_file(), path
    contributed = {each["command"] for each in CONTRIBUTED["commands"]}
    for each in CONTRIBUTED["walkthroughs"]:
        named = {name for step in each["steps"] for name in re.findall(r"ommand:([\w.]+)", json.dumps(step))}
        assert named <= contributed


@pytest.mark.parametrize(("language", "name", "snippet"), SNIPPETS, ids=lambda each: str(each)[:30])
def test_snippets_have_no_errors(language: str, name: str, snippet: dict[str, Any], tmp_path: Path) -> None:
    text = "\n".join(snippet["body"])
    text = re.sub(r"\$\{\d+\|([^,|]*)[^}]*\}", r"\1", text)
    text = re.sub(r"(?<!\\)\$(?:\{\d+:([^}]*)\}|\d)", r"\1", text).replace("\\$", "$")
    if not text.startswith("<?xml"):
        text = ROBOTS[language].replace("{}", INSIDE.get(name, "{}").replace("{}", text))
    file = tmp_path / ("r.urdf.xacro" if "xacro" in text else "m.sdf" if language == "sdformat" else "r.urdf")
    file.write_text(text)
    errors = [each for each in sdfcheck.lint([file]).diagnostics if each.severity.value == "error"]
    assert [each for each in errors if OF_THE_TEXT.fullmatch(each.code)] == []
