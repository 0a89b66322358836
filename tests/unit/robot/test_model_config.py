"""``model.config``: the file that is chosen, and what is wrong."""

from __future__ import annotations

from pathlib import Path

import pytest

from sdfcheck.files.library import Library
from sdfcheck.robot.includes.model_config import ConfigFault, ModelConfig, model_file
from sdfcheck.source.document import read
from tests.unit.robot.files import write

FILES = {"five.sdf": "", "six.sdf": "", "nine.sdf": "", "new.sdf": "", "bare.sdf": ""}


def chosen(folder: Path, entries: str) -> str | None:
    write(folder, FILES)
    path = folder / "model.config"
    file = model_file(read(f"<model><name>a</name>{entries}</model>".encode(), path))
    return None if file is None else file.name


@pytest.mark.parametrize(
    ("entries", "file"),
    [
        ('<sdf version="1.5">five.sdf</sdf><sdf version="1.9">nine.sdf</sdf>', "nine.sdf"),
        ('<sdf version="1.9">nine.sdf</sdf><sdf version="1.6">six.sdf</sdf>', "nine.sdf"),
        ('<sdf version="1.9">nine.sdf</sdf><sdf version="1.99">new.sdf</sdf>', "nine.sdf"),
        ('<sdf version="1.99">new.sdf</sdf>', "new.sdf"),
        ("<sdf>bare.sdf</sdf>", "bare.sdf"),
        ('<sdf version="1.99">new.sdf</sdf><sdf>bare.sdf</sdf>', "new.sdf"),
        ('<sdf>bare.sdf</sdf><sdf version="1.5">five.sdf</sdf>', "five.sdf"),
        ('<sdf version="1.10">six.sdf</sdf><sdf version="1.9">nine.sdf</sdf>', "six.sdf"),
        ('<sdf version="1.9">gone.sdf</sdf>', None),
        ("", None),
    ],
)  # fmt: skip
def test_the_newest_readable_version_is_chosen(tmp_path: Path, entries: str, file: str | None) -> None:
    assert chosen(tmp_path, entries) == file


@pytest.mark.parametrize(
    ("text", "faults"),
    [
        ('<model><name>a</name><sdf version="1.9">nine.sdf</sdf></model>', []),
        ("<robot/>", [ConfigFault.NO_MODEL]),
        ("<model/>", [ConfigFault.NO_NAME_NO_FILE]),
        ("<model><name>a</name></model>", [ConfigFault.NO_FILE]),
        ('<model><sdf version="1.9">nine.sdf</sdf></model>', [ConfigFault.NO_NAME]),
        ('<model><name/><sdf version="1.9">nine.sdf</sdf></model>', [ConfigFault.NO_NAME]),
        ("<model><name>a</name><sdf>nine.sdf</sdf></model>", [ConfigFault.NO_VERSION]),
        ('<model><name>a</name><sdf version=" ">nine.sdf</sdf></model>', [ConfigFault.EMPTY_VERSION]),
        ('<model><name>a</name><sdf version="one">nine.sdf</sdf></model>', [ConfigFault.BAD_VERSION]),
        ('<model><name>a</name><sdf version="2.0">nine.sdf</sdf></model>', [ConfigFault.TOO_NEW]),
        ('<model><name>a</name><sdf version="1.9"/></model>', [ConfigFault.EMPTY_FILE]),
        ('<model><name>a</name><sdf version="1.9">gone.sdf</sdf></model>', [ConfigFault.MISSING_FILE]),
        ("<model><name>a</name>", []),
    ],
)
def test_faults(tmp_path: Path, text: str, faults: list[ConfigFault]) -> None:
    write(tmp_path, FILES)
    document = read(text.encode(), tmp_path / "model.config")
    document.library = Library()
    assert [problem.fault for problem in ModelConfig(document).faults] == faults


def test_a_file_that_may_be_meant(tmp_path: Path) -> None:
    write(tmp_path, {"model.sdf": ""})
    text = '<model><name>a</name><sdf version="1.9">arm.sdf</sdf></model>'
    document = read(text.encode(), tmp_path / "model.config")
    document.library = Library()
    assert [problem.near for problem in ModelConfig(document).faults] == ["model.sdf"]
