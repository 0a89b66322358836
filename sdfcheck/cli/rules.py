"""``sdfcheck rules``."""

from __future__ import annotations

from pathlib import Path

import click

from sdfcheck.cli.parts import completing
from sdfcheck.cli.parts.command import Command
from sdfcheck.cli.parts.options import configured
from sdfcheck.cli.parts.terminal import emit, emit_lines, lines_of, say
from sdfcheck.convert.loss import LossKind
from sdfcheck.lint.config.configuration import Configuration
from sdfcheck.lint.rulebook.packs import RuleIndex
from sdfcheck.lint.rulebook.rulebook import RuleBook
from sdfcheck.lint.run import RuleFacts
from sdfcheck.lint.select import SILENT, covered
from sdfcheck.report.manual import facts_record, markdown
from sdfcheck.source.wrong_usage import WrongUsage

VERSION = 1
"""Of the JSON that ``rules`` and ``rule`` write."""


@click.command(cls=Command)
@click.argument("selectors", nargs=-1, shell_complete=completing.rules, metavar="[RULES]...")
@click.option("--output-format", type=click.Choice(["text", "json"]), default="text", help="How to list.")
@configured
@click.option(
    "--test", "pack", metavar="PACK", help="Run the examples of a pack: a folder, entry point or import name."
)
def rules(
    selectors: tuple[str, ...], output_format: str, configuration: Configuration, pack: str | None
) -> int:
    """List the rules, or those that the codes, names or families RULES cover."""
    if pack is not None:
        if output_format == "json":
            raise WrongUsage("--test writes text only")
        return test(pack, selectors)
    index, known = loaded(configuration)
    chosen = narrowed(known, selectors)
    if output_format == "json":
        import json

        listed = [dict(facts_record(facts)) for facts in chosen]
        emit(json.dumps({"version": VERSION, "rules": listed}, indent=2) + "\n")
    else:
        emit_lines(lines_of(table(chosen)))
    return 2 if index.faults else 0


def loaded(configuration: Configuration) -> tuple[RuleIndex, tuple[RuleFacts, ...]]:
    """The packs, and the facts of all rules, under the configuration of the current folder.

    What conversions report is listed with them."""
    settings = configuration.settings_in(Path.cwd())
    book = RuleBook(SILENT, None)
    losses = tuple(kind.facts for kind in LossKind)
    index = book.index(settings)
    for fault in index.faults:
        say(f"error: {fault}")
    return index, (*book.rules(settings), *losses)


def test(pack: str, selectors: tuple[str, ...]) -> int:
    """Run the examples of a pack's rules and write a line for each that fails; the exit code.

    Raises:
        WrongUsage: the pack cannot be loaded, or a selector covers none of its rules.
    """
    from sdfcheck.lint.rulebook.pack import PackError
    from sdfcheck.lint.rulebook.trial import Bench

    try:
        bench = Bench(Path(pack) if Path(pack).is_dir() else pack)
    except PackError as error:
        raise WrongUsage(str(error)) from None
    codes = {facts.code for facts in narrowed(bench.facts, selectors)}
    trials = [trial for trial in bench.trials if trial.rule.code in codes]
    faults = () if selectors else bench.faults
    lines = [*map(str, faults), *filter(None, (trial.failure() for trial in trials))]
    counts = f"{_counted(len(trials), 'example')} of {_counted(len(codes), 'rule')}"
    failed = len(lines) - len(faults)
    outcome = f"{counts}: {failed} failed" if failed else f"{counts}: all as expected"
    left_out = f"; {_counted(len(faults), 'fault')} in the pack" if faults else ""
    emit_lines((*lines, f"{outcome}{left_out}"))
    return 1 if lines else 0


def _counted(number: int, noun: str) -> str:
    return f"{number} {noun}{'' if number == 1 else 's'}"


def narrowed(known: tuple[RuleFacts, ...], selectors: tuple[str, ...]) -> list[RuleFacts]:
    """The rules that the selectors cover (all without selectors), sorted by code.

    Raises:
        UnknownSelector: one covers none.
    """
    codes = {code for selector in selectors or ("ALL",) for code in covered(selector, known)[1]}
    return sorted((facts for facts in known if facts.code in codes), key=lambda facts: facts.code)


def table(rules: list[RuleFacts]) -> str:
    """One line a rule, in columns."""
    name = max(len(facts.name) for facts in rules)
    trait = max(len(_traits(facts)) for facts in rules)
    return "".join(
        f"{facts.code:7} {facts.name:{name}}  {facts.severity.value:7}  "
        f"{_traits(facts):{trait}}  {markdown(facts.summary)}\n"
        for facts in rules
    )


def _traits(facts: RuleFacts) -> str:
    fix = f"{facts.fixable} fix" if facts.fixable else ""
    return ", ".join(filter(None, (fix, "" if facts.default else "off")))
