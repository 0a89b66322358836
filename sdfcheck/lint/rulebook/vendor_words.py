"""How to speak of problems with vendors' tags."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

from sdfcheck.consumers.reaction import by_effect
from sdfcheck.formats.vendor import problems
from sdfcheck.formats.vendor.definitions import Outcome
from sdfcheck.formats.vendor.problems import TagFault, TagProblem
from sdfcheck.lint.diagnostic import Diagnostic, Severity
from sdfcheck.lint.fix.fix import Edit, Fix
from sdfcheck.lint.rule import Rule, Target, make_fix
from sdfcheck.lint.wording import named, used
from sdfcheck.source.element import Element, Value
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.text import Span


class Words(NamedTuple):
    """What there is to say: where, what, and who else takes part."""

    target: Target
    message: str
    labels: Mapping[Target, str] = {}
    fix: Fix | None = None


def report(rule: Rule, problem: TagProblem) -> Diagnostic:
    """The diagnostic of a problem, as severe as its effect: what is only passed over is a warning."""
    said = _WORDS[type(problem)](problem)
    severity = rule.severity
    if severity is Severity.ERROR and problem.effect.outcome in {Outcome.IGNORED, Outcome.ACCEPTED}:
        severity = Severity.WARNING
        if isinstance(problem, problems.OutdatedTag) and not problem.removed:
            severity = Severity.INFO
    reaction = by_effect(problem.effect)
    affects = dict.fromkeys(rule.affects, reaction)
    if isinstance(problem, problems.TooNewTag):
        affects = {}  # the effect is that of older releases
    return rule.diagnostic(
        said.target,
        said.message,
        labels=said.labels,
        fix=said.fix,
        severity=severity,
        affects=affects,
    )


def consequence(problem: TagProblem, it: str = "it") -> str:
    """What the reader does, as the second half of a sentence."""
    reader = problem.vendor.name
    if problem.effect.outcome is Outcome.READ:
        return f"{reader} reads `{problem.effect.value}`"
    return {
        Outcome.ERROR: f"{reader} refuses the file",
        Outcome.ABORT: f"{reader} aborts",
        Outcome.CRASH: f"{reader} crashes",
        Outcome.IGNORED: f"{reader} ignores {it}",
        Outcome.ACCEPTED: f"{reader} takes it all the same",
    }[problem.effect.outcome]


def _near(suggestion: str | None) -> str:
    return f"; did you mean `{suggestion}`?" if suggestion else ""


def _unknown(problem: problems.UnknownTag) -> Words:
    prefixed = problem.name.startswith(f"{problem.vendor.prefix}:")
    what = (
        f"`{problem.name}` is not known to {problem.vendor.name}"
        if prefixed
        else f"`{problem.name}` has no prefix"
    )
    fix = _renaming(problem.target, problem.suggestion) if problem.suggestion else None
    message = f"{what}: {consequence(problem)}{_near(problem.suggestion)}"
    return Words(_name_of(problem.target), message, fix=fix)


def _misplaced(problem: problems.MisplacedTag) -> Words:
    owner = _owner(problem.target)
    place = owner.title if owner is not None else "the root"
    if problem.condition is not None:
        message = f"`{problem.name}` is read only in {named(problem.places, 'or')}: {consequence(problem)}"
    elif problem.places:
        message = (
            f"`{problem.name}` does not belong in {place}: {consequence(problem)}; "
            f"it goes into {named(problem.places, 'or')}"
        )
    else:
        dialects = "URDF", "SDF"
        here, there = dialects if problem.other and problem.other[0].startswith("model") else dialects[::-1]
        use = f"; use `{problem.use}`" if problem.use else ""
        message = f"`{problem.name}` is for {there}: in {here} {consequence(problem)}{use}"
    return Words(_name_of(problem.target), message)


_FAULTS = {
    TagFault.EMPTY: "is empty",
    TagFault.NOT_FINITE: "should be {expected}, and `{part}` is none",
    TagFault.TRAILING: "should be {expected}, not `{part}`",
    TagFault.TOO_FEW: "should be {expected}, and has fewer",
    TagFault.TOO_MANY: "should be {expected}, and has more: `{part}`",
}


def _malformed(problem: problems.MalformedTag) -> Words:
    text = _FAULTS.get(problem.fault, "should be {expected}, not `{part}`")
    said = text.format(expected=problem.expected, part=problem.span.text)
    return Words(problem.span, f"{_called(problem.name, problem.value)} {said}: {consequence(problem)}")


def _miscarried(problem: problems.MiscarriedTag) -> Words:
    shapes = {"@": "attribute `{}`", "/": "child `{}`"}
    found = shapes[problem.found[0]].format(problem.found[1:]) if problem.found != "text" else "text"
    wanted = shapes[problem.wanted[0]].format(problem.wanted[1:]) if problem.wanted != "text" else "text"
    target: Target = problem.value.name_span if problem.value.attribute else problem.value
    message = f"the value of `{problem.name}` is read from its {wanted}, not from its {found}"
    return Words(target, f"{message}: {consequence(problem)}")


def _out_of_range(problem: problems.TagOutOfRange) -> Words:
    called = _called(problem.name, problem.value)
    return Words(
        problem.value,
        f"{called} should be {problem.bound}, not `{problem.value.text.strip()}`: {consequence(problem)}",
    )


def _choice(problem: problems.UnknownTagChoice) -> Words:
    called = _called(problem.name, problem.value)
    text = problem.value.text.strip()
    choices = "" if problem.suggestion else f"; it is one of {named(problem.choices, 'or')}"
    message = f"{called} cannot be `{text}`: {consequence(problem)}{choices}{_near(problem.suggestion)}"
    return Words(problem.value, message)


def _unordered(problem: problems.UnorderedTags) -> Words:
    low, high = problem.value, problem.other
    message = (
        f"`{problem.name}` is {low.text.strip()} and above `{high.element.name}`, {high.text.strip()}: "
        f"{consequence(problem)}"
    )
    return Words(low, message, {high: "the value that it must not exceed"})


def _missing(problem: problems.MissingTag) -> Words:
    message = (
        f"{problem.element.title} lacks {named(problem.choices, 'or')}: {consequence(problem, 'the whole')}"
    )
    if problem.near is not None:
        return Words(problem.near, f"{message}; did you mean `{problem.choices[0]}`?")
    return Words(problem.element, message)


def _missing_value(problem: problems.MissingTagValue) -> Words:
    kind = "attribute" if problem.wanted[0] == "@" else "child"
    message = f"{problem.element.title} lacks the {kind} `{problem.wanted[1:]}`: {consequence(problem)}"
    return Words(problem.element, message + (f"; is `{problem.near}` meant for it?" if problem.near else ""))


def _repeated(problem: problems.RepeatedTag) -> Words:
    return Words(
        problem.element,
        f"`{problem.name}` is given again: {problem.vendor.name} reads the first only",
        {problem.first: "the first"},
    )


def _repeated_name(problem: problems.RepeatedTagName) -> Words:
    return Words(
        problem.value,
        f"there is a `{problem.name}` of the name `{problem.value.text}` already: {consequence(problem)}",
        {problem.first: "the first"},
    )


def _conflicting(problem: problems.ConflictingTags) -> Words:
    other = problem.other
    message = f"`{problem.element.name}` and `{other.name}` exclude each other: {consequence(problem)}"
    return Words(problem.element, message, {other: "the other"})


def _unmet(problem: problems.UnmetTag) -> Words:
    because = problem.because
    on = f" on a `{because.name}`" if because is not None else ""
    labels: dict[Target, str] = {because: "the shape"} if because is not None else {}
    return Words(
        problem.element, f"`{problem.name}`{on} needs `{problem.needed}`: {consequence(problem)}", labels
    )


def _idle(problem: problems.IdleTag) -> Words:
    message = f"`{problem.name}` has no effect beside `{problem.other.name}`: {consequence(problem)}"
    return Words(problem.element, message, {problem.other: "this one counts"})


def _scoped(problem: problems.ScopedTagName) -> Words:
    return Words(
        problem.value, f"a `{problem.name}` cannot be defined under a scoped name: {consequence(problem)}"
    )


def _reference(problem: problems.UnknownTagReference) -> Words:
    name, kinds = problem.value.text.strip(), " or ".join(problem.kinds)
    if problem.found is not None:
        message = f"`{name}` is a {problem.found}, and `{problem.name}` names a {kinds}"
    elif "::" in name and not problem.scoped:
        message = f"`{problem.name}` names a {kinds} of its own model, and `{name}` is a scoped name"
    else:
        message = f"there is no {kinds} `{name}`"
    return Words(problem.value, f"{message}: {consequence(problem)}{_near(problem.suggestion)}")


def _self_tied(problem: problems.SelfTiedTag) -> Words:
    message = f"both ends are `{problem.value.text.strip()}`: {consequence(problem)}"
    return Words(problem.value, message, {problem.other: "the other end"})


def _outdated(problem: problems.OutdatedTag) -> Words:
    if problem.removed:
        fix = _renaming(problem.element, problem.successor)
        message = f"`{problem.name}` is now `{problem.successor}`: {consequence(problem)}"
        return Words(problem.element, message, fix=fix)
    return Words(
        problem.element,
        f"`{problem.name}` is older than the standard `{problem.successor}`, which takes its place",
    )


def _too_new(problem: problems.TooNewTag) -> Words:
    message = f"`{problem.name}`{used(problem.uses)} came with {problem.vendor.name} {problem.since}"
    declared = problem.declared
    if declared is not None:
        message += f", and the file says {declared.text}"
        return Words(_name_of(problem.target), message, {declared: "declared here"})
    return Words(_name_of(problem.target), f"{message}: an older {consequence(problem)}")


_WORDS: Mapping[type[TagProblem], Callable[[Any], Words]] = {
    problems.ConflictingTags: _conflicting,
    problems.IdleTag: _idle,
    problems.MalformedTag: _malformed,
    problems.MiscarriedTag: _miscarried,
    problems.MisplacedTag: _misplaced,
    problems.MissingTag: _missing,
    problems.MissingTagValue: _missing_value,
    problems.OutdatedTag: _outdated,
    problems.RepeatedTag: _repeated,
    problems.RepeatedTagName: _repeated_name,
    problems.ScopedTagName: _scoped,
    problems.SelfTiedTag: _self_tied,
    problems.TagOutOfRange: _out_of_range,
    problems.TooNewTag: _too_new,
    problems.UnknownTag: _unknown,
    problems.UnknownTagChoice: _choice,
    problems.UnknownTagReference: _reference,
    problems.UnmetTag: _unmet,
    problems.UnorderedTags: _unordered,
}


def _called(name: str, value: Value) -> str:
    """A value by its attribute or plain child, where that is not the tag itself."""
    own = value.attribute or value.element.name
    if own in {name, "value"}:
        return f"`{name}`"
    return f"`{own}` of `{name}`"


def _name_of(target: Element | Value) -> Element | Span:
    return target.name_span if isinstance(target, Value) else target


def _owner(target: Element | Value) -> Element | None:
    return target.element if isinstance(target, Value) else target.parent


def _renaming(target: Element | Value, name: str) -> Fix:
    if isinstance(target, Value):
        edits: tuple[Edit, ...] = (Edit(target.name_span, name),)
    else:
        spans = (target.span, target.document.spans.end_name(target))
        edits = tuple(Edit(span, name) for span in spans if span is not None)
    return make_fix(f"rename it to {name}", edits, unsafe=True)
