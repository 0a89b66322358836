"""Processes that are killed at random moments: every file is as it was, or as it should become."""

from __future__ import annotations

import random
import shutil
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path

from tests.fuzz.documents import FIXTURES
from tests.fuzz.language_server import Ended, LanguageServer, converse

COPIES = 12
_FIX = ("lint", "--fix", "--unsafe-fixes", "--isolated", "--exit-zero", "--jobs", "1")
_CONVERT = ("convert", "urdf-to-sdf", "--isolated")

Files = dict[str, bytes]


class Torn(Exception):
    """A file that is neither as it was nor as it should become."""


def kill_fix(chance: random.Random, folder: Path) -> bool:
    """Kill ``lint --fix``. Returns whether it was at work: some files are fixed and some are not."""
    place = folder / "fix"
    _copies(FIXTURES / "robots" / "with_mistakes", place)
    before = _files(place)
    whole = _time(folder, "fix", lambda: _run(*_FIX, str(place)))
    after = _done(folder, "fix", place)
    _restore(place, before)
    _killed((*_FIX, str(place)), chance.uniform(0, 1.1 * whole))
    return _compare(_files(place), before, after)


def kill_convert(chance: random.Random, folder: Path) -> bool:
    """Kill ``convert --output-dir``. Returns whether it was at work."""
    source, place = folder / "source", folder / "results"
    _copies(FIXTURES / "robots" / "two_link_arm", source)
    place.mkdir(exist_ok=True)
    command = (*_CONVERT, str(source), "--output-dir", str(place))
    inputs = _files(source)
    whole = _time(folder, "convert", lambda: _run(*command))
    after = _done(folder, "convert", place)
    _restore(place, {})
    _killed(command, chance.uniform(0, 1.1 * whole))
    if _files(source) != inputs:
        raise Torn("an input of a conversion is changed")
    return _compare(_files(place), {}, after)


def kill_server(chance: random.Random, folder: Path) -> bool:
    """Kill the language server while it answers. Returns whether it was at work."""
    place = folder / "opened"
    _copies(FIXTURES / "robots" / "with_mistakes", place, 1)
    before = _files(place)
    file = next(path for path in sorted(place.rglob("*")) if path.suffix in {".sdf", ".urdf"})
    server = LanguageServer(place)
    end = time.monotonic() + chance.uniform(0, 0.5)
    text = file.read_bytes()
    was_at_work = False
    try:
        while time.monotonic() < end:
            server.notify("textDocument/didOpen", _opened(file, text))
            was_at_work = True
        server.process.kill()
        converse(server, file, text)
    except Ended:
        pass
    finally:
        server.close()
    if _files(place) != before:
        raise Torn("a file that the server reads is changed")
    return was_at_work


KILLS: tuple[Callable[[random.Random, Path], bool], ...] = (kill_fix, kill_convert, kill_server)


def run(count: int, seed: int) -> int:
    """Kill so many processes, of each kind in turn. Returns how many of them were at work; raises Torn."""
    chance = random.Random(seed)
    with tempfile.TemporaryDirectory(prefix="kills-") as folder:
        return sum(KILLS[number % len(KILLS)](chance, Path(folder)) for number in range(count))


def _opened(file: Path, text: bytes) -> dict[str, object]:
    words = text.decode("utf-8", "replace")
    return {"textDocument": {"uri": file.as_uri(), "languageId": "xml", "version": 1, "text": words}}


def _copies(origin: Path, place: Path, count: int = COPIES) -> None:
    """A folder with many robots, made anew."""
    shutil.rmtree(place, ignore_errors=True)
    for number in range(count):
        shutil.copytree(origin, place / f"robot{number:02}")


def _files(folder: Path) -> Files:
    return {
        path.relative_to(folder).as_posix(): path.read_bytes()
        for path in sorted(folder.rglob("*"))
        if path.is_file()
    }


def _restore(folder: Path, files: Files) -> None:
    shutil.rmtree(folder)
    folder.mkdir()
    for name, data in files.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(data)


def _run(*arguments: str) -> None:
    command = [sys.executable, "-m", "sdfcheck", *arguments]
    subprocess.run(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=False)


def _killed(arguments: tuple[str, ...], seconds: float) -> None:
    command = [sys.executable, "-m", "sdfcheck", *arguments]
    process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    try:
        process.wait(seconds)
    except subprocess.TimeoutExpired:
        process.kill()
        process.wait()


def _time(folder: Path, name: str, run_whole: Callable[[], None]) -> float:
    """How long an undisturbed run takes, in s; it is run once a folder."""
    note = folder / f"{name}.seconds"
    if not note.exists():
        begin = time.monotonic()
        run_whole()
        note.write_text(str(time.monotonic() - begin))
    return float(note.read_text())


def _done(folder: Path, name: str, place: Path) -> Files:
    """The files after an undisturbed run, kept beside; the first call finds them in place."""
    kept = folder / f"{name}.whole"
    if not kept.exists():
        shutil.copytree(place, kept)
    return _files(kept)


def _compare(found: Files, before: Files, after: Files) -> bool:
    """Whether some files are as before and some as after; a file that waits for its name may be left over."""
    states = set()
    for name, data in found.items():
        if Path(name).name.startswith(".sdfcheck-"):
            states |= {"before", "after"}
        elif data == after.get(name):
            states.add("after" if data != before.get(name) else "same")
        elif data == before.get(name):
            states.add("before")
        else:
            raise Torn(
                f"{name}: {len(data)} bytes, neither {len(before.get(name, b''))} nor {len(after.get(name, b''))}"
            )
    if after.keys() - found.keys():
        states.add("before")
    return {"before", "after"} <= states
