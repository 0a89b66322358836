"""Each folder of fixtures/convert/sdf-to-urdf holds a model, the robot that it becomes, and what is lost."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from sdfcheck.convert.sdf_to_urdf import Loops, Options, Planes, Unsupported, convert
from sdfcheck.files.library import Library
from sdfcheck.source.document import read

CASES = sorted((Path(__file__).parents[1] / "fixtures" / "convert" / "sdf-to-urdf").iterdir())

_KINDS = {"ball": Unsupported, "forest": Unsupported, "loops": Loops, "planes": Planes}


def _options(case: Path) -> Options:
    """The lines ``name value`` of the file ``options``, if it exists; a name alone is a switch."""
    path = case / "options"
    given: dict[str, Any] = {}
    for line in path.read_text().splitlines() if path.is_file() else ():
        name, _, value = line.partition(" ")
        given[name] = _KINDS.get(name, str)(value) if value else True
    return Options(**given)


@pytest.mark.parametrize("case", CASES, ids=lambda case: case.name)
def test_case(case: Path, request: pytest.FixtureRequest) -> None:
    document = read((case / "input.sdf").read_bytes(), case / "input.sdf")
    document.library = Library()
    done = convert(document, _options(case))
    assert done.verification is not None
    assert done.verification.is_equal
    lines = [
        f"{loss.span.begin.line}: {loss.severity.value}[{loss.kind.code}]: {loss.message}"
        for loss in done.losses
    ]
    produced = {"expected.urdf": done.text, "losses.txt": "".join(f"{line}\n" for line in lines)}
    for name, text in produced.items():
        if request.config.getoption("--golden"):
            (case / name).write_text(text)
        assert (case / name).read_text() == text
