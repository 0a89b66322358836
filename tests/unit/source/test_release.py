from __future__ import annotations

from pathlib import Path

import pytest

from sdfcheck.files.library import Library
from sdfcheck.source.document import read


@pytest.mark.parametrize("is_referred_to", [False, True])
def test_a_document_is_released_for_the_next_unless_another_was_reached_through_it(
    *, is_referred_to: bool
) -> None:
    library = Library()
    first, second = (read(b'<sdf version="1.12"/>', Path(name)) for name in ("a.sdf", "b.sdf"))
    first.is_referred_to = is_referred_to
    library.turn_to(first)
    library.turn_to(second)
    assert (first.root is not None) is is_referred_to
    assert second.root is not None
