"""Writes the table of measured reactions: ``python -m sdfcheck.lint.rulebook.reactions``.

Each rule's bad examples, and what they are after the fix (or the rule's good examples), are given
to the consumers that are installed. An example whose counterpart is refused as well says nothing.
The rows of consumers that are not installed stay as they are.
"""

from __future__ import annotations

import re
import sys
from collections.abc import Iterable, Iterator, Mapping, Sequence
from pathlib import Path
from tempfile import TemporaryDirectory

from sdfcheck.consumers.engines import RUN_BY, Answer, Limits, Outcome, Question, ask_all, is_installed
from sdfcheck.consumers.measured import AS_PARSER, CONSUMERS, FILE, THROUGH, Table
from sdfcheck.consumers.reaction import READS, Consumer, Reaction
from sdfcheck.lint.config.configuration import Configuration
from sdfcheck.lint.example import Bad, Good, fill, unmark
from sdfcheck.lint.rule import Rule
from sdfcheck.lint.rulebook.plugins.find import find_pack
from sdfcheck.lint.rulebook.plugins.load import load_rules
from sdfcheck.lint.run import BUILT_IN
from sdfcheck.lint.session import Options, run
from sdfcheck.source.record import NamedTuple

_LIMITS = Limits(10.0)
_ELSEWHERE = (".xacro", ".config", ".srdf")
_ALARM = re.compile(r"warn|error|fail|not found|unknown|missing|no inertial", re.IGNORECASE)


class Trial(NamedTuple):
    """A bad example, and documents that are like it without the defect."""

    code: str
    bad: Path
    sound: tuple[Path, ...]
    is_fixed: bool
    """Is it the same document after the fix, and not another one?"""


def trials(rules: Iterable[type[Rule]], folder: Path) -> Iterator[Trial]:
    """The bad examples that are URDF, written out."""
    for rule in rules:
        sound = [_written(rule, one, folder, f"good-{n}") for n, one in enumerate(rule.good)]
        for number, one in enumerate(rule.bad):
            bad = _written(rule, one, folder, f"bad-{number}")
            if bad is None:
                continue
            fixed = None
            if one.fixed is not None:
                fixed = _written(rule, one._replace(text=one.fixed), folder, f"fixed-{number}")
            known = [fixed] if fixed is not None else sound
            yield Trial(rule.code, bad, tuple(path for path in known if path is not None), fixed is not None)


def _written(rule: type[Rule], example: Bad | Good, folder: Path, name: str) -> Path | None:
    text = unmark(fill(rule.scaffold, example))[0]
    if "<robot" not in text or example.file.endswith(_ELSEWHERE):
        return None
    file = folder / f"{rule.code}-{name}" / (example.file or "example.urdf")
    for beside, content in {**(example.files or {}), file.name: text}.items():
        path = file.parent / beside
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(content, encoding="utf-8")
    return file


def measured(consumer: Consumer, known: Sequence[Trial]) -> Iterator[tuple[str, str]]:
    """Rule → the reaction of a consumer, for the rules whose examples say something."""
    paths = sorted({path for trial in known for path in (trial.bad, *trial.sound)})
    asked = ask_all(RUN_BY[consumer], map(Question, paths), _LIMITS)
    answers = dict(zip(paths, asked, strict=True))
    by_rule: dict[str, list[Trial]] = {}
    for trial in known:
        if any(answers[path].is_accepted for path in trial.sound):
            by_rule.setdefault(trial.code, []).append(trial)
    for code, own in sorted(by_rule.items()):
        if consumer in THROUGH and all(_does_as_parser(trial, answers[trial.bad], consumer) for trial in own):
            yield code, AS_PARSER
        else:
            yield code, str(_reaction(own, answers))


def _does_as_parser(trial: Trial, answer: Answer, consumer: Consumer) -> bool:
    """Is the verdict on an example the one that its finding gives of the consumer's parser?"""
    parser = THROUGH[consumer].value
    done = run([trial.bad], Options(Configuration(isolated=True), target=(parser,)))
    refused = any(dict(one.affects)[parser].is_refusal for one in done.diagnostics if parser in one.concerned)
    return refused is not answer.is_accepted


def _reaction(own: Sequence[Trial], answers: Mapping[Path, Answer]) -> Reaction:
    refused = [answers[trial.bad] for trial in own if not answers[trial.bad].is_accepted]
    if len(refused) == len(own):
        crashed = all(answer.outcome is Outcome.CRASHED for answer in refused)
        return Reaction.of("reject: crashes" if crashed else "reject: refuses the file")
    if any(trial.is_fixed and not answers[trial.bad].is_accepted for trial in own):
        return Reaction.of("warn: refuses some of such files")
    if any(_complaints(trial, answers) for trial in own):
        return Reaction.of("warn: warns, and reads on")
    return Reaction.of("accept: takes it as it is")


def _complaints(trial: Trial, answers: Mapping[Path, Answer]) -> set[str]:
    """Messages about an example that none of its counterparts causes."""

    def alarms(path: Path) -> set[str]:
        said = (re.sub(r"\S*/\S*|\d+", "", line) for line in answers[path].messages)
        return {line for line in said if _ALARM.search(line)}

    return alarms(trial.bad).difference(*map(alarms, trial.sound))


def stated(rules: Iterable[type[Rule]], consumer: Consumer) -> Iterator[tuple[str, str]]:
    """Rule → the reaction that it states itself, where there is nothing to read: xacro that is not expanded."""
    for rule in rules:
        said = rule.affects.get(consumer)
        is_xacro = all(
            "xacro" in fill(rule.scaffold, one) or one.file.endswith(_ELSEWHERE) for one in rule.bad
        )
        if isinstance(said, Reaction) and is_xacro and consumer not in THROUGH:
            yield rule.code, str(said)


def render(rules: Sequence[type[Rule]], before: Table) -> str:
    """The table with the rows of the consumers that are installed measured again."""
    rows: dict[tuple[str, str], str] = {
        (code, name): by["urdf"]
        for code, own in before.rows.items()
        for name, by in own.items()
        if not is_installed(RUN_BY[Consumer(name)])
    }
    versions = dict(before.versions)
    with TemporaryDirectory() as folder:
        known = list(trials(rules, Path(folder)))
        for consumer in filter(lambda one: is_installed(RUN_BY[one]), CONSUMERS):
            found = {**dict(stated(rules, consumer)), **dict(measured(consumer, known))}
            rows.update(((code, consumer.value), said) for code, said in found.items())
            (sample,) = ask_all(RUN_BY[consumer], [Question(known[0].bad)], _LIMITS)
            versions[consumer.value] = f"{RUN_BY[consumer].value} {sample.version}"
    assert all(READS[consumer] == ("urdf",) for consumer in CONSUMERS)
    lines = [f"# {name}: {version}" for name, version in sorted(versions.items())]
    lines += [f"{code}\t{name}\turdf\t{said}" for (code, name), said in sorted(rows.items())]
    return "\n".join(lines) + "\n"


def main() -> int:
    rules, faults = load_rules(find_pack(BUILT_IN))
    before = Table(FILE.read_text("utf-8") if FILE.is_file() else "")
    if faults:
        return 1
    FILE.write_text(render(sorted(rules, key=lambda rule: rule.code), before), encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
