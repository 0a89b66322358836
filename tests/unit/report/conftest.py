from __future__ import annotations

import pytest


@pytest.fixture(autouse=True)
def _no_ci(monkeypatch: pytest.MonkeyPatch) -> None:
    """Reports count from the checkout of a CI service, also of the one that runs the tests."""
    monkeypatch.delenv("GITHUB_WORKSPACE", raising=False)
    monkeypatch.delenv("BUILD_SOURCESDIRECTORY", raising=False)
    monkeypatch.delenv("CI_PROJECT_DIR", raising=False)
