"""Reports: one module of ``formats`` for each, with a ``render`` that turns a run into text."""

from __future__ import annotations

from enum import Enum
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from sdfcheck.lint.run import Run
    from sdfcheck.report.content import Robot
    from sdfcheck.report.summary import View


class OutputFormat(Enum):
    """The formats of a report; the value is the name on the command line and the module's."""

    FULL = "full"
    CONCISE = "concise"
    JSON = "json"
    JSONL = "jsonl"
    SARIF = "sarif"
    GITHUB = "github"
    GITLAB = "gitlab"
    AZURE = "azure"
    JUNIT = "junit"
    CHECKSTYLE = "checkstyle"
    RDJSON = "rdjson"
    MARKDOWN = "markdown"
    HTML = "html"

    @property
    def is_text(self) -> bool:
        """Made for people: may have colors, ends with a closing line."""
        return self in {OutputFormat.FULL, OutputFormat.CONCISE}


def render(
    format: OutputFormat,
    run: Run,
    *,
    color: bool = False,
    view: View | None = None,
    robots: Sequence[Robot] = (),
) -> str:
    """The report of a run. Unless empty it ends with a line end.

    Only text formats know colors and views, and only HTML shows robots.
    """
    from importlib import import_module

    renderer: Callable[..., str] = import_module(f"sdfcheck.report.formats.{format.value}").render
    if format is OutputFormat.HTML:
        return renderer(run, robots)
    if not format.is_text:
        return renderer(run)
    return renderer(run, color=color) if view is None else renderer(run, color=color, view=view)
