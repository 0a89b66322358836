"""Runs the examples of a pack's rules: the exact place, the fix, and silence."""

from __future__ import annotations

from collections.abc import Collection, Iterable
from pathlib import Path
from tempfile import TemporaryDirectory

from sdfcheck.files.library import Library, SearchPaths
from sdfcheck.formats.vendor import SUFFIX
from sdfcheck.lint.diagnostic import Diagnostic, Severity
from sdfcheck.lint.engine import INTERNAL_ERROR, Dispatch, Xacro
from sdfcheck.lint.example import Bad, Good, fill, unmark
from sdfcheck.lint.fix import Fix
from sdfcheck.lint.one_file import lint_source
from sdfcheck.lint.rule import Rule
from sdfcheck.lint.rulebook.pack import CONDITIONS
from sdfcheck.lint.rulebook.packs import RuleIndex, load_index
from sdfcheck.lint.rulebook.plugins import load_plugins, places_of_examples
from sdfcheck.lint.run import BUILT_IN, RuleFacts
from sdfcheck.lint.select import ActiveRules
from sdfcheck.source.sniff import Kind
from sdfcheck.source.text import Source, Span
from sdfcheck.xacro.expansion import Expander

# Lints examples of rules, each among the other files that it names.


_KINDS = {".xacro": Kind.XACRO, ".config": Kind.MODEL_CONFIG, ".srdf": Kind.SRDF}


class ExampleRunner:
    """Lints with some of the rules of an index, for the consumers in ``targets``."""

    def __init__(
        self,
        index: RuleIndex,
        rules: Iterable[RuleFacts],
        targets: Iterable[str] = (),
        *,
        expander: Expander | None = None,
    ) -> None:
        self._dispatch = Dispatch(index, ActiveRules(tuple(rules), {}, frozenset(targets)))
        self._xacro = Xacro(expander or Expander())
        self._tables = index.tables

    def lint(self, text: str, example: Bad | Good, folder: Path | None = None) -> list[Diagnostic]:
        """Lint a text as the example's file, among the example's other files, which are written to ``folder``."""
        kind, path = _KINDS.get(Path(example.file).suffix), Path(file_name(text, example))
        if example.files is None:
            library = Library(SearchPaths(tables=self._tables)) if self._tables else None
            return lint_source(text.encode(), path, kind, self._dispatch, library, self._xacro).diagnostics
        if folder is None:
            with TemporaryDirectory() as made:
                return self.lint(text, example, Path(made))
        for name, content in example.files.items():
            file = folder / name
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_text(content, encoding="utf-8")
        given = (folder / name for name in example.files if name.endswith(SUFFIX))
        library = Library(SearchPaths(tables=(*self._tables, *given)))
        return lint_source(
            text.encode(), folder / path, kind, self._dispatch, library, self._xacro
        ).diagnostics


def file_name(text: str, example: Bad | Good) -> str:
    """The name of the file that an example is in."""
    return example.file or ("robot.urdf" if "<robot" in text else "robot.sdf")


class Bench:
    """The rules of a pack, and what it takes to run their examples.

    ``faults`` are about rules that cannot be loaded. ``strict`` are codes of rules that
    report warnings and errors only in examples that name them in ``also``.

    Raises:
        PackError: the pack cannot be loaded at all.
    """

    def __init__(self, pack: str | Path, *, strict: Collection[str] = ()) -> None:
        others = () if pack == BUILT_IN else load_index().facts
        loaded = load_plugins((pack,), others, anew=True)
        conditions = (f"{BUILT_IN}.{CONDITIONS}", *loaded.conditions)
        index = RuleIndex((*others, *loaded.facts), loaded.tables, conditions)
        self.facts = tuple(sorted(loaded.facts))
        self.rules: tuple[type[Rule], ...] = tuple(type(index.rule(facts)) for facts in self.facts)
        self.faults = loaded.faults
        self.tables = loaded.tables
        self.strict = frozenset(strict)
        self.lint = ExampleRunner(index, index.facts).lint

    @property
    def trials(self) -> tuple[Trial, ...]:
        """All examples of all rules."""
        return tuple(
            Trial(self, rule, kind, number)
            for rule in self.rules
            for kind in ("bad", "good")
            for number in range(len(getattr(rule, kind)))
        )


class Trial:
    """One example of a rule, ready to run; its text names it: ``ABC001-bad-1``."""

    __slots__ = ("_bench", "kind", "number", "rule")

    def __init__(self, bench: Bench, rule: type[Rule], kind: str, number: int) -> None:
        self._bench = bench
        self.rule = rule
        self.kind = kind
        self.number = number

    def __repr__(self) -> str:
        return f"{self.rule.code}-{self.kind}-{self.number + 1}"

    @property
    def example(self) -> Bad | Good:
        """The example itself."""
        found: Bad | Good = getattr(self.rule, self.kind)[self.number]
        return found

    @property
    def place(self) -> str:
        """Where the example is written, as ``path:line``."""
        count = len(getattr(self.rule, self.kind))
        return places_of_examples(self.rule, self.kind, count)[self.number]

    def failure(self) -> str | None:
        """Where the example is, what was expected and what came; None if it is as it should be."""
        example = self.example
        text = self._bad(example) if isinstance(example, Bad) else self._good(example)
        if text is None:
            return None
        rule = f"{self.rule.code} {self.rule.name}"
        return f"{self.place}: {rule}, {self.kind} example {self.number + 1}: {text}"

    def check(self) -> None:
        """Fail as a test fails.

        Raises:
            AssertionError: the example is not as it should be.
        """
        if text := self.failure():
            raise AssertionError(text)

    def _good(self, example: Good) -> str | None:
        found = self._bench.lint(fill(self.rule.scaffold, example), example)
        own = self._own(found)
        return self._broken(found) or (f"expected no diagnostic, got {_listed(own)}" if own else None)

    def _bad(self, example: Bad) -> str | None:
        text, start, end = unmark(fill(self.rule.scaffold, example))
        found = self._bench.lint(text, example)
        if broken := self._broken(found):
            return broken
        if start < 0:
            return "expected «» around what is reported, got an example without these marks"
        expected = Source(Path("example"), text).span(start, end)
        own = self._own(found)
        if len(own) != 1:
            rest = "" if own else _errors(found)
            return f"expected one diagnostic at {_place(expected)}, got {_listed(own)}{rest}"
        (diagnostic,) = own
        if (diagnostic.span.start, diagnostic.span.end) != (start, end):
            return f"expected a diagnostic at {_place(expected)}, got one at {_place(diagnostic.span)}"
        if example.says not in diagnostic.message:
            return f"expected a message with “{example.says}”, got “{diagnostic.message}”"
        return self._beside(example, found) or self._fixed(example, text, diagnostic.fix)

    def _beside(self, example: Bad, found: list[Diagnostic]) -> str | None:
        codes = {d.code for d in found if d.severity >= Severity.WARNING} - {self.rule.code}
        if missing := sorted(set(example.also) - codes):
            return f"expected a diagnostic of {', '.join(missing)}, too, got none"
        if extra := sorted((codes & self._bench.strict).difference(example.also)):
            return f"expected no diagnostic of {', '.join(extra)}, got one"
        return None

    def _fixed(self, example: Bad, text: str, fix: Fix | None) -> str | None:
        if example.fixed is None:
            return None
        if fix is None:
            return "expected a fix, got none"
        if fix.is_safe is example.unsafe:
            wanted, got = ("an unsafe", "a safe") if example.unsafe else ("a safe", "an unsafe")
            return f"expected {wanted} fix, got {got} one"
        for edit in sorted(fix.edits, key=lambda edit: -edit.span.start):
            text = text[: edit.span.start] + edit.text + text[edit.span.end :]
        expected = fill(self.rule.scaffold, example._replace(text=example.fixed))
        if text != expected:
            return f"expected the fix to give {_difference(expected, text)}"
        left = self._own(self._bench.lint(text, example))
        return f"expected no diagnostic after the fix, got {_listed(left)}" if left else None

    def _own(self, found: list[Diagnostic]) -> list[Diagnostic]:
        return [diagnostic for diagnostic in found if diagnostic.code == self.rule.code]

    def _broken(self, found: list[Diagnostic]) -> str | None:
        """How the rule has failed, if it has."""
        start = f"rule {self.rule.code} "
        failures = (d.message for d in found if d.code == INTERNAL_ERROR.code)
        return next((text for text in failures if text.startswith(start)), None)


def _place(span: Span) -> str:
    line, column = span.begin
    return f"`{span.text}` (line {line}, column {column})"


def _listed(diagnostics: list[Diagnostic]) -> str:
    return "; ".join(f"“{d.message}” at {_place(d.span)}" for d in diagnostics) or "none"


def _errors(found: list[Diagnostic]) -> str:
    """The reason for an example in which a rule finds nothing."""
    error = next((d for d in found if d.severity is Severity.ERROR), None)
    return f" (but {error.code} {error.name}: “{error.message}” at {_place(error.span)})" if error else ""


def _difference(expected: str, got: str) -> str:
    """The first lines that differ."""
    pairs = zip(expected.splitlines(), got.splitlines(), strict=False)
    pair = next((pair for pair in pairs if pair[0] != pair[1]), (expected, got))
    return f"`{pair[0].strip()}`, got `{pair[1].strip()}`"
