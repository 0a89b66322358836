"""Relative paths of a result, written for the folder that it goes to."""

from __future__ import annotations

import os
from pathlib import Path

from sdfcheck.files.uris import file_path, scheme_of
from sdfcheck.robot.root import root_of
from sdfcheck.source.document import read
from sdfcheck.source.element import Value
from sdfcheck.source.sniff import Kind
from sdfcheck.source.splice import Replacement, replaced


def seen_from(text: str, kind: Kind, source: Path, target: Path) -> str:
    """A result whose meshes, textures and included files are named as seen from the folder ``target``.

    In ``text`` they are named as seen from ``source``. Only what is there is written otherwise:
    simulators also look for a relative path in folders that their environment names.
    """
    if os.path.realpath(source) == os.path.realpath(target):
        return text
    document = read(text.encode("utf-8", "surrogateescape"), source / "result", kind)
    root = root_of(document)
    values = [named.uri_value for named in (*root.resources, *root.includes)]
    edits = (edit for value in values if value is not None and (edit := _edit(value, source, target)))
    return replaced(text, sorted(set(edits)))


def _edit(value: Value, source: Path, target: Path) -> Replacement | None:
    uri = value.text.strip()
    scheme = scheme_of(uri)
    path = file_path(uri) if scheme == "file" else uri
    if scheme not in {"", "file"} or not path or os.path.isabs(path) or not (source / path).exists():
        return None
    span = value.span
    if span.text.strip() != uri:
        return None  # spelled with references such as `&amp;`
    moved = Path(os.path.relpath(source / path, target)).as_posix()
    start = span.start + len(span.text) - len(span.text.lstrip())
    return start, start + len(uri), f"file://{moved}" if scheme else moved
