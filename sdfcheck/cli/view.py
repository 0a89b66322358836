"""``sdfcheck view``."""

from __future__ import annotations

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

if TYPE_CHECKING:
    from sdfcheck.lint.run import Run
    from sdfcheck.source.document import Document


@click.command(cls=Command)
@click.argument("file", type=PATH)
@click.argument("other", type=PATH, required=False)
@written("Write the page there instead of to stdout.")
@click.option("--open", "opened", is_flag=True, help="Open the page in a browser.")
@described
def view(file: Path, other: Path | None, output_file: Path | None, opened: bool, **given: Any) -> int:
    """Write a page that shows a robot, or two robots over each other, in three dimensions.

    Links with shapes, frames, joint axes, inertias and fields of view; sliders move the joints;
    findings and differences select the parts that they are about.
    """
    arguments = tuple(given["arguments"])
    if other is not None and ":=" in str(other):
        given["arguments"], other = (str(other), *arguments), None
    surroundings = around(given)
    files = [file] if other is None else [file, other]
    for one in files:
        require_file(one)
    check_arguments(surroundings.arguments, files, surroundings.settings_for(file))
    documents = [load(one, surroundings, check=False) for one in files]
    warn_if_broken(*documents)
    text = _page(files, documents, surroundings)
    if output_file is None and not opened:
        deliver(text, None)
        return 0
    target = output_file or Path(mkdtemp(prefix="sdfcheck-")) / f"{file.stem}.html"
    deliver(text, target)
    say(f"wrote {target}")
    if opened:
        click.launch(str(target))
    return 0


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
