"""Errors that keep a description from being understood."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from sdfcheck.source.document import Element


class DescriptionError(ValueError):
    """A description from which something cannot be worked out; ``element`` is where."""

    def __init__(self, message: str, element: Element) -> None:
        super().__init__(message)
        self.element = element
