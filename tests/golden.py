"""Comparison of written texts with expected ones."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

_NUMBER = re.compile(r"(?<![\w.])[-+]?(?:\d+\.\d+|\d+)(?:e[-+]?\d+)?(?![\w.])")


def assert_as_in(text: str, file: Path) -> None:
    """The text is that of the file, but for the last digits of numbers, which releases of numpy round differently."""
    expected = file.read_text(encoding="utf-8")
    if text != expected:
        assert _NUMBER.sub("#", text) == _NUMBER.sub("#", expected)
        own, other = (list(map(float, _NUMBER.findall(each))) for each in (text, expected))
        assert own == pytest.approx(other, rel=1e-9, abs=1e-12)
