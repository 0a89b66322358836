"""The robots of a run, as the HTML report embeds them."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from pathlib import Path

from sdfcheck.lint.diagnostic import Diagnostic
from sdfcheck.lint.run import Run
from sdfcheck.source.document import Document
from sdfcheck.source.record import NamedTuple
from sdfcheck.view.meshes import Meshes
from sdfcheck.view.notes import findings
from sdfcheck.view.page import page
from sdfcheck.view.scene import scene
from sdfcheck.view.sealed import split

_BYTES = 10_000_000
"""Of the scenes in a report, meshes included; what does not fit is left out."""
_FINDINGS = 200
"""The findings listed beside a robot, at most."""
TITLE = "\ue000"
"""A substitute for the file's name in the page of a robot; names cannot hold it, as it cannot be shown."""


class Robot(NamedTuple):
    """A file whose robot can be shown: ``page`` is what `sdfcheck view` writes, with TITLE as its title."""

    path: Path
    page: str


def robots(run: Run, documents: Iterable[tuple[Path, Document]]) -> Iterator[Robot]:
    """The robots of descriptions that can be drawn, with the findings of a run."""
    left = _BYTES
    for path, document in documents:
        meshes = Meshes(all=left // 2)
        drawn = scene(document, meshes)
        if not any(model["links"] for model in drawn["models"]):
            continue
        found = findings(_gravest(run, path), document, run.pages)
        text = page(TITLE, [drawn], meshes.entries, findings=found)
        size = len(split(text)[1])
        if size <= left:
            left -= size
            yield Robot(path, text)


def _gravest(run: Run, path: Path) -> tuple[Diagnostic, ...]:
    """The findings about a file that are listed beside its robot; the report has all of them."""
    found = [each for each in run.diagnostics if _is_in(each, path)]
    return tuple(sorted(found, key=lambda each: -each.severity.rank)[:_FINDINGS])


def _is_in(found: Diagnostic, path: Path) -> bool:
    """Whether a finding is in a file, or in what that includes or calls."""
    return any(span.source.path == path for span in (found.span, *(origin.span for origin in found.origins)))
