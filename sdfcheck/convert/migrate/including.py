"""What includes bring: written out where the target cannot include it, told of where it is too new."""

from __future__ import annotations

from sdfcheck.convert.loss import Loss, LossKind, loss_at, refusal
from sdfcheck.convert.migrate.migration import Migration, title
from sdfcheck.convert.migrate.node import Node
from sdfcheck.convert.relocation import relocated
from sdfcheck.formats.survey import survey
from sdfcheck.model.includes import Included, included, includes_of, ring
from sdfcheck.model.parameters import PARAMETERS
from sdfcheck.source.element import Element
from sdfcheck.source.sniff import Kind

_OVERRIDES = ("pose", "static")


def brought_by(migration: Migration, include: Node) -> Included | str:
    """What an include brings, or why that cannot be written out."""
    document = migration.draft.read()
    found = included(document, migration.draft.element(include))
    if include.find(PARAMETERS) is not None:
        return "has parameters"
    if found.model is None or found.document is None:
        return "brings nothing that is there"
    if found.model.name == "robot":
        return "brings no SDFormat model"
    if any(ring(found.document, inner) for inner in includes_of(found.document)):
        return "brings what includes itself"
    return found


def brought(migration: Migration, include: Node, found: Included) -> Node:
    """The model that an include brings, in the version of the draft, as part of it."""
    from sdfcheck.convert.migrate.merging import write_out_merges
    from sdfcheck.convert.migrate.migrate import migrated

    assert found.model is not None
    inner = migrated(found.model.document, migration.draft.version, keep_unknown=migration.keep_unknown)
    inner.target = migration.target
    write_out_merges(inner)
    migration.losses += inner.losses
    model = inner.root.find(found.model.name)
    assert model is not None
    document = migration.draft.read()
    for node in model.walk():
        text = relocated(node.name, node.content, found, document)
        if text is not None:
            node.write(text)
        node.origin = None
    assert include.place is not None
    for node in (model, *model.children()):
        _declare(node, found.model, include.place)
    model.origin = include.origin
    model.remove()
    return model


def _declare(node: Node, model: Element, include: Element) -> None:
    """Declare the prefixes that only the included file declares."""
    inside = [node] if node.name == "model" else list(node.walk())
    names = [name for one in inside for name in (one.name, *one.attributes())]
    for prefix in sorted({name.partition(":")[0] for name in names if ":" in name}):
        uri = model.nsmap.get(prefix)
        if uri is not None and include.nsmap.get(prefix) != uri and node.get(f"xmlns:{prefix}") is None:
            node.set(f"xmlns:{prefix}", uri)


def write_out_includes(migration: Migration) -> None:
    """Below 1.5 an include stands in a world and says nothing but a uri; others are written out."""
    settled: set[Node] = set()
    while True:
        waiting = [node for node in migration.root.of("include") if node not in settled and _says_more(node)]
        if not waiting:
            return
        include = waiting[0]
        settled.add(include)
        found = brought_by(migration, include)
        if isinstance(found, str):
            _leave(migration, include, found)
        else:
            _write_out(migration, include, found)


def _says_more(include: Node) -> bool:
    in_world = include.parent is not None and include.parent.name == "world"
    return not in_world or any(child.name != "uri" and not child.is_custom for child in include.children())


def _leave(migration: Migration, include: Node, why: str) -> None:
    assert include.place is not None
    if include.parent is None or include.parent.name == "model":
        text = f"an include that {why} cannot be written out, and {migration.target} has none in models"
        raise refusal(include.place, text)
    text = f"the include {why} and stays, though {migration.target} has no place for what it says besides its uri"
    migration.lose(include, text, LossKind.UNKNOWN_REFERENCE)
    migration.kept.update(include.children())


def _write_out(migration: Migration, include: Node, found: Included) -> None:
    model = brought(migration, include, found)
    model.set("name", found.name or "")
    if (placement := include.find("placement_frame")) is not None:
        model.set("placement_frame", placement.content)
    for child in include.children():
        if child.name in _OVERRIDES:
            old = model.find(child.name)
            child.remove()
            if old is not None:
                old.replace([child])
            else:
                first = model.children()
                model.append(child, before=first[0] if first else None)
        elif child.name == "plugin" or child.is_custom:
            child.remove()
            model.append(child)
    text = f"what {title(include)} of {found.name} brings is written out: {migration.target} cannot place it"
    migration.note(include, text, LossKind.EXPANDED_INCLUDE)
    include.replace([model])


def tell_of_newer_files(migration: Migration) -> None:
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


__all__ = ["brought", "brought_by", "tell_of_newer_files", "write_out_includes"]
