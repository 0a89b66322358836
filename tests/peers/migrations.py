"""Documents to migrate or print, and what libsdformat makes of the results."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from pathlib import Path

from lxml import etree

from sdfcheck.files.library import Library
from sdfcheck.source.document import Document
from tests.peers.cmdprint import Job, printed
from tests.peers.findings import SHARED

FIXTURES = Path(__file__).parents[2] / "fixtures" / "convert" / "sdf-to-sdf"
LARGEST = 4_000
"""Bytes; printing larger files takes long and says the same."""


def documents() -> Iterator[Document]:
    """Real files, and the sources of our own golden pairs."""
    real = sorted((SHARED / "corpus").rglob("*.sdf")) if SHARED.is_dir() else []
    for path in (*sorted(FIXTURES.glob("*/input.sdf")), *real):
        document = Library().document(path) if path.stat().st_size <= LARGEST else None
        if document is not None and document.root is not None and document.root.name == "sdf":
            yield document


def trees(texts: Sequence[tuple[Document, str]], folder: Path) -> list[etree._Element | None]:
    """The print of texts by libsdformat, each in the place of its document."""
    jobs = []
    for number, (document, text) in enumerate(texts):
        file = folder / f"{number}.sdf"
        file.write_text(text, encoding="utf-8")
        jobs.append(Job(file, document.path.parent))
    parser = etree.XMLParser(recover=True, remove_comments=True)
    found = printed(jobs)
    return [etree.fromstring(text.encode(), parser) if text else None for text in found]
