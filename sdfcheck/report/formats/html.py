"""A page for people: one file that loads nothing, with search, filters and lines of code."""

from __future__ import annotations

from html import escape
from importlib.resources import files

from sdfcheck.lint.run import Run
from sdfcheck.report.colors import painter
from sdfcheck.report.content import WHOLE, Content
from sdfcheck.report.overview import overview
from sdfcheck.report.paths import Paths
from sdfcheck.report.summary import closing_line
from sdfcheck.view.sealed import Assets, sealed

_BODY = """<a class="skip" href="#main">Skip to the content</a>
<header><h1>Robot descriptions</h1><p id="closing">{closing}</p>
<nav id="views" aria-label="Views"></nav></header>
<main id="main" tabindex="-1">
<noscript><p>This browser runs no scripts. Search, filters and lines of code need them; this is the overview.</p>
<pre>{overview}</pre></noscript>
</main>
<footer id="footer"></footer>"""


def render(run: Run) -> str:
    body = _BODY.format(
        closing=escape(closing_line(run, WHOLE)),
        overview=escape("\n".join(overview(run, WHOLE, Paths(), painter(False))) if run.diagnostics else ""),
    )
    folder = files("sdfcheck.report").joinpath("data")
    style, script = (
        folder.joinpath(name).read_text(encoding="utf-8") for name in ("report.css", "report.js")
    )
    return sealed("sdfcheck report", body, Content(run).as_json(), Assets(style, script))
