"""Which rules apply to which file, worked out once for all files of one configuration."""

from __future__ import annotations

from collections.abc import Callable, Collection
from pathlib import Path
from typing import TYPE_CHECKING

from sdfcheck.lint.config.settings import UNSET, Settings
from sdfcheck.lint.run import RuleFacts
from sdfcheck.lint.select import ActiveRules, UnknownSelector, covered, select, without
from sdfcheck.source.errors import WrongUsage

if TYPE_CHECKING:
    from sdfcheck.lint.engine import Dispatch
    from sdfcheck.lint.rulebook.pack import Fault
    from sdfcheck.lint.rulebook.packs import RuleIndex


class RuleBook:
    """The rules of each file, as its settings choose them."""

    __slots__ = ("_active", "_dispatch", "_indexes", "_pause")

    def __init__(self, pause: Callable[[], None] = lambda: None) -> None:
        self._pause = pause
        self._indexes: dict[tuple[str, ...], tuple[RuleIndex, tuple[RuleFacts, ...]]] = {}
        self._active: dict[tuple[Settings, tuple[str, ...]], ActiveRules] = {}
        self._dispatch: dict[tuple[Settings, tuple[str, ...]], Dispatch] = {}

    def rules(self, settings: Settings) -> tuple[RuleFacts, ...]:
        """All rules there are: those of the packs and the engine's own."""
        return self._loaded(settings)[1]

    def index(self, settings: Settings) -> RuleIndex:
        """The rules of the packs."""
        return self._loaded(settings)[0]

    def faults(self, settings: Settings) -> tuple[Fault, ...]:
        """Errors that keep rules of the plugins from being loaded."""
        return self._loaded(settings)[0].faults

    def active(self, settings: Settings, path: Path, less: tuple[str, ...] = ()) -> ActiveRules:
        """The rules that run on a file, without those that the selectors ``less`` cover.

        Raises:
            WrongUsage: a selector names no rule, a target or plugin is unknown.
        """
        ignored = (*settings.ignored_for(path), *less)
        key = (settings, ignored)
        if key not in self._active:
            if ignored:
                everywhere = self._chosen(settings)
                self._active[key] = without(everywhere, ignored, self.rules(settings))
            else:
                self._active[key] = self._chosen(settings)
        return self._active[key]

    def dispatch(self, settings: Settings, path: Path, less: tuple[str, ...] = ()) -> Dispatch:
        """The same, as the engine wants it; files with the same rules share it."""
        key = (settings, (*settings.ignored_for(path), *less))
        if key not in self._dispatch:
            from sdfcheck.lint.engine import Dispatch

            self._dispatch[key] = Dispatch(
                self.index(settings), self.active(settings, path, less), self._pause
            )
        return self._dispatch[key]

    def _chosen(self, settings: Settings) -> ActiveRules:
        rules = self.rules(settings)
        given = settings.given or UNSET
        # A rule that is not there may be one that could not be loaded.
        faults = "".join(f"; {fault}" for fault in self.faults(settings))
        try:
            for selector in (*(given.select or ()), *given.extend_select):
                if covered(selector, rules)[1].isdisjoint(facts.code for facts in rules):
                    raise WrongUsage(f"`sdfcheck simulate` finds `{selector}`, and no rule does")
            for selector in given.ignore:
                covered(selector, rules)
        except UnknownSelector as error:
            raise WrongUsage(f"{error}{faults}") from None
        target = (settings.target if given.target is None else given.target) or ()
        try:
            for _, selectors in settings.per_file_ignores:
                for selector in selectors:
                    covered(selector, rules)
            asked = _with_measured(rules, target)
            return select(asked, settings, target)
        except UnknownSelector as error:
            raise settings.misplaced(error.selector, f"{error}{faults}") from None

    def _loaded(self, settings: Settings) -> tuple[RuleIndex, tuple[RuleFacts, ...]]:
        if settings.plugins not in self._indexes:
            from sdfcheck.lint.engine import INTERNAL_ERROR
            from sdfcheck.lint.rulebook.pack import PackError
            from sdfcheck.lint.rulebook.packs import load_index
            from sdfcheck.lint.suppress.rules import FACTS

            try:
                index = load_index(settings.plugins)
            except PackError as error:
                raise settings.misplaced(Path(error.plugin).name, str(error)) from None
            self._indexes[settings.plugins] = index, (*index.facts, *FACTS, INTERNAL_ERROR)
        return self._indexes[settings.plugins]


def _with_measured(rules: tuple[RuleFacts, ...], targets: Collection[str]) -> tuple[RuleFacts, ...]:
    """The rules with the reactions of those targets that are not in the index."""
    if not targets:
        return rules
    from sdfcheck.consumers.reaction import ON_REQUEST

    if ON_REQUEST.isdisjoint(targets):
        return rules
    from sdfcheck.consumers.measured import concerns, with_measured
    from sdfcheck.lint.diagnostic import Severity

    return tuple(
        facts._replace(
            affects=with_measured(
                facts.code, facts.affects, targets, is_error=facts.severity is Severity.ERROR
            )
        )
        if facts.affects or concerns(facts.code, targets)
        else facts
        for facts in rules
    )
