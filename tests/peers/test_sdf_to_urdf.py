"""Real SDF models as URDF: other consumers accept them and place links where we do, and they come back the same."""

from __future__ import annotations

import re
import shutil
import subprocess
from collections.abc import Callable, Iterator
from functools import cache
from pathlib import Path

import pytest

from sdfcheck.convert.independent import Judge, second_opinion
from sdfcheck.convert.ledger import models
from sdfcheck.convert.loss import NotConvertible
from sdfcheck.convert.result import Conversion
from sdfcheck.convert.sdf_to_urdf import convert
from sdfcheck.files.library import Library, SearchPaths
from sdfcheck.source.document import Document
from sdfcheck.source.sniff import Kind
from tests.peers import cmdcheck, libsdformat
from tests.peers.findings import SHARED
from tests.there_and_back import there_and_back, untold

CORPUS = SHARED / "corpus"
REFUSED = {
    "four_bar_loop.sdf": "leads to no link",  # its frames are attached to `world`, which a model does not have
    "four_bar_weld.sdf": "leads to no link",
    "graph_four_bar.sdf": "closes a loop",
    "graph_loop.sdf": "closes a loop",
    "joint_revolute_two_joints_two_links.sdf": "closes a loop",
}
LEAST = 180

pytestmark = [
    pytest.mark.peers,
    pytest.mark.skipif(not CORPUS.is_dir(), reason="the files to convert are not here"),
]


def single_models() -> Iterator[Document]:
    """The files with one model, nothing else in which they look for others."""
    library = Library(SearchPaths((CORPUS / "PX4-gazebo-models" / "models",), (CORPUS,)))
    for path in sorted((*CORPUS.rglob("*.sdf"), *CORPUS.rglob("*.world"))):
        document = library.document(path)
        if document is None or document.kind is not Kind.SDF or document.root is None:
            continue
        document.library = library
        if len(models(document)) == 1:
            yield document


@cache
def outcomes() -> list[tuple[Document, Conversion | NotConvertible]]:
    return [(document, outcome(document)) for document in single_models()]


def outcome(document: Document) -> Conversion | NotConvertible:
    try:
        return convert(document)
    except NotConvertible as error:
        return error


def conversions() -> list[tuple[Document, Conversion]]:
    return [(document, done) for document, done in outcomes() if isinstance(done, Conversion)]


def test_a_refused_model_is_not_a_tree() -> None:
    refused = {
        document.path.name: done.loss.message
        for document, done in outcomes()
        if isinstance(done, NotConvertible)
    }
    assert set(refused) == set(REFUSED)
    for name, message in refused.items():
        assert REFUSED[name] in message


def test_every_tree_is_converted_and_verified() -> None:
    found = conversions()
    assert len(found) >= LEAST
    for document, done in found:
        assert done.verification is not None
        assert done.verification.is_equal, (document.path, done.verification.differences)


def test_urdfdom_accepts_them(tmp_path: Path) -> None:
    if shutil.which("check_urdf") is None:
        pytest.skip("check_urdf is not installed")
    for document, done in conversions():
        target = tmp_path / "robot.urdf"
        target.write_text(done.text)
        child = subprocess.run(["check_urdf", target], capture_output=True, text=True, check=False)
        assert child.returncode == 0, (document.path, child.stderr)


def test_yourdfpy_places_their_links_alike(stride: Callable[[int], int]) -> None:
    pytest.importorskip("yourdfpy")
    for document, done in conversions()[:: stride(30)]:  # a process for each takes its time
        if re.search("<drake:(capsule|ellipsoid)", done.text):
            continue  # shapes of URDF that it refuses
        assert not second_opinion(done, document, [Judge.YOURDFPY]).differences, document.path


def test_they_come_back_the_same(stride: Callable[[int], int]) -> None:
    for document, _ in conversions()[:: stride(2)]:
        changes, losses = there_and_back(document)
        assert not list(untold(changes, losses)), document.path


NOT_FOR_LIBSDFORMAT = {
    "universal_joint.sdf": "at least one link",  # it drops massless links, and the joint in two parts needs one
    **dict.fromkeys(
        ("airspeed", "quadtailsitter", "tiltrotor"), "sensor type"
    ),  # too new a sensor for release 12
}
"""Files or their folders, and what libsdformat says of them."""


def test_libsdformat_accepts_them(tmp_path: Path, stride: Callable[[int], int]) -> None:
    if libsdformat.library() is None:
        pytest.skip("libsdformat is not installed")
    target = tmp_path / "robot.urdf"
    for number, (document, done) in enumerate(conversions()):
        if number % stride(10) and 'type="floating"' not in done.text:
            continue  # all with joints that it does not have, and some of the others
        target.write_text(done.text)
        opinion = cmdcheck.check(target)
        path = document.path
        known = NOT_FOR_LIBSDFORMAT.get(path.name) or NOT_FOR_LIBSDFORMAT.get(path.parent.name)
        assert opinion.accepted or (known and known in opinion.messages[0]), (path, opinion.messages)


def test_odd_documents_are_converted_or_refused() -> None:
    library = Library()
    for path in sorted((SHARED / "peer-cases").rglob("*.sdf")):
        document = library.document(path)
        if document is None or document.kind is not Kind.SDF or document.root is None:
            continue
        document.library = library
        if len(models(document)) == 1:
            done = outcome(document)
            is_broken = not document.is_wellformed  # then there is nothing to verify
            assert isinstance(done, NotConvertible) or is_broken or done.verifications[0].is_equal, path
