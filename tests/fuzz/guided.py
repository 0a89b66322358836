"""Fuzzing that is guided by coverage, with atheris: ``python -m tests.fuzz --coverage``.

The commands run in this process, which ends at the first finding; hypothesis makes documents of
what atheris tries.
"""

from __future__ import annotations

import sys
import tempfile
from pathlib import Path
from typing import Any

from hypothesis import HealthCheck, given, settings

from tests.fuzz.commands import attempt
from tests.fuzz.driver import Case, cases
from tests.fuzz.worker import SERVER

_SIZES = ("-max_len=20000", "-len_control=0")
"""A document takes more bytes than libFuzzer begins with."""


class Found(Exception):
    """A command has not kept a promise."""


@settings(database=None, deadline=None, suppress_health_check=list(HealthCheck))
@given(cases())
def attempt_all(case: Case) -> None:
    """Run the commands of a case; raises Found."""
    with tempfile.TemporaryDirectory(prefix="fuzz-") as folder:
        file = Path(folder, f"file{case.text.suffix}")
        for command in case.commands:
            file.write_bytes(case.text.data)
            failure = None if command == SERVER else attempt(command, file)
            if failure is not None:
                raise Found(f"{command}: {failure.mark}\n{case.text.data!r}\n{failure.story}")


def run(minutes: float, seed: int, folder: Path) -> int:
    """Run for so long; libFuzzer writes what has failed into the folder, and ends the process."""
    try:
        import atheris
    except ImportError:
        print("atheris is not installed: pip install atheris", file=sys.stderr)
        return 2
    folder.mkdir(parents=True, exist_ok=True)
    options = [
        f"-max_total_time={int(60 * minutes)}",
        f"-seed={seed}",
        f"-artifact_prefix={folder}/",
        *_SIZES,
    ]
    test: Any = attempt_all
    atheris.instrument_all()
    atheris.Setup([sys.argv[0], *options], test.hypothesis.fuzz_one_input)
    atheris.Fuzz()
    return 0
