"""``sdfcheck targets``."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import click

from sdfcheck.cli.options import configured
from sdfcheck.cli.terminal import emit, say
from sdfcheck.lint.config import Configuration
from sdfcheck.lint.rule import Consumer
from sdfcheck.lint.session import Level, Notice, Options, run
from sdfcheck.lint.targets import Reason, Row, Verdict, matrix
from sdfcheck.source.sniff import sniff
from sdfcheck.source.wrong_usage import WrongUsage

VERSION = 1
"""Of the JSON."""


@click.command(name="targets")
@click.argument("file", type=click.Path(path_type=Path))
@click.option(
    "--target",
    multiple=True,
    type=click.Choice([reader.value for reader in Consumer]),
    help="Ask about this reader only (may be repeated), and exit with 1 if it rejects the file.",
)
@click.option(
    "--format", "form", type=click.Choice(["text", "json"]), default="text", help="How to show the verdicts."
)
@configured
def targets_command(
    file: Path, target: tuple[str, ...], form: str, config: Path | None, isolated: bool
) -> int:
    """Say which readers accept an SDFormat, URDF or xacro file, and why others do not.

    \b
    accept    it is read as it is written, as far as the rules know
    warn      it is read, but not all of it, or not as it was meant
    reject    it is not read to its end
    not read  the reader does not know the format
    """
    if not file.is_file():
        raise WrongUsage(f"no such file: {file}")
    readers = tuple(Consumer(name) for name in target) or tuple(Consumer)
    rows = verdicts(file, readers, Configuration(config, isolated=isolated))
    if form == "json":
        import json

        told = {"version": VERSION, "file": file.as_posix(), "readers": [record(row) for row in rows]}
        emit(json.dumps(told, indent=2, ensure_ascii=False) + "\n")
    else:
        emit(text(rows))
    return int(bool(target) and any(row.verdict in {Verdict.REJECT, Verdict.UNREAD} for row in rows))


def verdicts(file: Path, readers: Sequence[Consumer], configuration: Configuration) -> tuple[Row, ...]:
    """Lint a file with everything that the rules know about some readers.

    Raises:
        WrongUsage: it cannot be read, or is no robot description.
    """
    failures: list[str] = []

    def notify(notice: Notice) -> None:
        if notice.level is Level.FAILURE:
            failures.append(notice.text)

    asked = tuple(reader.value for reader in readers)
    done = run([file], Options(configuration, target=asked), notify=notify)
    if failures:
        raise WrongUsage("; ".join(failures))
    if done.suppressed:
        say(f"note: {done.suppressed} findings are suppressed and not counted")
    return matrix(done, sniff(file.read_bytes(), file), readers)


def text(rows: Sequence[Row]) -> str:
    """A line a reader, and below it the reasons."""
    width = max(len(row.reader.value) for row in rows)
    lines = []
    for row in rows:
        lines.append(f"{row.reader.value:{width}}  {row.verdict.value}")
        lines += [f"{'':{width}}    {line}" for line in _reasons(row)]
    return "\n".join(lines) + "\n"


_SHOWN = 5


def _reasons(row: Row) -> list[str]:
    told = []
    for reason in row.reasons[:_SHOWN]:
        diagnostic = reason.diagnostic
        effect = f" ({reason.effect})" if reason.effect else ""
        line = diagnostic.span.begin.line
        told.append(f"line {line}: {diagnostic.message} [{diagnostic.code}]{effect}")
    if len(row.reasons) > _SHOWN:
        told.append(f"and {len(row.reasons) - _SHOWN} more")
    return told


def record(row: Row) -> dict[str, object]:
    """What JSON holds: all reasons."""
    return {
        "reader": row.reader.value,
        "verdict": row.verdict.value,
        "reasons": [_reason(reason) for reason in row.reasons],
    }


def _reason(reason: Reason) -> dict[str, object]:
    diagnostic = reason.diagnostic
    line, column = diagnostic.span.begin
    return {
        "verdict": reason.verdict.value,
        "code": diagnostic.code,
        "name": diagnostic.name,
        "severity": diagnostic.severity.value,
        "message": diagnostic.message,
        "effect": reason.effect,
        "file": diagnostic.span.source.path.as_posix(),
        "line": line,
        "column": column,
    }
