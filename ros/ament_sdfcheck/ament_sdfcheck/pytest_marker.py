"""The marker of tests that run sdfcheck, for pytest."""

from __future__ import annotations

from typing import Any


def pytest_configure(config: Any) -> None:
    config.addinivalue_line("markers", "sdfcheck: marks tests that check robot descriptions")
