"""Meshes, textures, scripts and sounds: is each where its URI leads?

No reader refuses a description for one that is absent: it is drawn without, and
collides with nothing. Nothing is fetched, and nothing is read.
"""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator
from pathlib import Path

from sdfcheck.files.uris import Location, locate
from sdfcheck.formats.sdf.survey import survey
from sdfcheck.robot.file_problems import MissingFile, MissingFolder, MissingOwner, UnportableUri
from sdfcheck.robot.gazebo_blocks import extension_parts
from sdfcheck.robot.uri_spelling import absolute, malformed, misspelt
from sdfcheck.source.document import Document
from sdfcheck.source.element import Element, Value

_MAPS = (
    "albedo_map", "ambient_occlusion_map", "emissive_map", "environment_map", "glossiness_map", "light_map",
    "metalness_map", "normal_map", "roughness_map", "specular_map",
)  # fmt: skip
_PBR = frozenset({"metal", "specular", "shader"})

_PLACES: dict[str, frozenset[str]] = {
    "uri": frozenset({"mesh", "heightmap", "image", "script", "audio_source"}),
    "filename": frozenset({"mesh", "skin", "animation"}),
    "texture": frozenset({"projector"}),
    "diffuse": frozenset({"texture"}),
    "normal": frozenset({"texture"}),
    "cubemap_uri": frozenset({"sky"}),
    "color_range_image": frozenset({"particle_emitter"}),
    **dict.fromkeys(_MAPS, _PBR),
}
"""Elements whose text names a file, and the parents below which it does."""

_WHAT = {"script": "material script", "skin": "mesh", "audio_source": "sound", "texture": "texture"}
_SHIPPED = ("file://media/", "__default__")
"""What Gazebo Classic brings along, and the word for nothing."""
_TEXTURE_FOLDERS = ("materials/textures", "../materials/textures", "../textures")


def problems(document: Document) -> list[object]:
    """What is wrong with the files that an SDF document names, includes aside."""
    return _judge(document, list(_references(document)))


def urdf_problems(document: Document) -> list[object]:
    """The same for the meshes and textures of a URDF document."""
    from sdfcheck.formats.urdf import survey as urdf_survey

    index = urdf_survey.survey(document).index
    uses = [
        (value, kind)
        for kind in ("mesh", "texture")
        for element in index.get(kind, ())
        if (value := element.attribute("filename")) is not None
    ]
    # What stands in <gazebo> is for Gazebo alone: it knows all schemes, and where its own pictures are.
    of_gazebo = [
        (value, what)
        for block in index.get("gazebo", ())
        for value, what in _named_in(extension_parts(block))
        if "/" in value.text
    ]
    return [*_judge(document, [*uses, *of_gazebo]), *_unportable([value for value, _ in uses])]


def _references(document: Document) -> Iterator[tuple[Value, str]]:
    index = survey(document).index
    return _named_in(element for name in _PLACES for element in index.get(name, ()))


def _named_in(elements: Iterable[Element]) -> Iterator[tuple[Value, str]]:
    """The files that elements name by their text, and what kind of file each is."""
    for element in elements:
        parent, name = element.parent, element.tag
        if parent is not None and parent.tag in _PLACES.get(name, ()):
            default = "texture" if name in _MAPS or parent.tag in {"projector", "sky"} else parent.tag
            yield element.own_value, _WHAT.get(parent.tag, default)


def _judge(document: Document, uses: list[tuple[Value, str]]) -> list[object]:
    sorting = _Sorting(document)
    for value, what in uses:
        text = value.text.strip()
        if text and not text.startswith(_SHIPPED) and "$(" not in text and "${" not in text:
            sorting.take(value, what)
    return sorting.conclude()


class _Sorting:
    """What is wrong with one URI after the other; what is lacked as a whole is told once."""

    def __init__(self, document: Document) -> None:
        self.document = document
        self.found: list[object] = []
        self.owners: dict[tuple[str, str], list[Value]] = {}
        self.folders: dict[str, list[Value]] = {}
        self.files: dict[tuple[str, str], list[tuple[Value, Location, str | None]]] = {}

    def take(self, value: Value, what: str) -> None:
        slip = malformed(value) or absolute(value)
        if slip is not None:
            self.found.append(slip)
        elif self.document.library is not None:
            location = locate(self.document, value.text)
            if location.path is None and location.is_local and not _texture(self.document, what, value.text):
                self.lacks(value, what, location)

    def lacks(self, value: Value, what: str, location: Location) -> None:
        if slip := misspelt(value, location):
            self.found.append(slip)
            return
        if location.is_searched_for and location.owner is None:
            self.owners.setdefault((location.scheme, location.name), []).append(value)
            return
        expected = _expected(location)
        folder = None if expected is None else os.path.dirname(expected) or os.curdir
        if folder is None or self.has_folder(folder):
            self.files.setdefault((value.text.strip(), what), []).append((value, location, expected))
        else:
            self.folders.setdefault(folder, []).append(value)

    def has_folder(self, folder: str) -> bool:
        return folder not in self.folders and os.path.isdir(folder)

    def conclude(self) -> list[object]:
        for (_, what), names in self.files.items():
            value, location, expected = names[0]
            self.found.append(_missing(value, what, location, expected, len(names)))
        for uses in self.owners.values():
            location = locate(self.document, uses[0].text)
            self.found.append(MissingOwner(uses[0], location, tuple(uses)))
        for folder, uses in self.folders.items():
            location = locate(self.document, uses[0].text)
            self.found.append(MissingFolder(uses[0], Path(folder), location, tuple(uses)))
        return self.found


def _texture(document: Document, what: str, text: str) -> bool:
    """Gazebo also looks for the bare name of a picture in the folders that models keep theirs in."""
    if what not in {"texture", "heightmap", "projector"} or "/" in text:
        return False
    folder = document.path.parent
    return any(os.path.exists(folder / place / text) for place in _TEXTURE_FOLDERS)


def _missing(value: Value, what: str, location: Location, expected: str | None, count: int) -> MissingFile:
    if expected is None:
        return MissingFile(value, what, location, None, has_kin=False, count=count)
    from sdfcheck.formats.suggest import suggest

    folder, own = os.path.split(expected)
    suffix = os.path.splitext(own)[1]
    try:
        beside = [name for name in os.listdir(folder or os.curdir) if name.endswith(suffix)]
    except OSError:
        beside = []
    return MissingFile(value, what, location, suggest(own, beside), bool(beside), count)


def _expected(location: Location) -> str | None:
    """Of the paths that were tried the one in the model or package that was found."""
    if location.owner is None:
        return next(iter(location.tried), None)
    first = location.tried[0]
    return first if first.startswith(f"{os.path.normpath(location.owner)}{os.sep}") else None


def _unportable(uses: list[Value]) -> Iterator[UnportableUri]:
    """RViz and the readers built on ROS's resource retriever take package, file and web addresses only."""
    by_scheme: dict[str, list[Value]] = {}
    for value in uses:
        text = value.text.strip()
        scheme, delimiter, _ = text.partition("://")
        if text and not text.startswith("/") and "$" not in text and "\\" not in text and ":/" not in scheme:
            by_scheme.setdefault(scheme.lower() if delimiter else "", []).append(value)
    for scheme in ("", "model"):
        if values := by_scheme.get(scheme):
            yield UnportableUri(values[0], scheme, tuple(values))
