"""Reactions of consumers of robot descriptions to a defect.

Those to the defects of the built-in rules are in a table (:mod:`sdfcheck.consumers.measured`). A
pack's rule says them itself: ``affects = {Consumer.GAZEBO: REFUSES, Consumer.URDFDOM:
drops("the link")}``, and where it depends on the dialect, for each: ``Consumer.DRAKE: {"sdf":
REFUSES, "urdf": ignores("it")}``. A consumer that is not named, or not for a dialect, takes the
file as it is.
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
    """A program that reads robot descriptions: one line has all that is known of it, but for its reactions."""

    _value_: str
    title: str
    """Its name as its makers write it."""
    reads: tuple[str, ...]
    """The dialects that it reads."""
    is_on_request: bool
    """Are its reactions looked up only where it is a target?"""

    def __new__(
        cls, name: str, title: str = "", reads: tuple[str, ...] = (), is_on_request: bool = True
    ) -> Consumer:
        made = object.__new__(cls)
        made._value_, made.title, made.reads, made.is_on_request = name, title, reads, is_on_request
        return made

    GAZEBO = "gazebo", "Gazebo", ("sdf", "urdf"), False
    DRAKE = "drake", "Drake", ("sdf", "urdf"), False
    URDFDOM = "urdfdom", "urdfdom", ("urdf",), False
    MUJOCO = "mujoco", "MuJoCo", ("urdf",), False
    ROS = "ros", "ROS", ("urdf",)
    PYBULLET = "pybullet", "PyBullet", ("urdf",)
    PINOCCHIO = "pinocchio", "Pinocchio", ("urdf",)
    ISAAC = "isaac", "Isaac Sim", ("urdf",)

    def build(self, robot: Model) -> GazeboRobot:
        """The robot that it makes of a URDF robot; ValueError where that is not known."""
        if self is not Consumer.GAZEBO:
            raise ValueError(f"what {self.title} builds is not known")
        from sdfcheck.consumers.gazebo import GazeboRobot

        return GazeboRobot(robot)


READS: Mapping[Consumer, tuple[str, ...]] = {consumer: consumer.reads for consumer in Consumer}
"""Consumer → the dialects that it reads."""
ON_REQUEST = frozenset(consumer.value for consumer in Consumer if consumer.is_on_request)
"""The names of the consumers whose reactions are looked up only where they are a target."""


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


class Manner(Enum):
    """The ways in which a consumer reads a file with a defect."""

    ACCEPT = "accept"
    UNMEASURED = "not measured"
    WARN = "warn"
    """It reads the file otherwise than it was meant."""
    IGNORE = "ignore"
    """It reads the file as if something were not written."""
    DROP = "drop"
    """It reads the file without a part of the robot that is written there."""
    REJECT = "reject"

    @property
    def verdict(self) -> Verdict:
        return Verdict.WARN if self in (Manner.IGNORE, Manner.DROP) else Verdict(self.value)


class Reaction(NamedTuple):
    """The reaction of a consumer to a defect."""

    manner: Manner
    """Conversions judge their results by it."""
    words: str
    """The end of the sentence "Drake …", which begins with a verb: `refuses the file`, `takes 1`."""

    @property
    def verdict(self) -> Verdict:
        """The verdict on a file with the defect."""
        return self.manner.verdict

    @property
    def is_harmless(self) -> bool:
        return self.manner is Manner.ACCEPT

    @property
    def severity(self) -> int:
        """How bad it is, to be compared."""
        return tuple(Verdict).index(self.verdict)

    @property
    def is_refusal(self) -> bool:
        return self.manner is Manner.REJECT

    @property
    def is_loss(self) -> bool:
        return self.manner is Manner.DROP

    @property
    def is_disregard(self) -> bool:
        return self.manner is Manner.IGNORE

    def __str__(self) -> str:
        return f"{self.manner.value}: {self.words}"

    @classmethod
    @cache
    def of(cls, text: str) -> Reaction:
        """The reaction that ``str`` wrote."""
        manner, _, words = text.partition(": ")
        return cls(Manner(manner), words)


def accepts(words: str) -> Reaction:
    """It takes the file as it is; worth saying where one expects something else."""
    return Reaction(Manner.ACCEPT, words)


def warns(words: str) -> Reaction:
    """It reads the file, though not as it was meant: ``warns("takes 1")``."""
    return Reaction(Manner.WARN, words)


def ignores(what: str) -> Reaction:
    """It reads the file as if something were not written: ``ignores("it")``."""
    return Reaction(Manner.IGNORE, f"ignores {what}")


def drops(what: str) -> Reaction:
    """It reads the file without a part of the robot that is written there: ``drops("the link")``."""
    return Reaction(Manner.DROP, f"drops {what}")


def refuses(words: str = "refuses the file") -> Reaction:
    """It does not get to the end of the file, or ends up with nothing."""
    return Reaction(Manner.REJECT, words)


REFUSES = refuses()
UNFOUND = warns("refuses the file where it is not found")
"""A file that it opens is not on this computer; on another one it may be there."""

Affects = Mapping[Consumer, Reaction | Mapping[str, Reaction]]
"""Consumer → its reaction, or the reaction for each dialect."""


def by_dialect(affects: Affects) -> dict[str, dict[str, str]]:
    """Consumer → dialect → reaction, in full and as text: how an index holds it."""
    texts = {}
    for consumer, said in sorted(affects.items(), key=lambda item: item[0].value):
        if consumer.value in ON_REQUEST:
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
        "ignored": ignores("it"),
        "accepted": accepts("takes it anyway"),
    }[outcome]
