"""The meshes of a scene and its numbers, as the page reads them; each file once, embedded if it is not too large."""

from __future__ import annotations

import base64
import math
import re
from pathlib import Path
from typing import Any
from urllib.parse import unquote

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
        entry = {"name": name, "format": form, "data": base64.b64encode(data).decode()}
        return entry | self._beside(path, data, form, document)

    def _beside(self, mesh: Path, data: bytes, form: str, document: Document) -> Json:
        """The files beside a mesh that give its colors, by name, and a note for each that is not there."""
        found: dict[str, str] = {}
        notes: list[str] = []
        materials = _LIBRARIES.findall(data) if form == "obj" else ()
        texts = [self._text(mesh, name, document) for name in map(_decoded, materials)]
        names = [_decoded(name) for text in texts for name in _MAPS.findall(text)]
        if form == "dae":
            names = _diffuse_images(data)
        for name, text in zip(map(_decoded, materials), texts, strict=True):
            if b"newmtl" in text:
                found[_last(name)] = "data:text/plain;base64," + base64.b64encode(text).decode()
            else:
                notes.append(f"material library {_last(name)} is not found")
        for name in dict.fromkeys(names):
            picture = self._text(mesh, name, document)
            kind = next((kind for start, kind in _PICTURES if re.match(start, picture, re.DOTALL)), None)
            if kind:
                found[_last(name)] = f"data:image/{kind};base64,{base64.b64encode(picture).decode()}"
            else:
                notes.append(
                    f"texture {_last(name)} is {'not a picture that is shown' if picture else 'not found'}"
                )
        return {key: value for key, value in (("files", found), ("notes", notes)) if value}

    def _text(self, mesh: Path, name: str, document: Document) -> bytes:
        """A file that a mesh names, from its folder or from where Gazebo keeps textures; empty if it is not there."""
        library = library_of(document)
        named = name.removeprefix("file://").replace("\\", "/")
        for path in (mesh.parent / named, mesh.parent / _last(name), mesh.parent / _TEXTURES / _last(name)):
            try:
                data = library.read(path, document, min(self._one, self._left)) if library else b""
            except (OSError, ValueError):
                continue
            self._left -= len(data)
            return data
        return b""


_LIBRARIES = re.compile(rb"^[ \t]*mtllib[ \t]+(\S.*?)[ \t\r]*$", re.MULTILINE)
_MAPS = re.compile(
    rb"^[ \t]*map_Kd[ \t]+(?:-\w+[ \t]+(?:[-+.\d]+[ \t]+|on[ \t]+|off[ \t]+)*)*(\S.*?)[ \t\r]*$", re.MULTILINE
)
_TEXTURES = "../materials/textures"
_PICTURES = (
    (rb"\x89PNG", "png"),
    (rb"\xff\xd8\xff", "jpeg"),
    (rb"GIF8", "gif"),
    (rb"BM.{4}\0\0\0\0", "bmp"),
    (rb"RIFF.{4}WEBP", "webp"),
    (rb".[\0\1][\1\2\3\x09\x0a\x0b].{13}[\x08\x10\x18\x20]", "x-tga"),
)
"""How the pictures begin that the page shows."""


def _decoded(name: bytes) -> str:
    return name.decode("utf-8", "replace")


def _last(name: str) -> str:
    return re.split(r"[/\\]", name)[-1]


def _diffuse_images(data: bytes) -> list[str]:
    """The pictures that give the surfaces of a COLLADA file their colors, as it names them."""
    root = etree.fromstring(data, _PARSER)
    within = "{*}"
    images = {
        image.get("id"): start.text or ""
        for image in root.iter(f"{within}image")
        if (start := image.find(f".//{within}init_from")) is not None
    }
    names = []
    for effect in root.iter(f"{within}effect"):
        leads = {
            parameter.get("sid"): (source.text or source.get("url", "").lstrip("#")).strip()
            for parameter in effect.iter(f"{within}newparam")
            for source in parameter.iter(f"{within}source", f"{within}init_from", f"{within}instance_image")
        }
        for texture in effect.iterfind(f".//{within}diffuse/{within}texture"):
            name = texture.get("texture")
            for _ in leads:
                name = leads.get(name, name)
            if name in images:
                names.append(unquote(images[name].strip()))
    return names


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


_PARSER = etree.XMLParser(resolve_entities=False, no_network=True, huge_tree=True)


def _is_well_formed(data: bytes) -> bool:
    """Whether a page can read the XML; what browsers say of broken XML would be styled against the page's policy."""
    try:
        etree.fromstring(data, _PARSER)
    except etree.XMLSyntaxError:
        return False
    return True
