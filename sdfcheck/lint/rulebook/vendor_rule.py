"""Rules about vendors' own elements: the words are here, a pack adds its prefix, codes and examples."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any, ClassVar

from sdfcheck.lint.diagnostic import Diagnostic
from sdfcheck.lint.rule import Rule


class VendorRule(Rule):
    """A rule about one kind of problem with the tags of one vendor.

    A subclass names the kinds in ``explains`` and needs no ``check`` of its own. One that
    also looks at objects of the robot does so for those who ask about the readers in
    ``affects`` only: as a target, or by a rule that is off by default.
    """

    prefix: ClassVar[str]
    """The prefix of the vendor's tags."""

    def check(self, problem: Any) -> Iterator[Diagnostic]:
        """Put a problem with a tag of this vendor into words."""
        if problem.vendor.prefix == self.prefix and self.is_about(problem):
            from sdfcheck.lint.rulebook.vendor_words import report

            yield report(self, problem)

    def is_about(self, problem: Any) -> bool:
        """For a rule that takes a part of a kind only."""
        return True
