"""Pages that load nothing from anywhere: one file, and a policy that allows its own styles and scripts only."""

from __future__ import annotations

import base64
import json
import re
from collections.abc import Mapping, Sequence
from hashlib import sha256
from html import escape
from typing import Any

from sdfcheck.source.record import NamedTuple

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
