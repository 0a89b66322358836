"""``--report``: the page that shows a robot before and after its conversion, with losses at their parts."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from sdfcheck.cli.parts.output import deliver
from sdfcheck.cli.parts.terminal import say

if TYPE_CHECKING:
    from sdfcheck.cli.convert.inputs import Input
    from sdfcheck.cli.convert.outcome import Outcome
    from sdfcheck.source.document import Document


def write_page(page: Path, given: Input, outcome: Outcome) -> None:
    """Write the page to a file: both robots, or the source alone where there is no result.

    Raises:
        WrongUsage: the file is the input, or cannot be written.
    """
    if given.document is None:
        say(f"note: {page} is not written: {given.file} cannot be expanded")
        return
    deliver(_page(given.document, outcome), page)


def _page(source: Document, outcome: Outcome) -> str:
    from sdfcheck.view.meshes import Meshes
    from sdfcheck.view.notes import differences, findings
    from sdfcheck.view.page import page
    from sdfcheck.view.scene import scene

    documents = [source]
    if outcome.conversion is not None:
        documents.append(outcome.conversion.document)
    meshes = Meshes()
    scenes = [scene(document, meshes) for document in documents]
    for shown, name in zip(scenes, ("before", "after"), strict=False):
        shown["file"] = f"{shown['file']} ({name})"
    return page(
        f"{source.path.name}: {outcome.verdict}",
        scenes,
        meshes.entries,
        findings=findings(outcome.diagnostics, source),
        heading="Losses and errors",
        differences=differences(*documents) if len(documents) > 1 else (),
    )
