"""Options of the test suite."""

from __future__ import annotations

import shutil
import sys
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from hypothesis import settings

# A machine that is busy makes no test fail.
settings.register_profile("patient", settings.get_profile(settings.get_current_profile_name()), deadline=None)
settings.load_profile("patient")


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption(
        "--all-examples",
        action="store_true",
        help="show consumers and commands every example of every rule and every real file, which takes long",
    )
    parser.addoption("--golden", action="store_true", help="write the expected outputs again")


def pytest_make_parametrize_id(val: object, argname: str) -> str | None:
    """A long text is not the name of a test, which workers send to one another and reports show."""
    return argname if isinstance(val, (str, bytes)) and len(val) > 200 else None


@pytest.hookimpl(wrapper=True)
def pytest_collection() -> Iterator[None]:
    """The modules of tests are kept as pytest compiles them, as `make compiled` keeps the others."""
    before, sys.dont_write_bytecode = sys.dont_write_bytecode, False
    try:
        return (yield)
    finally:
        sys.dont_write_bytecode = before


@pytest.fixture(scope="session")
def stride(request: pytest.FixtureRequest) -> Callable[[int], int]:
    """How to step through a long list: ``files[:: stride(5)]`` is every fifth, or all with ``--all-examples``."""
    takes_all = request.config.getoption("--all-examples")
    return lambda usual: 1 if takes_all else usual


@pytest.fixture
def tmp_path(tmp_path: Path) -> Path:
    """A folder in a folder of its own: the project of a file may be the folder above it, which tests would share."""
    folder = tmp_path / "test"
    folder.mkdir()
    return folder


@pytest.fixture(scope="session")
def copied(tmp_path_factory: pytest.TempPathFactory) -> Callable[[Path], Path]:
    """Where a file below ``fixtures/robots`` is in a copy that is a project of its own, and so a small one."""
    robots = Path(__file__).parents[1] / "fixtures" / "robots"
    copy = Path(shutil.copytree(robots, tmp_path_factory.mktemp("project") / "robots"))
    (copy / ".git").mkdir()
    return lambda path: copy / path.relative_to(robots)


@pytest.fixture(scope="session")
def _empty_project(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("empty")
    (folder / ".git").mkdir()
    return folder


@pytest.fixture
def elsewhere(_empty_project: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Texts without a folder are in an empty project: that of the tests has thousands of files, which rules read."""
    monkeypatch.chdir(_empty_project)


@pytest.fixture(autouse=True)
def _no_cache(monkeypatch: pytest.MonkeyPatch) -> None:
    """Tests leave nothing in the cache of the person who runs them, nor read it."""
    monkeypatch.setenv("SDFCHECK_CACHE_DIR", "")


@pytest.fixture(autouse=True)
def _accounts(monkeypatch: pytest.MonkeyPatch) -> None:
    """In tests a conversion fails where it has no outcome for an item; users get a loss."""
    from sdfcheck.convert.ledger import Ledger

    def fail(ledger: Ledger, element: object, item: str) -> None:
        raise AssertionError(f"the ledger has no outcome: {item}")

    monkeypatch.setattr(Ledger, "forget", fail)
