"""Relative paths of a result, written for the folder that it goes to."""

from __future__ import annotations

import os
from pathlib import Path

from sdfcheck.convert.result import Conversion
from sdfcheck.files.uris import file_path, scheme_of
from sdfcheck.robot.root import root_of
from sdfcheck.source.element import Value
from sdfcheck.source.relative import relative_path
from sdfcheck.source.splice import Replacement, replaced


def seen_from(done: Conversion, source: Path, target: Path) -> str:
    """The text of a result, with meshes, textures and included files named as seen from the folder ``target``.

    They were named as seen from ``source``. Only what is there is written otherwise:
    simulators also look for a relative path in folders that their environment names.
    """
    if os.path.realpath(source) == os.path.realpath(target):
        return done.text
    root = root_of(done.document)
    values = [named.uri_value for named in (*root.resources, *root.includes)]
    edits = (edit for value in values if value is not None and (edit := _edit(value, source, target)))
    return replaced(done.text, sorted(set(edits)))


def _edit(value: Value, source: Path, target: Path) -> Replacement | None:
    uri = value.text.strip()
    scheme = scheme_of(uri)
    path = file_path(uri) if scheme == "file" else uri
    if scheme not in {"", "file"} or not path or os.path.isabs(path) or not (source / path).exists():
        return None
    span = value.span
    if span.text.strip() != uri:
        return None  # spelled with references such as `&amp;`
    moved = Path(relative_path(source / path, target)).as_posix()
    start = span.start + len(span.text) - len(span.text.lstrip())
    return start, start + len(uri), f"file://{moved}" if scheme else moved
