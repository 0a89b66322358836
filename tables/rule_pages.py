"""Writes what the documentation takes from the code: ``python -m tables.rule_pages [--check]``.

That is a page for each rule, their overview, the table of families in the README, and
the schema of configuration files. Run it in the project's folder.
"""

from __future__ import annotations

import sys
from collections.abc import Iterator, Mapping, Sequence
from importlib import import_module
from itertools import groupby
from pathlib import Path

from sdfcheck.lint.config import schema as config_schema
from sdfcheck.lint.config.settings import FIELDS, Field
from sdfcheck.lint.engine import INTERNAL_ERROR
from sdfcheck.lint.rulebook.packs import load_index
from sdfcheck.lint.run import RuleFacts
from sdfcheck.lint.suppress.rules import FACTS
from sdfcheck.report.manual import Manuals, markdown, render

RULE_PAGES = Path("docs", "rules")
OVERVIEW = RULE_PAGES / "README.md"
README = Path("README.md")
SCHEMA = Path("docs", "sdfcheck.schema.json")
CONFIGURATION = Path("docs", "configuration.md")

_GENERATED = "<!-- Written by `python -m tables.rule_pages`; do not edit. -->\n\n"
_OWN_FAMILIES = {
    "INT": "the engine itself",
    "SUP": "comments that silence diagnostics",
}


def files() -> Mapping[Path, str]:
    """The generated files and what they hold."""
    index = load_index()
    rules = tuple(sorted((*index.facts, *FACTS, INTERNAL_ERROR)))
    manuals = Manuals(index)
    pages = {page_of(facts): _GENERATED + render(manuals.of(facts)) for facts in rules}
    readme = README.read_text(encoding="utf-8")
    return {
        **pages,
        OVERVIEW: _GENERATED + "\n\n".join(_overview(rules)) + "\n",
        README: with_table(readme, "rules", table(rules)),
        CONFIGURATION: with_table(CONFIGURATION.read_text(encoding="utf-8"), "keys", keys()),
        SCHEMA: config_schema.render(),
    }


def page_of(facts: RuleFacts) -> Path:
    return RULE_PAGES / f"{facts.name}.md"


def families(rules: Sequence[RuleFacts]) -> Iterator[tuple[str, str, list[RuleFacts]]]:
    """Each family: its name, what it is about, its rules."""
    for family, members in groupby(rules, key=lambda facts: facts.family):
        listed = list(members)
        yield family, _OWN_FAMILIES.get(family) or _about(listed[0]), listed


def _about(facts: RuleFacts) -> str:
    """The first sentence of the family's package, without its name."""
    about = (import_module(facts.module.rpartition(".")[0]).__doc__ or "").strip().partition("\n")[0]
    return markdown(about.removeprefix(f"{facts.family}: "))


def table(rules: Sequence[RuleFacts]) -> str:
    """The families, for the README."""
    rows = [
        f"| [`{family}`]({OVERVIEW.as_posix()}#{family.lower()}) | {about.rstrip('.')} | {len(members)} |"
        for family, about, members in families(rules)
    ]
    return "\n".join(["| family | about | rules |", "|---|---|---|", *rows]) + "\n"


def keys() -> str:
    """The keys of a configuration file."""
    rows = [f"| `{key.key}` | {key.shape} | {_default(key)} | {key.summary} |" for key in FIELDS]
    return "\n".join(["| key | value | default | meaning |", "|---|---|---|---|", *rows]) + "\n"


def _default(key: Field) -> str:
    return f"`{key.default}`" if key.default else ""


def with_table(page: str, name: str, rows: str) -> str:
    """A page with the table between the marks of that name; without them as it is."""
    mark, end_mark = f"<!-- {name} -->\n", f"<!-- /{name} -->"
    before, start, rest = page.partition(mark)
    _, end, after = rest.partition(end_mark)
    return f"{before}{start}{rows}{end}{after}" if start and end else page


def _overview(rules: Sequence[RuleFacts]) -> Iterator[str]:
    yield "# Rules"
    for family, about, members in families(rules):
        yield f"## {family}"
        yield f"{about[:1].upper()}{about[1:]}"
        yield "\n".join(
            ["| code | name | severity | fix | defect |", "|---|---|---|---|---|", *map(_row, members)]
        )


def _row(facts: RuleFacts) -> str:
    severity = facts.severity.value + _when(facts)
    summary = markdown(facts.summary).replace("|", "\\|")
    return f"| {facts.code} | [{facts.name}]({facts.name}.md) | {severity} | {facts.fixable} | {summary} |"


def _when(facts: RuleFacts) -> str:
    return ", preview" if facts.preview else "" if facts.default else ", off unless selected"


def superfluous(wanted: Mapping[Path, str]) -> list[Path]:
    """Pages of rules that are no more."""
    return sorted(path for path in RULE_PAGES.glob("*.md") if path not in wanted)


def main(arguments: Sequence[str]) -> int:
    wanted = files()
    left_over = superfluous(wanted)
    if "--check" not in arguments:
        RULE_PAGES.mkdir(parents=True, exist_ok=True)
        for path, text in wanted.items():
            path.write_text(text, encoding="utf-8")
        for path in left_over:
            path.unlink()
        return 0
    stale = [
        path
        for path, text in wanted.items()
        if not path.is_file() or path.read_text(encoding="utf-8") != text
    ]
    for path in sorted([*stale, *left_over]):
        sys.stdout.write(f"{path} is stale: run `make generate`\n")
    return int(bool(stale or left_over))


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
