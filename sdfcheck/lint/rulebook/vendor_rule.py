"""Rules about vendors' own elements: what follows from what the vendor's consumer does."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, ClassVar

from sdfcheck.consumers.reaction import Consumer, by_effect
from sdfcheck.formats.vendor.definitions import IGNORED, REFUSED, Effect, Outcome
from sdfcheck.lint.diagnostic import Diagnostic, Severity
from sdfcheck.lint.fix import Fix, TextEdit
from sdfcheck.lint.rule import Rule, Target, make_fix
from sdfcheck.robot.vendor.tags import VendorTag, VendorValue


class VendorRule(Rule):
    """A rule about the tags of one vendor: it looks at :class:`VendorTag` or :class:`VendorValue`.

    Its consumer is the one of that name, or is named in ``affects``. A rule that also looks at other objects
    of the robot does so for those who ask about it only: as a target, or by a rule that is off by default.
    """

    prefix: ClassVar[str]
    """The prefix of the vendor's tags."""
    refused: ClassVar[Effect] = REFUSED
    ignored: ClassVar[Effect] = IGNORED

    def report(  # noqa: PLR0913 - all but three are named
        self,
        subject: VendorTag | VendorValue,
        message: str,
        effect: Effect,
        *,
        at: Target | None = None,
        rest: str = "",
        labels: Mapping[Any, str] | None = None,
        fix: Fix | None = None,
    ) -> Diagnostic:
        """A diagnostic that also says what the vendor's consumer does; what it only ignores is a warning.

        ``at`` is the place where it is not that of the tag or value; ``rest`` ends the message.
        """
        text = f"{message}: {self.does(subject, effect)}{rest}"
        return self.judged(subject if at is None else at, text, effect, labels, fix)

    @staticmethod
    def does(subject: VendorTag | VendorValue, effect: Effect) -> str:
        """The reaction of the vendor's consumer, as the second half of a sentence."""
        tag = subject.tag if isinstance(subject, VendorValue) else subject
        return f"{tag.vendor.name} {by_effect(effect).words}"

    def judged(
        self,
        target: Target,
        message: str,
        effect: Effect,
        labels: Mapping[Any, str] | None = None,
        fix: Fix | None = None,
    ) -> Diagnostic:
        """The same in words of one's own."""
        is_read = effect.outcome in {Outcome.IGNORED, Outcome.ACCEPTED}
        severity = Severity.WARNING if is_read and self.severity is Severity.ERROR else self.severity
        own = self.affects or (each for each in Consumer if each.value == self.prefix)
        affects = dict.fromkeys(own, by_effect(effect))
        return self.diagnostic(target, message, labels=labels, fix=fix, severity=severity, affects=affects)

    @staticmethod
    def renaming(tag: VendorTag, name: str) -> Fix:
        """A fix that gives a tag another name."""
        element = tag.element
        spans = (tag.span, None if element is None else element.document.spans.end_name(element))
        edits = tuple(TextEdit(span, name) for span in spans if span is not None)
        return make_fix(f"rename it to {name}", edits, unsafe=True)
