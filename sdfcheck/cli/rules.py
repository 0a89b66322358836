"""The commands ``rules`` and ``rule``."""

from __future__ import annotations

import os
import sys
from pathlib import Path
from textwrap import wrap

import click

from sdfcheck.cli.parts import options
from sdfcheck.cli.parts.command import Command
from sdfcheck.cli.parts.options import colored, configured, formatted, written
from sdfcheck.cli.parts.output import deliver, deliver_lines
from sdfcheck.cli.parts.terminal import emit_lines, lines_of, say, wants_color, wants_links, width_of
from sdfcheck.convert.loss import LossKind
from sdfcheck.lint.config.configuration import Configuration
from sdfcheck.lint.diagnostic import counted
from sdfcheck.lint.kinds import SimKind
from sdfcheck.lint.rulebook.packs import RuleIndex
from sdfcheck.lint.rulebook.rulebook import RuleBook
from sdfcheck.lint.run import RuleFacts
from sdfcheck.lint.select import covered
from sdfcheck.report.manual import Manuals, facts_record, markdown, record, render
from sdfcheck.source.errors import WrongUsage
from sdfcheck.source.visible import visible

# ``sdfcheck rules``.

VERSION = 1
"""Of the JSON that ``rules`` and ``rule`` write."""


@click.command(cls=Command)
@click.argument("selectors", nargs=-1, shell_complete=options.rules, metavar="[RULES]...")
@formatted("A table to read, or JSON.", "text", "json")
@written()
@configured
@colored("When to color the table.")
@click.option(
    "--test", "pack", metavar="PACK", help="Run the examples of a pack: a folder, entry point or import name."
)
def rules(
    selectors: tuple[str, ...],
    form: str,
    output_file: Path | None,
    configuration: Configuration,
    color: str,
    pack: str | None,
) -> int:
    """List the rules, or those that the codes, names or families RULES cover."""
    if pack is not None:
        if form == "json" or output_file is not None:
            raise WrongUsage("--test writes text to stdout only")
        return test(pack, selectors)
    index, known = loaded(configuration)
    chosen = narrowed(known, selectors)
    if form == "json":
        import json

        records = [dict(facts_record(facts)) for facts in chosen]
        deliver(json.dumps({"version": VERSION, "rules": records}, indent=2) + "\n", output_file)
    else:
        painted = output_file is None and wants_color(color, sys.stdout)
        width = width_of(sys.stdout) if output_file is None else None
        links = output_file is None and wants_links(color, sys.stdout)
        lines = listed(chosen, width=width, color=painted, links=links)
        deliver_lines(lines, output_file, color=painted)
    return 2 if index.faults else 0


def loaded(configuration: Configuration) -> tuple[RuleIndex, tuple[RuleFacts, ...]]:
    """The packs, and the facts of all rules, under the configuration of the current folder.

    Losses that conversions report, and findings of simulations, are listed with them."""
    settings = configuration.settings_in(Path.cwd())
    book = RuleBook()
    reported = tuple(kind.facts for kind in (*LossKind, *SimKind))
    index = book.index(settings)
    for fault in index.faults:
        say(f"error: {fault}")
    return index, (*book.rules(settings), *reported)


def test(pack: str, selectors: tuple[str, ...]) -> int:
    """Run the examples of a pack's rules and write a line for each that fails; the exit code.

    Raises:
        WrongUsage: the pack cannot be loaded, or a selector covers none of its rules.
    """
    from sdfcheck.lint.rulebook.pack import PackError
    from sdfcheck.lint.rulebook.trial import Bench

    try:
        bench = Bench(Path(pack) if os.path.isdir(pack) else pack)
    except PackError as error:
        raise WrongUsage(str(error)) from None
    codes = {facts.code for facts in narrowed(bench.facts, selectors)}
    trials = [trial for trial in bench.trials if trial.rule.code in codes]
    faults = () if selectors else bench.faults
    lines = [*map(str, faults), *filter(None, (trial.failure() for trial in trials))]
    counts = f"{counted(len(trials), 'example')} of {counted(len(codes), 'rule')}"
    if bench.tables:
        counts += f" and {counted(len(bench.tables), 'table')}"
    failed = len(lines) - len(faults)
    outcome = f"{counts}: {failed} failed" if failed else f"{counts}: all as expected"
    left_out = f"; {counted(len(faults), 'fault')} in the pack" if faults else ""
    emit_lines((*lines, f"{outcome}{left_out}"))
    return 1 if lines else 0


def narrowed(known: tuple[RuleFacts, ...], selectors: tuple[str, ...]) -> list[RuleFacts]:
    """The rules that the selectors cover (all without selectors), sorted by code; codes in any case.

    Raises:
        UnknownSelector: one covers none.
    """
    called = {facts.code.lower(): facts.code for facts in known}
    wanted = [called.get(selector.lower(), selector) for selector in selectors or ("ALL",)]
    codes = {code for selector in wanted for code in covered(selector, known)[1]}
    return sorted((facts for facts in known if facts.code in codes), key=lambda facts: facts.code)


def listed(rules: list[RuleFacts], *, width: int | None, color: bool, links: bool = False) -> list[str]:
    """One line a rule, in columns; on a terminal without room for the summaries they come below, folded."""
    from sdfcheck.report.colors import INK_OF
    from sdfcheck.report.table import Cell, Column, table

    columns = (
        Column("rule"),
        Column("name", gives_way=True),
        Column("severity"),
        Column("fix"),
        Column("summary"),
    )
    rows = [
        (
            Cell(facts.code, address=facts.page if links else None),
            Cell(facts.name),
            Cell(facts.severity.value, INK_OF[facts.severity]),
            Cell(_traits(facts)),
            Cell(markdown(facts.summary)),
        )
        for facts in rules
    ]
    needed = max(map(len, table(columns, rows, width=None, color=False)), default=0)
    if width is None or width >= needed:
        return table(columns, rows, width=width, color=color)
    heading, *lines = table(columns[:-1], [row[:-1] for row in rows], width=width, color=color)
    found = [heading]
    for line, row in zip(lines, rows, strict=True):
        indent = " " * (len(row[0].text) + 2)
        below = wrap(visible(row[-1].text), max(width, 40), initial_indent=indent, subsequent_indent=indent)
        found += [line, *below]
    return found


def _traits(facts: RuleFacts) -> str:
    fix = f"{facts.fixable} fix" if facts.fixable else ""
    return ", ".join(filter(None, (fix, "preview" if facts.preview else "" if facts.default else "off")))


# ``sdfcheck rule``.


@click.command(cls=Command)
@click.argument("selectors", nargs=-1, shell_complete=options.rules, required=True, metavar="RULE...")
@formatted("Pages to read, or JSON.", "text", "json")
@written()
@configured
@colored()
def rule(
    selectors: tuple[str, ...], form: str, output_file: Path | None, configuration: Configuration, color: str
) -> int:
    """Explain rules, given by code, name or family (ALL for all)."""
    index, known = loaded(configuration)
    manuals = Manuals(index)
    pages = [manuals.of(facts) for facts in narrowed(known, selectors)]
    if form == "json":
        import json

        explained = [dict(record(page)) for page in pages]
        deliver(json.dumps({"version": VERSION, "rules": explained}, indent=2) + "\n", output_file)
        return 2 if index.faults else 0
    text = "\n".join(render(page) for page in pages)
    painted = output_file is None and wants_color(color, sys.stdout)
    deliver_lines(lines_of(_painted(text) if painted else text), output_file, color=painted)
    return 2 if index.faults else 0


def _painted(markdown: str) -> str:
    """Markdown laid out for a terminal."""
    from io import StringIO

    from rich.console import Console
    from rich.markdown import Markdown

    console = Console(file=StringIO(), force_terminal=True, width=min(Console().width, 100))
    with console.capture() as capture:
        console.print(Markdown(markdown, code_theme="ansi_dark", hyperlinks=False))
    return capture.get()
