"""A page for people: one file that loads nothing, with search, filters and lines of code."""

from __future__ import annotations

from collections.abc import Sequence
from html import escape
from importlib.resources import files
from typing import TYPE_CHECKING

from sdfcheck.lint.run import Run
from sdfcheck.report.colors import painter
from sdfcheck.report.content import WHOLE, Content
from sdfcheck.report.digest import overview
from sdfcheck.report.paths import Paths
from sdfcheck.report.summary import closing_line
from sdfcheck.source.visible import visible
from sdfcheck.view.page import Assets, as_data, assets, sealed, split

if TYPE_CHECKING:
    from sdfcheck.report.content import Robot

MOST_ROBOTS = 20
"""Reports of more files show no robots."""
_BODY = """<a class="skip" href="#main">Skip to the content</a>
<header><h1>Robot descriptions</h1><p id="closing">{closing}</p>
<nav id="views" aria-label="Views"></nav></header>
<main id="main" tabindex="-1">
<noscript><p>This browser runs no scripts. Search, filters and lines of code need them; this is the overview.</p>
<pre>{overview}</pre></noscript>
</main>
<footer id="footer"></footer>"""


def render(run: Run, robots: Sequence[Robot] = ()) -> str:
    paths = Paths(files=run.files)  # the page may be passed on: it has no whole paths
    body = _BODY.format(
        closing=escape(closing_line(run, WHOLE)),
        overview=escape("\n".join(overview(run, WHOLE, paths, painter(False))) if run.diagnostics else ""),
    )
    folder = files("sdfcheck.report").joinpath("data")
    style, script = (
        folder.joinpath(name).read_text(encoding="utf-8") for name in ("report.css", "report.js")
    )
    drawn = [robot for robot in robots if robot.page]
    data = Content(run, paths).as_json() | {
        "robots": [visible(paths(robot.path)) for robot in drawn],
        "notDrawn": [
            {"file": visible(paths(robot.path)), "reason": visible(robot.reason)}
            for robot in robots
            if not robot.page
        ],
        "mostRobots": MOST_ROBOTS,
    }
    if not drawn:
        return sealed("sdfcheck report", body, data, Assets(style, script))

    before, _, after = split(drawn[0].page)
    more = {"viewer": as_data([before, after])}
    more |= {f"robot-{number}": split(robot.page)[1] for number, robot in enumerate(drawn)}
    return sealed("sdfcheck report", body, data, Assets(style, script), more=more, framed=[assets()])
