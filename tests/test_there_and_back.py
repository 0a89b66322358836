"""A model that becomes URDF and SDF again is the same robot, except for reported losses."""

from __future__ import annotations

from pathlib import Path

import pytest

from sdfcheck.convert.ledger import models
from sdfcheck.files.library import Library
from sdfcheck.source.document import read
from tests.there_and_back import there_and_back, untold

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
