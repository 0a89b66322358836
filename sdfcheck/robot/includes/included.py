"""Included models: found, read once, and said by what name they go.

Source: libsdformat 17's parser.cc for what an include accepts, gz-sim for the folders
in which it looks.
"""

from __future__ import annotations

import os
from enum import Enum
from pathlib import Path

from sdfcheck.files.library import library_of
from sdfcheck.files.uris import locate
from sdfcheck.formats.sdf.problems import MisplacedElement
from sdfcheck.formats.sdf.survey import PARAMETERS, survey
from sdfcheck.robot.includes.model_config import CONFIG, config_of, model_file
from sdfcheck.robot.values import is_true
from sdfcheck.source.altered import Altered
from sdfcheck.source.document import Document
from sdfcheck.source.element import Element, Value
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.sniff import Kind

INCLUDABLE = ("model", "actor", "light")
"""The parts that an included file may hold, in the order in which libsdformat prefers them."""


class Obstacle(Enum):
    """Why an include brings nothing."""

    NO_URI = "no uri"
    NOT_FOUND = "not found"
    NO_CONFIG = "no model.config"
    BAD_CONFIG = "bad model.config"
    UNREADABLE = "unreadable"
    OUTSIDE = "outside of what is read"
    BROKEN = "broken"
    FOREIGN = "foreign"
    XACRO = "xacro"
    NO_MODEL = "no model"


class Included(NamedTuple):
    """The parts that one ``include`` brings.

    ``model`` is the included file's model, actor or light (or a URDF's robot), in a
    document of its own, None where there is none to be had, for the reason in
    ``obstacle``; ``kind`` is what it counts as. Where the include has parameters, it is in
    a copy of the file that they have changed; ``faults`` are what is wrong with them.
    ``name`` is the name by which it goes here, None where it is not known.
    """

    include: Element
    uri: Value | None
    name: str | None
    merge: bool
    is_static: bool
    file: Path | None = None
    """The file that is meant, after a folder's ``model.config``."""
    document: Document | None = None
    """The file as it was read, also where it holds no model."""
    config: Document | None = None
    """The ``model.config`` of the folder that the uri leads to."""
    model: Element | None = None
    kind: str | None = None
    obstacle: Obstacle | None = None
    faults: tuple[object, ...] = ()


def included(document: Document, include: Element) -> Included:
    """Resolve one include of a document, once; its parameters are carried out."""
    resolved = document.view(_Resolved)
    if include in resolved:
        return resolved[include]
    read = document.origin.get(include) if isinstance(document, Altered) else None
    if read is not None and isinstance(document, Altered) and read.document is document.original:
        found = included(read.document, read)._replace(include=include)
    else:
        found = resolved[include] = _resolve(document, include)  # where it leads back to itself
        found = with_parameters(found)
    resolved[include] = found
    return found


def with_parameters(found: Included) -> Included:
    """The same after the parameters of the include are carried out, in a copy."""
    if not found.include.has(PARAMETERS):
        return found
    from sdfcheck.robot.includes.parameters import Parameters

    changed = Parameters(found, included, bring)
    return found._replace(model=changed.model, faults=tuple(changed.problems))


def bring(include: Element, found: Included) -> None:
    """Let an include of a copied document bring something else than its file."""
    include.document.view(_Resolved)[include] = found


def includes_of(document: Document) -> list[Element]:
    """The includes that libsdformat follows: those in place, and misplaced ones too."""
    surveyed = survey(document)
    misplaced = [
        problem.element
        for problem in surveyed.problems
        if isinstance(problem, MisplacedElement) and problem.element.name == "include"
    ]
    return [*surveyed.index.get("include", ()), *misplaced]


def is_made_static(document: Document) -> bool:
    """Was the document reached by an include that makes its model static?"""
    include = document.included_by[-1].element.parent if document.included_by else None
    static = include.find("static") if include is not None else None
    return static is not None and is_true(static.content)


def included_element(document: Document) -> Element | None:
    """The model, actor or light of a file, or the robot of a URDF."""
    root = document.root
    if root is None:
        return None
    if root.name == "robot":
        return root
    if root.name != "sdf":
        return None
    return next((found for kind in INCLUDABLE if (found := root.find(kind)) is not None), None)


def is_description(document: Document) -> bool:
    """Was a text without any element meant to be a robot description? Others are not shown in findings."""
    return document.kind in {Kind.BROKEN_XML, Kind.EMPTY, Kind.XACRO}


def ring(document: Document, include: Element) -> tuple[Value, ...]:
    """The includes that lead from one in this document back to it, outside in; empty if none do."""
    goal = os.path.realpath(document.path)
    seen: set[Document] = set()
    # Depth first without recursion: a chain of includes may be long.
    stack: list[tuple[Document, Element, tuple[Value, ...]]] = [(document, include, ())]
    while stack:
        holder, element, chain = stack.pop()
        found = included(holder, element)
        if found.document is None or found.uri is None:
            continue
        chain = (*chain, found.uri)
        if os.path.realpath(found.document.path) == goal:
            return chain
        if found.document not in seen and len(chain) < _LONGEST_CHAIN:
            seen.add(found.document)
            stack += [(found.document, deeper, chain) for deeper in reversed(includes_of(found.document))]
    return ()


_LONGEST_CHAIN = 100


class _Resolved(dict[Element, Included]):
    def __init__(self, document: Document) -> None:
        super().__init__()


def _resolve(document: Document, include: Element) -> Included:
    name, static, uri = include.find("name"), include.find("static"), include.find("uri")
    found = Included(
        include,
        uri.own_value if uri is not None and uri.content else None,
        (name.content or None) if name is not None else None,
        is_true(include.attributes.get("merge", "")),
        static is not None and is_true(static.content),
    )
    if found.uri is None:
        return found._replace(obstacle=Obstacle.NO_URI)
    path = locate(document, found.uri.text).path
    if path is None or document.library is None:
        return found._replace(obstacle=Obstacle.NOT_FOUND)
    found = _find_file(document, found, path)
    return found if found.file is None else _read(document, found, found.file)


def _find_file(document: Document, found: Included, path: Path) -> Included:
    """The file itself, or what the folder's ``model.config`` says."""
    if not os.path.isdir(path):
        return found._replace(file=path)
    config = config_of(document, path)
    if config is None:
        is_outside = _is_refused(document, path / CONFIG)
        return found._replace(obstacle=Obstacle.OUTSIDE if is_outside else Obstacle.NO_CONFIG)
    _note_origin(document, config, found)
    file = model_file(config)
    return found._replace(config=config, file=file, obstacle=None if file else Obstacle.BAD_CONFIG)


def _read(document: Document, found: Included, file: Path) -> Included:
    library = library_of(document)
    assert library is not None
    other = library.document(file, of=document)
    if other is None:
        is_outside = _is_refused(document, file)
        return found._replace(obstacle=Obstacle.OUTSIDE if is_outside else Obstacle.UNREADABLE)
    _note_origin(document, other, found)
    found = found._replace(document=other)
    if other.root is None:
        return found._replace(obstacle=Obstacle.BROKEN if is_description(other) else Obstacle.FOREIGN)
    if other.root.name not in {"sdf", "robot"}:
        return found._replace(obstacle=Obstacle.FOREIGN)
    if other.root.name == "robot" and other.source.contains("<xacro:"):
        return found._replace(obstacle=Obstacle.XACRO)
    model = included_element(other)
    if model is None:
        return found._replace(obstacle=Obstacle.NO_MODEL)
    kind = "model" if model.name == "robot" else model.name
    own = model.attributes.get("name", "").strip() or None
    return found._replace(model=model, kind=kind, name=found.name or own)


def _is_refused(document: Document, file: Path) -> bool:
    library = library_of(document)
    return library is not None and file in library.refused


def _note_origin(document: Document, other: Document, found: Included) -> None:
    """The include that leads to a file: the first, or the first one that is not in a static model."""
    if found.uri is None or other is document:
        return
    if not other.included_by or (is_made_static(other) and not found.is_static):
        other.included_by = (*document.included_by, found.uri)
        document.is_referred_to = True
