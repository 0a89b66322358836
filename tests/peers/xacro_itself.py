"""Where sdfcheck and xacro itself expand a file to different texts.

``python -m tests.peers.xacro_itself FOLDER …`` expands every xacro file below the folders with both, and
compares the texts byte for byte but for comments. Packages are found by sdfcheck for both, since xacro asks
ROS for them. xacro runs the code in these files: name folders that you trust.
"""

from __future__ import annotations

import multiprocessing.connection
import os
import re
import sys
from collections import Counter
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import NamedTuple

from sdfcheck.files.packages import Packages, project_root
from sdfcheck.source.document import read
from sdfcheck.source.sniff import Kind
from sdfcheck.xacro.expansion import PASSED_ON, Expander
from sdfcheck.xacro.problems import ExpansionFailure

_COMMENT = re.compile(r"<!--.*?-->", re.DOTALL)
_WORD = re.compile(r"\w+")
_TIME = 60
"""s: what xacro may take for a file."""


class Compared(NamedTuple):
    """The texts that xacro and sdfcheck give for a file, None if it fails, and the reason."""

    path: Path
    theirs: str | None
    ours: str | None
    their_reason: str = ""
    our_reason: str = ""

    @property
    def verdict(self) -> str:
        if self.theirs is None or self.ours is None:
            return {
                (True, True): "both fail",
                (True, False): "only xacro fails",
                (False, True): "only sdfcheck fails",
            }[self.theirs is None, self.ours is None]
        theirs, ours = _COMMENT.sub("", self.theirs), _COMMENT.sub("", self.ours)
        if theirs == ours:
            return "same"
        words = [sorted(_WORD.findall(text)) for text in (theirs, ours)]
        return (
            "other order of a set"
            if words[0] == words[1] and "set(" in self.path.read_text()
            else "different"
        )

    @property
    def is_wrong(self) -> bool:
        return self.verdict in {"different", "only sdfcheck fails", "only xacro fails"}


def xacro_files(folders: Iterable[Path]) -> list[Path]:
    return sorted({path for folder in folders for path in folder.rglob("*.xacro") if path.is_file()})


def compare(paths: Iterable[Path]) -> Iterator[Compared]:
    known: dict[Path, Packages] = {}
    with Expander() as expander:
        for path in paths:
            root = project_root(path)
            packages = known.setdefault(root, Packages(root, environment={}))
            packages.survey()
            theirs, their_reason = _expanded_by_xacro(path, packages)
            expansion = expander.expand(read(path.read_bytes(), path, Kind.XACRO))
            yield Compared(path, theirs, expansion.text, their_reason, _words(expansion.problems))


def _words(problems: Iterable[object]) -> str:
    return "; ".join(
        f"{problem.kind.value}: {problem.detail}"
        if isinstance(problem, ExpansionFailure)
        else repr(problem)[:200]
        for problem in problems
    )


def _expanded_by_xacro(path: Path, packages: Packages) -> tuple[str | None, str]:
    """The text that xacro expands a file to, in a process of its own, or the reason why it fails."""
    context = multiprocessing.get_context("fork")
    receiving, sending = context.Pipe(duplex=False)
    process = context.Process(target=_expand, args=(path, packages, sending))
    process.start()
    sending.close()
    try:
        answer: tuple[str | None, str] = receiving.recv() if receiving.poll(_TIME) else (None, "no end")
    except EOFError:
        answer = None, "it came to an unexpected end"
    process.kill()
    process.join()
    return answer


def _expand(path: Path, packages: Packages, sending: multiprocessing.connection.Connection) -> None:
    import xacro
    from xacro import substitution_args

    def find(name: str) -> str:
        folder = packages.find(name)
        if folder is None:
            raise LookupError(f"no package {name}")
        return str(folder)

    plain = xacro.abs_filename_spec

    def locate(spec: str) -> str:
        return str(packages.locate(Path(plain(spec))))

    kept = {name: os.environ[name] for name in PASSED_ON if name in os.environ}
    os.environ.clear()
    os.environ.update(kept)
    substitution_args._eval_find = substitution_args._eval_dict["find"] = find
    xacro.abs_filename_spec = locate
    sys.stderr = sys.stdout = open(os.devnull, "w")  # noqa: SIM115
    try:
        sending.send((xacro.process_file(str(path)).toprettyxml(indent="  "), ""))
    except BaseException as error:
        sending.send((None, f"{type(error).__name__}: {error}"))


def main() -> None:
    counts: Counter[str] = Counter()
    for one in compare(xacro_files(map(Path, sys.argv[1:]))):
        counts[one.verdict] += 1
        if one.is_wrong:
            print(f"{one.path}: {one.verdict}: {one.their_reason or one.our_reason}", flush=True)
    print(
        f"{counts.total()} files: " + ", ".join(f"{number} {what}" for what, number in counts.most_common())
    )


if __name__ == "__main__":
    main()
