"""The manual page of a rule, in Markdown."""

from __future__ import annotations

import inspect
import re
from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from sdfcheck.consumers.reaction import lines
from sdfcheck.lint.example import MARK_END, MARK_START, Bad, Good
from sdfcheck.lint.rulebook.packs import RuleIndex
from sdfcheck.lint.run import RuleFacts
from sdfcheck.lint.suppress.rules import MalformedSuppression, UnusedSuppression
from sdfcheck.source.record import NamedTuple

_OWN = (UnusedSuppression, MalformedSuppression)


class Manual(NamedTuple):
    """All that is to be said of a rule."""

    facts: RuleFacts
    documentation: str
    """The rule's documentation, in Markdown."""
    bad: tuple[Bad, ...]
    good: tuple[Good, ...]
    is_own: bool = False
    """Whether the engine reports it, whatever the rules say; comments do not silence it."""


def manual(facts: RuleFacts, index: RuleIndex) -> Manual:
    """The manual of a rule, imported from where the rule is."""
    own = next((rule for rule in _OWN if rule.code == facts.code), None)
    if own is not None:
        return Manual(facts, markdown(own.__doc__), own.bad, own.good, is_own=True)
    if facts not in index.facts:
        return Manual(facts, markdown(facts.summary), (), (), is_own=True)
    rule = index.rule(facts)
    return Manual(facts, markdown(type(rule).__doc__), rule.bad, rule.good)


def record(page: Manual) -> Mapping[str, Any]:
    """A manual as JSON values."""
    return {
        **facts_record(page.facts),
        "documentation": page.documentation,
        "bad": [{"text": _plain(bad.text), "fixed": bad.fixed} for bad in page.bad],
        "good": [{"text": good.text, "why": good.why} for good in page.good],
    }


def facts_record(facts: RuleFacts) -> Mapping[str, Any]:
    """What the list of rules says of one, as JSON values."""
    return {
        "code": facts.code,
        "name": facts.name,
        "family": facts.family,
        "severity": facts.severity.value,
        "summary": markdown(facts.summary),
        "fix": facts.fixable or None,
        "default": facts.default,
        "affects": {reader: dict(reactions) for reader, reactions in facts.affects.items()},
    }


def render(page: Manual) -> str:
    """A manual as Markdown."""
    return "\n\n".join(_sections(page)) + "\n"


def _sections(page: Manual) -> Iterator[str]:
    facts = page.facts
    yield f"# {facts.name} ({facts.code})"
    traits = [facts.severity.value, f"{facts.fixable} fix" if facts.fixable else "no fix"]
    if not facts.default:
        traits.append("off unless selected")
    yield f"*{', '.join(traits)}*"
    yield page.documentation
    if facts.affects:
        yield "## Who is affected"
        yield "\n".join(f"- {line}" for line in lines(facts.affects))
    if page.bad:
        yield "## Reported"
        yield from _reported(page.bad)
    if page.good:
        yield "## Fine"
        for good in page.good:
            yield (f"{good.why}:\n\n" if good.why else "") + _code(good.text)
    if page.is_own:
        return
    yield "## Silencing it"
    yield (
        f"Here: `<!-- sdfcheck: ignore[{facts.name}] reason -->` before the element. "
        f"In a file: `<!-- sdfcheck: ignore-file[{facts.name}] -->`. "
        f'Everywhere: `ignore = ["{facts.name}"]` in `sdfcheck.toml`.'
    )


def _reported(examples: Sequence[Bad]) -> Iterator[str]:
    for bad in examples:
        yield _code(_plain(bad.text))
        if bad.fixed is not None:
            yield f"{'Unsafe fix' if bad.unsafe else 'Fixed'}:\n\n" + _code(bad.fixed)


def _code(text: str) -> str:
    fence = "`" * max(3, 1 + max((len(run) for run in re.findall("`+", text)), default=0))
    return f"{fence}xml\n{text.strip(chr(10))}\n{fence}"


def _plain(text: str) -> str:
    return text.replace(MARK_START, "").replace(MARK_END, "")


def markdown(documentation: str | None) -> str:
    """Documentation as rules carry it, as Markdown."""
    return inspect.cleandoc(documentation or "").replace("``", "`")
