"""Parts by name or number."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, TypeVar

if TYPE_CHECKING:
    from sdfcheck.robot.part import Part

P = TypeVar("P", bound="Part")


class NotFound(LookupError):
    """There is no part of that name or number."""


def pick(owner: Part, kind: str, parts: Sequence[P], key: str | int) -> P:
    """The part of a name (``outer::inner`` reaches into models) or number; raises NotFound."""
    where = f"{type(owner).__name__.lower()} `{owner.name}`" if owner.holder is not None else "the file"
    if isinstance(key, int):
        if -len(parts) <= key < len(parts):
            return parts[key]
        held = f"{len(parts)} {kind}" if len(parts) == 1 else f"{len(parts)} {kind}s"
        raise NotFound(f"{where} has no {kind} number {key}; it has {held}")
    found = next((part for part in parts if part.name == key), None)
    if found is not None:
        return found
    outer, scoped, inner = key.partition("::")
    if scoped:
        model = next((model for model in getattr(owner, "models", ()) if model.name == outer), None)
        if model is not None:
            return getattr(model, kind)(inner)  # type: ignore[no-any-return]
    from sdfcheck.formats.suggest import did_you_mean

    near = did_you_mean(key, tuple(part.name for part in parts))
    raise NotFound(f"{where} has no {kind} `{key}`{near}")
