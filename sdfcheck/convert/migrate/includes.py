"""Includes: written out where the target cannot include the file, reported where it is too new."""

from __future__ import annotations

from pathlib import Path

from sdfcheck.convert.loss import Loss, LossKind, loss_at, refusal
from sdfcheck.convert.migrate.balance import custom_names
from sdfcheck.convert.migrate.draft import Draft
from sdfcheck.convert.migrate.migration import Migration, title
from sdfcheck.convert.migrate.node import Node
from sdfcheck.convert.rewrite.include_expansion import IncludeExpansion
from sdfcheck.convert.rewrite.tidy_tree import text_of
from sdfcheck.formats.sdf.survey import PARAMETERS, survey
from sdfcheck.robot.includes.included import included
from sdfcheck.source.document import Document
from sdfcheck.source.sniff import Kind
from sdfcheck.source.text import Source


def write_out_merges(migration: Migration) -> None:
    """Put the parts of merged includes in their place; a frame replaces the merged model."""
    for include in migration.root.of("include"):
        merges = (include.get("merge") or "").strip().lower() in {"true", "1"}
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
    for include in migration.root.of("include"):
        if _says_more(include) and (why := _write_out(migration, include, keeps_models=False)):
            _leave(migration, include, why)


def _write_out(migration: Migration, include: Node, *, keeps_models: bool) -> str:
    """Replace an include by what it brings; returns why it has to stay."""
    migration.draft.read()
    element = migration.draft.element(include)
    expansion = IncludeExpansion(migration.to_sdf, keeps_models=keeps_models)
    branches = expansion.replacement(element)
    if not branches:
        return expansion.notes[-1].partition(": the include stays: ")[2]
    migration.losses.extend(expansion.losses)
    nodes = [node for branch in branches for node in _nodes(text_of(branch))]
    for node in nodes:
        node.origin = include.origin
    name = included(element.document, element).name
    text = f"what {title(include)} of {name} brings is written out: {migration.target} does not include it so"
    migration.note(include, text, LossKind.EXPANDED_INCLUDE)
    migration.enter(include)
    migration.enter_alone(include)
    if include.place is not None:
        migration.brought.append((include.place, custom_names(nodes)))
    for parameters in element.children(PARAMETERS) if include.source is not None else ():
        migration.ledger.take_whole(parameters)
    include.replace(nodes)
    return ""


def _nodes(text: str) -> list[Node]:
    """The nodes of a text, as parts of another file than that of the text."""
    root = Draft(Document(Source(Path(), f"<sdf>\n{text}\n</sdf>"), Kind.SDF, [])).root
    for node in root.walk():
        node.origin = None
    return root.children()


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
    document = migration.draft.read()
    for include in migration.root.of("include"):
        found = included(document, migration.draft.element(include))
        other = found.document
        if other is None or other.kind is not Kind.SDF or other.root is None or include.place is None:
            continue
        version = survey(other).version
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
