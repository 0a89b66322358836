"""``sdfcheck rules``."""

from __future__ import annotations

from pathlib import Path

import click

from sdfcheck.cli.terminal import emit
from sdfcheck.convert.loss import LossKind
from sdfcheck.lint.config.configuration import Configuration
from sdfcheck.lint.manual import facts_record, markdown
from sdfcheck.lint.packs import RuleIndex
from sdfcheck.lint.rulebook import RuleBook
from sdfcheck.lint.run import RuleFacts
from sdfcheck.lint.select import SILENT, covered

VERSION = 1
"""Of the JSON that ``rules`` and ``rule`` write."""


@click.command()
@click.argument("selectors", nargs=-1, metavar="[RULES]...")
@click.option("--output-format", type=click.Choice(["text", "json"]), default="text", help="How to list.")
@click.option("--config", type=click.Path(path_type=Path), metavar="FILE", help="Take plugins from there.")
@click.option("--isolated", is_flag=True, help="Use no configuration file, so no plugins.")
def rules(selectors: tuple[str, ...], output_format: str, config: Path | None, isolated: bool) -> None:
    """List the rules, or those that the codes, names or families RULES cover."""
    _, known = loaded(config, isolated=isolated)
    chosen = narrowed(known, selectors)
    if output_format == "json":
        import json

        listed = [dict(facts_record(facts)) for facts in chosen]
        emit(json.dumps({"version": VERSION, "rules": listed}, indent=2) + "\n")
    else:
        emit(table(chosen))


def loaded(config: Path | None, *, isolated: bool) -> tuple[RuleIndex, tuple[RuleFacts, ...]]:
    """The packs, and the facts of all rules, under the configuration of the current folder.

    What conversions report is told with them."""
    settings = Configuration(config, isolated=isolated).settings_in(Path.cwd())
    book = RuleBook(SILENT, None)
    losses = tuple(kind.facts for kind in LossKind)
    return book.index(settings), (*book.rules(settings), *losses)


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
