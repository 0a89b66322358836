"""Whether fixes have done harm: a second opinion, by linting the text before and after them, and libsdformat's."""

from __future__ import annotations

import re
from collections import Counter
from pathlib import Path

from sdfcheck import Consumer, Run, Severity, lint
from sdfcheck.consumers.engines import Answer, Engine, Limits, Question, ask
from sdfcheck.consumers.reaction import ON_REQUEST

_DIRECTIVE = re.compile(r"sdfcheck:\s*(?:ignore-file|ignore|disable|enable)\b(?:\[[^\]<>]*\])?")

_LIMITS = Limits(seconds=20)


def harm(before: bytes, after: bytes, path: Path) -> str:
    """The harm, in words; empty for none. The texts are linted as if they were in the folder of the path."""
    runs = [lint(text, name=path, isolated=True) for text in (before, after)]
    if runs[0].skipped:
        return ""  # no run fixes what it does not lint
    brought = _errors(runs[1]) - _errors(runs[0])
    # Of a text that no consumer reads, what else is wrong is a guess.
    if brought and not _stops(runs[0]):
        return f"new errors: {sorted(brought)}"
    lost = _directives(before) - _directives(after) - _reported(runs[0])
    if any(each.code == "XML001" for each in runs[0].diagnostics):
        # The comments of a broken text, and so the effect of one about the text, are a guess.
        lost = Counter({words: count for words, count in lost.items() if "[XML" not in words})
    if lost:
        return f"comments for sdfcheck are gone: {sorted(lost)}"
    return ""


def refusal(before: bytes, after: bytes, folder: Path, suffix: str) -> str:
    """The words of libsdformat on the text after fixes, where it takes the one before; empty if it takes both.

    Both texts are written into the folder, and removed.
    """
    now = _asked(after, folder / f"after{suffix}")
    if now.is_accepted or now.is_missing or not _asked(before, folder / f"before{suffix}").is_accepted:
        return ""
    return f"libsdformat refuses it: {now.outcome.value} {now.error}"


def _asked(data: bytes, file: Path) -> Answer:
    file.write_bytes(data)
    try:
        return ask(Engine.LIBSDFORMAT, Question(file), _LIMITS)
    finally:
        file.unlink()


def _errors(run: Run) -> Counter[str]:
    return Counter(each.code for each in run.diagnostics if each.severity is Severity.ERROR)


def _stops(run: Run) -> bool:
    """Does no consumer get a robot?"""
    return any(
        each.severity is Severity.ERROR
        and all(
            any(name == consumer.value and how.is_refusal for name, how in each.affects)
            for consumer in Consumer
            if consumer.value not in ON_REQUEST
        )
        for each in run.diagnostics
    )


def _directives(data: bytes) -> Counter[str]:
    return Counter(_DIRECTIVE.findall(data.decode("utf-8", "replace")))


def _reported(run: Run) -> Counter[str]:
    """The directives that are reported as useless or misspelled themselves: every one on these lines."""
    lines = (
        each.span.source.text.splitlines()[each.span.begin.line - 1]
        for each in run.diagnostics
        if each.code.startswith("SUP")
    )
    return Counter(found for line in lines for found in _DIRECTIVE.findall(line))
