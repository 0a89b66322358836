"""``python -m sdfcheck``."""

from __future__ import annotations

import gc
import os

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import NoReturn


def run() -> NoReturn:
    """Run the command line; an interrupt while its modules are loaded ends it as one later does."""
    # Modules stay, and trees are acyclic and short-lived: collecting them early costs and frees nothing.
    gc.set_threshold(500_000, 50, 100)
    try:
        from sdfcheck.cli.main import run as run_command

        run_command()
    except KeyboardInterrupt:
        os._exit(130)


if __name__ == "__main__":
    run()
