"""``sdfcheck targets``."""

from __future__ import annotations

import sys
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from textwrap import wrap
from types import MappingProxyType
from typing import TYPE_CHECKING, Any

import click

from sdfcheck.cli.parts.command import Command
from sdfcheck.cli.parts.descriptions import (
    SearchContext,
    around,
    check_arguments,
    described,
    load,
    load_unexpanded,
)
from sdfcheck.cli.parts.options import formatted, limited, require_file, targeted, written
from sdfcheck.cli.parts.output import deliver, deliver_lines
from sdfcheck.cli.parts.terminal import say, wants_color, width_of
from sdfcheck.consumers.reaction import UNFOUND, Consumer, Verdict
from sdfcheck.files.library import Library
from sdfcheck.files.regular import read_named
from sdfcheck.lint.diagnostic import counted
from sdfcheck.lint.session import Level, Notice, Options
from sdfcheck.lint.session import run as lint
from sdfcheck.lint.targets import Reason, Row, matrix, without_sdf
from sdfcheck.report.colors import Ink, painter
from sdfcheck.report.paths import Paths
from sdfcheck.source.document import Document, Element, read
from sdfcheck.source.errors import WrongUsage
from sdfcheck.source.sniff import Kind, sniff
from sdfcheck.xacro.prepare import is_fragment
from sdfcheck.xacro.static.definitions import is_robot, keyword, visible_definitions

if TYPE_CHECKING:
    from sdfcheck.consumers.engines import Answer, Engine

_PART = "it is a part for other xacro files: a robot has a name, and more than macros"
_NO_LINK = "it is a part for other files: a robot has a link"
_FOREIGN = frozenset(
    (
        Kind.SRDF,
        Kind.MJCF,
        Kind.WEBOTS,
        Kind.OTHER_XML,
        Kind.MODEL_CONFIG,
        Kind.SDF_SPECIFICATION,
        Kind.CHEMISTRY,
        Kind.TEMPLATE,
        Kind.LFS_POINTER,
    )
)
"""Files that are something else, and not just wrong."""
VERSION = 1
"""Of the JSON."""


@click.command(cls=Command, name="targets")
@click.argument("file", type=click.Path(path_type=Path))
@targeted("Ask about these consumers only, and exit with 1 if one rejects the file")
@click.option("--run", is_flag=True, help="Also ask the consumers that are installed, and compare.")
@limited
@click.option("--all", "every", is_flag=True, help="Show all reasons, not only the weightiest.")
@formatted("Lines to read, or JSON.", "text", "json")
@written()
@described
def targets_command(  # noqa: PLR0913, PLR0917 - one for each option
    file: Path,
    target: tuple[str, ...] | None,
    run: bool,
    time_limit: float,
    every: bool,
    form: str,
    output_file: Path | None,
    **given: Any,
) -> int:
    """Say which consumers accept an SDFormat, URDF or xacro file, and why others do not.

    \b
    accept        it is read as it is written, as far as the rules know
    warn          it is read, but not all of it, or not as it was meant
    reject        it is not read to its end
    not read      the consumer does not know the format
    not measured  nobody knows what the consumer does with what is in the file

    With --run each consumer that is installed reads the file in a process of its own, with
    limits on time and memory. Where it does otherwise than predicted, that is marked.
    """
    require_file(file)
    consumers = tuple(map(Consumer, target or ())) or tuple(Consumer)
    surroundings = around(given)
    rows = verdicts(file, consumers, surroundings)
    real = asked(file, rows, surroundings, time_limit) if run else {}
    if form == "json":
        deliver(_json(file, rows, real), output_file)
    else:
        painted = output_file is None and wants_color("auto", sys.stdout)
        width = width_of(sys.stdout) if output_file is None else None
        shown = lines(rows, file, real, most=None if every else _SHOWN, width=width, color=painted)
        deliver_lines(shown, output_file, color=painted)
    refusing = [row for row in rows if row.verdict in {Verdict.REJECT, Verdict.UNREAD}]
    return int(bool(target) and bool(refusing or any(map(refuses, real.values()))))


def _json(file: Path, rows: Sequence[Row], real: Mapping[Consumer, Answer]) -> str:
    import json

    records = [
        record(row) | (_record_of(row, real[row.consumer]) if row.consumer in real else {}) for row in rows
    ]
    return json.dumps({"version": VERSION, "file": Paths()(file), "consumers": records}, indent=2) + "\n"


def verdicts(file: Path, consumers: Sequence[Consumer], around: SearchContext) -> tuple[Row, ...]:
    """Lint a file with everything that the rules know about some consumers.

    Raises: WrongUsage: it cannot be read, or is not a robot description.
    """
    failures: list[str] = []

    def notify(notice: Notice) -> None:
        if notice.level is Level.FAILURE:
            failures.append(notice.text)

    asked = tuple(consumer.value for consumer in consumers)
    check_arguments(around.arguments, [file], around.settings_for(file))
    configuration = around.configuration.with_given(around.configuration.given._replace(target=asked))
    options = Options(configuration, arguments=around.arguments, is_alone=True)
    done = lint([file], options, notify=notify)
    if failures:
        raise WrongUsage("; ".join(failures))
    if done.suppressed:
        say(f"note: {done.suppressed} findings are suppressed and not counted")
    settings = around.settings_for(file)
    data = read_named(file, settings.size_limit)
    kind = sniff(data, file)
    if kind in _FOREIGN:
        raise WrongUsage(f"{file} looks like {kind.description}, no robot description")
    rows = matrix(done, kind, file, consumers)
    document = read(data, file, kind) if kind in {Kind.XACRO, Kind.URDF} else None
    if document is None or document.root is None:
        return rows
    document.library = Library(settings.search, settings.size_limit)
    if kind is Kind.URDF:
        is_part = not document.root.has("link") and is_fragment(document)
        return _unread(rows, _NO_LINK) if is_part else rows
    is_sdf = document.root.name == "sdf"
    if not (is_robot(document) and (is_sdf or may_have_links(document))):
        return _unread(rows, _PART)
    return tuple((is_sdf and without_sdf(row.consumer)) or row for row in rows)


def _unread(rows: Sequence[Row], note: str) -> tuple[Row, ...]:
    return tuple(Row(row.consumer, Verdict.UNREAD, (), note) for row in rows)


def may_have_links(document: Document) -> bool:
    """Has a xacro file a link outside of the macros that it does not call, as far as they are known?"""
    visible = visible_definitions(document)
    called = {call.name for read in visible.readings for call in read.calls if call.macro is None}
    while (
        more := {name for each in called for macro in visible.macros.get(each, ()) for name in macro.calls}
    ) - called:
        called |= more
    taken = {macro.element for name in called for macro in visible.macros.get(name, ())}
    return visible.is_open or any(
        element.name == "link" and (macro is None or macro in taken) and _is_directly_in_robot(element)
        for read in visible.readings
        for element, macro in read.elements
    )


def _is_directly_in_robot(element: Element) -> bool:
    """Is an element of xacro in nothing else than a robot, and what xacro takes away?"""
    return all(each.name == "robot" or ":" in each.name or keyword(each) for each in element.around)


def asked(file: Path, rows: Sequence[Row], around: SearchContext, seconds: float) -> dict[Consumer, Answer]:
    """The consumers' own answers, of those that know the format; xacro is expanded for them."""
    from sdfcheck.consumers.engines import RUN_BY, Answer, Limits, Outcome, ask
    from sdfcheck.consumers.engines.staging import Stage

    found: dict[Consumer, Answer] = {}
    known: dict[Engine, Answer] = {}
    readers = [row.consumer for row in rows if row.verdict is not Verdict.UNREAD]
    with Stage() as stage:
        try:
            document = load(file, around, check=False, as_launched=True)
        except WrongUsage as error:
            written = load_unexpanded(file, around)
            if written is None:
                nothing = f"it gets nothing to read: {error}"
                return {one: Answer(RUN_BY[one], Outcome.REFUSED, error=nothing) for one in readers}
            document = written
        question = stage.question(document)
        for consumer in readers:
            engine = RUN_BY[consumer]
            if engine not in known:
                known[engine] = ask(engine, question, Limits(seconds))
            found[consumer] = known[engine]
    return found


def refuses(answer: Answer) -> bool:
    """Whether a consumer that is installed did not get to the end of the file."""
    return not answer.is_accepted and not answer.is_missing


def differs(row: Row, answer: Answer) -> bool:
    """Does a consumer do otherwise than predicted?"""
    if answer.is_missing or row.verdict is Verdict.UNMEASURED or unfound(row, answer) is not None:
        return False
    return refuses(answer) is not (row.verdict is Verdict.REJECT)


def unfound(row: Row, answer: Answer) -> Reason | None:
    """A reason for which the consumer refuses the file here, and may take it on another computer."""
    if not refuses(answer) or row.verdict is Verdict.REJECT:
        return None
    absent = (each for each in row.reasons if each.reaction == UNFOUND or each.diagnostic.missing is not None)
    return next(absent, None)


_SHOWN = 5
"""So many reasons for a verdict are shown unasked."""
_INKS = {Verdict.REJECT: Ink.ERROR, Verdict.WARN: Ink.WARNING, Verdict.UNREAD: Ink.FAINT}


def lines(
    rows: Sequence[Row],
    file: Path,
    real: Mapping[Consumer, Answer] = MappingProxyType({}),
    *,
    most: int | None = _SHOWN,
    width: int | None = None,
    color: bool = False,
) -> Iterator[str]:
    """A line a consumer, and below it the reasons, and what the consumer said itself; folded to the width."""
    paint = painter(color)
    names = max(len(row.consumer.value) for row in rows)
    for row in rows:
        note = f": {row.note}" if row.note else ""
        ink = _INKS.get(row.verdict)
        verdict = row.verdict.value if ink is None else paint(row.verdict.value, ink)
        yield f"{row.consumer.value:{names}}  {verdict}{note}"
        own = list(_said(row, real[row.consumer])) if row.consumer in real else []
        for line in (*_reasons(row, file, most), *own):
            yield from _folded(line, names + 4, width)


def _folded(line: str, indent: int, width: int | None) -> list[str]:
    """A line below a verdict; on a terminal that is too narrow for it several."""
    start = " " * indent
    if width is None or indent + len(line) <= width:
        return [start + line]
    return wrap(
        line,
        max(width, indent + 30),
        initial_indent=start,
        subsequent_indent=start + " " * 7,
        break_long_words=False,
        break_on_hyphens=False,
    )


def _reasons(row: Row, file: Path, most: int | None) -> list[str]:
    """The lines of the reasons; those of one rule share one, unless all are asked for."""
    groups: dict[object, list[Reason]] = {}
    for number, reason in enumerate(row.reasons):
        key = (reason.reaction, reason.diagnostic.code)
        groups.setdefault(number if most is None else key, []).append(reason)
    lines = []
    for first, *others in list(groups.values())[:most]:
        verdict, words = first.reaction
        about = first.diagnostic
        is_same = all(other.diagnostic.message == about.message for other in others)
        more = counted(len(others), "other place") if is_same else f"{len(others)} like it"
        place = _place(first, file) + (f" and {more}" if others else "")
        lines.append(f"{verdict.value:6} {place}: {about.message} [{about.code}] ({words})")
    if left := sum(map(len, list(groups.values())[len(lines) :])):
        lines.append(f"and {left} more (--all shows them)")
    elif len(lines) < len(row.reasons):
        lines.append("--all shows each place")
    return lines


def _said(row: Row, answer: Answer) -> Iterator[str]:
    """The verdict of the consumer itself, and what explains it where it is not the predicted one."""
    if answer.is_missing:
        yield f"run: not installed here: {answer.error}"
        return
    mark = "  (differs)" if differs(row, answer) else ""
    absent = unfound(row, answer)
    note = "" if absent is None else f", as {_lacked(absent)} is not found here ({absent.diagnostic.code})"
    version = f" {answer.version}" if answer.version else ""
    yield f"run: {answer.engine.value}{version}: {answer.outcome.value}{note}{mark}"
    if answer.error:
        yield f"     {answer.error}"
    if mark and not answer.error:
        yield f"     it takes the file although it was expected to refuse it ({row.reasons[0].diagnostic.code})"
    if mark and answer.error and not row.reasons:
        yield "     no rule finds a reason in the file"


def _lacked(reason: Reason) -> str:
    missing = reason.diagnostic.missing
    return "a file" if missing is None else f"{missing.kind.value} `{missing.name}`"


def _record_of(row: Row, answer: Answer) -> dict[str, object]:
    return {
        "run": {
            "engine": answer.engine.value,
            "version": answer.version or None,
            "verdict": answer.outcome.value,
            "differs": differs(row, answer),
            "error": answer.error or None,
            "messages": list(answer.messages),
        }
    }


def _place(reason: Reason, file: Path) -> str:
    """Line and column; after the name of the file if that is another one."""
    span = reason.diagnostic.span
    line, column = span.begin
    path = span.source.path
    return f"{line}:{column}" if path == file else f"{Paths()(path)}:{line}:{column}"


def record(row: Row) -> dict[str, object]:
    """What JSON holds: all reasons."""
    paths = Paths()
    return {
        "consumer": row.consumer.value,
        "verdict": row.verdict.value,
        "note": row.note or None,
        "reasons": [_reason(reason, paths) for reason in row.reasons],
    }


def _reason(reason: Reason, paths: Paths) -> dict[str, object]:
    diagnostic = reason.diagnostic
    line, column = diagnostic.span.begin
    return {
        "verdict": reason.reaction.verdict.value,
        "code": diagnostic.code,
        "name": diagnostic.name,
        "severity": diagnostic.severity.value,
        "message": diagnostic.message,
        "effect": reason.reaction.words,
        "file": paths(diagnostic.span.source.path),
        "line": line,
        "column": column,
    }
