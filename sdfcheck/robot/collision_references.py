"""Names of collisions, links and models that sensors, sounds, grippers and states use.

No reader checks them: a contact sensor on a misspelt collision stays silent, a gripper
without its links holds nothing, and a state of an unknown model is not restored.
"""

from __future__ import annotations

from collections.abc import Iterator

from sdfcheck.formats.sdf.survey import Survey, survey
from sdfcheck.formats.suggest import suggest_in
from sdfcheck.robot.file_problems import UnknownReference
from sdfcheck.source.document import Document

_DEFAULT = "__default__"
_TOUCHING = frozenset({"sensor", "audio_source"})


def problems(document: Document) -> list[UnknownReference]:
    """The references of an SDF document that name nothing."""
    surveyed = survey(document)
    return [*_collisions(surveyed), *_gripped(document, surveyed), *_restored(document, surveyed)]


def _collisions(surveyed: Survey) -> Iterator[UnknownReference]:
    for contact in surveyed.index.get("contact", ()):
        holder = contact.parent
        link = holder.parent if holder is not None else None
        if holder is None or link is None or holder.name not in _TOUCHING or link.name != "link":
            continue
        names = [collision.attributes.get("name", "") for collision in link.children("collision")]
        for reference in contact.children("collision"):
            name = reference.content
            # A scoped name is spelt from the world or the model, in ways that differ by reader.
            if name and name != _DEFAULT and "::" not in name and name not in names:
                yield UnknownReference(
                    reference.own_value, "collision", link, suggest_in(surveyed.document, name, names)
                )


def _gripped(document: Document, surveyed: Survey) -> Iterator[UnknownReference]:
    for gripper in surveyed.index.get("gripper", ()):
        from sdfcheck.robot.scopes import scopes

        scope = scopes(document).of(gripper)
        for reference in (*gripper.children("gripper_link"), *gripper.children("palm_link")):
            name = reference.content
            if not name or name == _DEFAULT or scope is None or "" in name.split("::"):
                continue
            found = scope.find(name)
            if (found is None and not scope.may_hold(name)) or (found is not None and found.kind != "link"):
                links = [frame.name for frame in scope.links()]
                yield UnknownReference(
                    reference.own_value, "link", scope.element, suggest_in(document, name, links)
                )


def _restored(document: Document, surveyed: Survey) -> Iterator[UnknownReference]:
    """The worlds and models whose state is to be restored."""
    for state in surveyed.index.get("state", ()):
        from sdfcheck.robot.scopes import scopes

        scope, world = scopes(document).of(state), state.attribute("world_name")
        if scope is None or scope.kind != "world" or not scope.complete:
            continue
        if world is not None and world.text.strip() not in {"", _DEFAULT, scope.name}:
            root = document.root
            assert root is not None
            yield UnknownReference(world, "world", root, suggest_in(document, world.text, [scope.name]))
            continue
        models = [frame.name for frame in scope.frames.values() if frame.kind == "model"]
        for kind in ("model", "model_state"):
            for element in state.children(kind):
                name = element.attribute("name")
                if name is not None and "::" not in name.text and name.text not in models:
                    yield UnknownReference(
                        name, "model", scope.element, suggest_in(document, name.text, models)
                    )
