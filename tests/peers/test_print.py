"""The canonical form means to libsdformat what its source meant."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from sdfcheck.convert.canonical import CanonicalStyle, canonical
from sdfcheck.formats.version import Version
from sdfcheck.source.document import Document
from tests.peers.cmdprint import version_of
from tests.peers.findings import SHARED
from tests.peers.libsdformat import library
from tests.peers.migrations import documents, trees
from tests.peers.trees import differences

LEAST = 150

pytestmark = [
    pytest.mark.peers,
    pytest.mark.skipif(library() is None, reason="libsdformat is not installed"),
]


def known_documents() -> Iterator[Document]:
    newest = Version.parse(version_of(library() or ""))
    for document in documents():
        own = Version.parse(document.version or "")
        if own is not None and newest is not None and own <= newest:
            yield document


def test_the_canonical_form_is_the_same_to_libsdformat(tmp_path: Path, stride: Callable[[int], int]) -> None:
    given = list(known_documents())[:: stride(8)]
    theirs = trees([(document, document.source.text) for document in given], tmp_path)
    ours = trees([(document, canonical(document, CanonicalStyle()).text) for document in given], tmp_path)
    wrong, compared = [], 0
    for document, their, our in zip(given, theirs, ours, strict=True):
        assert (their is None) == (our is None), document.path
        if their is not None and our is not None:
            compared += 1
            wrong += [f"{document.path}: {one}" for one in differences(their, our)]
    assert wrong == []
    assert compared >= (LEAST if SHARED.is_dir() else 10) // stride(8)
