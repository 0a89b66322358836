"""Rules about vendors' own elements: what follows from what the vendor's consumer does."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any, ClassVar

from sdfcheck.consumers.reaction import Consumer, by_effect
from sdfcheck.formats.near_names import suggest
from sdfcheck.formats.vendor.definitions import IGNORED, REFUSED, Effect, Outcome
from sdfcheck.lint.diagnostic import Diagnostic, Severity, named
from sdfcheck.lint.fix import Fix, TextEdit
from sdfcheck.lint.rule import Rule, Target, make_fix, rename, write_instead
from sdfcheck.robot.vendor import VendorTag, VendorValue

_FAULTS = {
    "EMPTY": "is empty",
    "NOT_FINITE": "should be {expected}, and `{part}` is not a number",
    "TOO_FEW": "should be {expected}, and has fewer",
    "TOO_MANY": "should be {expected}, and has more: `{part}`",
}
"""Why a value is not read as it is written, in words."""


class VendorRule(Rule):
    """A rule about the tags of one vendor: it looks at :class:`VendorTag` or :class:`VendorValue`.

    Its consumer is the one of that name, or is named in ``affects``. A rule that also looks at other objects
    of the robot does so for those who ask about it only: as a target, or by a rule that is off by default.
    """

    prefix: ClassVar[str] = ""
    """The prefix of the vendor's tags; empty: those of all vendors without rules of their own."""
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
        return self.judged(subject, text, effect, at=at, labels=labels, fix=fix)

    @staticmethod
    def does(subject: VendorTag | VendorValue, effect: Effect) -> str:
        """The reaction of the vendor's consumer, as the second half of a sentence."""
        return f"{_vendor(subject)} {by_effect(effect).words}"

    def judged(
        self,
        subject: VendorTag | VendorValue,
        message: str,
        effect: Effect,
        *,
        at: Target | None = None,
        labels: Mapping[Any, str] | None = None,
        fix: Fix | None = None,
    ) -> Diagnostic:
        """The same in words of one's own."""
        is_read = effect.outcome in {Outcome.IGNORED, Outcome.ACCEPTED}
        severity = Severity.WARNING if is_read and self.severity is Severity.ERROR else self.severity
        own = self.affects or (each for each in Consumer if each.value == subject.prefix)
        affects = dict.fromkeys(own, by_effect(effect))
        target = subject if at is None else at
        return self.diagnostic(target, message, labels=labels, fix=fix, severity=severity, affects=affects)

    # The defects that a table shows, in words.

    def unknown(self, tag: VendorTag) -> Diagnostic:
        """The table does not have the tag."""
        is_prefixed = tag.name.startswith(f"{tag.prefix}:")
        what = (
            f"`{tag.name}` is not known to {_vendor(tag)}" if is_prefixed else f"`{tag.name}` has no prefix"
        )
        near = f"; did you mean `{tag.meant}`?" if tag.meant else ""
        fix = self.renaming(tag, tag.meant) if tag.meant else None
        return self.report(tag, what, tag.effect, rest=near, fix=fix)

    def misplaced(self, tag: VendorTag) -> Diagnostic:
        """The tag is where nobody looks for it."""
        name = tag.name
        places = named([f"{each}{name}" if each.endswith("@") else each for each in tag.places], "or")
        if tag.unmet is not None:
            return self.report(tag, f"`{name}` is read only in {places}", tag.effect)
        if places:
            message = f"`{name}` does not belong in {tag.parent.title}"
            return self.report(tag, message, tag.effect, rest=f"; it goes into {places}")
        here, there = ("SDF", "URDF") if tag.document.kind.value == "sdf" else ("URDF", "SDF")
        use = f"; use `{tag.substitute}`" if tag.substitute else ""
        message = f"`{name}` is for {there}: in {here} {self.does(tag, tag.effect)}{use}"
        return self.judged(tag, message, tag.effect)

    def malformed(self, given: VendorTag | VendorValue) -> Diagnostic:
        """A value is not of its type, not one of the choices, or not where it is read."""
        if isinstance(given, VendorTag):
            return self._valueless(given)
        if (bad := given.misreading) is None:
            return self._unknown_choice(given)
        span = given.misread_span
        words = _FAULTS.get(bad.fault.name, "should be {expected}, not `{part}`")
        said = words.format(expected=given.expected, part=span.text)
        return self.report(given, f"{given.title} {said}", bad.effect, at=span)

    def _valueless(self, tag: VendorTag) -> Diagnostic:
        effect = tag.effect_of_empty
        if tag.stray is None:
            return self.report(tag, f"`{tag.name}` is empty", effect)
        found, value = tag.stray
        message = (
            f"the value of `{tag.name}` is read from its {_shape(tag.carrier)}, not from its {_shape(found)}"
        )
        return self.report(tag, message, effect, at=value.name_span if value.attribute else value)

    def _unknown_choice(self, value: VendorValue) -> Diagnostic:
        word, choices = value.text.strip(), value.slot.choices
        near = suggest(word, choices)
        rest = f"; did you mean `{near}`?" if near else f"; it is one of {named(choices, 'or')}"
        message, fix = f"{value.title} cannot be `{word}`", write_instead(near, value)
        return self.report(value, message, value.slot.bad, rest=rest, fix=fix)

    def out_of_range(self, value: VendorValue) -> Diagnostic:
        """A value breaks a bound."""
        message = f"{value.title} should be {value.bound}, not `{value.text.strip()}`"
        return self.report(value, message, value.slot.wrong)

    def lacking_children(self, tag: VendorTag) -> Iterator[Diagnostic]:
        """Children of the vendor's that must be there; one that is only misspelled is reported as such."""
        for lack in tag.lacks:
            if lack.misspelled is None:
                message = f"{tag.title} lacks {named(lack.choices, 'or')}"
                near = f"; did you mean `{lack.choices[0]}`?" if lack.near is not None else ""
                fix = rename(lack.choices[0], lack.near) if lack.near is not None else None
                yield self.report(tag, message, lack.effect, at=lack.near, rest=near, fix=fix)

    def lacking_values(self, tag: VendorTag) -> Iterator[Diagnostic]:
        """Attributes and plain children that must be there."""
        for missing in tag.missing_values:
            kind = "attribute" if missing.carrier[0] == "@" else "child"
            near = f"; is `{missing.near}` meant for it?" if missing.near else ""
            message = f"{tag.title} lacks the {kind} `{missing.carrier[1:]}`"
            yield self.report(tag, message, missing.effect, rest=near)

    def repeated(self, given: VendorTag | VendorValue) -> Iterator[Diagnostic]:
        """A tag of which one counts, or a name that another such tag has."""
        labels = {given.first: "the first"}
        if isinstance(given, VendorTag):
            message = f"`{given.name}` is given again: {_vendor(given)} reads the first only"
            yield self.judged(given, message, given.effect, labels=labels)
        elif (effect := given.slot.unique) is not None:
            message = f"there is a `{given.tag.name}` of the name `{given.text}` already"
            yield self.report(given, message, effect, labels=labels)

    def unresolved(self, name: VendorValue) -> Iterator[Diagnostic]:
        """A name of nothing, or of something else."""
        if (unresolved := name.unresolved) is None:
            return
        text, kinds = name.text.strip(), " or ".join(unresolved.kinds)
        if unresolved.found is not None:
            message = f"`{text}` is a {unresolved.found}, and `{name.tag.name}` names a {kinds}"
        elif "::" in text and not name.slot.scoped:
            message = f"`{name.tag.name}` names a {kinds} of its own model, and `{text}` is a scoped name"
        else:
            message = f"there is no {kinds} `{text}`"
        near = f"; did you mean `{unresolved.near}`?" if unresolved.near else ""
        yield self.report(name, message, self.refused, rest=near, fix=write_instead(unresolved.near, name))

    def outdated(self, tag: VendorTag) -> Diagnostic:
        """Another tag, or a standard element, takes the place of the tag."""
        if tag.is_gone:
            fix = self.renaming(tag, tag.successor)
            return self.report(tag, f"`{tag.name}` is now `{tag.successor}`", tag.effect, fix=fix)
        message = f"`{tag.name}` is older than the standard `{tag.successor}`, which takes its place"
        return self.judged(tag, message, tag.effect)._replace(severity=Severity.INFO)

    def conflicting(self, tag: VendorTag) -> Iterator[Diagnostic]:
        """Tags that exclude or need each other."""
        pairs = [(tag.element, tag.excluded), *((child, tag.element) for child in tag.forbidden)]
        for element, other in pairs:
            if element is not None and other is not None:
                message = f"`{element.name}` and `{other.name}` exclude each other"
                yield self.report(tag, message, self.refused, at=element, labels={other: "the other"})
        for need in tag.needs:
            shape = need.because
            on = f" on a `{shape.name}`" if shape is not None else ""
            message = f"`{tag.name}`{on} needs `{need.name}`"
            labels = {shape: "the shape"} if shape is not None else None
            yield self.report(tag, message, self.refused, labels=labels)
        if (idle := tag.idle_beside) is not None:
            message = f"`{tag.name}` has no effect beside `{idle.name}`"
            yield self.report(tag, message, self.ignored, labels={idle: "this one counts"})

    @staticmethod
    def renaming(tag: VendorTag, name: str) -> Fix:
        """A fix that gives a tag another name."""
        element = tag.element
        spans = (tag.span, None if element is None else element.document.spans.end_name(element))
        edits = tuple(TextEdit(span, name) for span in spans if span is not None)
        return make_fix(f"rename it to `{name}`", edits, unsafe=True)


def _vendor(subject: VendorTag | VendorValue) -> str:
    tag = subject.tag if isinstance(subject, VendorValue) else subject
    return tag.vendor.name


def _shape(carrier: str) -> str:
    """Where a value is, in words."""
    kinds = {"@": "attribute", "/": "child"}
    return f"{kinds[carrier[0]]} `{carrier[1:]}`" if carrier[0] in kinds else carrier
