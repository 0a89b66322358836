"""Models that parameters of includes change are where libsdformat has them."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.peers.cmdprint import Job, printed
from tests.peers.libsdformat import library
from tests.unit.cli.test_include_parameters import INNER, INSIDE, PARAMETERS, poses_of, write

pytestmark = [
    pytest.mark.peers,
    pytest.mark.skipif(library() is None, reason="libsdformat is not installed"),
]
CASES = [(entries, "") for entries in PARAMETERS.values()] + [(entries, INNER) for entries in INSIDE.values()]


@pytest.mark.parametrize(("entries", "more"), CASES, ids=[*PARAMETERS, *INSIDE])
@pytest.mark.parametrize("merge", ["false", "true"])
def test_poses_are_those_of_what_libsdformat_prints(
    tmp_path: Path, entries: str, more: str, merge: str
) -> None:
    path = write(tmp_path, entries, more, merge=merge)
    (text,) = printed([Job(path, tmp_path)])
    assert "<include" not in text
    theirs = tmp_path / "theirs.sdf"
    theirs.write_text(text)
    assert poses_of(path) == poses_of(theirs)
