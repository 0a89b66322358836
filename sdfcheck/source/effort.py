"""How much guessing a document is worth."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from sdfcheck.source.document import Document


class Effort:
    """The comparisons of names that are left for one document: one full of unknown names ends somewhere."""

    __slots__ = ("_left",)

    def __init__(self, document: Document) -> None:
        self._left = 50_000

    @property
    def is_spent(self) -> bool:
        return self._left <= 0

    def spend(self, comparisons: int) -> None:
        self._left -= comparisons
