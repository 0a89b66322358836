"""SDFormat from one version to another, up or down."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import replace
from pathlib import Path

import numpy as np

from sdfcheck.convert import ledger
from sdfcheck.convert.comparison import Correspondence
from sdfcheck.convert.include_expansion import IncludeExpansion, expanded
from sdfcheck.convert.ledger import EVERYTHING, TEXT
from sdfcheck.convert.loss import Loss, LossKind, loss_at, refusal
from sdfcheck.convert.migrate.down import (
    attach_joints_to_links,
    drop_frames,
    drop_leftovers,
    express_axes,
    flat_links,
    flatten,
    move_world_joints,
    name_plugins,
    put_canonical_links_first,
    put_gravity_into_physics,
    rename_frame_ids,
    rename_sensors,
    rename_states,
    resolve_poses,
    split_capsules,
    write_inertias,
    write_limits,
    write_thread_pitch,
)
from sdfcheck.convert.migrate.migration import Draft, Migration, Node, drop_dead, title, write_defaults
from sdfcheck.convert.migrate.up import go_up
from sdfcheck.convert.result import Comparison, Conversion, conversion, read_result, with_text
from sdfcheck.convert.settings_tree import Contents, of_model, of_world
from sdfcheck.convert.writer import render
from sdfcheck.formats.sdf.survey import PARAMETERS, version_of
from sdfcheck.formats.version import VERSIONS, Version
from sdfcheck.robot.graph import Model, Scope, World
from sdfcheck.robot.includes.included import included
from sdfcheck.robot.motion.flatten import mechanism_of
from sdfcheck.robot.motion.mechanism import Link, Mechanism
from sdfcheck.robot.motion.origin import PoseError
from sdfcheck.robot.motion.poses import Array
from sdfcheck.robot.root import root_of
from sdfcheck.source.altered import Altered, Xml, copied_as
from sdfcheck.source.document import Document, Element
from sdfcheck.source.errors import DescriptionError
from sdfcheck.source.sniff import Kind
from sdfcheck.source.text import Source

# The parts of a source that are in a draft at the end: text that no step takes out is the author's.


def close(migration: Migration) -> None:
    """Enter what the draft still has of its source, and report what is gone in silence."""
    ledger, source = migration.ledger, migration.draft.original
    for node in migration.root.walk():
        element = node.source
        if element is None or element.document is not source:
            continue
        if node.is_as_read:
            ledger.take(element, EVERYTHING)
            continue
        # Of the format's own attributes steps take out what is said elsewhere.
        own = (name for name in element.attributes if ":" not in name)
        ledger.take(element, EVERYTHING, TEXT, *own, *node.attributes)
    if migration.brought:
        _enter_brought(migration)
    assert source.root is not None
    ledger.close(source.root)


def custom_names(nodes: Iterable[Node]) -> frozenset[str]:
    """The names of custom elements and attributes in nodes."""
    names = (name for top in nodes for node in top.walk() for name in (node.name, *node.attributes))
    return frozenset(name for name in names if ":" in name and not name.startswith("xmlns"))


def _enter_brought(migration: Migration) -> None:
    """Custom data of includes, and of what they bring: is it there at the end?"""
    there = custom_names([migration.root])
    for include, names in migration.brought:
        for name in include.attributes:
            if name in there & names:
                migration.ledger.take(include, name)
        for child in include.children():
            if child.name in there & names:
                migration.ledger.take_whole(child)
        own = {*include.attributes, *(child.name for child in include.children())}
        for name in sorted(names - there - own):
            text = f"`{name}` in what is included is left out: it has no place in SDFormat {migration.target}"
            migration.ledger.note(LossKind.DROPPED_ELEMENT, include, text)


# Includes: written out where the target cannot include the file, reported where it is too new.


def write_out_merges(migration: Migration) -> None:
    """Put the parts of merged includes in their place; a frame replaces the merged model."""
    includes = migration.root.of("include")
    if includes:
        migration.draft.read()
    for include in includes:
        merges = include.attributes.get("merge", "").strip().lower() in {"true", "1"}
        since = 9 if include.parent is None or include.parent.name == "model" else 10
        if (
            merges
            and migration.goes_below(since)
            and (why := _write_out(migration, include, keeps_models=True))
        ):
            assert include.place is not None
            raise refusal(include.place, f"an include cannot be merged in {migration.target}: {why}")


def write_out_includes(migration: Migration) -> None:
    """Below 1.5 an include is in a world and says nothing but a uri; others are written out."""
    includes = migration.root.of("include")
    if includes:
        migration.draft.read()
    for include in includes:
        if _says_more(include) and (why := _write_out(migration, include, keeps_models=False)):
            _leave(migration, include, why)


def _write_out(migration: Migration, include: Node, *, keeps_models: bool) -> str:
    """Replace an include by what it brings; returns why it has to stay."""
    element = migration.draft.element(include)
    expansion = IncludeExpansion(migration.to_sdf, keeps_models=keeps_models)
    brought = expansion.replacement(element)
    if not brought:
        return expansion.notes[-1].partition(": the include stays: ")[2]
    migration.losses.extend(expansion.losses)
    nodes = _nodes(brought)
    for node in nodes:
        node.origin = include.origin
    name = included(element.document, element).name
    text = f"what {title(include)} of {name} brings is written out: {migration.target} does not include it so"
    migration.note(include, text, LossKind.EXPANDED_INCLUDE)
    migration.enter(include)
    migration.enter_alone(include)
    if include.place is not None:
        migration.brought.append((include.place, custom_names(nodes)))
    for parameters in include.source.children(PARAMETERS) if include.source is not None else ():
        migration.ledger.take_whole(parameters)
    include.exchange(nodes)
    return ""


def _nodes(elements: list[Xml]) -> list[Node]:
    """Elements as nodes, as parts of another file."""
    texts = (render(element, keeps_lines=True).partition("\n")[2] for element in elements)
    document = Document(Source(Path(), f"<sdf>\n{''.join(texts)}</sdf>"), Kind.SDF, [])
    assert document.root is not None
    nodes = [copied_as(Node, element) for element in document.root.children()]
    for node in nodes:
        for part in node.walk():
            part.source, part.origin = part.origin, None
    return nodes


def _says_more(include: Node) -> bool:
    in_world = include.parent is not None and include.parent.name == "world"
    return not in_world or any(child.name != "uri" and not child.is_custom for child in include.children())


def _leave(migration: Migration, include: Node, why: str) -> None:
    assert include.place is not None
    if include.parent is None or include.parent.name == "model":
        raise refusal(include.place, f"an include in a model cannot be written in {migration.target}: {why}")
    text = f"the include stays, though {migration.target} has no place for more than its uri: {why}"
    migration.lose(include, text, LossKind.UNKNOWN_REFERENCE)
    migration.kept.update(include.children())


def report_newer_files(migration: Migration) -> None:
    """On the way down an included file may be too new for the target; it is not touched."""
    includes = migration.root.of("include")
    if not includes:
        return
    document = migration.draft.read()
    for include in includes:
        found = included(document, migration.draft.element(include))
        other = found.document
        if other is None or other.kind is not Kind.SDF or other.root is None or include.place is None:
            continue
        version = version_of(other)
        if not version > migration.target:
            continue
        uri = found.uri.text.strip() if found.uri is not None else ""
        text = f"`{uri}` stays in {version}: migrate that file to {migration.target} as well"
        place = found.uri.element if found.uri is not None else include.place
        loss = loss_at(place, LossKind.INCLUDED_FILE_KEPT, text)
        version_value = other.root.attribute("version")
        if version_value is not None:
            loss = Loss(loss.kind, loss.span, text, loss.severity, ((version_value.span, "its version"),))
        migration.losses.append(loss)


# Source and result as robots, to be compared model by model.


def comparisons(migration: Migration, result: Document) -> list[Comparison]:
    """The models to compare; a model whose source cannot be read is reported."""
    source = migration.draft.original
    others = dict(models(result))
    elsewhere = _translated(migration)
    compared = list(_worlds(migration, source, result, elsewhere))
    for name, scope in models(source):
        try:
            robot = comparable(migration, mechanism_of(scope))
        except (DescriptionError, PoseError) as error:
            place = scope.place
            if place.document is source:
                text = f"model `{scope.name}` cannot be compared with its result: {error}"
                migration.losses.append(loss_at(place, LossKind.NOT_VERIFIED, text))
            continue
        other = others.get(name)
        contents = None if other is None else (of_model(scope), of_model(other))
        compared.append(
            Comparison(robot, _robot(other), correspondence(migration, robot), contents, elsewhere)
        )
    return compared


def _robot(scope: Model | None) -> Mechanism:
    """The robot of a result; one that cannot be read is empty, so that everything is missing."""
    try:
        return mechanism_of(scope) if scope is not None else Mechanism("", {}, {})
    except (DescriptionError, PoseError):
        return Mechanism("", {}, {})


def models(document: Document) -> Iterator[tuple[str, Model]]:
    """The models at the top and in worlds, by their names with that of the world."""
    for model in ledger.models(document):
        world = model.holder
        yield f"{world.name}::{model.name}" if isinstance(world, World) else model.name, model


def _translated(migration: Migration) -> frozenset[Element]:
    """The elements that steps have renamed, moved or said in other words, and what is in them."""
    found = set(migration.ledger.entered)
    for node in migration.root.walk():
        element, parent = node.source, node.parent
        if element is None or parent is None:
            continue
        if parent.source is not None and parent.source.document is not element.document:
            continue  # the top of what is included
        if node.name != element.name or parent.source is not element.parent:
            found.update(element.walk())
    return frozenset(found)


def _worlds(
    migration: Migration, source: Document, result: Document, elsewhere: frozenset[Element]
) -> Iterator[Comparison]:
    """The worlds, with their models for links: where do they are?"""
    results = {scope.name: scope for scope in root_of(result).scopes if scope.kind == "world"}
    for scope in root_of(source).scopes:
        other = results.get(scope.name)
        if scope.kind == "world" and other is not None:
            standing = _standing(scope, migration)
            if len(standing.links) > 1:
                contents = (_of_world(scope), _of_world(other))
                yield Comparison(standing, _standing(other, None), Correspondence(), contents, elsewhere)


def _of_world(world: Scope) -> Contents:
    """The parts of a world beside its models."""
    found = Contents(world.name)
    if isinstance(world, World):
        found.add("model", "", of_world(world))
    return found


def _standing(world: Scope, migration: Migration | None) -> Mechanism:
    poses = world.root.poses
    robot = Mechanism(world.name, {"world": Link("world", np.eye(4), world.element)}, {})
    for name, model in world.nodes.items():
        if not isinstance(model, Model):
            continue
        try:
            robot.links[name] = Link(name, poses.in_scope(model) @ _placement(model), model.place)
        except PoseError as error:
            if migration is not None and model.place.document is migration.draft.original:
                text = f"the pose of model `{name}` cannot be compared: {error}"
                migration.losses.append(loss_at(model.place, LossKind.NOT_VERIFIED, text))
    return robot


def _placement(model: Model) -> Array:
    """From a model's frame to its first link, which is what has a place."""
    link = model.canonical_link
    return np.eye(4) if link is None else model.root.poses.reached(model, link)


def comparable(migration: Migration, robot: Mechanism) -> Mechanism:
    """A robot of the source without what is a loss."""
    if not migration.lost_mimics:
        return robot
    joints = {
        name: replace(joint, axes=tuple(replace(axis, mimic=None) for axis in joint.axes))
        for name, joint in robot.joints.items()
    }
    return replace(robot, joints=joints)


def correspondence(migration: Migration, source: Mechanism) -> Correspondence:
    """The new names of the links and joints of a model, and those that are lost."""
    joints = dict(migration.renamed_joints)
    links = dict(migration.moved_links)
    if migration.target < Version(1, 5):
        links |= flat_links(list(source.links))
        joints |= {name: name.replace("::", "__") for name in source.joints if "::" in name}
    return Correspondence(
        links,
        joints,
        dropped_shapes=migration.dropped_shapes,
        changed_bodies=frozenset(source.links) if migration.changed_bodies else frozenset(),
    )


LOWEST = Version(1, 4)
"""The oldest version that can be asked for."""
TARGETS = tuple(version for version in reversed(VERSIONS) if version >= LOWEST)


def sdf_to_sdf(
    document: Document, target: Version, *, keep_unknown: bool = False, verified: bool = True
) -> Conversion:
    """Write a document for the consumers of another version.

    Text that is not touched stays as it is, to the byte. Raises NotConvertible where no
    result could be right.
    """
    migration = migrated(document, target, keep_unknown=keep_unknown)
    text = migration.draft.text()
    written = migration.draft.reread(text) if verified else read_result(text, document, Kind.SDF)
    compared = comparisons(migration, written) if verified else []
    close(migration)
    return conversion(document, text, written, migration.losses, compared, verified=verified)


def to_sdf(document: Document, version: Version) -> Conversion:
    """An SDF or URDF document in a version of SDFormat; raises NotConvertible."""
    if document.kind is not Kind.URDF:
        return sdf_to_sdf(document, version, keep_unknown=True)
    from sdfcheck.convert.urdf_to_sdf.conversion import urdf_to_sdf
    from sdfcheck.convert.urdf_to_sdf.options import Options

    return urdf_to_sdf(document, Options(version))


def written_out(document: Document) -> tuple[Document, IncludeExpansion]:
    """The document with all includes replaced by what they bring, and what became of them."""
    return expanded(document, to_sdf)


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
    migration = Migration(Draft(document, given.source.text), target, to_sdf, keep_unknown=keep_unknown)
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
    migration.root.attributes["version"] = str(migration.target)


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


def with_newer_root(document: Document) -> Document:
    """The document as if its root were called ``sdf``; every place stays where it is in the file."""
    root = document.root
    if root is None or root.name != _OLD or document.version != "1.2" or isinstance(document, Altered):
        return document
    place, text = document.spans.place(root), document.source.text
    start, end = place.start + 1, place.close + 2
    changed = f"{text[:start]}{_NEW:{len(_OLD)}}{text[start + len(_OLD) :]}"
    if text.startswith(_OLD, end):
        changed = f"{changed[:end]}{_NEW:{len(_OLD)}}{changed[end + len(_OLD) :]}"
    return with_text(document, changed)
