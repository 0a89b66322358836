"""The picture of a terminal in the README: a real run of the linter, drawn by rich.

``make picture`` writes it again: ``python -m tables.picture``.
"""

from __future__ import annotations

import os
import re
import subprocess
import sys
from io import StringIO
from pathlib import Path

from rich.console import Console
from rich.text import Text

ROOT = Path(__file__).parents[1]
PICTURE = ROOT / "docs" / "terminal.svg"
FOLDER = ROOT / "fixtures" / "robots" / "with_mistakes"
COMMAND = ("lint", "gripper.urdf.xacro")
_WIDTH = 96
_REMOTE_FONT = re.compile(r"@font-face \{.*?\}\s*", re.DOTALL)


def report() -> str:
    """The output of the command on a terminal, with its colors."""
    known = {name: text for name, text in os.environ.items() if name not in {"NO_COLOR", "COLUMNS"}}
    run = subprocess.run(
        [sys.executable, "-m", "sdfcheck", *COMMAND, "--isolated", "--color", "always"],
        cwd=FOLDER,
        env={**known, "PYTHONPATH": str(ROOT)},
        capture_output=True,
        encoding="utf-8",
        check=False,
    )
    return f"\x1b[1m$ sdfcheck {' '.join(COMMAND)}\x1b[0m\n{run.stdout}"


def svg(text: str) -> str:
    """A terminal with a text in it; it loads nothing from elsewhere."""
    console = Console(
        file=StringIO(), record=True, width=_WIDTH, force_terminal=True, color_system="standard"
    )
    console.print(Text.from_ansi(text), soft_wrap=True)
    drawn = console.export_svg(title="sdfcheck", unique_id="sdfcheck")
    lines = (line.rstrip() for line in _REMOTE_FONT.sub("", drawn).splitlines())
    return "\n".join(lines) + "\n"


if __name__ == "__main__":
    PICTURE.write_text(svg(report()), encoding="utf-8")
