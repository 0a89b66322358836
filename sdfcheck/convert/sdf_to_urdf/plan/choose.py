"""The one model of a file that is to become a robot."""

from __future__ import annotations

from collections.abc import Iterator

from sdfcheck.formats.suggest import suggest
from sdfcheck.robot.scopes import Scope, scopes
from sdfcheck.source.document import Document
from sdfcheck.source.element import Element
from sdfcheck.source.wrong_usage import WrongUsage


def models(document: Document) -> list[Scope]:
    """The top-level models of a file and of its worlds, in document order."""
    return [model for root in scopes(document).roots for model in _models(root)]


def _models(scope: Scope) -> Iterator[Scope]:
    if scope.kind == "model":
        yield scope
    else:
        yield from scope.inner


def choose(document: Document, name: str) -> Scope:
    """The model of a name, or the only one.

    Raises:
        WrongUsage: there is none, or several and no name to choose by.
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


def others(document: Document, chosen: Scope) -> Iterator[Element]:
    """What stands beside the chosen model: other models, lights, physics and the rest of its world."""
    at: Element | None = chosen.placed if chosen.placed is not None else chosen.element
    while at is not None and at is not document.root:
        around = at.parent
        if around is not None:
            yield from (child for child in around.children() if child is not at and not child.is_custom)
        at = around
