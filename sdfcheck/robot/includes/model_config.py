"""``model.config``: which file of a model folder is the model, and how it fails to say so.

Source: libsdformat 17's ``getModelFilePath``, checked against what it does.
"""

from __future__ import annotations

import os
import re
from enum import Enum
from pathlib import Path

from sdfcheck.files.library import library_of
from sdfcheck.formats.version import NEWEST
from sdfcheck.robot.values import lazy
from sdfcheck.source.document import Document, Element, Value
from sdfcheck.source.problems import SyntaxDefect
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.sniff import TEMPLATE_SUFFIXES, Kind
from sdfcheck.source.text import Span

CONFIG = "model.config"
OLD_CONFIG = "manifest.xml"

_NUMBERS = re.compile(r"\s*(\d+)(?!\d)[^.]*(?:\.\s*(\d+)(?!\d)[^.]*(?:\.\s*\d.*)?|\.)?", re.DOTALL)
"""As libsdformat reads a version: the number that each part begins with; those left out are 0."""
_PLACEHOLDER = re.compile(r"@\w+@")
_MADE_FROM = TEMPLATE_SUFFIXES | {".xacro"}
_DESCRIPTIONS = (".sdf", ".urdf", ".world", ".xacro")
_BUILD = "CMakeLists.txt"


class ConfigFault(Enum):
    """The ways in which a ``model.config`` fails."""

    NO_MODEL = "no model element"
    NO_NAME = "no name"
    NO_NAME_NO_FILE = "neither name nor sdf"
    NO_FILE = "no sdf"
    EMPTY_FILE = "empty sdf"
    NO_VERSION = "no version"
    EMPTY_VERSION = "empty version"
    BAD_VERSION = "bad version"
    TOO_NEW = "too new"
    MISSING_FILE = "missing file"
    UNMADE_FILE = "file not made yet"
    OTHER_VERSION = "version of the file is another"


class Misconfiguration(NamedTuple):
    """Something in a ``model.config`` that simulators stumble over.

    ``place`` is an element, or a value of one; ``near`` what a missing file may be called.
    """

    place: Element | Value
    fault: ConfigFault
    near: str | None = None


class ModelConfig:
    """The ``model.config`` of a model folder."""

    kind = "model.config"

    def __init__(self, document: Document) -> None:
        assert document.root is not None, "a document without elements says nothing"
        self.document = document
        self.element = document.root

    @property
    def span(self) -> Span:
        """The place of the root element."""
        return self.element.span

    @property
    def name(self) -> str:
        """The name of the model; empty if there is none."""
        name = self.element.find("name")
        return name.content if name is not None else ""

    @property
    def _name_or_root(self) -> Element:
        name = self.element.find("name")
        return self.element if name is None else name

    @property
    def entries(self) -> tuple[Element, ...]:
        """The ``sdf`` elements, each for a version of the format."""
        return tuple(self.element.children("sdf"))

    @property
    def chosen(self) -> Element | None:
        """The one that is read."""
        return chosen_entry(self.element)

    @property
    def file(self) -> Path | None:
        """The file of the model; None if there is none of that name."""
        return model_file(self.document)

    @property
    def is_misconfigured(self) -> bool:
        """Does it fail to say which file is the model?"""
        return bool(self.faults)

    @lazy
    def faults(self) -> tuple[Misconfiguration, ...]:
        """How it fails to say which file is the model."""
        if any(isinstance(problem, SyntaxDefect) for problem in self.document.problems):
            return ()  # what is not well formed is reported as that
        if self.element.name != "model":
            return (Misconfiguration(self.element, ConfigFault.NO_MODEL),)
        if not self.entries:
            if self.name and _is_of_files(self.document.path.parent):
                return ()  # so that addresses lead to the files of a world, or to meshes
            fault = ConfigFault.NO_FILE if self.name else ConfigFault.NO_NAME_NO_FILE
            return (Misconfiguration(self.element, fault),)
        found = []
        if not self.name:
            found.append(Misconfiguration(self._name_or_root, ConfigFault.NO_NAME))
        chosen = self.chosen
        for entry in self.entries:
            found += _of_entry(self.document, entry, is_chosen=entry is chosen)
        return tuple(found)


def chosen_entry(root: Element) -> Element | None:
    """The ``sdf`` element that is read: of the highest version that is not newer than the format's, else the first.

    Source: getBestSupportedModelVersion in libsdformat 17's parser.cc.
    """

    def rank(entry: Element) -> tuple[int, ...]:
        version = _version(entry) or (0, 0)
        return (0, 0) if version > NEWEST else version

    return max(root.children("sdf"), key=rank, default=None)


def config_of(document: Document, folder: Path) -> Document | None:
    """The ``model.config`` of a model folder, or the manifest that came before it."""
    library = library_of(document)
    for name in (CONFIG, OLD_CONFIG):
        if library is not None and os.path.isfile(folder / name):
            return library.document(folder / name, Kind.MODEL_CONFIG, document)
    return None


def is_superseded(document: Document) -> bool:
    """Does the ``model.config`` beside a file name it, and take another one for newer versions?"""
    config = config_of(document, document.path.parent)
    if config is None or config.root is None or model_file(config) in {None, document.path}:
        return False
    return any(entry.content == document.path.name for entry in config.root.children("sdf"))


def model_file(config: Document) -> Path | None:
    """The file that a ``model.config`` names, None if there is none of that name."""
    entry = chosen_entry(config.root) if config.root is not None else None
    if entry is None or not entry.content:
        return None
    file = config.path.parent / entry.content
    return file if os.path.isfile(file) else None


def _of_entry(document: Document, entry: Element, *, is_chosen: bool) -> list[Misconfiguration]:
    found = []
    version = entry.attribute("version")
    if _PLACEHOLDER.search(entry.content) or (version is not None and _PLACEHOLDER.search(version.text)):
        return []  # a template, which a build fills in
    if version is None:
        found.append(Misconfiguration(entry, ConfigFault.NO_VERSION))
    elif not version.text.strip():
        found.append(Misconfiguration(version, ConfigFault.EMPTY_VERSION))
    elif (numbers := _version(entry)) is None:
        found.append(Misconfiguration(version, ConfigFault.BAD_VERSION))
    elif numbers > NEWEST:
        found.append(Misconfiguration(version, ConfigFault.TOO_NEW))
    if not entry.content:
        if is_chosen:
            found.append(Misconfiguration(entry, ConfigFault.EMPTY_FILE))
    elif not os.path.isfile(document.path.parent / entry.content) and document.library is not None:
        template = _template(document.path.parent, entry.content)
        fault = ConfigFault.MISSING_FILE if template is None else ConfigFault.UNMADE_FILE
        near = template or _near(document.path.parent, entry.content)
        found.append(Misconfiguration(entry.own_value, fault, near))
    return found or _of_other_version(document, entry)


def _of_other_version(config: Document, entry: Element) -> list[Misconfiguration]:
    """Whether the file of an entry, if it is SDFormat, declares another version than the entry says."""
    library, version = library_of(config), entry.attribute("version")
    if library is None or version is None or not entry.content:
        return []
    named = library.document(config.path.parent / entry.content, of=config)
    declared = named.version if named is not None and named.kind is Kind.SDF else None
    if not declared or declared == version.text.strip():
        return []
    return [Misconfiguration(version, ConfigFault.OTHER_VERSION, declared)]


def _template(folder: Path, name: str) -> str | None:
    """The file in the folder from which one of that name is to be made.

    That is CMakeLists.txt where the folder holds nothing else that describes a model.
    """
    stems = {name, os.path.splitext(name)[0]}
    try:
        files = sorted(os.listdir(folder))
    except OSError:
        return None
    for stem, suffix in map(os.path.splitext, files):
        if stem in stems and suffix.lower() in _MADE_FROM:
            return stem + suffix
    is_described = any(file.lower().endswith(_DESCRIPTIONS) for file in files)
    return _BUILD if _BUILD in files and not is_described else None


def _is_of_files(folder: Path) -> bool:
    """Does a folder hold a world, or meshes for other models and no description?"""
    try:
        files = os.listdir(folder)
    except OSError:
        return False
    is_described = any(file.lower().endswith(_DESCRIPTIONS) for file in files)
    has_world = any(file.endswith(".world") for file in files)
    return has_world or ("meshes" in files and not is_described)


def _version(entry: Element) -> tuple[int, int] | None:
    match = _NUMBERS.fullmatch(entry.attributes.get("version", ""))
    return (int(match[1]), int(match[2] or 0)) if match else None


def _near(folder: Path, name: str) -> str | None:
    """A description in the folder that may be meant."""
    from sdfcheck.formats.near_names import suggest

    try:
        there = sorted(entry for entry in os.listdir(folder) if entry.endswith((".sdf", ".urdf")))
    except OSError:
        return None
    return there[0] if len(there) == 1 else suggest(name, there)


def model_configs(document: Document) -> tuple[ModelConfig, ...]:
    """The content of a ``model.config``."""
    return (document.view(ModelConfig),)
