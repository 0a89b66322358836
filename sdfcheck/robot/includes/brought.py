"""The model that an include brings."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from sdfcheck.robot.kinds import class_named

if TYPE_CHECKING:
    from sdfcheck.robot.includes.included import Included
    from sdfcheck.robot.model import Model
    from sdfcheck.robot.scope import Scope

MOST_MODELS = 10_000
"""So many included models are looked into: includes of includes can multiply without end."""
DEEPEST = 50


def included_model(source: Scope, found: Included) -> Model | None:
    """The model that an include brings; without content where the file cannot be read or leads in a ring.

    None where not even its name is known.
    """
    chain, inside = source.chain, found.document
    root = source.root
    is_readable = (
        found.model is not None and inside is not None and inside not in chain and len(chain) <= DEEPEST
    )
    if is_readable:
        root.included += 1
        is_readable = root.included <= MOST_MODELS
    if found.name is None and not is_readable:
        return None
    made: Any = class_named("Model")
    model: Model = made(source, found.model if is_readable else found.include, found.name or "")
    model.registry = {}
    model.include, model.is_readable = found.include, is_readable
    if is_readable and inside is not None:
        model.chain = (*chain, inside)
    return model
