"""Migrated files against libsdformat, which goes up on its own when it reads."""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from pathlib import Path

import pytest
from lxml import etree

from sdfcheck.convert.comparison import verify
from sdfcheck.convert.loss import NotConvertible
from sdfcheck.convert.migrate.migrate import comparable, correspondence, migrated, models, sdf_to_sdf
from sdfcheck.convert.migrate.migration import Migration
from sdfcheck.formats.version import Version
from sdfcheck.robot.graph import Model
from sdfcheck.robot.motion.flatten import mechanism_of
from sdfcheck.robot.motion.mechanism import Mechanism
from sdfcheck.robot.motion.origin import PoseError
from sdfcheck.source.document import Document, read
from sdfcheck.source.errors import DescriptionError
from tests.peers.cmdprint import version_of
from tests.peers.findings import SHARED
from tests.peers.libsdformat import library
from tests.peers.migrations import documents, trees
from tests.peers.trees import Difference, differences

LEAST_UP, LEAST_DOWN = 120, 150

ARGUED = {
    r"heightmap/sampling|ode/mu2?|scene/ambient|force_torque/frame|collide_bitmask": (
        "its default is another one in the source's version; libsdformat does not make up for that"
    ),
    r"imu/(angular_velocity|linear_acceleration)": "libsdformat adds an empty one to each imu",
    r"(model|world)/joint$": "a joint with the name of a link: libsdformat prints what it then refuses to read",
    r"axis2?/initial_position": "left SDF with 1.9: we say so, libsdformat keeps it as unknown",
}
"""Paths of elements at which we differ from libsdformat, and why."""

ARGUED_CASES = {
    "actor-static": "left SDF with 1.7: we say so, libsdformat keeps it as unknown",
    "clashing-joint": "libsdformat prints two things of one name, which it then refuses to read",
    "inner-frames": "libsdformat leaves poses that refer to frames which are no longer read",
    "moved-settings": "libsdformat leaves settings where they are no longer read",
    "reserved-names": "libsdformat leaves names that it then refuses",
    "unflattened": "libsdformat leaves names with `::` in models at the top, and refuses them when it reads its result",
}
"""Our own sources of which libsdformat makes something that cannot be used."""

pytestmark = [
    pytest.mark.peers,
    pytest.mark.skipif(library() is None, reason="libsdformat is not installed"),
]


def unargued(step: int) -> list[Document]:
    return [document for document in documents() if document.path.parent.name not in ARGUED_CASES][::step]


def unexplained(found: Sequence[Difference]) -> list[Difference]:
    return [one for one in found if not any(re.search(pattern, one.path) for pattern in ARGUED)]


def test_going_up_gives_the_tree_that_libsdformat_gives(tmp_path: Path, stride: Callable[[int], int]) -> None:
    newest = Version.parse(version_of(library() or ""))
    assert newest is not None
    older = [one for one in unargued(stride(3)) if is_older(one, newest)]
    texts = [sdf_to_sdf(document, newest, verified=False).text for document in older]
    theirs = trees([(document, document.source.text) for document in older], tmp_path)
    ours = trees(list(zip(older, texts, strict=True)), tmp_path)
    pairs = [(d, t, o) for d, t, o in zip(older, theirs, ours, strict=True) if t is not None]
    wrong = [str(document.path) for document, _, our in pairs if our is None]
    for document, their, our in pairs:
        if our is not None:
            wrong += [f"{document.path}: {one}" for one in unexplained(list(differences(their, our)))]
    assert wrong == []
    assert len(pairs) >= (LEAST_UP if SHARED.is_dir() else 10) // stride(3)


def is_older(document: Document, newest: Version) -> bool:
    own = Version.parse(document.version or "")
    return own is not None and own < newest


def test_libsdformat_reads_the_same_robot_from_an_older_version(
    tmp_path: Path, stride: Callable[[int], int]
) -> None:
    down = list(filter(None, map(to_old, unargued(stride(3)))))
    printed_trees = trees([(one.draft.original, one.draft.text()) for one in down], tmp_path)
    compared, wrong = 0, []
    for migration, tree in zip(down, printed_trees, strict=True):
        source = migration.draft.original
        there = dict(models(read(etree.tostring(tree), source.path))) if tree is not None else {}
        for name, scope in models(source):
            robot = readable(scope)
            if robot is not None and name in there:
                compared += 1
                done = verify(
                    comparable(migration, robot),
                    mechanism_of(there[name]),
                    correspondence(migration, robot),
                )
                wrong += [f"{source.path}: {name}: {one}" for one in done.differences]
    assert wrong == []
    assert compared >= (LEAST_DOWN if SHARED.is_dir() else 10) // stride(3)


def to_old(document: Document) -> Migration | None:
    """The document in 1.5; None if it cannot be had, or includes what libsdformat would look for elsewhere."""
    try:
        migration = migrated(document, Version(1, 5))
    except NotConvertible:
        return None
    return None if migration.root.of("include") else migration


def readable(scope: Model) -> Mechanism | None:
    try:
        return mechanism_of(scope)
    except (DescriptionError, PoseError):
        return None
