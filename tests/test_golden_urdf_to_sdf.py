"""URDF and what becomes of it, in pairs; ``pytest tests/test_golden_urdf_to_sdf.py --golden`` writes them again."""

from __future__ import annotations

from pathlib import Path

import pytest

from sdfcheck.cli.convert.command import Reader, Source
from sdfcheck.cli.parts.descriptions import SearchContext
from sdfcheck.convert.urdf_to_sdf.conversion import urdf_to_sdf
from sdfcheck.convert.urdf_to_sdf.options import FixedJoints, Massless, Options, PackageUris
from sdfcheck.formats.version import Version
from sdfcheck.lint.config.configuration import Configuration
from sdfcheck.source.sniff import Kind
from tests.golden import assert_as_in

CASES = Path(__file__).parents[1] / "fixtures" / "convert" / "urdf-to-sdf"


def options_of(case: Path) -> Options:
    """The options that a case's file ``options.txt`` names, one ``name=value`` a line."""
    file = case / "options.txt"
    given = dict(line.split("=") for line in file.read_text().split()) if file.exists() else {}
    version = Version.parse(given.get("sdf-version", "1.12"))
    assert version is not None
    return Options(
        version,
        FixedJoints(given.get("fixed-joints", "keep")),
        Massless(given.get("massless", "merge")),
        PackageUris(given.get("package-uris", "model")),
    )


def test_there_are_cases() -> None:
    assert len(list(CASES.iterdir())) >= 10


@pytest.mark.parametrize("case", sorted(CASES.iterdir()), ids=lambda case: case.name)
def test_conversion(case: Path, request: pytest.FixtureRequest) -> None:
    (source,) = case.glob("input.*")
    with Reader(SearchContext(Configuration(isolated=True)), lint=False) as consumer:
        document = consumer.read(Source(source), {Kind.URDF: "URDF"}).document
    assert document is not None
    done = urdf_to_sdf(document, options_of(case))
    losses = "".join(
        f"{loss.span.begin.line}:{loss.span.begin.column}: "
        f"{loss.severity.value}[{loss.kind.code}]: {loss.message}\n"
        for loss in done.losses
    )
    assert done.verification is not None
    assert done.verification.is_equal, done.verification.differences
    if request.config.getoption("--golden"):
        (case / "expected.sdf").write_text(done.text, encoding="utf-8")
        (case / "losses.txt").write_text(losses, encoding="utf-8")
    assert_as_in(done.text, case / "expected.sdf")
    assert losses == (case / "losses.txt").read_text(encoding="utf-8")
