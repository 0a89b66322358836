"""SDFormat from one version to another, up or down."""

from __future__ import annotations

import re
from collections.abc import Callable

from sdfcheck.convert.loss import refusal
from sdfcheck.convert.migrate.balance import close
from sdfcheck.convert.migrate.defaults import drop_dead, write_defaults
from sdfcheck.convert.migrate.down.axes import express_axes
from sdfcheck.convert.migrate.down.capsules import split_capsules
from sdfcheck.convert.migrate.down.flattening import flatten
from sdfcheck.convert.migrate.down.inertias import write_inertias
from sdfcheck.convert.migrate.down.leftovers import drop_leftovers
from sdfcheck.convert.migrate.down.older_spellings import (
    drop_frames,
    name_plugins,
    put_canonical_links_first,
    put_gravity_into_physics,
    rename_frame_ids,
    rename_sensors,
    rename_states,
    write_limits,
    write_thread_pitch,
)
from sdfcheck.convert.migrate.down.poses import attach_joints_to_links, resolve_poses
from sdfcheck.convert.migrate.down.world_joints import move_world_joints
from sdfcheck.convert.migrate.includes import report_newer_files, write_out_includes, write_out_merges
from sdfcheck.convert.migrate.migration import Migration
from sdfcheck.convert.migrate.node import Node
from sdfcheck.convert.migrate.proof import comparisons
from sdfcheck.convert.migrate.up.upward import go_up
from sdfcheck.convert.result import Conversion, conversion, read_result, with_text
from sdfcheck.formats.sdf.version import NEWEST, Version
from sdfcheck.source.document import Document
from sdfcheck.source.sniff import Kind

LOWEST = Version(1, 4)
"""The oldest version that can be asked for."""
TARGETS = tuple(Version(1, minor) for minor in range(NEWEST.minor, LOWEST.minor - 1, -1))


def sdf_to_sdf(
    document: Document, target: Version, *, keep_unknown: bool = False, verified: bool = True
) -> Conversion:
    """Write a document for the consumers of another version.

    Text that is not touched stays as it is, to the byte. Raises NotConvertible where no
    result could be right.
    """
    migration = migrated(document, target, keep_unknown=keep_unknown)
    compared = comparisons(migration) if verified else []
    close(migration)
    text = migration.draft.text()
    written = migration.draft.read() if verified else read_result(text, document, Kind.SDF)
    return conversion(document, text, written, migration.losses, compared, verified=verified)


def to_sdf(document: Document, version: Version) -> Conversion:
    """An SDF or URDF document in a version of SDFormat; raises NotConvertible."""
    if document.kind is not Kind.URDF:
        return sdf_to_sdf(document, version, keep_unknown=True)
    from sdfcheck.convert.urdf_to_sdf.conversion import urdf_to_sdf
    from sdfcheck.convert.urdf_to_sdf.options import Options

    return urdf_to_sdf(document, Options(version))


def migrated(document: Document, target: Version, *, keep_unknown: bool = False) -> Migration:
    """The migration of a document, done.

    Raises NotConvertible: the document is not SDFormat of a known version, or needs a feature that
    the target cannot express.
    """
    given, document = document, with_newer_root(document)
    root = document.root
    assert root is not None
    if root.name != "sdf" or Version.parse(document.version or "") is None:
        raise refusal(root, f"version {document.version!r} cannot be converted")
    if not target >= LOWEST:
        raise refusal(root, f"{target} is older than anything that can be written")
    migration = Migration(document, target, to_sdf, keep_unknown=keep_unknown)
    if document is not given:
        tidy_root(migration.root)
    if target > migration.source:
        go_up(migration)
        write_out_merges(migration)
        # A file may use what is newer than the version that it declares: consumers let it.
        _say_in_older_words(migration)
    elif target < migration.source:
        _go_down(migration)
    if target != migration.source:
        drop_leftovers(migration)
    return migration


def _go_down(migration: Migration) -> None:
    write_out_merges(migration)
    if migration.goes_below(5):
        write_out_includes(migration)
    report_newer_files(migration)
    drop_dead(migration)
    write_defaults(migration)
    _say_in_older_words(migration)
    migration.root.set("version", str(migration.target))


def _say_in_older_words(migration: Migration) -> None:
    for minor, step in _STEPS:
        if migration.goes_below(minor):
            step(migration)


_STEPS: tuple[tuple[int, Callable[[Migration], None]], ...] = (
    (12, rename_states),
    (12, rename_frame_ids),
    (11, write_inertias),
    (10, write_limits),
    (10, write_thread_pitch),
    (10, name_plugins),
    (10, move_world_joints),
    (8, attach_joints_to_links),
    (7, express_axes),
    (7, put_canonical_links_first),
    (9, resolve_poses),
    (8, split_capsules),
    (7, drop_frames),
    (7, rename_sensors),
    (6, put_gravity_into_physics),
    (5, flatten),
)
"""The steps for a target below 1.minor: in this order, since axes are turned while frames are still there."""


_OLD, _NEW = "gazebo", "sdf"
_SURPLUS = len(_OLD) - len(_NEW)


def with_newer_root(document: Document) -> Document:
    """The document as if its root were called ``sdf``; every place stays where it is in the file."""
    root = document.root
    if root is None or root.name != _OLD or document.version != "1.2":
        return document
    place, text = document.spans.place(root), document.source.text
    start, end = place.start + 1, place.close + 2
    changed = f"{text[:start]}{_NEW:{len(_OLD)}}{text[start + len(_OLD) :]}"
    if text.startswith(_OLD, end):
        changed = f"{changed[:end]}{_NEW:{len(_OLD)}}{changed[end + len(_OLD) :]}"
    return with_text(document, changed)


def tidy_root(root: Node) -> None:
    """Take out the spaces that kept the places."""
    blanks = " " * _SURPLUS
    root.opening = re.sub(rf"^<{_NEW}{blanks}(?=[\s>/])", f"<{_NEW}", root.opening)
    root.closing = root.closing.replace(f"</{_NEW}{blanks}>", f"</{_NEW}>")
