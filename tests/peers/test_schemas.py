"""The schemas let pass what the linter lets pass, on real files."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from pathlib import Path

import pytest
from lxml import etree

from sdfcheck.formats.export import rng, xsd
from sdfcheck.formats.version import Version
from tests.peers.findings import SHARED, findings

pytestmark = [
    pytest.mark.peers,
    pytest.mark.skipif(not SHARED.is_dir(), reason="the files to compare on are not here"),
]

OF_SHAPE = ("SCH", "NS", "XML", "NAM", "GAZ")
"""The families whose findings a schema may share."""

ARGUED = {
    "mimic_fast_slow_pendulums_world.sdf": "text in a CDATA section, which consumers ignore",
    "shapes.sdf": "the same",
    "attribute_missing_plugin_filename.sdf": "reported by the family of files",
    "incdeg.sdf": "reported by the family of frames",
}


@cache
def validators(version: Version) -> tuple[etree.XMLSchema, etree.RelaxNG]:
    return (
        etree.XMLSchema(etree.fromstring(xsd(version).encode())),
        etree.RelaxNG(etree.fromstring(rng(version).encode())),
    )


def test_real_files(stride: Callable[[int], int]) -> None:
    checked, refused = 0, []
    paths = sorted(path for path in SHARED.glob("**/*.*") if path.suffix in {".sdf", ".world"})
    for path in paths[:: stride(2)]:
        if path.name in ARGUED:
            continue
        try:
            tree = etree.parse(path)
        except etree.XMLSyntaxError:
            continue
        version = Version.parse(tree.getroot().get("version", ""))
        if tree.getroot().tag != "sdf" or version is None or findings(path, OF_SHAPE):
            continue
        checked += 1
        refused += [f"{path}: {by.error_log}" for by in validators(version) if not by.validate(tree)]
    assert checked > 300 // stride(2)
    assert not refused, "\n".join(refused)


def test_the_argued_files_are_still_there() -> None:
    assert {path.name for path in Path(SHARED).glob("**/*.sdf")} >= ARGUED.keys()
