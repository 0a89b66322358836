"""The one model of a file that is to become a robot."""

from __future__ import annotations

from collections.abc import Iterator

from sdfcheck.convert.items import models
from sdfcheck.formats.suggest import suggest
from sdfcheck.robot.model import Model
from sdfcheck.source.document import Document
from sdfcheck.source.element import Element
from sdfcheck.source.wrong_usage import WrongUsage


def choose(document: Document, name: str) -> Model:
    """The model of a name, or the only one.

    Raises: WrongUsage: the file has no model, or several and no name was given.
    """
    found = models(document)
    names = [scope.name for scope in found]
    if not found:
        raise WrongUsage(f"{document.path} has no model")
    if not name:
        if len(found) > 1:
            raise WrongUsage(f"{document.path} has several models; choose one with --model: {_list(names)}")
        return found[0]
    if name not in names:
        near = suggest(name, names)
        hint = f", did you mean `{near}`?" if near else f"; it has {_list(names)}"
        raise WrongUsage(f"{document.path} has no model `{name}`{hint}")
    return found[names.index(name)]


def _list(names: list[str]) -> str:
    shown = ", ".join(names[:20])
    return shown if len(names) <= 20 else f"{shown} and {len(names) - 20} more"


def others(document: Document, chosen: Model) -> Iterator[Element]:
    """The parts beside the chosen model: other models, lights, physics and the rest of its world."""
    at: Element | None = chosen.place
    while at is not None and at is not document.root:
        around = at.parent
        if around is not None:
            yield from (child for child in around.children() if child is not at and not child.is_custom)
        at = around
