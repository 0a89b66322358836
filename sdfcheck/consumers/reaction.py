"""Reactions of consumers of robot descriptions to a defect.

A rule says it for each consumer: ``affects = {Consumer.GAZEBO: REFUSES, Consumer.URDFDOM:
warns("drops the link")}``. Where it depends on the dialect, it says it for each:
``Consumer.DRAKE: {"sdf": REFUSES, "urdf": warns("ignores it")}``. A consumer that a rule does
not name, or not for a dialect, takes the file as it is.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from enum import Enum
from functools import cache
from typing import TYPE_CHECKING

from sdfcheck.source.record import NamedTuple

if TYPE_CHECKING:
    from sdfcheck.consumers.gazebo import GazeboRobot
    from sdfcheck.formats.vendor.definitions import Effect
    from sdfcheck.robot.graph import Model


class Consumer(Enum):
    """A program that reads robot descriptions."""

    GAZEBO = "gazebo"
    DRAKE = "drake"
    URDFDOM = "urdfdom"
    MUJOCO = "mujoco"
    ROS = "ros"
    PYBULLET = "pybullet"
    PINOCCHIO = "pinocchio"
    ISAAC = "isaac"

    @property
    def title(self) -> str:
        """Its name as its makers write it."""
        return _TITLES[self]

    def build(self, robot: Model) -> GazeboRobot:
        """The robot that it makes of a URDF robot; ValueError where that is not known."""
        if self is not Consumer.GAZEBO:
            raise ValueError(f"what {self.title} builds is not known")
        from sdfcheck.consumers.gazebo import GazeboRobot

        return GazeboRobot(robot)


_TITLES = {
    Consumer.GAZEBO: "Gazebo",
    Consumer.DRAKE: "Drake",
    Consumer.URDFDOM: "urdfdom",
    Consumer.MUJOCO: "MuJoCo",
    Consumer.ROS: "ROS",
    Consumer.PYBULLET: "PyBullet",
    Consumer.PINOCCHIO: "Pinocchio",
    Consumer.ISAAC: "Isaac Sim",
}


READS: Mapping[Consumer, tuple[str, ...]] = {
    Consumer.GAZEBO: ("sdf", "urdf"),
    Consumer.DRAKE: ("sdf", "urdf"),
    Consumer.URDFDOM: ("urdf",),
    Consumer.MUJOCO: ("urdf",),
    Consumer.ROS: ("urdf",),
    Consumer.PYBULLET: ("urdf",),
    Consumer.PINOCCHIO: ("urdf",),
    Consumer.ISAAC: ("urdf",),
}
"""Consumer → the dialects that it reads."""

MEASURED = frozenset(("ros", "pybullet", "pinocchio", "isaac"))
"""The names of the consumers whose reactions are in a table (:mod:`sdfcheck.consumers.measured`), not in rules."""


class Verdict(Enum):
    """The verdicts of a consumer on a file, the worst last."""

    ACCEPT = "accept"
    UNMEASURED = "not measured"
    """Nobody knows what it does with what is in the file."""
    WARN = "warn"
    """It reads the file, though not all of it, or not as it was meant."""
    REJECT = "reject"
    """It does not get to the end of the file, or ends up with nothing."""
    UNREAD = "not read"
    """It does not know the format."""


class Reaction(NamedTuple):
    """The reaction of a consumer to a defect, and its verdict on a file with the defect."""

    verdict: Verdict
    words: str
    """The end of the sentence "Drake …", which begins with a verb: `refuses the file`, `ignores it`.

    `drops …` is said of a part of the robot that is written and does not come about, `ignores …` of what is
    written in vain: conversions judge their results by the two.
    """

    @property
    def is_harmless(self) -> bool:
        return self.verdict is Verdict.ACCEPT

    @property
    def severity(self) -> int:
        """How bad it is, to be compared."""
        return tuple(Verdict).index(self.verdict)

    @property
    def is_refusal(self) -> bool:
        return self.verdict is Verdict.REJECT

    @property
    def is_loss(self) -> bool:
        """Does it read the file without a part of the robot that is written there?"""
        return self.verdict is Verdict.WARN and "drops" in self._verbs

    @property
    def is_disregard(self) -> bool:
        """Does it read the file as if something were not written?"""
        return self.verdict is Verdict.WARN and "ignores" in self._verbs

    @property
    def _verbs(self) -> tuple[str, ...]:
        """`ignores`; `warns`, `ignores` of "warns and ignores it"."""
        return tuple(part.partition(" ")[0] for part in self.words.split(" and "))

    def __str__(self) -> str:
        return f"{self.verdict.value}: {self.words}"

    @classmethod
    @cache
    def of(cls, text: str) -> Reaction:
        """The reaction that ``str`` wrote."""
        verdict, _, words = text.partition(": ")
        return cls(Verdict(verdict), words)


def accepts(words: str) -> Reaction:
    """It takes the file as it is; worth saying where one expects something else."""
    return Reaction(Verdict.ACCEPT, words)


def warns(words: str) -> Reaction:
    """It reads the file, though not all of it, or not as it was meant."""
    return Reaction(Verdict.WARN, words)


def refuses(words: str = "refuses the file") -> Reaction:
    """It does not get to the end of the file, or ends up with nothing."""
    return Reaction(Verdict.REJECT, words)


REFUSES = refuses()

Affects = Mapping[Consumer, Reaction | Mapping[str, Reaction]]
"""Consumer → its reaction, or the reaction for each dialect."""


def by_dialect(affects: Affects) -> dict[str, dict[str, str]]:
    """Consumer → dialect → reaction, in full and as text: how an index holds it; without measured ones."""
    texts = {}
    for consumer, said in sorted(affects.items(), key=lambda item: item[0].value):
        if consumer.value in MEASURED:
            continue
        reactions = dict.fromkeys(READS[consumer], said) if isinstance(said, Reaction) else said
        texts[consumer.value] = {dialect: str(reactions[dialect]) for dialect in sorted(reactions)}
    return texts


def lines(affects: Mapping[str, Mapping[str, str]]) -> Iterable[str]:
    """The reactions in an index, for people: a line a consumer, or one for each of its dialects."""
    for consumer, reactions in sorted(affects.items()):
        everywhere = set(reactions) == set(READS[Consumer(consumer)])
        if everywhere and len(set(reactions.values())) == 1:
            yield f"{consumer}: {_words(next(iter(reactions.values())))}"
        else:
            for dialect, said in sorted(reactions.items()):
                yield f"{consumer}, {dialect.upper()}: {_words(said)}"


def _words(said: str) -> str:
    return Reaction.of(said).words


def by_effect(effect: Effect) -> Reaction:
    """The reactions of a consumer to its own elements."""
    outcome = effect.outcome.value
    if outcome == "read":
        return warns(f"reads `{effect.value}`")
    return {
        "error": REFUSES,
        "abort": refuses("aborts"),
        "crash": refuses("crashes"),
        "ignored": warns("ignores it"),
        "accepted": accepts("takes it anyway"),
    }[outcome]
