"""The rules of all packs: what is known of each, and the rule itself when it is needed."""

from __future__ import annotations

import importlib
import sys
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from sdfcheck.lint.rulebook.pack import CONDITIONS, Fault, read_index, rule_classes
from sdfcheck.lint.run import BUILT_IN, RuleFacts

if TYPE_CHECKING:
    from sdfcheck.lint.rule import Rule

    Condition = Callable[[Any], bool]


class RuleIndex:
    """The rules that are there: their facts at once, their conditions and classes when asked for."""

    def __init__(
        self,
        facts: Sequence[RuleFacts],
        tables: Sequence[Path] = (),
        conditions: Sequence[str] = (),
        faults: Sequence[Fault] = (),
    ) -> None:
        """``conditions`` are the modules that hold conditions of the rules; ``faults`` keep others from loading."""
        self.facts = tuple(sorted(facts))
        self.tables = tuple(tables)
        """Those of vendors' own elements that packs bring."""
        self.faults = tuple(faults)
        self._rules: dict[str, Rule] = {}
        self._conditions: dict[str, Condition] | None = None
        self._modules_of_conditions = conditions

    def condition(self, facts: RuleFacts) -> Condition:
        """Conditions that decide at little cost whether a rule has something to report."""
        if self._conditions is None:
            self._conditions = {}
            for module in self._modules_of_conditions:
                self._conditions.update(_conditions_in(module))
        found = self._conditions.get(facts.code)
        return self.rule(facts).applies if found is None else found

    def rule(self, facts: RuleFacts) -> Rule:
        """The rule itself; its module is imported now if it was not before."""
        found = self._rules.get(facts.code)
        if found is None:
            found = self._rules[facts.code] = _rule(facts)
        return found


def _conditions_in(name: str) -> Mapping[str, Condition]:
    """The conditions that a module holds; none if it was not written, so that the rules themselves are loaded."""
    try:
        found: Mapping[str, Condition] = importlib.import_module(name).CONDITIONS
    except ModuleNotFoundError as error:
        if error.name != name:
            raise
        return {}
    return found


def _rule(facts: RuleFacts) -> Rule:
    module = sys.modules.get(facts.module) or importlib.import_module(facts.module)
    found = next((c for c in rule_classes(module) if c.code == facts.code), None)
    if found is None:
        raise LookupError(f"{facts.module} has no rule {facts.code}: write the index of its pack again")
    rule = found()
    if not facts.is_built_in:
        from sdfcheck.lint.rulebook.plugins import guard

        guard(rule)
    return rule


def load_index(plugins: Sequence[str | Path] = ()) -> RuleIndex:
    """The built-in rules and those of the plugins (folders, entry points or import names).

    Raises:
        PackError: a plugin cannot be loaded at all, or takes a prefix that is taken.
    """
    facts = read_index(BUILT_IN)
    if not plugins:
        return RuleIndex(facts, conditions=(f"{BUILT_IN}.{CONDITIONS}",))
    from sdfcheck.lint.rulebook.plugins import load_plugins

    loaded = load_plugins(plugins, facts)
    conditions = (f"{BUILT_IN}.{CONDITIONS}", *loaded.conditions)
    return RuleIndex((*facts, *loaded.facts), loaded.tables, conditions, loaded.faults)
