"""Meshes, textures, scripts and sounds: is each where its URI leads?

No reader refuses a description for one that is absent: it is drawn without, and
collides with nothing. Nothing is fetched, and nothing is read.
"""

from __future__ import annotations

import os
from collections.abc import Iterator
from pathlib import Path

from sdfcheck.formats.survey import survey
from sdfcheck.model.file_problems import MissingFile, MissingOwner, UnportableUri
from sdfcheck.model.uri_spelling import absolute, malformed, misspelt
from sdfcheck.model.uris import Location, locate
from sdfcheck.source.document import Document
from sdfcheck.source.element import Value

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
    from sdfcheck.formats import urdf_survey

    index = urdf_survey.survey(document).index
    uses = [
        (value, kind)
        for kind in ("mesh", "texture")
        for element in index.get(kind, ())
        if (value := element.attribute("filename")) is not None
    ]
    return [*_judge(document, uses), *_unportable([value for value, _ in uses])]


def _references(document: Document) -> Iterator[tuple[Value, str]]:
    index = survey(document).index
    for name, parents in _PLACES.items():
        for element in index.get(name, ()):
            parent = element.parent
            if parent is not None and parent.tag in parents:
                default = "texture" if name in _MAPS or parent.tag in {"projector", "sky"} else parent.tag
                yield element.own_value, _WHAT.get(parent.tag, default)


def _judge(document: Document, uses: list[tuple[Value, str]]) -> list[object]:
    found: list[object] = []
    owners: dict[tuple[str, str], list[Value]] = {}
    for value, what in uses:
        text = value.text.strip()
        if not text or text.startswith(_SHIPPED) or "$(" in text or "${" in text:
            continue
        slip = malformed(value) or absolute(value)
        if slip is not None:
            found.append(slip)
        elif document.library is not None:
            location = locate(document, text)
            if location.path is not None or not location.is_local or _texture(document, what, text):
                continue
            if location.is_searched_for and location.owner is None and location.near is None:
                owners.setdefault((location.scheme, location.name), []).append(value)
            else:
                found.append(misspelt(value, location) or _missing(value, what, location))
    for same in owners.values():
        found += [MissingOwner(same[0], locate(document, same[0].text.strip()), tuple(same))]
    return found


def _texture(document: Document, what: str, text: str) -> bool:
    """Gazebo also looks for the bare name of a picture in the folders that models keep theirs in."""
    if what not in {"texture", "heightmap", "projector"} or "/" in text:
        return False
    folder = document.path.parent
    return any(os.path.exists(folder / place / text) for place in _TEXTURE_FOLDERS)


def _missing(value: Value, what: str, location: Location) -> MissingFile:
    wanted = _expected(location)
    apart, suggestion = True, None
    if wanted is not None and os.path.isdir(wanted.parent):
        from sdfcheck.formats.suggest import suggest

        apart = False
        try:
            beside = [name for name in os.listdir(wanted.parent) if name.endswith(wanted.suffix)]
        except OSError:
            beside = []
        suggestion = suggest(wanted.name, beside)
    return MissingFile(value, what, location, apart, suggestion)


def _expected(location: Location) -> Path | None:
    """Of the paths that were tried the one in the model or package that was found."""
    if location.owner is None:
        return next(iter(location.tried), None)
    owner = os.path.normpath(location.owner)
    return next((path for path in location.tried if str(path).startswith(f"{owner}{os.sep}")), None)


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
