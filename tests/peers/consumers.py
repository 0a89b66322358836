"""The consumers themselves, as far as they are installed: does each take a file?"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import partial
from pathlib import Path

from sdfcheck.consumers.engines import RUN_BY, Engine, Question, ask_all, is_installed
from sdfcheck.consumers.reaction import ON_REQUEST, Consumer


def loads(engine: Engine, paths: Sequence[Path]) -> dict[Path, bool]:
    """Which of some files an engine takes."""
    answers = ask_all(engine, map(Question, paths))
    return {path: answer.is_accepted for path, answer in zip(paths, answers, strict=True)}


def installed() -> Mapping[Consumer, Callable[[Sequence[Path]], dict[Path, bool]]]:
    """Consumer → the function that finds out which of some files it takes; of those that rules speak of."""
    stated = ((one, engine) for one, engine in RUN_BY.items() if one.value not in ON_REQUEST)
    return {consumer: partial(loads, engine) for consumer, engine in stated if is_installed(engine)}
