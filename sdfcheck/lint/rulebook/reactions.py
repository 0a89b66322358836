"""Writes the table of reactions: ``python -m sdfcheck.lint.rulebook.reactions [CONSUMER…]``.

Each rule's bad examples, and what they are after the fix (or the rule's good examples), are given
to the consumers that are installed. An example whose counterpart is refused as well says nothing.
The reactions of :data:`ON_REQUEST` are written as they were measured. Those of the others are
written by people: a row counts as measured if the consumer takes and refuses the examples as
their findings say, and what differs is printed. The rows of consumers that are not installed stay as they are.
"""

from __future__ import annotations

import os
import re
import sys
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from pathlib import Path
from tempfile import TemporaryDirectory

from sdfcheck.consumers.engines import RUN_BY, Answer, Limits, Outcome, Question, ask_all, is_installed
from sdfcheck.consumers.measured import AS_PARSER, FILE, TAKEN, THROUGH, Place, Table
from sdfcheck.consumers.reaction import (
    ON_REQUEST,
    READS,
    REFUSES,
    Consumer,
    Reaction,
    Verdict,
    accepts,
    refuses,
    warns,
)
from sdfcheck.lint.config.configuration import Configuration
from sdfcheck.lint.config.settings import UNSET
from sdfcheck.lint.example import Bad, Good, fill, unmark
from sdfcheck.lint.rule import Rule
from sdfcheck.lint.rulebook.plugins import find_pack, load_rules
from sdfcheck.lint.run import BUILT_IN
from sdfcheck.lint.session import Options, run
from sdfcheck.lint.targets import matrix
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.sniff import Kind

_LIMITS = Limits(10.0)
_ELSEWHERE = (".xacro", ".config", ".srdf")
_ALARM = re.compile(r"warn|error|fail|not found|unknown|missing|no inertial", re.IGNORECASE)


class Trial(NamedTuple):
    """A bad example, and documents that are like it without the defect."""

    code: str
    kind: Kind
    bad: Path
    sound: tuple[Path, ...]
    is_fixed: bool
    """Is it the same document after the fix, and not another one?"""


def trials(rules: Iterable[type[Rule]], folder: Path) -> Iterator[Trial]:
    """The bad examples that are SDFormat or URDF, written out."""
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
            like = tuple(other.path for other in known if other is not None and other.kind is bad.kind)
            yield Trial(rule.code, bad.kind, bad.path, like, fixed is not None)


class _Written(NamedTuple):
    path: Path
    kind: Kind


def _written(rule: type[Rule], example: Bad | Good, folder: Path, name: str) -> _Written | None:
    text = unmark(fill(rule.scaffold, example))[0]
    kind = Kind.URDF if "<robot" in text else Kind.SDF if "<sdf" in text else None
    if kind is None or example.file.endswith(_ELSEWHERE):
        return None
    file = folder / f"{rule.code}-{name}" / (example.file or f"example.{kind.value}")
    for beside, content in {**(example.files or {}), file.name: text}.items():
        path = file.parent / beside
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(content, encoding="utf-8")
    return _Written(file, kind)


class _Expected:
    """The verdicts on documents that their findings give."""

    def __init__(self, consumers: Collection[Consumer]) -> None:
        self._consumers = consumers
        self._known: dict[Path, Mapping[Consumer, Verdict]] = {}

    def of(self, trial: Trial, consumer: Consumer) -> Verdict:
        """The verdict of a consumer on a bad example."""
        if trial.bad not in self._known:
            names = tuple(one.value for one in self._consumers)
            done = run([trial.bad], Options(Configuration(isolated=True, given=UNSET._replace(target=names))))
            rows = matrix(done, trial.kind, trial.bad, self._consumers)
            self._known[trial.bad] = {row.consumer: row.verdict for row in rows}
        return self._known[trial.bad][consumer]

    def is_met(self, trial: Trial, consumer: Consumer, answer: Answer) -> bool:
        return (self.of(trial, consumer) is Verdict.REJECT) is not answer.is_accepted


def measured(
    consumer: Consumer, known: Sequence[Trial], before: Mapping[Place, str], expected: _Expected
) -> Iterator[tuple[Place, str]]:
    """The rows of a consumer, for the rules whose examples say something."""
    read = [one for one in known if one.kind.value in READS[consumer]]
    if consumer.value not in ON_REQUEST:
        read = [one for one in read if expected.of(one, consumer) is not Verdict.UNREAD]
    paths = sorted({path for trial in read for path in (trial.bad, *trial.sound)})
    asked = ask_all(RUN_BY[consumer], map(Question, paths), _LIMITS)
    answers = dict(zip(paths, asked, strict=True))
    by_rule: dict[Place, list[Trial]] = {}
    for trial in read:
        if any(answers[path].is_accepted for path in trial.sound):
            by_rule.setdefault(Place(trial.code, consumer.value, trial.kind.value), []).append(trial)
    for place, own in sorted(by_rule.items()):
        said = _row(place, own, answers, expected, before.get(place))
        if said is not None:
            yield place, said


def _row(
    place: Place,
    own: Sequence[Trial],
    answers: Mapping[Path, Answer],
    expected: _Expected,
    before: str | None,
) -> str | None:
    consumer = Consumer(place.consumer)
    judge = THROUGH.get(consumer, consumer)
    if judge.value in ON_REQUEST:
        return str(_reaction(own, answers))
    differing = [one for one in own if not expected.is_met(one, judge, answers[one.bad])]
    if judge is not consumer:
        return str(_reaction(own, answers)) if differing else AS_PARSER
    for one in differing:
        print(f"{one.bad.parent.name}: {place.consumer} {answers[one.bad].outcome.value}s it, unexpectedly")
    if differing:
        return None
    return before or (TAKEN if all(answers[one.bad].is_accepted for one in own) else None)


def _reaction(own: Sequence[Trial], answers: Mapping[Path, Answer]) -> Reaction:
    refused = [answers[trial.bad] for trial in own if not answers[trial.bad].is_accepted]
    if len(refused) == len(own):
        crashed = all(answer.outcome is Outcome.CRASHED for answer in refused)
        return refuses("crashes") if crashed else REFUSES
    if any(trial.is_fixed and not answers[trial.bad].is_accepted for trial in own):
        return warns("refuses some of such files")
    if any(_complaints(trial, answers) for trial in own):
        return warns("warns, and reads on")
    return accepts("takes it as it is")


def _complaints(trial: Trial, answers: Mapping[Path, Answer]) -> set[str]:
    """Messages about an example that none of its counterparts causes."""

    def alarms(path: Path) -> set[str]:
        said = (re.sub(r"\S*/\S*|\d+", "", line) for line in answers[path].messages)
        return {line for line in said if _ALARM.search(line)}

    return alarms(trial.bad).difference(*map(alarms, trial.sound))


def again(rules: Sequence[type[Rule]], before: Table, consumers: Iterable[Consumer]) -> Table:
    """The table with the rows of those of the consumers that are installed measured again."""
    codes = {rule.code for rule in rules}
    rows = {place: said for place, said in before if place.code in codes}
    after = Table("")
    after.versions.update(before.versions)
    after.unmeasured |= before.unmeasured & rows.keys()
    with TemporaryDirectory() as folder:
        known = list(trials(rules, Path(folder)))
        expected = _Expected([one for one in Consumer if one.value not in ON_REQUEST])
        for consumer in filter(lambda one: is_installed(RUN_BY[one]), consumers):
            found = dict(measured(consumer, known, rows, expected))
            after.unmeasured |= {one for one in rows.keys() - found.keys() if one.consumer == consumer.value}
            after.unmeasured -= found.keys()
            rows.update(found)
            (sample,) = ask_all(RUN_BY[consumer], [Question(known[0].bad)], _LIMITS)
            after.versions[consumer.value] = f"{RUN_BY[consumer].value} {sample.version}"
    for place, said in rows.items():
        after.rows.setdefault(place.code, {}).setdefault(place.consumer, {})[place.dialect] = said
    return after


def main(names: Sequence[str]) -> int:
    rules, faults = load_rules(find_pack(BUILT_IN))
    before = Table(FILE.read_text("utf-8") if os.path.isfile(FILE) else "")
    if faults:
        return 1
    after = again(
        sorted(rules, key=lambda rule: rule.code), before, map(Consumer, names) if names else Consumer
    )
    FILE.write_text(after.render(), encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
