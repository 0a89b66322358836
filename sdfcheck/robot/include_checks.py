"""Includes: does each bring something, may it stand as it is, and do its names and parameters fit?

Source: libsdformat 17's parser.cc, checked against what it reports. What is wrong with
an included file itself is said there, where it is mended.
"""

from __future__ import annotations

import os
from collections.abc import Iterator
from pathlib import Path

from sdfcheck.formats.sdf.problems import MissingElement
from sdfcheck.robot.include_problems import (
    EmptyIncludeSetting,
    FolderWithoutConfig,
    IncludeCycle,
    OldManifest,
    UnresolvedInclude,
    UnusableInclude,
)
from sdfcheck.robot.includes import Included, Obstacle, included, includes_of, ring
from sdfcheck.robot.model_config import OLD_CONFIG
from sdfcheck.robot.parameters import PARAMETERS, parameters
from sdfcheck.robot.uri_spelling import absolute, malformed, misspelt
from sdfcheck.source.document import Document

_SETTINGS = ("name", "static", "placement_frame")


def problems(document: Document) -> list[object]:
    """Everything about the includes of an SDF document that is wrong, in no particular order."""
    if "<include" not in document.source.text:
        return []
    found: list[object] = []
    for include in includes_of(document):
        brought = included(document, include)
        found += _settings(brought)
        if brought.uri is not None and (slip := malformed(brought.uri)) is not None:
            found.append(slip)
        found += _parameters(brought)
        if document.library is not None:
            found += _source(brought)
            found += _cycle(document, brought)
    if "merge" in document.source.text and document.library is not None:
        from sdfcheck.robot.merges import merge_problems

        found += merge_problems(document)
    return _told_once(found)


def _settings(found: Included) -> Iterator[object]:
    for name in _SETTINGS:
        for setting in found.include.children(name):
            if not setting.content:
                yield EmptyIncludeSetting(setting)
    placement = found.include.find("placement_frame")
    if placement is None or not placement.content:
        return
    if not found.include.has("pose"):
        yield MissingElement(found.include, "pose", None, refused=True)


def _parameters(found: Included) -> list[object]:
    return parameters(found).problems if found.include.has(PARAMETERS) else []


def _source(found: Included) -> Iterator[object]:
    """What keeps the uri from leading to a model."""
    uri, location = found.uri, found.location
    if uri is None or location is None:
        return  # the format says that it has to be there
    config = found.config
    if config is not None and config.path.name == OLD_CONFIG:
        yield OldManifest(uri, config.path)
    if malformed(uri) is not None:
        return
    if found.obstacle is None and (path := absolute(uri)) is not None:
        yield path
    if found.obstacle is Obstacle.NOT_FOUND:
        yield misspelt(uri, location) or UnresolvedInclude(uri, location, (uri,))
    elif found.obstacle is Obstacle.NO_CONFIG and location.path is not None:
        yield FolderWithoutConfig(uri, location.path, _descriptions(location.path))
    # A file that is no XML at all is told where it is.
    elif found.file is not None and found.obstacle not in {None, Obstacle.BROKEN}:
        root = found.document.root if found.document is not None else None
        name = root.name if root is not None else ""
        holds_world = root is not None and root.find("world") is not None
        yield UnusableInclude(uri, found.obstacle, found.file, name, holds_world)


def _told_once(found: list[object]) -> list[object]:
    """Join what is unresolved for one reason outside of the document."""
    others: list[object] = []
    by_text: dict[str, list[UnresolvedInclude]] = {}
    for problem in found:
        if isinstance(problem, UnresolvedInclude) and (problem.location.is_remote or problem.is_searched_for):
            by_text.setdefault(problem.uri.text, []).append(problem)
        else:
            others.append(problem)
    joined = (
        UnresolvedInclude(same[0].uri, same[0].location, tuple(problem.uri for problem in same))
        for same in by_text.values()
    )
    return [*others, *joined]


def _descriptions(folder: Path) -> tuple[str, ...]:
    try:
        names = sorted(os.listdir(folder))
    except OSError:
        return ()
    return tuple(name for name in names if name.endswith((".sdf", ".urdf")))


def _cycle(document: Document, found: Included) -> Iterator[object]:
    """Each cycle is told once, in the file of it that comes first by its path."""
    if found.document is None:
        return
    steps = ring(document, found.include)
    own = os.path.realpath(document.path)
    if steps and own == min(os.path.realpath(step.element.document.path) for step in steps):
        yield IncludeCycle(steps)
