"""A hook of mkdocs: files of the root that are pages of the site, too, with their links as the site has them."""

from __future__ import annotations

import re
from pathlib import Path

_WHOLE_FILE = re.compile(r'--8<-- "([\w.]+)"\s*')


def on_page_markdown(markdown: str, **_: object) -> str:
    """The text of a page; where it is one line that names a file of the root, that file."""
    line = _WHOLE_FILE.fullmatch(markdown)
    return markdown if line is None else Path(line[1]).read_text("utf-8").replace("](docs/", "](")
