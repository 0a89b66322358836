"""Real robots, converted both ways: their consumers take the results, references lead somewhere, nothing is refused."""

from __future__ import annotations

from pathlib import Path

import pytest

from sdfcheck.consumers.engines import Engine, is_installed
from sdfcheck.source.sniff import Kind
from tests.peers.conversions import Done, Finding, Job, broken, examine
from tests.peers.findings import SHARED

CORPUS = SHARED / "corpus"
FOLDERS = ("urdf_files_dataset", "sdformat_urdf", "PX4-gazebo-models/models", "drake")
LEAST = 270
"""Robots that are converted."""
KNOWN = frozenset({"Unknown geometry type 'drake:capsule'", "Unknown geometry type 'drake:ellipsoid'"})
"""The shapes of files that are written for Drake, of which others say that they do not have them."""

pytestmark = [
    pytest.mark.peers,
    pytest.mark.skipif(not CORPUS.is_dir(), reason="the files to convert are not here"),
    pytest.mark.skipif(not is_installed(Engine.LIBSDFORMAT), reason="libsdformat is not installed"),
    pytest.mark.skipif(not is_installed(Engine.URDFDOM), reason="urdfdom is not installed"),
]


@pytest.fixture(scope="module")
def examined(tmp_path_factory: pytest.TempPathFactory) -> tuple[list[Done], list[Finding]]:
    return examine([CORPUS / folder for folder in FOLDERS], tmp_path_factory.mktemp("results"))


def test_robots_are_converted(examined: tuple[list[Done], list[Finding]]) -> None:
    assert sum(one.is_written for one in examined[0]) >= LEAST


@pytest.mark.parametrize("kind", ["reference", "refused result", "complaint", "false refusal"])
def test_nothing_is_wrong(examined: tuple[list[Done], list[Finding]], kind: str) -> None:
    found = [one for one in examined[1] if one.kind == kind and not any(text in one.text for text in KNOWN)]
    assert not found, "\n".join(map(str, found))


BROKEN = """<robot name="r"><link name="a"/><gazebo>
<plugin name="p" filename="f"><bodyName>a</bodyName></plugin></gazebo></robot>"""


def test_a_reference_that_breaks_is_found(tmp_path: Path) -> None:
    source, target = tmp_path / "a.urdf", tmp_path / "a.sdf"
    source.write_text(BROKEN)
    target.write_text(BROKEN.replace("<bodyName>a<", "<bodyName>b<"))
    job = Job(source, Kind.URDF, "", target)
    assert [one.kind for one in broken(Done(job, "", ()))] == ["reference"]
    assert not list(broken(Done(job, "", (("CNV018", "info", "`a` is part of another"),))))
