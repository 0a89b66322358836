"""``python -m sdfcheck``."""

from __future__ import annotations

from sdfcheck.cli.main import run

run()
