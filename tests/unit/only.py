"""One mistake, one problem."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any


def only(found: Iterable[Any], kind: type) -> Any:
    """The one problem that was found, which is of that kind."""
    problem, *others = found
    assert type(problem) is kind, problem
    assert not others
    return problem
