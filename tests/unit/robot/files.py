"""Small documents on disk, for tests of what refers to other files."""

from __future__ import annotations

from pathlib import Path

from sdfcheck.files.library import Library, SearchPaths
from sdfcheck.lint.diagnostic import Diagnostic
from sdfcheck.lint.engine import Dispatch, lint_document
from sdfcheck.lint.rulebook.packs import load_index
from sdfcheck.lint.select import ActiveRules
from sdfcheck.source.document import Document, read

WORLD = '<sdf version="1.12"><world name="w">{}</world></sdf>'
MODEL = '<sdf version="1.12"><model name="m">{}</model></sdf>'
ARM = (
    '<sdf version="1.12"><model name="arm">'
    '<link name="base"><visual name="skin"><geometry><box><size>1 1 1</size></box></geometry></visual></link>'
    '<link name="tip"/><joint name="elbow" type="fixed"><parent>base</parent><child>tip</child></joint>'
    '<frame name="grip" attached_to="tip"/></model></sdf>'
)
CONFIG = '<model><name>arm</name><sdf version="1.12">model.sdf</sdf></model>'


def write(folder: Path, files: dict[str, str]) -> None:
    for name, text in files.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")


def opened(path: Path, *model_folders: Path) -> Document:
    """The document of a file, with a library."""
    document = read(path.read_bytes(), path)
    document.library = Library(SearchPaths(models=model_folders))
    return document


def document(folder: Path, text: str, **files: str) -> Document:
    """A document in a folder with ``arm.sdf`` and other files beside it."""
    write(
        folder, {"arm.sdf": ARM, "main.sdf": text, **{f"{name}.sdf": other for name, other in files.items()}}
    )
    return opened(folder / "main.sdf")


def reported(document: Document, family: str = "RES") -> list[Diagnostic]:
    """The reports of the rules of a family in a document."""
    index = load_index()
    facts = tuple(facts for facts in index.facts if facts.family == family)
    return lint_document(document, Dispatch(index, ActiveRules(facts, {})))


def codes(document: Document, family: str = "RES") -> list[str]:
    return [diagnostic.code for diagnostic in reported(document, family)]
