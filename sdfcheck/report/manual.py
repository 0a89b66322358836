"""The manual page of a rule, in Markdown: what it reports, shown on its examples."""

from __future__ import annotations

import inspect
import re
import sys
from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import nullcontext
from itertools import product
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

from sdfcheck.consumers.reaction import READS, Reaction
from sdfcheck.convert.loss import VARYING
from sdfcheck.lint.diagnostic import Diagnostic
from sdfcheck.lint.engine import INTERNAL_ERROR
from sdfcheck.lint.example import MARK_END, MARK_START, Bad, Good, fill, unmark
from sdfcheck.lint.rulebook.packs import RuleIndex
from sdfcheck.lint.rulebook.trial import ExampleRunner, file_name
from sdfcheck.lint.run import RuleFacts
from sdfcheck.lint.suppress.rules import MalformedSuppression, UnusedSuppression
from sdfcheck.release import FIRST_RELEASE
from sdfcheck.report.colors import painter
from sdfcheck.report.frame import Style, block
from sdfcheck.report.paths import Paths
from sdfcheck.source.record import NamedTuple
from sdfcheck.xacro.expansion import Expander

# Lays out the document of an example: one line in its rule, indented lines for those who read it.


_INDENT = "  "
_SHORT = 60
"""Characters of an element that is kept on one line."""
_LONG = 100
"""Characters of a line that is broken, even if there are others."""
_DEEP = 40
"""More nested elements than this are not indented."""
_TOKEN = re.compile(f"{MARK_START}?<(?:!--.*?--|[^<>]*)>{MARK_END}?|[^<]+", re.DOTALL)


def laid_out(text: str) -> str:
    """The text with lines broken between tags; as it is if it has short lines already, or its tags do not match."""
    if "\n" in text.strip() and all(len(line) <= _LONG for line in text.splitlines()):
        return text
    tokens = [match[0] for match in _TOKEN.finditer(text)]
    if "".join(tokens) != text:
        return text
    top = _parsed(tokens)
    lines = [line for node in top for line in _lines(node, "")]
    return "\n".join(lines) + "\n" if len(lines) > 1 else text


class _Node:
    """An element, or a text or comment: a node without ``end`` and children."""

    def __init__(self, start: str) -> None:
        self.start = start
        self.end = ""
        self.children: list[_Node] = []

    @property
    def flat(self) -> str:
        return self.start + "".join(child.flat for child in self.children) + self.end

    @property
    def is_text(self) -> bool:
        return "<" not in self.start


def _parsed(tokens: list[str]) -> list[_Node]:
    """The nodes at the top; none if the tags do not match."""
    top = _Node("")
    open_nodes = [top]
    for token in tokens:
        bare = _unmarked(token)
        if bare.startswith("</"):
            node = open_nodes.pop()
            if not open_nodes or bare[2:-1].strip() != _tag(node.start):
                return []
            node.end = token
            continue
        node = _Node(token)
        open_nodes[-1].children.append(node)
        if bare.startswith("<") and bare[1] not in "!?" and not bare.endswith("/>"):
            open_nodes.append(node)
            if len(open_nodes) > _DEEP:
                return []
    return top.children if len(open_nodes) == 1 else []


def _tag(start: str) -> str:
    return re.split(r"[\s>]", _unmarked(start)[1:], maxsplit=1)[0]


def _unmarked(text: str) -> str:
    return text.replace(MARK_START, "").replace(MARK_END, "")


def _lines(node: _Node, indent: str) -> Iterator[str]:
    flat = node.flat
    is_mixed = any(child.is_text and child.start.strip() for child in node.children)
    is_nested = any(child.children for child in node.children)
    if is_mixed or not node.children or (indent and not is_nested and len(flat) <= _SHORT):
        if flat.strip():
            yield indent + (flat if is_mixed else flat.strip())
        return
    yield indent + node.start
    for child in node.children:
        yield from _lines(child, indent + _INDENT)
    yield indent + node.end


_OWN = (UnusedSuppression, MalformedSuppression)
_LONGEST = 1500
_PREVIEW = "preview: off unless selected by its code or name, or with `--preview`"
"""Characters that are shown of either end of a long example."""
_REPORT_IT = (
    "Report it with the file and the line that names the error, and leave the rule out meanwhile.\n\n"
    'The message names the rule: `ignore = ["name-of-the-rule"]` in `sdfcheck.toml` leaves it out, and\n'
    "`SDFCHECK_DEBUG=1` before the command shows the whole traceback. For a rule of your own pack, the message\n"
    "names the line that failed: correct it there, and try it with `sdfcheck rules --test PACK`."
)
_DIALECTS = {"sdf": "SDFormat", "urdf": "URDF"}


class Shown(NamedTuple):
    """An example as a page shows it."""

    name: str
    """Of the file."""
    text: str
    """The whole document."""
    files: Mapping[str, str]
    """The other files: path → text."""
    report: str = ""
    """Diagnostics of it."""
    fixed: str | None = None
    is_safe: bool = True
    why: str = ""


class Manual(NamedTuple):
    """The whole manual of a rule."""

    facts: RuleFacts
    documentation: str
    """The rule's documentation, in Markdown."""
    remedy: str
    """The way to correct a finding, in Markdown; may be empty."""
    bad: tuple[Shown, ...]
    good: tuple[Shown, ...]
    sources: tuple[str, ...] = ()
    """Addresses of what the rule follows."""
    since: str = ""
    """The first version that has the rule."""
    is_own: bool = False
    """Whether the engine reports it, whatever the rules say; comments do not silence it."""


class Manuals:
    """The manuals of an index's rules; one process expands what is xacro in their examples."""

    def __init__(self, index: RuleIndex) -> None:
        self._index = index
        self._expander = Expander()

    def of(self, facts: RuleFacts) -> Manual:
        """The manual of a rule, imported from where the rule is; its examples are linted."""
        own = next((rule for rule in _OWN if rule.code == facts.code), None)
        if own is None and facts not in self._index.facts:
            # The others are findings of conversions and simulations.
            remedy = _REPORT_IT if facts is INTERNAL_ERROR else ""
            return Manual(facts, markdown(facts.summary), remedy, (), (), is_own=True)
        rule = own or type(self._index.rule(facts))
        runners = self._runners(() if own else (facts,), facts.affects)
        return Manual(
            facts,
            markdown(rule.__doc__),
            markdown(rule.remedy),
            tuple(_bad(example, rule.scaffold, facts.code, runners) for example in rule.bad),
            tuple(_good(example, rule.scaffold) for example in rule.good),
            _sources(rule),
            getattr(rule, "since", "") or (FIRST_RELEASE if facts.is_built_in else ""),
            is_own=own is not None,
        )

    def _runners(self, rules: Sequence[RuleFacts], targets: Iterable[str]) -> tuple[ExampleRunner, ...]:
        """Some rules judge some things only for those who ask for a consumer."""
        asked = ((), targets)
        return tuple(ExampleRunner(self._index, rules, targets, expander=self._expander) for targets in asked)


def _sources(rule: Any) -> tuple[str, ...]:
    """The rule's own, or those of its family: the package that it is in."""
    family = sys.modules.get(rule.__module__.rpartition(".")[0])
    return tuple(getattr(rule, "sources", ()) or getattr(family, "SOURCES", ()))


def _good(example: Good, scaffold: str) -> Shown:
    text = laid_out(fill(scaffold, example))
    return Shown(file_name(text, example), text, _files(example), why=example.why)


def _files(example: Bad | Good) -> Mapping[str, str]:
    return {name: laid_out(text) for name, text in (example.files or {}).items()}


def _bad(example: Bad, scaffold: str, code: str, runners: Sequence[ExampleRunner]) -> Shown:
    """The example with lines broken, unless that moves or removes what is reported."""
    written = fill(scaffold, example)
    lined = example if example.files is None else example._replace(files=_files(example))
    for marked, runner in product((laid_out(written), written), runners):
        text, start, end = unmark(marked)
        with nullcontext("") if example.files is None else TemporaryDirectory() as made:
            found = runner.lint(text, lined, Path(made))
            own = [d for d in found if d.code == code and (d.span.start, d.span.end) == (start, end)]
            if own:
                report = "\n".join(block(own[0], False, Style(_Beside(made), painter(False))))
                return _shown(example, text, report, own[0])
    return Shown(file_name(written, example), unmark(laid_out(written))[0], _files(example))


def _shown(example: Bad, text: str, report: str, diagnostic: Diagnostic) -> Shown:
    fix = diagnostic.fix if example.fixed is not None else None
    fixed = None
    if fix is not None:
        fixed = text
        for edit in sorted(fix.edits, key=lambda edit: -edit.span.start):
            fixed = fixed[: edit.span.start] + edit.text + fixed[edit.span.end :]
    is_safe = fix is None or fix.is_safe
    return Shown(file_name(text, example), text, _files(example), report, fixed, is_safe)


class _Beside(Paths):
    """Names files as seen from the folder of the example."""

    def __init__(self, folder: str) -> None:
        super().__init__()
        if folder:
            self._here, self._root = folder, f"{folder}/"


def record(page: Manual) -> Mapping[str, Any]:
    """A manual as JSON values."""
    return {
        **facts_record(page.facts),
        "documentation": page.documentation,
        "remedy": page.remedy,
        "sources": list(page.sources),
        "bad": [_record(bad, "report", "fixed") for bad in page.bad],
        "good": [_record(good, "why") for good in page.good],
    }


def _record(example: Shown, *keys: str) -> Mapping[str, Any]:
    return {key: getattr(example, key) for key in ("name", "text", "files", *keys)}


def facts_record(facts: RuleFacts) -> Mapping[str, Any]:
    """The entry of one rule in the list of rules, as JSON values."""
    return {
        "code": facts.code,
        "name": facts.name,
        "family": facts.family,
        "severity": facts.severity.value,
        "summary": markdown(facts.summary),
        "fix": facts.fixable or None,
        "default": facts.is_on,
        "preview": facts.preview,
        "url": facts.page,
        "affects": {
            consumer: {dialect: _judged(said) for dialect, said in by.items()}
            for consumer, by in facts.affects.items()
        },
    }


def _judged(said: str) -> str:
    """A reaction with its verdict, which is one of few words."""
    reaction = Reaction.of(said)
    return f"{reaction.verdict.value}: {reaction.words}"


def render(page: Manual) -> str:
    """A manual as Markdown."""
    return "\n\n".join(_sections(page)) + "\n"


def _sections(page: Manual) -> Iterator[str]:
    facts = page.facts
    yield f"# {facts.name} ({facts.code})"
    fix = f"{facts.fixable} fix" if facts.fixable else "no fix"
    when = _PREVIEW if facts.preview else "on by default" if facts.default else "off unless selected"
    since = f" · since {page.since}" if page.since else ""
    level = f"up to {facts.severity.value}, by case" if facts.code in VARYING else facts.severity.value
    yield f"**{level}** · {when} · {fix}{since}"
    yield page.documentation
    if page.remedy:
        yield "## How to fix it"
        yield page.remedy
    if facts.affects:
        yield "## What consumers do"
        yield _consumers(facts.affects)
    seen: set[tuple[str, str]] = set()
    if page.bad:
        yield "## Reported"
        for bad in page.bad:
            yield from _reported(bad, seen)
    if page.good:
        yield "## Not reported"
        for good in page.good:
            yield f"{good.why[:1].upper()}{good.why[1:]}:" if good.why else "This is as it should be:"
            yield from _document(good, seen)
    if not page.is_own:
        yield "## Turn it off"
        yield _silencing(facts.name)
    if page.sources:
        yield "## See also"
        yield "\n".join(f"- <{address}>" for address in page.sources)


def _consumers(affects: Mapping[str, Mapping[str, str]]) -> str:
    rows = ["| consumer | SDFormat | URDF |", "|---|---|---|"]
    for consumer, dialects in READS.items():
        said = affects.get(consumer.value, {})
        cells = (
            Reaction.of(said[dialect]).words
            if dialect in said
            else "–"
            if dialect not in dialects
            else "accepts it"
            for dialect in _DIALECTS
        )
        if said:
            rows.append(f"| {consumer.title} | {' | '.join(cells)} |")
    return "\n".join(rows)


def _reported(example: Shown, seen: set[tuple[str, str]]) -> Iterator[str]:
    yield from _document(example, seen)
    if example.report:
        yield _code(example.report, "text")
    if example.fixed is not None:
        yield "The fix:" if example.is_safe else "The fix, which `--unsafe-fixes` applies:"
        yield _code(_difference(example.text, example.fixed), "diff")


def _document(example: Shown, seen: set[tuple[str, str]]) -> Iterator[str]:
    """The example and the other files that it names; those in ``seen`` are only named."""
    yield _code(_shortened(example.text), "xml")
    for name, text in example.files.items():
        if name == example.name:
            continue
        is_known = (name, text) in seen
        seen.add((name, text))
        yield f"with `{name}`" + (" as above" if is_known else ":" if text.strip() else " (empty)")
        if text.strip() and not is_known:
            yield _code(text, "xml" if text.lstrip().startswith("<") else "text")


def _shortened(text: str) -> str:
    left_out = len(text) - 2 * _LONGEST
    return text if left_out <= 0 else f"{text[:_LONGEST]}\n… {left_out} characters …\n{text[-_LONGEST:]}"


def _silencing(name: str) -> str:
    return (
        f"- for one element: `<!-- sdfcheck:ignore[{name}] reason -->` before it\n"
        f"- for a file: `<!-- sdfcheck:ignore-file[{name}] -->` in it\n"
        f'- for a folder: `"folder/*" = ["{name}"]` below `[per-file-ignores]` in `sdfcheck.toml`\n'
        f'- everywhere: `ignore = ["{name}"]` in `sdfcheck.toml`'
    )


def _difference(before: str, after: str) -> str:
    from difflib import unified_diff

    lines = unified_diff(before.splitlines(), after.splitlines(), lineterm="", n=1)
    return "\n".join(line for line in lines if not line.startswith(("---", "+++", "@@")))


def _code(text: str, language: str) -> str:
    fence = "`" * max(3, 1 + max((len(run) for run in re.findall("`+", text)), default=0))
    return f"{fence}{language}\n{text.strip(chr(10))}\n{fence}"


def markdown(documentation: str | None) -> str:
    """Documentation as rules carry it, as Markdown."""
    return inspect.cleandoc(documentation or "").replace("``", "`")
