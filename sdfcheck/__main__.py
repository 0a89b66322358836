"""``python -m sdfcheck``."""

from __future__ import annotations

import os
from typing import NoReturn


def run() -> NoReturn:
    """Run the command line; an interrupt while its modules are loaded ends it as one later does."""
    try:
        from sdfcheck.cli.main import run as run_command

        run_command()
    except KeyboardInterrupt:
        os._exit(130)


if __name__ == "__main__":
    run()
