"""The meshes of a scene: each file once, embedded if it is not too large."""

from __future__ import annotations

import base64
from pathlib import Path
from typing import Any

from lxml import etree

from sdfcheck.files.uris import locate
from sdfcheck.source.document import Document

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
            self.entries.append(self._entry(uri, path))
        return number

    def _entry(self, uri: str, path: Path | None) -> dict[str, Any]:
        name = uri.rpartition("/")[2]
        form = FORMATS.get(Path(name).suffix.lower())
        if path is None or not path.is_file():
            return {"name": name, "missing": "not found"}
        if form is None:
            return {"name": name, "missing": "a format that is not shown"}
        size = path.stat().st_size
        if size > min(self._one, self._left):
            return {"name": name, "missing": f"too large to embed ({size / 1e6:.0f} MB)"}
        self._left -= size
        try:
            data = path.read_bytes()
        except OSError:
            return {"name": name, "missing": "cannot be read"}
        if form == "dae" and not _is_well_formed(data):
            return {"name": name, "missing": "not well-formed"}
        return {"name": name, "format": form, "data": base64.b64encode(data).decode()}


def _is_well_formed(data: bytes) -> bool:
    """Whether a page can read the XML; what browsers say of broken XML would be styled against the page's policy."""
    try:
        etree.fromstring(data, etree.XMLParser(resolve_entities=False, no_network=True, huge_tree=True))
    except etree.XMLSyntaxError:
        return False
    return True
