"""Pages that load nothing from anywhere: one file, and a policy that allows its own styles and scripts only."""

from __future__ import annotations

import base64
import json
import re
from collections.abc import Sequence
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
<script type="application/json" id="data">{data}</script>
<script>{script}</script>
</body>
</html>
"""
_UNPRINTABLE = re.compile(r"[^\x20-\x7e]")


class Assets(NamedTuple):
    """What a page looks like and does: CSS and JavaScript."""

    style: str
    script: str


def sealed(title: str, body: str, data: Any, assets: Assets, *, framed: Sequence[Assets] = ()) -> str:
    """The whole page: ``body`` is markup, ``data`` JSON for the script; ``framed``: the assets of pages in frames."""
    return _TEMPLATE.format(
        title=escape(title),
        policy=_policy([assets, *framed]),
        style=assets.style,
        body=body,
        data=as_data(data),
        script=assets.script,
    )


def as_data(value: Any) -> str:
    """JSON that cannot end the element that it is in; what cannot be printed is escaped."""
    text = json.dumps(value, ensure_ascii=False, allow_nan=False, separators=(",", ":")).replace(
        "<", "\\u003c"
    )
    return text if text.isprintable() else _UNPRINTABLE.sub(_escaped, text)


def _escaped(match: re.Match[str]) -> str:
    return match[0] if match[0].isprintable() else json.dumps(match[0])[1:-1]


def _policy(all_assets: Sequence[Assets]) -> str:
    scripts = " ".join(f"'{_digest(each.script)}'" for each in all_assets)
    styles = " ".join(f"'{_digest(each.style)}'" for each in all_assets)
    return (
        f"default-src 'none'; script-src {scripts}; style-src {styles}; "
        "img-src data: blob:; connect-src data: blob:; base-uri 'none'; form-action 'none'"
    )


def _digest(text: str) -> str:
    return f"sha256-{base64.b64encode(sha256(text.encode()).digest()).decode()}"
