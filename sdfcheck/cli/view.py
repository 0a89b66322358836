"""``sdfcheck view``."""

from __future__ import annotations

import os
import sys
from pathlib import Path
from tempfile import mkdtemp
from typing import TYPE_CHECKING, Any

import click

from sdfcheck.cli.parts.command import Command
from sdfcheck.cli.parts.descriptions import (
    SearchContext,
    around,
    check_arguments,
    described,
    load,
    warn_if_broken,
)
from sdfcheck.cli.parts.options import PATH, require_file, written
from sdfcheck.cli.parts.output import deliver
from sdfcheck.cli.parts.terminal import say
from sdfcheck.source.errors import WrongUsage

if TYPE_CHECKING:
    from sdfcheck.lint.run import Run
    from sdfcheck.source.document import Document


@click.command(cls=Command)
@click.argument("file", type=PATH)
@click.argument("other", type=PATH, required=False)
@written("Write the page there.")
@click.option("--open", "opened", is_flag=True, help="Open the page in a browser, also with -o.")
@described
def view(file: Path, other: Path | None, output_file: Path | None, opened: bool, **given: Any) -> int:
    """Show a robot, or two robots beside each other, in three dimensions in the browser.

    Without -o the page is a temporary file that is opened; where stdout is not a terminal, it goes there.
    """
    arguments = tuple(given["arguments"])
    if other is not None and ":=" in str(other):
        given["arguments"], other = (str(other), *arguments), None
    surroundings = around(given)
    files = [file] if other is None else [file, other]
    for one in files:
        require_file(one)
    is_piped = output_file is None and not opened and not sys.stdout.isatty()
    if output_file is None and not is_piped and not _has_display():
        raise WrongUsage(f"no display to open the page on; write it to a file: -o {file.stem}.html")
    check_arguments(surroundings.arguments, files, surroundings.settings_for(file))
    documents = [load(one, surroundings, check=False) for one in files]
    warn_if_broken(*documents)
    text = _page(files, documents, surroundings)
    if is_piped:
        deliver(text, None)
        return 0
    target = output_file or Path(mkdtemp(prefix="sdfcheck-")) / f"{file.stem}.html"
    deliver(text, target)
    say(f"wrote {target}")
    if (opened or output_file is None) and click.launch(str(target)):
        say("no browser could be started; open that file in one")
    return 0


def _has_display() -> bool:
    """Whether a browser can show something here."""
    if sys.platform in {"win32", "darwin"}:
        return True
    return any(os.environ.get(name) for name in ("DISPLAY", "WAYLAND_DISPLAY", "BROWSER", "WSL_DISTRO_NAME"))


def _page(files: list[Path], documents: list[Document], surroundings: SearchContext) -> str:
    from sdfcheck.view.meshes import Meshes
    from sdfcheck.view.notes import differences, findings
    from sdfcheck.view.page import page
    from sdfcheck.view.scene import scene

    meshes = Meshes()
    scenes = [scene(document, meshes) for document in documents]
    run = _linted(files[0], surroundings)
    return page(
        " and ".join(file.name for file in files),
        scenes,
        meshes.entries,
        findings=findings(run.diagnostics, documents[0], run.pages),
        differences=differences(*documents) if len(documents) > 1 else (),
    )


def _linted(file: Path, surroundings: SearchContext) -> Run:
    from sdfcheck.lint.session import Options, run

    return run([file], Options(**surroundings._asdict()))
