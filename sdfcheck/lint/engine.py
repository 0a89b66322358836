"""Runs rules over one document."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Iterator, Mapping, Sequence
from functools import cache, cached_property
from importlib import import_module
from typing import TYPE_CHECKING, Any

from sdfcheck.files.library import library_of
from sdfcheck.formats.vendor import used_tables
from sdfcheck.lint.diagnostic import Diagnostic, Severity
from sdfcheck.lint.rulebook.packs import RuleIndex
from sdfcheck.lint.run import EXTENSION, RuleFacts, reactions
from sdfcheck.lint.select import ActiveRules
from sdfcheck.lint.subjects import OF_VENDORS, Subjects, is_extension
from sdfcheck.source.document import Document, Element
from sdfcheck.source.document import problems as text_problems
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.sniff import Kind

if TYPE_CHECKING:
    from sdfcheck.robot.part import Part
    from sdfcheck.xacro.expansion import Expander

INTERNAL_ERROR = RuleFacts(
    "INT001",
    "internal-error",
    "INT",
    Severity.ERROR,
    "A rule failed on this document; this is a bug in the rule.",
    "",
    True,
    (),
    (),
    {},
    __name__,
)

_ANALYSES_OF_ALL = (("sdfcheck.source.document:problems", ""),)
_ANALYSES = {
    Kind.SDF: (
        ("sdfcheck.formats.sdf.survey:problems", ""),
        ("sdfcheck.formats.sdf.structure:structure_problems", ""),
        ("sdfcheck.robot.includes.included:problems", "<include"),
    ),
    Kind.URDF: (
        ("sdfcheck.formats.urdf.survey:problems", ""),
        ("sdfcheck.formats.sdf.survey:problems", "<gazebo"),
        ("sdfcheck.formats.sdf.structure:structure_problems", "<gazebo"),
    ),
}
"""The analyses of each kind of document, each with the text without which it finds nothing and is not loaded."""


OF_BODIES = frozenset({"GEO", "INR"})
"""Families of rules that find errors only where their own severity says so."""


class Xacro(NamedTuple):
    """How to expand a xacro file: by whom (None: not at all), once for each set of arguments."""

    expander: Expander | None
    argument_sets: tuple[Mapping[str, str], ...] = ()
    variants: bool = True
    """Is the robot also looked at with other values of its arguments?"""


class Dispatch:
    """Which rules look at which problems, objects and elements; made once for a set of rules."""

    def __init__(
        self, index: RuleIndex, active: ActiveRules, pause: Callable[[], None] = lambda: None
    ) -> None:
        self.index = index
        self.pause = pause
        """Called between portions of the work, for something else that cannot wait."""
        self.severities = active.severities
        self.targets = active.targets
        # The consumers that somebody asks about: as a target, or by a rule that is off by default.
        asked = active.targets.union(*(facts.affects for facts in active.facts if not facts.default))
        self.by_problem: dict[str, list[RuleFacts]] = {}
        groups: dict[tuple[tuple[str, ...], ...], list[RuleFacts]] = {}
        for facts in active.facts:
            for kind in facts.explains:
                self.by_problem.setdefault(kind, []).append(facts)
            if facts.looks_at or facts.selects:
                looked_at = (facts.looks_at, facts.selects, facts.needs)
                # A rule about a consumer's own elements judges the others for those who ask about the consumer.
                if asked.isdisjoint(facts.affects) and not OF_VENDORS.keys().isdisjoint(facts.looks_at):
                    looked_at = (tuple(name for name in facts.looks_at if name in OF_VENDORS), (), ())
                groups.setdefault(looked_at, []).append(facts)
        self.groups = [(Subjects(*looked_at), rules) for looked_at, rules in groups.items()]
        """Subjects, each with the rules that look at them."""
        self._active = active
        self._of_kind: dict[Kind, list[tuple[frozenset[str] | None, Subjects, list[RuleFacts]]]] = {}

    @cached_property
    def of_errors(self) -> Dispatch:
        """The same without the rules about bodies that only warn, which take longest."""
        kept = tuple(
            facts
            for facts in self._active.facts
            if facts.family not in OF_BODIES
            or self.severities.get(facts.code, facts.severity) is Severity.ERROR
        )
        return Dispatch(self.index, self._active._replace(facts=kept), self.pause)

    def groups_of(self, document: Document) -> Iterator[tuple[Subjects, list[RuleFacts]]]:
        """Those of the groups that a document can have subjects for, by its kind and the names in it."""
        kind = document.kind
        groups = self._of_kind.get(kind)
        if groups is None:
            groups = self._of_kind[kind] = [
                (subjects.names_in(kind), subjects, rules)
                for subjects, rules in self.groups
                if subjects.occur_in(kind)
            ]
        are_absent = document.names.isdisjoint
        for names, subjects, rules in groups:
            if names is None or not are_absent(names):
                yield subjects, rules


def lint_document(document: Document, dispatch: Dispatch) -> list[Diagnostic]:
    """All diagnostics of one document, sorted by place."""
    textual: list[Diagnostic] = []
    found: list[Diagnostic] = []
    for analysis in analyses(document):
        dispatch.pause()
        explained = explain(analysis(document), document, dispatch)
        (textual if analysis is text_problems else found).extend(explained)
    tables = used_tables(document)
    for subjects, rules in dispatch.groups_of(document):
        dispatch.pause()
        if seen := subjects.of(document, tables):
            for rule in rules:
                found += _check(rule, seen, document, dispatch)
    if (library := library_of(document)) is not None:
        library.shelves.save()
    # Where the text could only be guessed at, its own problems say why; the rest follows from the guess.
    certain = (diagnostic for diagnostic in found if not document.is_doubtful(diagnostic.span))
    return sorted(united({*textual, *certain}, document), key=lambda diagnostic: diagnostic.sort_key)


def united(found: Collection[Diagnostic], document: Document) -> Collection[Diagnostic]:
    """The findings without those that follow from another one, which is as severe and does what they do.

    Those of a text for xacro may follow from one in another file, and wait for the end of the run.
    """
    if document.kind is Kind.XACRO or not any(each.cause for each in found):
        return found
    from sdfcheck.lint.fold import with_consequences

    return with_consequences(found)


def analyses(document: Document) -> Iterator[Callable[[Document], Iterable[object]]]:
    """The analyses that fit a document's kind; each yields problems for rules to explain."""
    of_text = () if document.is_expanded else _ANALYSES_OF_ALL
    for path, text in (*of_text, *_ANALYSES.get(document.kind, ())):
        if text in document.source.text:
            yield _analysis(path)


@cache
def _analysis(path: str) -> Callable[[Document], Iterable[object]]:
    module, _, function = path.partition(":")
    found: Callable[[Document], Iterable[object]] = getattr(import_module(module), function)
    return found


def explain(problems: Iterable[object], document: Document, dispatch: Dispatch) -> Iterator[Diagnostic]:
    """The diagnostics of the rules about problems of a document."""
    for problem in problems:
        for rule in dispatch.by_problem.get(type(problem).__name__, ()):
            yield from _check(rule, (problem,), document, dispatch, is_certain=True)


def look_at(
    parts: Sequence[Part], elements: Sequence[Element], document: Document, dispatch: Dispatch
) -> Iterator[Diagnostic]:
    """The diagnostics of the rules about some parts and elements of the robot that a document describes."""
    for subjects, rules in dispatch.groups:
        if seen := subjects.among(parts, elements):
            for rule in rules:
                yield from _check(rule, seen, document, dispatch)


def _check(
    facts: RuleFacts,
    subjects: Iterable[Any],
    document: Document,
    dispatch: Dispatch,
    is_certain: bool = False,
) -> list[Diagnostic]:
    """Run one rule up to its first failure, which must not hide what the others report.

    On those of the subjects to which it applies, or on all where that ``is_certain``.
    """
    diagnostics: list[Diagnostic] = []
    failure: list[Diagnostic] = []
    extended: list[Diagnostic] = []
    dispatch.pause()
    try:
        for subject in subjects if is_certain else filter(dispatch.index.condition(facts), subjects):
            found = extended if is_extension(subject, document) else diagnostics
            found += dispatch.index.rule(facts).check(subject)
    except KeyboardInterrupt:
        raise
    except BaseException as error:  # also `sys.exit`
        failure.append(_internal_error(facts, error, document))
    if not (diagnostics or extended):
        return failure
    dialect = "sdf" if document.kind in (Kind.SDF, Kind.MODEL_CONFIG) else "urdf"
    adapted = _adapted(_for_audience(diagnostics, facts, document), facts, dialect, dispatch)
    if extended:
        adapted += _adapted(extended, facts, EXTENSION, dispatch)
    return [*adapted, *failure]


def _for_audience(diagnostics: list[Diagnostic], facts: RuleFacts, document: Document) -> list[Diagnostic]:
    """The diagnostics, with warnings for errors of others than the one consumer that can build a robot."""
    if all(each.severity is not Severity.ERROR for each in diagnostics):
        return diagnostics
    from sdfcheck.consumers.urdf_readers import is_for_drake

    if not document.view(is_for_drake):
        return diagnostics
    found = []
    for each in diagnostics:
        harmed = {by for by, said in reactions(facts, "urdf", each.affects) if not said.is_harmless}
        is_of_others = bool(harmed) and "drake" not in harmed
        found.append(each._replace(severity=Severity.WARNING) if is_of_others else each)
    return found


def _adapted(
    diagnostics: list[Diagnostic], facts: RuleFacts, dialect: str, dispatch: Dispatch
) -> list[Diagnostic]:
    """A rule's diagnostics after the configuration and the targets."""
    if not diagnostics:
        return diagnostics
    targets = dispatch.targets
    if facts.affects or diagnostics[0].affects:
        if dialect == EXTENSION and "gazebo" not in facts.affects:
            return []  # nobody concerned reads it
        diagnostics = [d._replace(affects=reactions(facts, dialect, d.affects, targets)) for d in diagnostics]
        if targets:
            diagnostics = [d for d in diagnostics if targets.intersection(d.concerned)]
    severity = dispatch.severities.get(facts.code)
    if severity is not None:
        return [diagnostic._replace(severity=severity) for diagnostic in diagnostics]
    return [diagnostic.for_targets(targets) for diagnostic in diagnostics] if targets else diagnostics


def _internal_error(facts: RuleFacts, error: BaseException, document: Document) -> Diagnostic:
    """The diagnostic of a rule that failed; for each document the first failure of a rule counts."""
    import os

    if os.environ.get("SDFCHECK_DEBUG"):
        raise error
    failures = document.view(_failures)
    if facts.code not in failures:
        from sdfcheck.lint.rulebook.plugins import failure

        message, advice = failure(facts, error)
        place = document.source.span(0, 0)
        failures[facts.code] = Diagnostic(
            INTERNAL_ERROR.code, INTERNAL_ERROR.name, Severity.ERROR, message, place, help=advice
        )
    return failures[facts.code]


def _failures(document: Document) -> dict[str, Diagnostic]:
    """Code → the failure of the rule."""
    return {}
