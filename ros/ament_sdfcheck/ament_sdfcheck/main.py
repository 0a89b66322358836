"""The command ``ament_sdfcheck``: sdfcheck with the options that all linters of ament have."""

from __future__ import annotations

import argparse
import sys
from collections.abc import Sequence

from sdfcheck.cli.main import main as sdfcheck


def main(argv: Sequence[str] | None = None) -> int:
    """Lint; the exit code is 0 without findings that fail a run, 1 with some, 2 where it could not run.

    Everything else, files and folders (default: the current one) and options, is handed on to ``sdfcheck lint``.
    """
    parser = argparse.ArgumentParser(
        prog="ament_sdfcheck",
        usage="%(prog)s [PATHS…] [--exclude PATH…] [--config FILE] [--xunit-file FILE] [options of sdfcheck lint]",
        description=__doc__,
        allow_abbrev=False,
    )
    parser.add_argument(
        "--exclude", nargs="*", default=[], metavar="PATH", help="files and folders to leave out"
    )
    parser.add_argument(
        "--config", metavar="FILE", help="the configuration to use instead of those in folders"
    )
    parser.add_argument("--xunit-file", metavar="FILE", help="also write the results as an xUnit file")
    given, others = parser.parse_known_args(argv)
    arguments = ["lint", "--output-format", "full"]
    if given.xunit_file:
        arguments += ["--output-format", f"junit={given.xunit_file}"]
    if given.config:
        arguments += ["--config", given.config]
    for path in given.exclude:
        arguments += ["--exclude", path]
    return sdfcheck([*arguments, *others])


def run() -> None:
    """The program."""
    sys.exit(main())
