"""The meshes of a scene and its numbers, as the page reads them; each file once, embedded if it is not too large."""

from __future__ import annotations

import base64
import math
import re
from pathlib import Path
from typing import Any

import numpy as np
from lxml import etree

from sdfcheck.files.library import library_of
from sdfcheck.files.uris import locate
from sdfcheck.robot.motion.poses import Array
from sdfcheck.source.document import Document, Element

# Numbers, transforms and places as the page reads them.

Json = dict[str, Any]


def place(element: Element) -> str:
    """``file:line`` of an element."""
    return f"{element.span.source.path.name}:{element.span.begin.line}"


def flat(transform: Array) -> list[float]:
    """A 4×4 transform column by column; what is not a number is 0, so that the page can draw it."""
    return [finite(number) for number in np.asarray(transform).T.ravel().tolist()]


def finite(number: float, default: float = 0.0) -> float:
    """The number; ``default`` for nan, infinity, and what is too large to be drawn."""
    return float(number) if math.isfinite(number) and abs(number) < 1e15 else default


def bound(number: float) -> float | None:
    """A limit; None for none."""
    return float(number) if math.isfinite(number) and abs(number) < 1e15 else None


FORMATS = {".stl": "stl", ".obj": "obj", ".dae": "dae", ".glb": "gltf", ".gltf": "gltf"}
ONE = 8_000_000
"""Bytes of a file that is embedded."""
ALL = 40_000_000
"""Bytes that are embedded in a page."""


class Meshes:
    """The meshes that the shapes of a scene refer to by number."""

    def __init__(self, *, one: int = ONE, all: int = ALL) -> None:
        self.entries: list[dict[str, Any]] = []
        self._numbers: dict[str, int] = {}
        self._one, self._left = one, all

    def add(self, document: Document, uri: str) -> int:
        """The number of the mesh that a document names."""
        path = locate(document, uri).path
        key = str(path) if path is not None else f"{document.source.path}\0{uri}"
        number = self._numbers.get(key)
        if number is None:
            number = self._numbers[key] = len(self.entries)
            self.entries.append(self._entry(document, uri, path))
        return number

    def _entry(self, document: Document, uri: str, path: Path | None) -> dict[str, Any]:
        name = uri.rpartition("/")[2]
        form = FORMATS.get(Path(name).suffix.lower())
        library = library_of(document)
        if path is None or library is None:
            return {"name": name, "missing": "not found"}
        if form is None:
            return {"name": name, "missing": "a format that is not shown"}
        try:
            size = path.stat().st_size
            if size > min(self._one, self._left):
                return {"name": name, "missing": f"too large to embed ({size / 1e6:.0f} MB)"}
            data = library.read(path, document, min(self._one, self._left))
        except OSError as error:
            return {"name": name, "missing": f"not read: {error.strerror}"}
        if not _is_mesh(form, data):
            return {"name": name, "missing": "not a mesh"}
        if form == "dae" and not _is_well_formed(data):
            return {"name": name, "missing": "not well-formed"}
        self._left -= len(data)
        return {"name": name, "format": form, "data": base64.b64encode(data).decode()}


def _is_mesh(form: str, data: bytes) -> bool:
    """Whether the bytes look like their format: a page shows nothing else of a file."""
    if form == "stl":
        is_text = data[:512].lstrip().startswith(b"solid") and b"facet" in data
        return is_text or 0 < int.from_bytes(data[80:84], "little") * 50 <= len(data) - 84
    if form == "obj":
        return re.search(rb"^[ \t]*v[ \t]+[-+.\d]", data, re.MULTILINE) is not None
    if form == "dae":
        return b"COLLADA" in data[:4096]
    return data.startswith(b"glTF") or (data.lstrip().startswith(b"{") and b'"asset"' in data)


def _is_well_formed(data: bytes) -> bool:
    """Whether a page can read the XML; what browsers say of broken XML would be styled against the page's policy."""
    try:
        etree.fromstring(data, etree.XMLParser(resolve_entities=False, no_network=True, huge_tree=True))
    except etree.XMLSyntaxError:
        return False
    return True
