"""Real robots, converted both ways: their consumers take the results, references lead somewhere, nothing is refused."""

from __future__ import annotations

from pathlib import Path

import pytest

from sdfcheck.consumers.engines import Engine, is_installed, libsdformat
from sdfcheck.source.sniff import Kind
from tests.peers.conversions import Done, Job, broken, examine
from tests.peers.findings import SHARED

CORPUS = SHARED / "corpus"
FOLDERS = ("urdf_files_dataset", "sdformat_urdf", "PX4-gazebo-models/models", "drake")
FEW = ("sdformat_urdf", "PX4-gazebo-models/models/x500_depth", "PX4-gazebo-models/models/rover_ackermann")
LEAST = {FOLDERS: 270, FEW: 45}
"""Folders → so many of their robots are converted at least."""
KNOWN = frozenset({"Unknown geometry type 'drake:capsule'", "Unknown geometry type 'drake:ellipsoid'"})
"""The shapes of files that are written for Drake, of which others say that they do not have them."""
NEWEST_IN = {"12": "1.9", "13": "1.10", "14": "1.11"}
"""Release of libsdformat → the newest version that it reads, where that is not ours."""

pytestmark = [
    pytest.mark.peers,
    pytest.mark.skipif(not CORPUS.is_dir(), reason="the files to convert are not here"),
    pytest.mark.skipif(not is_installed(Engine.LIBSDFORMAT), reason="libsdformat is not installed"),
    pytest.mark.skipif(not is_installed(Engine.URDFDOM), reason="urdfdom is not installed"),
]


def test_nothing_is_wrong(request: pytest.FixtureRequest, tmp_path: Path) -> None:
    """Of a few robots, or with ``--all-examples`` of all that are here."""
    folders = FOLDERS if request.config.getoption("--all-examples") else FEW
    newest = NEWEST_IN.get(libsdformat.version().partition(".")[0], "")
    done, found = examine([CORPUS / folder for folder in folders], tmp_path, newest)
    assert sum(one.is_written for one in done) >= LEAST[folders]
    found = [one for one in found if not any(text in one.text for text in KNOWN)]
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
