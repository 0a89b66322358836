"""The GitHub action: installs sdfcheck in an environment of its own and lints with it.

Its inputs come as variables (see ``action.yml``), so that no text of a workflow ends up in a
script. It runs before anything is installed, so it uses the standard library only. Python is
started with ``-I``: modules in the folder that is linted are not imported (docs/security.md).
"""

from __future__ import annotations

import os
import re
import shlex
import subprocess
import sys
import venv
from collections.abc import Mapping, Sequence
from pathlib import Path

_VERSION = re.compile(r"[0-9]+(\.[0-9]+)*((a|b|rc|\.post|\.dev)[0-9]+)?")


def requirement(environment: Mapping[str, str], folder: Path) -> str:
    """What to install: the release that was asked for, else what came with the action.

    Raises ValueError for what is no version.
    """
    version = environment.get("SDFCHECK_VERSION", "").strip()
    if not version:
        return str(folder)
    if version == "latest":
        return "sdfcheck"
    if not _VERSION.fullmatch(version):
        raise ValueError(f"`{version}` is no version of sdfcheck")
    return f"sdfcheck=={version}"


def options(environment: Mapping[str, str]) -> list[str]:
    """The arguments of ``sdfcheck``.

    Raises ValueError for a quotation mark that is not closed.
    """
    sarif = environment.get("SDFCHECK_SARIF", "").strip()
    return [
        "lint",
        "--output-format",
        "github",
        *(["--output-format", f"sarif={sarif}"] if sarif else []),
        *shlex.split(environment.get("SDFCHECK_ARGS", "")),
        "--",
        *(shlex.split(environment.get("SDFCHECK_PATHS", "")) or ["."]),
    ]


def install(what: str, folder: Path) -> Path:
    """Install into a fresh environment; returns its Python."""
    venv.create(folder, with_pip=True, clear=True)
    python = folder / ("Scripts/python.exe" if os.name == "nt" else "bin/python")
    command = [str(python), "-I", "-m", "pip", "install", "--quiet", "--disable-pip-version-check", what]
    subprocess.run(command, check=True)
    return python


def main(environment: Mapping[str, str]) -> int:
    try:
        arguments: Sequence[str] = options(environment)
        what = requirement(environment, Path(__file__).resolve().parent)
    except ValueError as error:
        sys.stdout.write(f"::error title=sdfcheck::{error}\n")
        return 2
    place = Path(environment.get("RUNNER_TEMP") or ".") / "sdfcheck-venv"
    try:
        python = install(what, place)
    except (OSError, subprocess.CalledProcessError) as error:
        sys.stdout.write(f"::error title=sdfcheck::cannot be installed: {error}\n")
        return 2
    code = subprocess.run([python, "-I", "-m", "sdfcheck", *arguments], check=False).returncode
    if output := environment.get("GITHUB_OUTPUT"):
        with Path(output).open("a", encoding="utf-8") as stream:
            stream.write(f"exit-code={code}\n")
    return code


if __name__ == "__main__":
    sys.exit(main(os.environ))
