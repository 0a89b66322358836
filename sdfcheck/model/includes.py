"""Included models: found, read once, and said by what name they go.

Source: libsdformat 17's parser.cc for what an include accepts, gz-sim for the folders
in which it looks.
"""

from __future__ import annotations

from pathlib import Path
from typing import NamedTuple

from sdfcheck.formats.version import Version
from sdfcheck.model.uris import Location, locate
from sdfcheck.source.document import Document
from sdfcheck.source.element import Element, Value

INCLUDABLE = ("model", "actor", "light")
"""What an included file may hold, in the order in which libsdformat prefers them."""


class Included(NamedTuple):
    """What one ``include`` brings.

    ``model`` is the included file's model, actor or light (or a URDF's robot), in a
    document of its own, None where there is none to be had; ``kind`` is what it counts
    as. ``name`` is the name by which it goes here, None where it is not known.
    """

    include: Element
    uri: Value | None
    location: Location | None
    file: Path | None
    """The file that was read, behind a folder's ``model.config``."""
    model: Element | None
    kind: str | None
    name: str | None
    merge: bool
    is_static: bool
    cycle: tuple[Value, ...] = ()
    """The chain of includes that leads back to a file that is being read, from the outside in."""


def included(document: Document, include: Element) -> Included:
    """Resolve one include of a document, once."""
    resolved = document.view(_Resolved)
    if include not in resolved:
        resolved[include] = _resolve(document, include)
    return resolved[include]


class _Resolved(dict[Element, Included]):
    def __init__(self, document: Document) -> None:
        super().__init__()


def _resolve(document: Document, include: Element) -> Included:
    name, static, uri = include.find("name"), include.find("static"), include.find("uri")
    result = Included(
        include,
        uri.own_value if uri is not None and uri.content else None,
        None,
        None,
        None,
        None,
        (name.content or None) if name is not None else None,
        _is_true(include.attributes.get("merge", "")),
        static is not None and _is_true(static.content),
    )
    if result.uri is None:
        return result
    location = locate(document, result.uri.text)
    result = result._replace(location=location)
    if location.path is None:
        return result
    file = model_file(document, location.path)
    if file is None:
        return result
    result = result._replace(file=file)
    if cycle := _cycle(document, file, result.uri):
        return result._replace(cycle=cycle)
    library = document.library
    other = library.document(file) if library is not None else None
    if other is None or other.root is None:
        return result
    other.included_by = (*document.included_by, result.uri)
    model = included_element(other)
    if model is None:
        return result
    kind = "model" if model.name == "robot" else model.name
    own = model.attributes.get("name", "").strip() or None
    return result._replace(model=model, kind=kind, name=result.name or own)


def included_element(document: Document) -> Element | None:
    """The model, actor or light of a file, or the robot of a URDF."""
    root = document.root
    if root is None:
        return None
    if root.name == "robot":
        return root
    return next((found for kind in INCLUDABLE if (found := root.find(kind)) is not None), None)


def model_file(document: Document, path: Path) -> Path | None:
    """The description behind a path: itself, or what a folder's ``model.config`` names."""
    if not path.is_dir():
        return path
    library = document.library
    config = library.document(path / "model.config") if library is not None else None
    if config is None or config.root is None:
        return None
    entries = [entry for entry in config.root.children("sdf") if entry.content]
    if not entries:
        return None

    def rank(entry: Element) -> tuple[int, int]:
        return Version.parse(entry.attributes.get("version", "").strip()) or (0, 0)

    chosen = max(entries, key=rank)
    file = path / chosen.content
    return file if file.is_file() else None


def _cycle(document: Document, file: Path, uri: Value) -> tuple[Value, ...]:
    """The includes that lead from ``file`` back to itself; empty if they don't."""
    chain = (*document.included_by, uri)
    real = file.resolve()
    for number, step in enumerate(chain):
        if step.element.document.path.resolve() == real:
            return chain[number:]
    return ()


def _is_true(text: str) -> bool:
    return text.strip().lower() in {"true", "1"}
