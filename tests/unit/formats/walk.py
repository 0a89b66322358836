"""The findings of the walk over a small document."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from sdfcheck.formats.sdf.survey import survey
from sdfcheck.source.document import read
from tests.unit.only import only

BOX = "<geometry><box><size>1 1 1</size></box></geometry>"


def found(text: str) -> list[Any]:
    return survey(read(text.encode(), Path("example.sdf"))).problems


def in_link(text: str, version: str = "1.12") -> list[Any]:
    return found(f'<sdf version="{version}"><model name="m"><link name="l">{text}</link></model></sdf>')


def only_in_link(text: str, kind: type, version: str = "1.12") -> Any:
    return only(in_link(text, version), kind)
