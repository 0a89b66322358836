"""Runs every command on texts that nobody would write: ``python -m tests.fuzz --minutes 10 --seed 1``.

A traceback, an exit code that is not documented, more than 10 s or 1 GB, a fix that is not
stable: each is a finding, is made small and kept in the folder. Exit code 1 if there are any.
With ``--kills N`` processes that write are killed instead, N times; with ``--messages N`` the language
server gets N messages, and its memory is shown after each fifth of them; with ``--coverage``
atheris, where it is installed, looks for texts that reach new code.
"""

from __future__ import annotations

import argparse
import sys
from pathlib import Path
from tempfile import TemporaryDirectory

from tests.fuzz import kills, messages
from tests.fuzz.driver import Fuzzer

MOST_MEMORY = 10 << 20
"""So much more memory, in bytes, may the server have in the end than after two fifths, when its caches are full."""


def main() -> int:
    parser = argparse.ArgumentParser(prog="python -m tests.fuzz", description=__doc__)
    parser.add_argument("--minutes", type=float, default=10, help="processor time of the commands")
    parser.add_argument("--seed", type=int, default=1, help="the seed of the first batch")
    parser.add_argument("--folder", type=Path, default=Path("build/fuzz"), help="where findings are kept")
    parser.add_argument("--kills", type=int, metavar="N", help="kill N processes at random moments")
    parser.add_argument("--messages", type=int, metavar="N", help="send N random messages to the server")
    parser.add_argument("--coverage", action="store_true", help="be guided by coverage (needs atheris)")
    given = parser.parse_args()
    if given.kills is not None:
        at_work = kills.run(given.kills, given.seed)
        print(f"{given.kills} kills, {at_work} of them at work: no file is torn")
        return 0
    if given.messages is not None:
        with TemporaryDirectory() as folder:
            marks = tuple(given.messages * fifth // 5 for fifth in range(1, 6))
            sizes = messages.weather(Path(folder).resolve(), given.seed, given.messages, marks)
        print(f"{given.messages} messages: all answered; MB:", *(f"{each / 2**20:.1f}" for each in sizes))
        return int(sizes[-1] - sizes[1] > MOST_MEMORY)
    if given.coverage:
        from tests.fuzz import guided

        return guided.run(given.minutes, given.seed, given.folder)
    fuzzer = Fuzzer(given.folder)
    fuzzer.run(given.minutes, given.seed)
    print(
        f"{sum(fuzzer.ran.values())} commands on {fuzzer.documents} documents; {len(fuzzer.marks)} findings"
    )
    return int(bool(fuzzer.marks))


if __name__ == "__main__":
    sys.exit(main())
