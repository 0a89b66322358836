"""``sdfcheck view``."""

from __future__ import annotations

from pathlib import Path
from tempfile import mkdtemp
from typing import TYPE_CHECKING, Any

import click

from sdfcheck.cli.parts.command import Command
from sdfcheck.cli.parts.descriptions import Around, around, check_arguments, described, load
from sdfcheck.cli.parts.options import PATH, require_file, written
from sdfcheck.cli.parts.result import deliver
from sdfcheck.cli.parts.terminal import say

if TYPE_CHECKING:
    from sdfcheck.convert.change import Change
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
    text = _page(files, documents, surroundings)
    if output_file is None and not opened:
        deliver(text, None)
        return 0
    target = output_file or Path(mkdtemp(prefix="sdfcheck-")) / f"{file.stem}.html"
    deliver(text, target, files)
    say(f"wrote {target}")
    if opened:
        click.launch(str(target))
    return 0


def _page(files: list[Path], documents: list[Document], surroundings: Around) -> str:
    from sdfcheck.view.meshes import Meshes
    from sdfcheck.view.notes import findings
    from sdfcheck.view.page import page
    from sdfcheck.view.scene import MOST_SHAPES, scene

    meshes = Meshes()
    scenes = [scene(document, meshes) for document in documents]
    return page(
        " and ".join(file.name for file in files),
        scenes,
        meshes.entries,
        findings=findings(_linted(files[0], surroundings), documents[0]),
        differences=_differences(documents),
        most_shapes=MOST_SHAPES,
    )


def _linted(file: Path, surroundings: Around) -> Any:
    from sdfcheck.lint.session import Options, run

    options = Options(
        surroundings.configuration,
        arguments=surroundings.arguments,
        search=surroundings.search,
        variables=surroundings.variables,
    )
    return run([file], options)


def _differences(documents: list[Document]) -> list[dict[str, Any]]:
    if len(documents) == 1:
        return []
    from sdfcheck.convert.file_difference import compare_files
    from sdfcheck.robot.errors import DescriptionError

    try:
        found = compare_files(*documents)
    except DescriptionError as error:
        return [{"text": f"not compared: {error}", "part": None}]
    return [
        {"text": _text(change), "part": change.name} for _, changes in found.changes for change in changes
    ]


def _text(change: Change) -> str:
    what = f", {change.what}" if change.what else ""
    values = f": {change.before} → {change.after}" if change.before or change.after else ""
    return f"{change.kind.value} {change.part} {change.name}{what}{values}"
