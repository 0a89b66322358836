"""Twice as much of anything takes twice as much work: lines of code are counted, not seconds."""

from __future__ import annotations

import pytest

from benchmarks.growth import DIMENSIONS, work

SIZE = 30
LARGER = {"joints without links": 400}
"""Up to some effort, unknown names are compared with all names that are there."""
STEEP = 1.15
"""Linear work adds 2 times as much from 2n to 4n as from n to 2n, quadratic work 4 times."""
SLACK = 1000
"""What is done once, such as looking into caches, may differ a little."""


@pytest.mark.parametrize("name", DIMENSIONS)
def test_work_grows_with_the_size(name: str) -> None:
    dimension, size = DIMENSIONS[name], LARGER.get(name, SIZE)
    work(dimension, SIZE)
    once, twice, four_times = (work(dimension, size * factor) for factor in (1, 2, 4))
    assert four_times - twice <= 2 * STEEP * (twice - once) + SLACK


def test_there_are_many_dimensions() -> None:
    assert len(DIMENSIONS) >= 40
