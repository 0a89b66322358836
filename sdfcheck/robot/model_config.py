"""``model.config``: which file of a model folder is the model, and what can be wrong with saying so.

Source: libsdformat 17's ``getModelFilePath``, checked against what it does.
"""

from __future__ import annotations

import os
import re
from enum import Enum
from pathlib import Path

from sdfcheck.files.library import library_of
from sdfcheck.formats.sdf.version import NEWEST
from sdfcheck.source.document import Document
from sdfcheck.source.element import Element, Value
from sdfcheck.source.problems import SyntaxDefect
from sdfcheck.source.record import Record
from sdfcheck.source.sniff import TEMPLATE_SUFFIXES, Kind

CONFIG = "model.config"
OLD_CONFIG = "manifest.xml"

_NUMBERS = re.compile(r"\s*(\d+)\.(\d+)\s*")
_MADE_FROM = TEMPLATE_SUFFIXES | {".xacro"}


class ConfigFault(Enum):
    """The ways in which a ``model.config`` fails."""

    NO_MODEL = "no model element"
    NO_NAME = "no name"
    NO_NAME_NO_FILE = "neither name nor sdf"
    NO_FILE = "no sdf"
    EMPTY_FILE = "empty sdf"
    NO_VERSION = "no version"
    BAD_VERSION = "bad version"
    TOO_NEW = "too new"
    MISSING_FILE = "missing file"
    UNMADE_FILE = "file not made yet"


class InvalidModelConfig(Record):
    """Something in a ``model.config`` that readers stumble over.

    ``place`` is an element, or a value of one; ``near`` what a missing file may be called.
    """

    place: Element | Value
    fault: ConfigFault
    near: str | None = None


def problems(document: Document) -> list[InvalidModelConfig]:
    """What is wrong with a ``model.config``, beyond its XML."""
    root = document.root
    if root is None or any(isinstance(problem, SyntaxDefect) for problem in document.problems):
        return []  # what is not well formed is told as that
    if root.name != "model":
        return [InvalidModelConfig(root, ConfigFault.NO_MODEL)]
    found: list[InvalidModelConfig] = []
    name, entries = root.find("name"), list(root.children("sdf"))
    is_named = name is not None and name.content != ""
    if not entries:
        fault = ConfigFault.NO_FILE if is_named else ConfigFault.NO_NAME_NO_FILE
        return [InvalidModelConfig(root, fault)]
    if not is_named:
        found.append(InvalidModelConfig(root if name is None else name, ConfigFault.NO_NAME))
    chosen = chosen_entry(root)
    for entry in entries:
        found += _of_entry(document, entry, is_chosen=entry is chosen)
    return found


def chosen_entry(root: Element) -> Element | None:
    """The ``sdf`` element that is read: the highest version that is not newer than the format's newest."""

    def rank(entry: Element) -> tuple[int, ...]:
        version = _version(entry) or (0, 0)
        return (-1,) if version > NEWEST else version

    return max(root.children("sdf"), key=rank, default=None)


def config_of(document: Document, folder: Path) -> Document | None:
    """The ``model.config`` of a model folder, or the manifest that came before it."""
    library = library_of(document)
    for name in (CONFIG, OLD_CONFIG):
        if library is not None and os.path.isfile(folder / name):
            return library.document(folder / name, Kind.MODEL_CONFIG)
    return None


def model_file(config: Document) -> Path | None:
    """The file that a ``model.config`` names, None if there is none of that name."""
    entry = chosen_entry(config.root) if config.root is not None else None
    if entry is None or not entry.content:
        return None
    file = config.path.parent / entry.content
    return file if os.path.isfile(file) else None


def _of_entry(document: Document, entry: Element, *, is_chosen: bool) -> list[InvalidModelConfig]:
    found = []
    version = entry.attribute("version")
    if version is None or not version.text.strip():
        found.append(InvalidModelConfig(entry, ConfigFault.NO_VERSION))
    elif (numbers := _version(entry)) is None:
        found.append(InvalidModelConfig(version, ConfigFault.BAD_VERSION))
    elif numbers > NEWEST:
        found.append(InvalidModelConfig(version, ConfigFault.TOO_NEW))
    if not entry.content:
        if is_chosen:
            found.append(InvalidModelConfig(entry, ConfigFault.EMPTY_FILE))
    elif not os.path.isfile(document.path.parent / entry.content) and document.library is not None:
        template = _template(document.path.parent, entry.content)
        fault = ConfigFault.MISSING_FILE if template is None else ConfigFault.UNMADE_FILE
        near = template or _near(document.path.parent, entry.content)
        found.append(InvalidModelConfig(entry.own_value, fault, near))
    return found


def _template(folder: Path, name: str) -> str | None:
    """The file in the folder from which one of that name is to be made."""
    stems = {name, os.path.splitext(name)[0]}
    try:
        split = map(os.path.splitext, sorted(os.listdir(folder)))
    except OSError:
        return None
    made = (stem + suffix for stem, suffix in split if stem in stems and suffix.lower() in _MADE_FROM)
    return next(made, None)


def _version(entry: Element) -> tuple[int, int] | None:
    match = _NUMBERS.fullmatch(entry.attributes.get("version", ""))
    return (int(match[1]), int(match[2])) if match else None


def _near(folder: Path, name: str) -> str | None:
    """A description in the folder that may be meant."""
    from sdfcheck.formats.suggest import suggest

    try:
        there = sorted(entry for entry in os.listdir(folder) if entry.endswith((".sdf", ".urdf")))
    except OSError:
        return None
    return there[0] if len(there) == 1 else suggest(name, there)
