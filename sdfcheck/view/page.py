"""The page that shows scenes: one file that loads nothing from anywhere."""

from __future__ import annotations

import base64
import json
import re
from collections.abc import Mapping, Sequence
from hashlib import sha256
from html import escape
from importlib.resources import files
from typing import Any

from sdfcheck.source.record import NamedTuple
from sdfcheck.view.scene import MOST_SHAPES

# Pages that load nothing from anywhere: one file, and a policy that allows its own styles and scripts only.

_TEMPLATE = """<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="{policy}">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>{title}</title>
<style>{style}</style>
</head>
<body>
{body}
{more}<script type="application/json" id="data">{data}</script>
<script>{script}</script>
</body>
</html>
"""
_UNPRINTABLE = re.compile(r"[^\x20-\x7e]")


class Assets(NamedTuple):
    """The style and the scripts of a page: CSS and JavaScript.

    ``connects``: the script may talk to the server that the page is from, and to no other.
    """

    style: str
    script: str
    connects: bool = False


def sealed(
    title: str,
    body: str,
    data: Any,
    assets: Assets,
    *,
    more: Mapping[str, str] | None = None,
    framed: Sequence[Assets] = (),
) -> str:
    """The whole page: ``body`` is markup, ``data`` is JSON for the script.

    ``more`` are texts of :func:`as_data` that the script asks for by their id; ``framed``: the assets of pages
    that it shows in frames, which inherit its policy.
    """
    return _TEMPLATE.format(
        title=escape(title),
        policy=policy([assets, *framed]),
        style=assets.style,
        body=body,
        more="".join(f"{_opening(name)}{text}</script>\n" for name, text in (more or {}).items()),
        data=as_data(data),
        script=assets.script,
    )


def split(page: str) -> tuple[str, str, str]:
    """A sealed page: what is before its data, the data, and the rest."""
    before, opening, after = page.rpartition(_opening("data"))
    data, closing, rest = after.partition("</script>")
    return before + opening, data, closing + rest


def _opening(name: str) -> str:
    return f'<script type="application/json" id="{name}">'


def as_data(value: Any) -> str:
    """JSON that cannot end the element that it is in; what cannot be printed is escaped."""
    text = json.dumps(value, ensure_ascii=False, allow_nan=False, separators=(",", ":")).replace(
        "<", "\\u003c"
    )
    return text if text.isprintable() else _UNPRINTABLE.sub(_escaped, text)


def _escaped(match: re.Match[str]) -> str:
    return match[0] if match[0].isprintable() else json.dumps(match[0])[1:-1]


def policy(all_assets: Sequence[Assets]) -> str:
    """The policy of a page with these assets, as browsers read it."""
    scripts = " ".join(f"'{_digest(each.script)}'" for each in all_assets)
    styles = " ".join(f"'{_digest(each.style)}'" for each in all_assets)
    own = "'self' " if any(each.connects for each in all_assets) else ""
    return (
        f"default-src 'none'; script-src {scripts}; style-src {styles}; "
        f"img-src data: blob:; connect-src {own}data: blob:; base-uri 'none'; form-action 'none'"
    )


def _digest(text: str) -> str:
    return f"sha256-{base64.b64encode(sha256(text.encode()).digest()).decode()}"


_STYLE = """
:root { color-scheme: light dark; --line: #8886; --error: #c92a2a; --warning: #8f5200; --info: #1864ab; }
:root { --before: #d9480f; --after: #1864ab; --chosen: #fff3bf; --ground: #f4f5f7; }
@media (prefers-color-scheme: dark) {
  :root { --error: #ff8787; --warning: #ffc078; --info: #74c0fc; --chosen: #5c4400; --ground: #1b1e23; }
}
* { box-sizing: border-box; }
body { margin: 0; height: 100vh; display: flex; flex-direction: column; font: 14px/1.45 system-ui, sans-serif; }
body { background: Canvas; color: CanvasText; }
header { padding: 6px 12px; border-bottom: 1px solid var(--line); }
h1 { font-size: 16px; margin: 0; overflow-wrap: anywhere; }
main { flex: 1; display: flex; min-height: 0; }
#stage { flex: 1; min-width: 0; position: relative; background: var(--ground); }
canvas { display: block; width: 100%; height: 100%; touch-action: none; position: absolute; }
#panel { width: 360px; overflow: auto; border-left: 1px solid var(--line); padding: 8px 12px; }
#legend { position: absolute; left: 12px; bottom: 8px; margin: 0; pointer-events: none; }
#legend span { display: block; }
#note { position: absolute; left: 12px; right: 12px; top: 8px; padding: 4px 8px; background: Canvas; }
#note { color: var(--warning); border: 1px solid var(--line); }
.argument { display: grid; grid-template-columns: 9em 1fr; gap: 6px; margin: 2px 0; overflow-wrap: anywhere; }
.argument input, .argument select { min-width: 0; font: inherit; }
#legend .before::before, #legend .after::before { content: "■ "; }
#legend .before::before { color: var(--before); }
#legend .after::before { color: var(--after); }
#no-webgl { position: absolute; inset: 0; padding: 2em; }
fieldset { border: 1px solid var(--line); display: grid; grid-template-columns: 1fr 1fr; margin: 0 0 8px; }
.views { display: flex; gap: 6px; }
details { margin: 8px 0; }
summary { font-weight: 600; cursor: pointer; overflow-wrap: anywhere; }
ul { list-style: none; margin: 0; padding: 0; }
.slider { display: grid; grid-template-columns: 9em 1fr 5em; gap: 6px; align-items: center; overflow-wrap: anywhere; }
.slider input { min-width: 0; }
.entry { all: unset; display: block; width: 100%; cursor: pointer; padding: 1px 4px; overflow-wrap: anywhere; }
.entry:focus-visible { outline: 2px solid Highlight; }
.entry[aria-pressed="true"] { background: var(--chosen); outline: 2px solid var(--line); }
.error { color: var(--error); } .warning { color: var(--warning); } .info { color: var(--info); }
p { margin: 2px 0; overflow-wrap: anywhere; }
@media (max-width: 700px) { main { flex-direction: column; } #panel { width: auto; height: 45%; } }
@media print { body { height: auto; } #stage { height: 60vh; } #panel { width: auto; overflow: visible; } }
""" + "".join(f'[data-depth="{depth}"] {{ padding-left: {14 * depth}px; }}\n' for depth in range(1, 13))
"""Deep chains of links are not indented any further than what fits."""

_BODY = """<header><h1>{title}</h1></header>
<main>
<div id="stage">
<canvas aria-label="The robot, drawn; drag to turn, scroll to zoom" role="img"></canvas>
<p id="legend"></p>
<p id="note" aria-live="polite" hidden></p>
<p id="no-webgl" hidden>This browser cannot draw in three dimensions (WebGL is off). The lists are complete.</p>
</div>
<section id="panel" aria-label="Parts, joints and findings" tabindex="0"></section>
</main>"""


def page(
    title: str,
    scenes: Sequence[Mapping[str, Any]],
    meshes: Sequence[Mapping[str, Any]],
    *,
    findings: Sequence[Mapping[str, Any]] = (),
    heading: str = "Findings",
    differences: Sequence[Mapping[str, Any]] = (),
) -> str:
    """The whole page; every name in it is text, never markup.

    ``heading`` says what the findings are.
    """
    data = {
        "scenes": scenes,
        "meshes": meshes,
        "findings": findings,
        "heading": heading,
        "differences": differences,
        "mostShapes": MOST_SHAPES,
    }
    return sealed(title, _BODY.format(title=escape(title)), data, assets())


def live_policy(how: str) -> str:
    """The policy of :func:`live_page`, for the server that sends it."""
    return policy([_live_assets(how)])


def live_page(title: str, how: str) -> str:
    """A page whose robot follows its text.

    ``how`` it gets the robot: ``"http"``, as events of the server that it is from, or ``"editor"``, as messages
    of the editor that shows it.
    """
    data = {
        "live": how,
        "scenes": [],
        "meshes": [],
        "findings": [],
        "differences": [],
        "mostShapes": MOST_SHAPES,
    }
    body = _BODY.format(title=escape(title))
    return sealed(title, body, data, _live_assets(how))


def _live_assets(how: str) -> Assets:
    return assets()._replace(connects=how == "http")


def assets() -> Assets:
    """The style and the script of the page."""
    script = files("sdfcheck.view").joinpath("data").joinpath("viewer.js").read_text(encoding="utf-8")
    return Assets(_STYLE, script)
