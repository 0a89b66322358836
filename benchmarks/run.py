"""Measures sdfcheck against the floor process: ``python -m benchmarks.run``.

Both run by turns on the same input (A B A B …); a ratio is the median of the ratios of
the pairs, so that it holds on a busy machine, too.
"""

from __future__ import annotations

import argparse
import ctypes.util
import json
import math
import statistics
import sys
import tempfile
from collections.abc import Iterator
from importlib.metadata import distribution
from pathlib import Path
from typing import NamedTuple

from benchmarks import conversions
from benchmarks.process import Measurement, installed, measure
from benchmarks.worlds import write_robots, write_world

HERE = Path(__file__).parent
SMALL = HERE.parent / "fixtures" / "robots" / "diff_drive" / "model.sdf"
ROVER = HERE.parent / "fixtures" / "robots" / "rover" / "rover.urdf.xacro"
REAL_FILES = HERE.parents[1] / "shared" / "corpus"
REAL_WORLD = REAL_FILES / "gz-sim" / "examples" / "worlds" / "3k_shapes.sdf"
LINT = [installed("sdfcheck"), "lint", "--isolated", "--jobs", "1", "--output-format", "concise"]
FLOOR = (sys.executable, str(HERE / "floor.py"))
PEER = [sys.executable, str(HERE / "libsdformat.py")]
GROWTH = (300, 3_000, 30_000)


class Input(NamedTuple):
    """An input: the paths given to sdfcheck, the files below them, the number of pairs, and the command beside it."""

    name: str
    given: tuple[Path, ...]
    files: tuple[Path, ...]
    pairs: int
    peer_runs: int
    against: tuple[str, ...] = FLOOR

    @property
    def size(self) -> int:
        return sum(file.stat().st_size for file in self.files)


class Result(NamedTuple):
    """Medians: seconds, bytes; ``ratio`` is sdfcheck to floor, ``peer_ratio`` libsdformat to floor."""

    name: str
    files: int
    size: int
    floor: float
    lint: float
    ratio: float
    peak: int
    peer: float | None
    peer_ratio: float | None


def library() -> tuple[str, str] | None:
    """The newest libsdformat that the loader finds: its version and file name."""
    for version in range(20, 8, -1):
        name = ctypes.util.find_library(f"sdformat{version}")
        if name:
            return str(version), name
    return None


def inputs(folder: Path, factor: float) -> Iterator[Input]:
    """The inputs, written below ``folder``; ``factor`` scales the number of pairs."""

    def pairs(number: int) -> int:
        return max(3, round(number * factor))

    yield Input("one small file", (SMALL,), (SMALL,), pairs(15), 5)
    large = folder / "large.urdf"
    large.write_text(conversions.urdf("large", 100_000))
    yield Input("a URDF file of 100 kB", (large,), (large,), pairs(11), 0)
    expand = (installed("xacro"),)
    yield Input("a xacro file, against `xacro`", (ROVER,), (ROVER,), pairs(11), 0, expand)
    if REAL_WORLD.is_file():
        yield Input("a real world of 3 000 models", (REAL_WORLD,), (REAL_WORLD,), pairs(7), 1)
        real = tuple(sorted(real_files()))
        yield Input(f"{len(real)} real files", real, real, pairs(5), 0)
    robots = folder / "robots"
    yield Input("a folder of 450 models", (robots,), tuple(write_robots(robots, 450)), pairs(5), 1)
    for models, number in zip(GROWTH, (9, 7, 3), strict=True):
        world = write_world(folder / f"solids_{models}.sdf", models)
        name = f"a generated world of {models:,} models".replace(",", " ")
        yield Input(name, (world,), (world,), pairs(number), 1 if models < 3_000 else 0)


def real_files() -> Iterator[Path]:
    """The SDFormat and URDF files of the collection, the one large world aside."""
    for suffix in (".sdf", ".world", ".urdf"):
        yield from (path for path in REAL_FILES.rglob(f"*{suffix}") if path.is_file() and path != REAL_WORLD)


def compare(subject: Input, folder: Path, peer: str | None) -> Result:
    """Measure one input by turns: floor, sdfcheck, and the peer where it is asked for."""
    files = [str(file) for file in subject.files]
    floors: list[Measurement] = []
    lints: list[Measurement] = []
    lint = [*LINT, *map(str, subject.given)]
    measure(lint, folder, accepted=(0, 1))
    for _ in range(subject.pairs):
        floors.append(measure([*subject.against, *files], folder))
        lints.append(measure(lint, folder, accepted=(0, 1)))
    floor = statistics.median(m.seconds for m in floors)
    seconds = None
    if peer and subject.peer_runs:
        peers = [measure([*PEER, peer, *files], folder).seconds for _ in range(subject.peer_runs)]
        seconds = statistics.median(peers)
    return Result(
        subject.name,
        len(files),
        subject.size,
        floor,
        statistics.median(m.seconds for m in lints),
        statistics.median(b.seconds / a.seconds for a, b in zip(floors, lints, strict=True)),
        max(m.peak for m in lints),
        seconds,
        None if seconds is None else seconds / floor,
    )


def growth(results: list[Result]) -> float:
    """The exponent of time over size from the middle to the largest world, starting time taken off."""
    start = next(result.lint for result in results if result.name.startswith("one"))
    _, middle, large = results[-3:]
    return math.log((large.lint - start) / (middle.lint - start)) / math.log(large.size / middle.size)


def table(results: list[Result], peer: str | None) -> Iterator[str]:
    """The results as a Markdown table."""
    names = ["input", "size", "floor", "sdfcheck", "a file", "sdfcheck / floor", "peak memory"]
    if peer:
        names += [f"libsdformat {peer}", f"libsdformat {peer} / floor"]
    yield f"| {' | '.join(names)} |"
    yield f"|---|{'--:|' * (len(names) - 1)}"
    for result in results:
        cells = [
            result.name,
            _bytes(result.size),
            _seconds(result.floor),
            _seconds(result.lint),
            f"{result.lint / result.files * 1000:.2f} ms" if result.files > 1 else "",
            f"{result.ratio:.2f}×",
            _bytes(result.peak),
            "" if result.peer is None else _seconds(result.peer),
            "" if result.peer_ratio is None else f"{result.peer_ratio:.1f}×",
        ]
        yield f"| {' | '.join(cells[: len(names)])} |"


def _seconds(seconds: float) -> str:
    return f"{seconds * 1000:.0f} ms" if seconds < 1 else f"{seconds:.1f} s"


def _bytes(number: int) -> str:
    return f"{number / 1e3:.1f} kB" if number < 1e6 else f"{number / 1e6:.1f} MB"


def is_editable() -> bool:
    """Is sdfcheck installed in editable mode? Then each start of Python pays for it, and ratios lie."""
    text = distribution("sdfcheck").read_text("direct_url.json")
    return bool(text) and bool(json.loads(text or "{}").get("dir_info", {}).get("editable"))


def main() -> None:
    parser = argparse.ArgumentParser(description="Measure sdfcheck against the floor process.")
    parser.add_argument("--json", action="store_true", help="print JSON instead of a table")
    parser.add_argument("--no-peer", action="store_true", help="leave libsdformat out")
    parser.add_argument("--factor", type=float, default=1, help="scale the number of runs")
    options = parser.parse_args()
    if is_editable():
        print("editable installation: the ratios will look better than they are", file=sys.stderr)
    version, name = (None, None) if options.no_peer else library() or (None, None)
    results = []
    with tempfile.TemporaryDirectory() as scratch:
        folder = Path(scratch)
        for subject in inputs(folder, options.factor):
            print(f"{subject.name} …", file=sys.stderr)
            results.append(compare(subject, folder, name))
        print("conversions …", file=sys.stderr)
        converted = list(conversions.timings(folder, options.factor))
    exponent = growth(results)
    if options.json:
        summary = {"results": [r._asdict() for r in results], "growth": exponent}
        summary["conversions"] = [one._asdict() for one in converted]
        print(json.dumps(summary, indent=1))
        return
    print("\n".join(table(results, version)))
    print("\n" + "\n".join(conversions.table(converted)))
    print(f"\nTime grows with size to the power of {exponent:.2f}.")


if __name__ == "__main__":
    main()
