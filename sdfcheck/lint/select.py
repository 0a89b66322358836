"""Which rules run, and how severe they are.

A selector is a code (``XYZ001``), a family or the beginning of its codes (``XYZ``,
``XYZ00``), a name (``name-of-rule``), or ``ALL``. A longer selector beats a shorter one; at equal
length, ignoring beats selecting. The command line comes after the configuration: its
``--select`` replaces ``select`` and ``extend-select`` (what the configuration ignores
stays ignored, unless it is selected by a selector at least as long), its
``--extend-select`` and ``--ignore`` change what the configuration selected. A rule in
preview is selected by its code or name only, unless previews are asked for.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path

from sdfcheck.lint.config.settings import UNSET, Settings
from sdfcheck.lint.diagnostic import Severity
from sdfcheck.lint.run import RuleFacts
from sdfcheck.source.errors import WrongUsage
from sdfcheck.source.record import NamedTuple

ALL = "ALL"


class UnknownSelector(WrongUsage):
    """A selector that names no rule."""

    def __init__(self, selector: str, rules: Sequence[RuleFacts]) -> None:
        self.selector = selector
        from sdfcheck.formats.near_names import nearest

        families = sorted({facts.family for facts in rules})
        choices = (ALL, *families, *(facts.name for facts in rules), *(facts.code for facts in rules))
        self.near = nearest(selector, choices)
        guess = f"; did you mean `{self.near}`?" if self.near else _others(selector, rules)
        super().__init__(f"unknown rule `{selector}`{guess}")


_FEW = 5
"""So many names are proposed, no more."""


def _others(code: str, rules: Sequence[RuleFacts]) -> str:
    """For a code that nothing has: those that its family has; for a part of a name: the names with that part."""
    alike = sorted(facts.name for facts in rules if "-" in code and code.lower() in facts.name)
    if 0 < len(alike) <= _FEW:
        return f"; did you mean {' or '.join(f'`{name}`' for name in alike)}?"
    own = sorted(facts.code for facts in rules if code.upper().rstrip("0123456789") == facts.family)
    return f"; {own[0].rstrip('0123456789')} has {own[0]} to {own[-1]}" if own else ""


class ActiveRules(NamedTuple):
    """The rules that run on a file, sorted by code.

    ``severities`` holds only what the configuration changed; ``targets`` the consumers
    that were asked for (empty: all). Files with the same rules share one value.
    """

    facts: tuple[RuleFacts, ...]
    severities: Mapping[str, Severity]
    targets: frozenset[str] = frozenset()

    @property
    def codes(self) -> frozenset[str]:
        return frozenset(facts.code for facts in self.facts)


def covered(
    selector: str, rules: Sequence[RuleFacts], hidden: frozenset[str] = frozenset()
) -> tuple[int, frozenset[str]]:
    """How specific a selector is, and the codes that it covers; those in ``hidden`` it has to name.

    Findings of simulations are known without being among the rules; ``ALL`` is all rules.

    Raises:
        UnknownSelector: it covers none.
    """
    if selector == ALL:
        return 0, frozenset(facts.code for facts in rules) - hidden
    found = _meant(selector, rules, hidden) or _meant(selector, _simulated(), hidden)
    if found is None:
        raise UnknownSelector(selector, rules)
    return found


def _meant(
    selector: str, rules: Iterable[RuleFacts], hidden: frozenset[str]
) -> tuple[int, frozenset[str]] | None:
    for facts in rules:
        if selector in (facts.code, facts.name):
            return len(facts.code), frozenset((facts.code,))
    codes = frozenset(f.code for f in rules if selector.startswith(f.family) and f.code.startswith(selector))
    return (len(selector), codes - hidden) if codes else None


def _simulated() -> tuple[RuleFacts, ...]:
    from sdfcheck.lint.kinds import SIMULATED

    return SIMULATED


def select(
    rules: Sequence[RuleFacts],
    settings: Settings,
    targets: Sequence[str] = (),
) -> ActiveRules:
    """The rules that settings choose, with those of the caller; a severity of None turns a rule off.

    A rule that is off by default runs without being selected if ``targets`` names a
    consumer that it is about. A rule stays if it affects one of the targets, or names no
    consumer at all.
    """
    given, severity = settings.given or UNSET, settings.severity
    wanted = frozenset(targets)
    off = tuple(selector for selector, level in severity if level is None)
    file = settings._replace(ignore=(*settings.ignore, *off))
    previews = settings.preview if given.preview is None else given.preview
    hidden = frozenset() if previews else frozenset(facts.code for facts in rules if facts.preview)
    initial = frozenset(f.code for f in rules if f.default or not wanted.isdisjoint(f.affects)) - hidden
    active = _apply(rules, initial, file, hidden)
    carried = file.ignore if given.select is not None else ()
    active = _apply(rules, active, given._replace(ignore=(*given.ignore, *carried)), hidden)
    chosen = [
        facts
        for facts in rules
        if facts.code in active and (not wanted or not facts.affects or not wanted.isdisjoint(facts.affects))
    ]
    chosen.sort(key=lambda facts: facts.code)
    return ActiveRules(tuple(chosen), _severities(rules, severity), wanted)


def without(active: ActiveRules, selectors: Iterable[str], rules: Sequence[RuleFacts]) -> ActiveRules:
    """The rules less those that the selectors cover, as ``per-file-ignores`` asks."""
    dropped = frozenset(code for selector in selectors for code in covered(selector, rules)[1])
    return active._replace(facts=tuple(facts for facts in active.facts if facts.code not in dropped))


def simulated_levels(settings: Settings, path: Path) -> Mapping[str, Severity | None]:
    """Codes of findings of simulations → the severity that they get in a file; None: they are ignored.

    ``select`` and ``ALL`` are about rules.
    """
    chosen = [(selector, None) for selector in (*settings.ignore, *settings.ignored_for(path))]
    levels: list[tuple[int, frozenset[str], Severity | None]] = []
    for selector, level in (*settings.severity, *chosen):
        found = _meant(selector, _simulated(), frozenset())
        if found is not None:
            levels.append((*found, level))
    # Of equally long selectors, ignoring counts.
    levels.sort(key=lambda each: (each[0], each[2] is None))
    return {code: level for _, codes, level in levels for code in codes}


def check_targets(targets: Iterable[str]) -> None:
    """Refuse names of consumers that nobody has heard of.

    Raises:
        WrongUsage: there is one.
    """
    from sdfcheck.consumers.reaction import Consumer

    known = tuple(consumer.value for consumer in Consumer)
    for target in targets:
        if target not in known:
            from sdfcheck.formats.near_names import did_you_mean

            near = did_you_mean(target, known) or f" (choose from {', '.join(sorted(known))})"
            raise WrongUsage(f"unknown target `{target}`{near}")


def _apply(
    rules: Sequence[RuleFacts], active: frozenset[str], choice: Settings, hidden: frozenset[str]
) -> frozenset[str]:
    """``active`` as changed by one choice, the least specific selectors first."""
    chosen = (*(choice.select or ()), *choice.extend_select)
    steps = [(*covered(selector, rules, hidden), True) for selector in chosen]
    steps += [(*covered(selector, rules), False) for selector in choice.ignore]
    steps.sort(key=lambda step: (step[0], not step[2]))
    result = frozenset[str]() if choice.select is not None else active
    for _, codes, wanted in steps:
        result = result | codes if wanted else result - codes
    return result


def _severities(
    rules: Sequence[RuleFacts], severity: Sequence[tuple[str, Severity | None]]
) -> Mapping[str, Severity]:
    changed: dict[str, Severity] = {}
    levels = [(*covered(selector, rules), level) for selector, level in severity]
    for _, codes, level in sorted(levels, key=lambda item: item[0]):
        if level is not None:
            changed.update(dict.fromkeys(codes, level))
    return changed
