"""The GitHub action: installs sdfcheck in an environment of its own and lints with it.

Its inputs come as variables (see ``action.yml``), so that no text of a workflow ends up in a
script. It runs before anything is installed, so it uses the standard library only. Python is
started with ``-I``: modules in the folder that is linted are not imported (docs/security.md).
"""

from __future__ import annotations

import os
import re
import shlex
import shutil
import subprocess
import sys
from collections.abc import Mapping, Sequence
from pathlib import Path

_VERSION = re.compile(r"[0-9]+(\.[0-9]+)*((a|b|rc|\.post|\.dev)[0-9]+)?")


def requirement(environment: Mapping[str, str], folder: Path) -> str:
    """The version to install: the release that was asked for, else the one of the action.

    Raises ValueError for a text that is not a version.
    """
    version = environment.get("SDFCHECK_VERSION", "").strip()
    if not version:
        return str(folder)
    if version == "latest":
        return "sdfcheck"
    if not _VERSION.fullmatch(version):
        raise ValueError(f"`{version}` is not a version of sdfcheck")
    return f"sdfcheck=={version}"


def options(environment: Mapping[str, str]) -> list[str]:
    """The arguments of ``sdfcheck``.

    Raises ValueError for a quotation mark that is not closed.
    """
    files = {
        "sarif": environment.get("SDFCHECK_SARIF", "").strip(),
        "markdown": summary(environment),
        "html": report(environment),
    }
    return [
        "lint",
        "--output-format",
        "github",
        *(word for form, file in files.items() if file for word in ("--output-format", f"{form}={file}")),
        *shlex.split(environment.get("SDFCHECK_ARGS", "")),
        "--",
        *(shlex.split(environment.get("SDFCHECK_PATHS", "")) or ["."]),
    ]


def summary(environment: Mapping[str, str]) -> Path | None:
    """Where to write the summary of the job, before it is added to those of other steps."""
    return _temporary(environment, "sdfcheck-summary.md") if environment.get("GITHUB_STEP_SUMMARY") else None


def report(environment: Mapping[str, str]) -> Path | None:
    """Where to write the page that becomes an artifact, if that has a name."""
    name = environment.get("SDFCHECK_REPORT", "").strip()
    return _temporary(environment, "sdfcheck-report.html") if name else None


def _temporary(environment: Mapping[str, str], name: str) -> Path:
    return Path(environment.get("RUNNER_TEMP") or ".") / name


def install(what: str, folder: Path) -> list[str]:
    """Install into a fresh folder; returns the command that starts sdfcheck from there.

    An environment of its own, or, where Python came without the means to make one (Debian's
    ``python3-venv``), a folder of packages.
    """
    pip = ["-I", "-m", "pip", "install", "--quiet", "--disable-pip-version-check"]
    shutil.rmtree(folder, ignore_errors=True)
    made = subprocess.run([sys.executable, "-I", "-m", "venv", folder], check=False, capture_output=True)
    if made.returncode == 0:
        python = str(folder / ("Scripts/python.exe" if os.name == "nt" else "bin/python"))
        subprocess.run([python, *pip, what], check=True)
        return [python, "-I", "-m", "sdfcheck"]
    shutil.rmtree(folder, ignore_errors=True)
    subprocess.run([sys.executable, *pip, "--target", str(folder), what], check=True)
    start = f"import sys; sys.path.insert(0, {str(folder)!r}); from sdfcheck.cli.main import run; run()"
    return [sys.executable, "-I", "-c", start]


def main(environment: Mapping[str, str]) -> int:
    try:
        arguments: Sequence[str] = options(environment)
        what = requirement(environment, Path(__file__).resolve().parent)
    except ValueError as error:
        sys.stdout.write(f"::error title=sdfcheck::{error}\n")
        return 2
    try:
        sdfcheck = install(what, _temporary(environment, "sdfcheck-venv"))
    except (OSError, subprocess.CalledProcessError) as error:
        sys.stdout.write(f"::error title=sdfcheck::cannot be installed: {error}\n")
        return 2
    written = [file for file in (summary(environment), report(environment)) if file is not None]
    for file in written:
        file.unlink(missing_ok=True)  # of an earlier step
    code = subprocess.run([*sdfcheck, *arguments], check=False).returncode
    _hand_over(environment, code)
    return code


def _hand_over(environment: Mapping[str, str], code: int) -> None:
    """What GitHub and later steps get."""
    summed_up, page = summary(environment), report(environment)
    if summed_up is not None and summed_up.exists():
        _append(environment["GITHUB_STEP_SUMMARY"], summed_up.read_text(encoding="utf-8"))
    if output := environment.get("GITHUB_OUTPUT"):
        _append(output, f"exit-code={code}\n")
        if page is not None and page.exists():
            _append(output, f"report={page}\n")


def _append(file: str, text: str) -> None:
    with Path(file).open("a", encoding="utf-8") as stream:
        stream.write(text)


if __name__ == "__main__":
    sys.exit(main(os.environ))
