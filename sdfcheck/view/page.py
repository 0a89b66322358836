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
:root { --faint: #5c636a; --accent: #1864ab; }
@media (prefers-color-scheme: dark) {
  :root { --error: #ff8787; --warning: #ffc078; --info: #74c0fc; --chosen: #5c4400; --ground: #1b1e23; }
  :root { --faint: #a6adb4; --accent: #74c0fc; }
}
* { box-sizing: border-box; }
[hidden] { display: none !important; }
body { margin: 0; height: 100vh; display: flex; flex-direction: column; font: 14px/1.45 system-ui, sans-serif; }
body { background: Canvas; color: CanvasText; }
header { display: flex; align-items: center; gap: 12px; padding: 5px 12px; border-bottom: 1px solid var(--line); }
h1 { flex: 1; font-size: 16px; margin: 0; overflow-wrap: anywhere; }
h2 { font-size: 14px; margin: 0 0 4px; overflow-wrap: anywhere; }
main { flex: 1; display: flex; min-height: 0; }
#picture { flex: 1; min-width: 0; display: flex; flex-direction: column; }
#stage { flex: 1; min-height: 0; position: relative; background: var(--ground); overflow: hidden; }
#stage canvas { display: block; width: 100%; height: 100%; touch-action: none; position: absolute; }
#stage img { display: none; }
#panel { width: 380px; overflow: auto; border-left: 1px solid var(--line); padding: 8px 12px; }
.folded #panel { display: none; }
#legend { position: absolute; left: 12px; bottom: 8px; margin: 0; pointer-events: none; }
#legend span { display: block; }
#tip { position: absolute; margin: 0; padding: 2px 7px; pointer-events: none; max-width: 90%; z-index: 2; }
#tip { background: Canvas; border: 1px solid var(--line); border-radius: 4px; }
#note { position: absolute; left: 12px; right: 12px; top: 8px; padding: 4px 8px; background: Canvas; }
#note { color: var(--warning); border: 1px solid var(--line); }
button { font: inherit; font-size: 13px; padding: 1px 6px; border: 1px solid var(--line); border-radius: 4px; }
button { background: transparent; color: inherit; cursor: pointer; }
button:hover { border-color: var(--accent); }
button:disabled { opacity: .35; cursor: default; }
button[aria-pressed="true"] { background: var(--chosen); border-color: var(--accent); }
:focus-visible { outline: 2px solid var(--accent); outline-offset: -1px; }
#tools { display: flex; flex-wrap: wrap; gap: 4px 12px; padding: 4px 12px; font-size: 13px; }
#tools { border-bottom: 1px solid var(--line); align-items: center; position: relative; }
.layers, .views, .modes, .buttons { display: flex; flex-wrap: wrap; gap: 4px; align-items: center; }
.layers { gap: 2px 8px; }
.layers label { white-space: nowrap; }
#tools input, fieldset input { margin: 0; vertical-align: -1px; accent-color: var(--accent); }
.help { margin: 0 0 0 auto; }
.help dl { position: absolute; right: 8px; top: 100%; z-index: 3; padding: 8px 12px; background: Canvas; }
.help dl { border: 1px solid var(--line); max-width: 90vw; }
#measured { font-variant-numeric: tabular-nums; }
.argument { display: grid; grid-template-columns: 9em 1fr; gap: 6px; margin: 2px 0; overflow-wrap: anywhere; }
.argument input, .argument select { min-width: 0; font: inherit; }
#legend .before::before, #legend .after::before { content: "■ "; }
#legend .before::before { color: var(--before); }
#legend .after::before { color: var(--after); }
#no-webgl { position: absolute; inset: 0; padding: 2em; }
fieldset { border: 1px solid var(--line); display: grid; grid-template-columns: 1fr 1fr; margin: 0 0 8px; }
details { margin: 8px 0; }
summary { font-weight: 600; cursor: pointer; overflow-wrap: anywhere; }
#search { width: 100%; font: inherit; padding: 3px 8px; border: 1px solid var(--line); border-radius: 4px; }
#search { background: Field; color: FieldText; }
#tree { max-height: 40vh; overflow: auto; margin: 6px 0; border: 1px solid var(--line); border-radius: 4px; }
.row { display: flex; gap: 4px; padding: 0 6px 0 2px; cursor: pointer; white-space: nowrap; }
.row { content-visibility: auto; contain-intrinsic-height: auto 20px; }
.row .fold { flex: 0 0 1em; text-align: center; color: var(--faint); }
.row .name { overflow: hidden; text-overflow: ellipsis; }
.row .kind { flex: 1; color: var(--faint); font-size: 12px; }
.row .eye { color: var(--faint); font-size: 10px; align-self: center; padding: 0 3px; }
.row.joint .name { color: var(--faint); font-style: italic; }
.row.model > .name { font-weight: 600; }
.row.hidden .name { text-decoration: line-through; }
.row:hover { background: var(--line); }
.row[aria-selected="true"] { background: var(--chosen); }
.row[role][aria-selected="true"] > span { color: CanvasText; }
#tree:focus-visible .at { outline: 2px solid var(--accent); outline-offset: -2px; }
#tree .none { padding: 2px 8px; color: var(--faint); }
#inspector { border: 1px solid var(--line); border-radius: 4px; padding: 6px 8px; margin: 8px 0; }
dl { display: grid; grid-template-columns: max-content 1fr; gap: 1px 10px; margin: 6px 0 0; font-size: 13px; }
dt { color: var(--faint); }
dd { margin: 0; overflow-wrap: anywhere; white-space: pre-wrap; font-variant-numeric: tabular-nums; }
.slider { display: grid; grid-template-columns: 7.5em 1fr 7.2em 1.9em; gap: 0 6px; align-items: center; margin: 2px 0; }
.slider .joint { border: 0; padding: 0; text-align: left; white-space: nowrap; }
.slider .joint { overflow: hidden; text-overflow: ellipsis; }
.slider input { min-width: 0; width: 100%; font: inherit; font-size: 13px; accent-color: var(--accent); }
.slider em { grid-column: 2 / 5; color: var(--faint); overflow-wrap: anywhere; }
.number { display: grid; grid-template-columns: 1fr 2em; gap: 3px; align-items: center; }
.slider > button:last-of-type { padding: 0; }
.ends { grid-column: 2; display: flex; justify-content: space-between; font-size: 11px; color: var(--faint); }
.said { min-height: 0; }
.group { margin: 2px 0 2px 8px; }
.group summary { font-weight: 500; }
.group .entry, .group p { margin-left: 14px; width: calc(100% - 14px); }
.rule { margin-left: 18px; font-size: 13px; color: var(--accent); }
.entry { all: unset; box-sizing: border-box; display: block; width: 100%; cursor: pointer; padding: 1px 4px; }
.entry { overflow-wrap: anywhere; }
.entry:focus-visible { outline: 2px solid var(--accent); }
.entry[aria-pressed="true"] { background: var(--chosen); outline: 2px solid var(--line); }
.error { color: var(--error); } .warning { color: var(--warning); } .info { color: var(--info); }
p { margin: 2px 0; overflow-wrap: anywhere; }
@media (max-width: 1100px) { #panel { width: 320px; } }
@media (max-width: 620px) { main { flex-direction: column; } #panel { width: auto; height: 45%; border-left: 0; } }
@media print {
  :root { color-scheme: light; --ground: white; }
  body { height: auto; display: block; }
  main { display: block; }
  #tools, #fold, #search, .buttons, .slider button, .eye, #tip { display: none !important; }
  #stage { height: auto; min-height: 0; overflow: visible; }
  #stage canvas { display: none; }
  #stage img { display: block; width: 100%; }
  #panel, .folded #panel { display: block; width: auto; overflow: visible; border: 0; }
  #tree { max-height: none; overflow: visible; }
}
""" + "".join(
    f'.row[data-level="{level}"] {{ padding-left: {2 + 12 * level}px; }}\n' for level in range(1, 17)
)
"""Deep chains of links are not indented any further than what fits."""

_BODY = """<header><h1>{title}</h1><button type="button" id="fold" aria-controls="panel">Panel</button></header>
<main>
<div id="picture">
<div id="tools" role="region" aria-label="Tools"></div>
<div id="stage">
<canvas aria-label="The robot, drawn; drag to turn, scroll to zoom" role="img"></canvas>
<p id="legend"></p>
<p id="tip" hidden></p>
<p id="note" aria-live="polite" hidden></p>
<p id="no-webgl" hidden>This browser cannot draw in three dimensions (WebGL is off). The lists are complete.</p>
</div>
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
