"""The result of one run: what reporters render."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Mapping
from pathlib import Path
from typing import TYPE_CHECKING

from sdfcheck.lint.diagnostic import Diagnostic, Severity
from sdfcheck.release import rule_page
from sdfcheck.source.record import NamedTuple

if TYPE_CHECKING:
    from sdfcheck.consumers.reaction import Reaction


BUILT_IN = "sdfcheck_rules"
"""The package of the built-in rules."""
EXTENSION = "extension"
"""The dialect of what is SDFormat in a URDF file, which nobody but Gazebo reads."""


class RuleFacts(NamedTuple):
    """The facts of a rule that are known without importing it (the index holds them)."""

    code: str
    name: str
    family: str
    severity: Severity
    summary: str
    """First sentence of the rule's documentation."""
    fixable: str
    """"safe", "unsafe" or "" (derived from the rule's examples)."""
    default: bool
    """False: off unless selected."""
    selects: tuple[str, ...]
    """Selectors of the elements that the rule looks at."""
    explains: tuple[str, ...]
    """Names of the kinds of problem that the rule puts into words."""
    affects: Mapping[str, Mapping[str, str]]
    """Consumer → dialect → its reaction: a :class:`~sdfcheck.consumers.reaction.Reaction` as text."""
    module: str
    """Module that holds the rule's class."""
    looks_at: tuple[str, ...] = ()
    """Names of the classes of the robot that the rule looks at."""
    needs: tuple[str, ...] = ()
    """Texts, one of which must be in a document: without them the rule has nothing to say."""
    preview: bool = False
    """True: not yet measured; off unless previews are asked for, or it is selected by code or name."""

    @property
    def is_on(self) -> bool:
        """Whether the rule runs where nobody selects rules."""
        return self.default and not self.preview

    @property
    def is_built_in(self) -> bool:
        """Whether the rule comes with sdfcheck."""
        return self.module.partition(".")[0] in {BUILT_IN, "sdfcheck"}

    @property
    def remedy(self) -> str:
        """How to correct a finding, in Markdown, from the rule's module; empty of a pack's rule that is not loaded."""
        import sys
        from importlib import import_module
        from inspect import cleandoc

        module = import_module(self.module) if self.is_built_in else sys.modules.get(self.module)
        rules = (
            (each for each in vars(module).values() if getattr(each, "code", "") == self.code)
            if module
            else ()
        )
        return cleandoc(getattr(next(iter(rules), None), "remedy", ""))

    @property
    def page(self) -> str | None:
        """The address of the page about the rule; rules of packs have none."""
        return rule_page(self.name) if self.is_built_in else None


def reactions(
    facts: RuleFacts,
    dialect: str,
    special: Iterable[tuple[str, Reaction]] = (),
    targets: Collection[str] = (),
) -> tuple[tuple[str, Reaction], ...]:
    """The reactions to a rule's defect in a document, sorted by consumer; ``special`` comes first.

    Measured consumers count if they are among the ``targets``.
    """
    from sdfcheck.consumers.reaction import ON_REQUEST, READS, Consumer, Reaction

    if dialect == EXTENSION:
        known = reactions(facts, "sdf", special)
        return tuple((consumer, said) for consumer, said in known if consumer == Consumer.GAZEBO.value)
    written = {consumer: by[dialect] for consumer, by in facts.affects.items() if dialect in by}
    found = {consumer: Reaction.of(said) for consumer, said in written.items()}
    own = {consumer: said for consumer, said in special if dialect in READS[Consumer(consumer)]}
    found.update((consumer, said) for consumer, said in own.items() if consumer not in ON_REQUEST)
    if not ON_REQUEST.isdisjoint(targets):
        from sdfcheck.consumers.measured import in_this_case

        found.update(in_this_case(facts.code, own, targets))
    return tuple(sorted(found.items(), key=lambda item: item[0]))


class Gate(NamedTuple):
    """The findings that count, because they fail a run. The exit code and all reports ask it.

    ``least``: those at least so severe. ``missing``: also all those about this computer.
    ``warnings``: so many warnings are tolerated, and more of them fail the run; None: ``least`` decides.
    """

    least: Severity = Severity.WARNING
    missing: bool = False
    warnings: int | None = None

    def severity(self, diagnostic: Diagnostic) -> Severity:
        """The severity that services show: what other computers may have is only worth knowing."""
        return Severity.INFO if diagnostic.missing is not None and not self.missing else diagnostic.severity

    def judge(self, diagnostics: Iterable[Diagnostic]) -> Callable[[Diagnostic], bool]:
        """Whether a finding fails the run that has these diagnostics."""
        too_many = self.warnings is not None and self.warnings < sum(
            each.severity is Severity.WARNING and (each.missing is None or self.missing)
            for each in diagnostics
        )

        def fails(diagnostic: Diagnostic) -> bool:
            if diagnostic.missing is not None:
                return self.missing
            if self.warnings is not None and diagnostic.severity is Severity.WARNING:
                return too_many
            return diagnostic.severity >= self.least

        return fails


class Run(NamedTuple):
    """One finished run. Diagnostics are sorted; nothing here changes afterwards.

    ``files`` are the linted files, also the clean ones; ``skipped`` those that were
    found but not linted, with the reason. ``suppressed`` counts silenced diagnostics,
    ``fixed`` applied fixes.
    """

    diagnostics: tuple[Diagnostic, ...]
    files: tuple[Path, ...]
    skipped: tuple[tuple[Path, str], ...] = ()
    suppressed: int = 0
    fixed: int = 0
    rules: tuple[RuleFacts, ...] = ()
    """Facts of every rule that was selected, sorted by code."""
    gate: Gate = Gate()

    @property
    def failing(self) -> tuple[Diagnostic, ...]:
        """The findings that fail the run."""
        return tuple(filter(self.gate.judge(self.diagnostics), self.diagnostics))

    @property
    def missing(self) -> tuple[Diagnostic, ...]:
        """The findings about this computer."""
        return tuple(each for each in self.diagnostics if each.missing is not None)

    @property
    def gravest_first(self) -> list[tuple[Diagnostic, Severity]]:
        """The findings with the severities that services show, the gravest first."""
        found = [(each, self.gate.severity(each)) for each in self.diagnostics]
        return sorted(found, key=lambda pair: -pair[1].rank)

    @property
    def pages(self) -> Mapping[str, str]:
        """Code → the address of the page about the rule."""
        return {facts.code: facts.page for facts in self.rules if facts.page}

    def count(self, severity: Severity) -> int:
        return sum(d.severity is severity for d in self.diagnostics)

    @property
    def fixable(self) -> int:
        return sum(d.fix is not None and d.fix.is_safe for d in self.diagnostics)
