"""``sdfcheck init``."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from pathlib import Path

import click

from sdfcheck.cli.parts.command import Command
from sdfcheck.cli.parts.options import targeted
from sdfcheck.cli.parts.terminal import say
from sdfcheck.lint.config.settings import FIELDS
from sdfcheck.source.wrong_usage import WrongUsage

NAME = "sdfcheck.toml"
_NAMES = (NAME, f".{NAME}")
_SHOWN = ("select", "extend-select", "ignore", "fail-on", "exclude", "model-paths", "package-paths")
"""The keys that a configuration begins with, as comments."""


@click.command(cls=Command)
@click.argument("folder", type=click.Path(path_type=Path, file_okay=False, exists=True), default=".")
@targeted("The consumers that the files are meant for")
def init(folder: Path, target: tuple[str, ...] | None) -> None:
    """Write a commented sdfcheck.toml into FOLDER (default: the current one)."""
    for name in _NAMES:
        if (folder / name).exists():
            raise WrongUsage(f"{folder / name} exists already")
    file = folder / NAME
    try:
        with file.open("x", encoding="utf-8") as opened:
            opened.write("\n".join(_lines(target or ())) + "\n")
    except OSError as error:
        raise WrongUsage(f"cannot write {file}: {error.strerror}") from None
    say(f"wrote {file}; next: sdfcheck lint {folder}")


def _lines(target: Sequence[str]) -> Iterator[str]:
    fields = {field.key: field for field in FIELDS}
    yield "# The configuration of sdfcheck; `sdfcheck config` lists all keys."
    yield ""
    yield f"# {fields['target'].summary}"
    listed = ", ".join(f'"{name}"' for name in target)
    yield f"target = [{listed}]" if target else "# target = []"
    for key in _SHOWN:
        yield ""
        yield f"# {fields[key].summary}"
        yield f"# {key} = {fields[key].default or '[]'}"
    yield ""
    yield f"# {fields['per-file-ignores'].summary}"
    yield "# [per-file-ignores]"
    yield '# "worlds/legacy/*" = ["deprecated-element"]'
