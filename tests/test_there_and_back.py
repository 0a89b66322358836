"""A robot that becomes the other format and comes back is the same, except for reported losses."""

from __future__ import annotations

from pathlib import Path

import pytest

from sdfcheck.convert.ledger import models
from sdfcheck.convert.loss import NotConvertible
from sdfcheck.files.library import Library
from sdfcheck.source.document import read
from tests.there_and_back import back_and_there, there_and_back, untold, unwarned

FIXTURES = Path(__file__).parents[1] / "fixtures"
FILES = sorted(
    (*(FIXTURES / "convert" / "sdf-to-urdf").glob("*/input.sdf"), *(FIXTURES / "robots").rglob("*.sdf"))
)
MODELS = [
    path
    for path in FILES
    if "with_mistakes" not in path.parts and len(models(read(path.read_bytes(), path))) == 1
]


@pytest.mark.parametrize("path", MODELS, ids=lambda path: f"{path.parent.name}/{path.name}")
def test_every_change_is_reported(path: Path) -> None:
    document = read(path.read_bytes(), path)
    document.library = Library()
    changes, losses = there_and_back(document)
    assert not list(untold(changes, losses))


ROBOTS = [
    path
    for path in sorted(
        (*(FIXTURES / "convert" / "urdf-to-sdf").glob("*/input.urdf"), *(FIXTURES / "robots").rglob("*.urdf"))
    )
    if "with_mistakes" not in path.parts
]


@pytest.mark.parametrize("path", ROBOTS, ids=lambda path: f"{path.parent.name}/{path.name}")
def test_every_change_of_a_robot_is_a_warning(path: Path) -> None:
    document = read(path.read_bytes(), path)
    document.library = Library()
    try:
        changes, losses = back_and_there(document)
    except NotConvertible as error:
        pytest.skip(error.loss.message)
    assert not list(unwarned(changes, losses))
