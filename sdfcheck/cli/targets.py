"""``sdfcheck targets``."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any

import click

from sdfcheck.cli.parts.command import Command
from sdfcheck.cli.parts.descriptions import Around, around, check_arguments, described
from sdfcheck.cli.parts.options import formatted, require_file, targeted, written
from sdfcheck.cli.parts.output import deliver, deliver_lines
from sdfcheck.cli.parts.terminal import say
from sdfcheck.consumers.reaction import Consumer, Verdict
from sdfcheck.files.regular import read_named
from sdfcheck.lint.session import Level, Notice, Options, run
from sdfcheck.lint.targets import Reason, Row, matrix
from sdfcheck.source.sniff import Kind, sniff
from sdfcheck.source.wrong_usage import WrongUsage

_JUDGED = frozenset((Kind.SDF, Kind.URDF, Kind.XACRO, Kind.BROKEN_XML))
VERSION = 1
"""Of the JSON."""


@click.command(cls=Command, name="targets")
@click.argument("file", type=click.Path(path_type=Path))
@targeted("Ask about these consumers only, and exit with 1 if one rejects the file")
@formatted("Lines to read, or JSON.", "text", "json")
@written()
@described
def targets_command(
    file: Path, target: tuple[str, ...] | None, form: str, output_file: Path | None, **given: Any
) -> int:
    """Say which consumers accept an SDFormat, URDF or xacro file, and why others do not.

    \b
    accept    it is read as it is written, as far as the rules know
    warn      it is read, but not all of it, or not as it was meant
    reject    it is not read to its end
    not read  the consumer does not know the format
    """
    require_file(file)
    consumers = tuple(map(Consumer, target or ())) or tuple(Consumer)
    rows = verdicts(file, consumers, around(given))
    if form == "json":
        import json

        record_of_all = {
            "version": VERSION,
            "file": file.as_posix(),
            "consumers": [record(row) for row in rows],
        }
        deliver(json.dumps(record_of_all, indent=2) + "\n", output_file)
    else:
        deliver_lines(lines(rows, file), output_file)
    return int(bool(target) and any(row.verdict in {Verdict.REJECT, Verdict.UNREAD} for row in rows))


def verdicts(file: Path, consumers: Sequence[Consumer], around: Around) -> tuple[Row, ...]:
    """Lint a file with everything that the rules know about some consumers.

    Raises: WrongUsage: it cannot be read, or is not a robot description.
    """
    failures: list[str] = []

    def notify(notice: Notice) -> None:
        if notice.level is Level.FAILURE:
            failures.append(notice.text)

    asked = tuple(consumer.value for consumer in consumers)
    check_arguments(around.arguments, [file], around.settings_for(file))
    done = run([file], Options(**around._asdict(), target=asked), notify=notify)
    if failures:
        raise WrongUsage("; ".join(failures))
    if done.suppressed:
        say(f"note: {done.suppressed} findings are suppressed and not counted")
    kind = sniff(read_named(file), file)
    if kind not in _JUDGED:
        raise WrongUsage(f"{file} looks like {kind.description}, no robot description")
    return matrix(done, kind, file, consumers)


def lines(rows: Sequence[Row], file: Path) -> Iterator[str]:
    """A line a consumer, and below it the reasons."""
    width = max(len(row.consumer.value) for row in rows)
    for row in rows:
        note = f": {row.note}" if row.note else ""
        yield f"{row.consumer.value:{width}}  {row.verdict.value}{note}"
        yield from (f"{'':{width}}    {line}" for line in _reasons(row, file))


_SHOWN = 5


def _reasons(row: Row, file: Path) -> list[str]:
    reasons = []
    for reason in row.reasons[:_SHOWN]:
        diagnostic = reason.diagnostic
        verdict, words = reason.reaction
        reasons.append(
            f"{verdict.value:6} {_place(reason, file)}: {diagnostic.message} [{diagnostic.code}] ({words})"
        )
    if len(row.reasons) > _SHOWN:
        reasons.append(f"and {len(row.reasons) - _SHOWN} more")
    return reasons


def _place(reason: Reason, file: Path) -> str:
    """Line and column; after the name of the file if that is another one."""
    span = reason.diagnostic.span
    line, column = span.begin
    path = span.source.path
    return f"{line}:{column}" if path == file else f"{path.as_posix()}:{line}:{column}"


def record(row: Row) -> dict[str, object]:
    """What JSON holds: all reasons."""
    return {
        "consumer": row.consumer.value,
        "verdict": row.verdict.value,
        "note": row.note or None,
        "reasons": [_reason(reason) for reason in row.reasons],
    }


def _reason(reason: Reason) -> dict[str, object]:
    diagnostic = reason.diagnostic
    line, column = diagnostic.span.begin
    return {
        "verdict": reason.reaction.verdict.value,
        "code": diagnostic.code,
        "name": diagnostic.name,
        "severity": diagnostic.severity.value,
        "message": diagnostic.message,
        "effect": reason.reaction.words,
        "file": diagnostic.span.source.path.as_posix(),
        "line": line,
        "column": column,
    }
