"""The commands that are run on a document, and what each of them promises."""

from __future__ import annotations

import io
import json
import os
import shlex
import traceback
from collections.abc import Callable
from contextlib import redirect_stderr, redirect_stdout
from pathlib import Path
from unittest.mock import patch

from sdfcheck.cli.main import main
from sdfcheck.source.record import NamedTuple
from tests.harm_of_fixes import harm, refusal

EXIT_CODES = {0, 1, 2}
BUGS = ("internal error", "this is a bug in", "CNV030")
"""The program's own words for its failures: also losses that nobody entered."""

_CONVERSIONS = (
    *(f"sdf-to-sdf --to {version}" for version in ("1.4", "1.5", "1.6", "1.7", "1.8", "1.9", "1.10", "1.12")),
    *("sdf-to-sdf --to 1.7 --no-lint", "sdf-to-urdf", "sdf-to-urdf --no-lint --frames --forest fixed"),
    *("sdf-to-urdf --keep-link-frames --loops cut --planes box --ball fixed", "urdf-to-sdf"),
    *("urdf-to-sdf --no-lint", "urdf-to-sdf --expand never", "urdf-to-sdf --like gazebo --no-lint"),
)
COMMANDS: tuple[str, ...] = (
    *("lint", "lint --select ALL --output-format json", "lint --statistics", "lint --no-expand"),
    *(f"lint --exit-zero --output-format {name}" for name in ("sarif", "junit", "concise", "github", "rdjson")),
    *("lint --target drake", "lint --kind sdf", "lint --kind urdf", "lint --kind xacro"),
    *("lint --diff --unsafe-fixes", "lint --fix", "lint --fix --unsafe-fixes", "lint --add-ignore --reason fuzz"),
    *("targets", "targets --format json", "expand", "expand --annotate", "view"),
    *(f"convert {conversion}" for conversion in _CONVERSIONS),
    *("print", "print --degrees", "print --expand-includes", "print --expand-auto-inertials --precision 6"),
    *("diff", "diff --format json", "inertia", "inertia --format json", "describe"),
    *(f"graph {kind}" for kind in ("frames", "poses", "joints", "frames --format dot", "joints --format mermaid")),
)  # fmt: skip
"""Command lines, without their files."""


class Failure(NamedTuple):
    """A promise that a command has not kept; failures with the same ``mark`` are probably the same."""

    mark: str
    story: str


class Done(NamedTuple):
    """How a command ended."""

    code: int | None
    out: str
    err: str


def run(command: list[str]) -> Done | Failure:
    """Run a command in this process."""
    out, err = io.TextIOWrapper(io.BytesIO(), "utf-8"), io.TextIOWrapper(io.BytesIO(), "utf-8")
    with redirect_stdout(out), redirect_stderr(err), patch.dict(os.environ, SDFCHECK_DEBUG="1"):
        try:
            code = main(command)
        except Exception as error:
            return Failure(_mark(error), traceback.format_exc())
        out.flush()
        err.flush()
    texts = [stream.buffer.getvalue().decode() for stream in (out, err)]
    return Done(code, *texts)


def _mark(error: BaseException) -> str:
    """The kind of an error, and the last line of the program on the way to it."""
    while error.__cause__ is not None:
        error = error.__cause__
    frames = traceback.extract_tb(error.__traceback__)
    own = [frame for frame in frames if f"{os.sep}tests{os.sep}" not in frame.filename]
    last = next((frame for frame in reversed(own) if "site-packages" not in frame.filename), None)
    place = f"{Path(last.filename).name}:{last.name}" if last else ""
    return f"{type(error).__name__} in {place}"


def attempt(command: str, file: Path) -> Failure | None:
    """Run a command on a file, and look whether it has kept its promises."""
    name, *options = shlex.split(command)
    before = file.read_bytes()
    if name == "describe":
        done = run([name, "--", _element_in(before)])
    else:
        last = [str(file)] * (2 if name == "diff" else 1)
        done = run([name, *options, "--isolated", *last])
    if isinstance(done, Failure):
        return done
    failure = _general(done)
    for check in _CHECKS.get(name, ()):
        failure = failure or check(options, file, before, done)
    if failure is None and name != "lint" and file.read_bytes() != before:
        failure = Failure("the input is changed", "")
    return failure


def _element_in(data: bytes) -> str:
    """Something to describe: what comes after the last `<`, as a path."""
    text = data[-80:].decode("utf-8", "replace").rpartition("<")[2]
    return text.replace(" ", "/@").replace(">", "/")


def _general(done: Done) -> Failure | None:
    if done.code not in EXIT_CODES:
        return Failure(f"exit code {done.code}", done.err)
    if done.code == 2 and not done.err.strip():
        return Failure("exit code 2 without a word", done.out)
    for words in BUGS:
        if words in done.err:
            return Failure(words, done.err + done.out)
    return None


def _is_json(options: list[str], file: Path, before: bytes, done: Done) -> Failure | None:
    if not {"json", "sarif", "rdjson"} & set(options) or not done.out:
        return None
    try:
        json.loads(done.out, parse_constant=_refuse)
    except ValueError as error:
        return Failure("not JSON", f"{error}\n{done.out}")
    return None


def _refuse(name: str) -> object:
    raise ValueError(f"{name} is not JSON")


def _is_stable(options: list[str], file: Path, before: bytes, done: Done) -> Failure | None:
    """A fix does no harm, after it a second one changes nothing, and nothing else is left in the folder."""
    after = file.read_bytes()
    if "--fix" not in options and "--add-ignore" not in options:
        return None if after == before else Failure("lint changes the file", "")
    if len(os.listdir(file.parent)) > 1:
        return Failure("files are left behind", str(os.listdir(file.parent)))
    if "--add-ignore" in options or after == before:
        return None
    if words := harm(before, after, file):
        return Failure("a fix does harm", f"{words}\n{after!r}")
    if file.suffix != ".xacro" and (words := refusal(before, after, file.parent, file.suffix)):
        return Failure("libsdformat refuses the fix", f"{words}\n{after!r}")
    again = run(["lint", *options, "--isolated", str(file)])
    if isinstance(again, Failure):
        return again
    last = file.read_bytes()
    return None if last == after else Failure("the fix is not stable", f"{after!r}\n\n{last!r}")


def _is_same(options: list[str], file: Path, before: bytes, done: Done) -> Failure | None:
    return Failure("a robot differs from itself", done.out) if done.code == 1 else None


def _prints_again(options: list[str], file: Path, before: bytes, done: Done) -> Failure | None:
    """The canonical form of a canonical form is the same."""
    if done.code != 0 or options:
        return None
    second = file.with_name(f"printed{'.urdf' if file.suffix == '.xacro' else file.suffix}")
    second.write_bytes(done.out.encode())
    again = run(["print", "--isolated", str(second)])
    second.unlink()
    if isinstance(again, Failure):
        return again
    same = again.code == 0 and again.out == done.out
    return None if same else Failure("print is not stable", f"{done.out}\n\n{again.out}{again.err}")


def _is_converted(options: list[str], file: Path, before: bytes, done: Done) -> Failure | None:
    """A success has a result; and if there is one, it is the same robot."""
    if done.code == 0 and not done.out:
        return Failure("a success without a result", done.err)
    differing = [line for line in done.err.splitlines() if "error:" in line and "[CNV002]" in line]
    if any("cannot be compared" not in line for line in differing):
        return Failure("another robot", done.err)
    return None


_Check = Callable[[list[str], Path, bytes, Done], Failure | None]
_CHECKS: dict[str, tuple[_Check, ...]] = {
    "lint": (_is_json, _is_stable),
    "targets": (_is_json,),
    "inertia": (_is_json,),
    "diff": (_is_json, _is_same),
    "print": (_prints_again,),
    "convert": (_is_converted,),
}
