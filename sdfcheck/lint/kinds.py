"""Kinds of finding that no rule has: those of conversions and of simulations."""

from __future__ import annotations

from enum import Enum

from sdfcheck.lint.diagnostic import Severity
from sdfcheck.lint.run import RuleFacts


class FindingKind(Enum):
    """Kinds of finding that no rule has. A value is the code, what happens and why it matters."""

    @property
    def code(self) -> str:
        return str(self.value).partition(" ")[0]

    @property
    def title(self) -> str:
        """The kebab-case name."""
        return self.name.lower().replace("_", "-")

    @property
    def is_grave(self) -> bool:
        """Can it be an error?"""
        raise NotImplementedError

    @property
    def facts(self) -> RuleFacts:
        """The facts about the kind, in the form of those about rules; the severity is the highest."""
        severity = Severity.ERROR if self.is_grave else Severity.WARNING
        family, about = self.code.rstrip("0123456789"), str(self.value).partition(" ")[2]
        module = type(self).__module__
        return RuleFacts(self.code, self.title, family, severity, about, "", True, (), (), {}, module)


class SimKind(FindingKind):
    """The kinds of finding: name, code, what happens and why it matters. Neither name nor code is ever reused."""

    NOT_LOADED = "SIM001 The simulator does not load the robot, or ends while it does."
    OTHER_MASS = (
        "SIM002 A link has other mass properties in the simulator than in the text, such as the 1 kg that "
        "PyBullet gives to links without mass, or none although it moves."
    )
    OTHER_JOINT = "SIM003 A joint is not in the simulator, or has another range there than in the text."
    START_OVERLAP = (
        "SIM004 Two links that are not neighbors overlap where the robot starts, so that the simulator "
        "pushes them apart or locks them."
    )
    UNSTABLE = (
        "SIM005 The robot gains energy from nothing, or its positions are not finite: mass, inertia or "
        "joints are not those of a body."
    )
    STEP_DEPENDENT = "SIM006 The robot moves differently with half and double the time step."
    COLLIDING_JOINT = "SIM007 A joint moves one part into another within its range."
    WEAK_JOINT = "SIM008 A joint cannot hold the robot against gravity with its effort."
    TIPPING = (
        "SIM009 A robot with wheels does not stay upright, or does not touch the ground with its wheels."
    )
    ENGINES_DISAGREE = "SIM010 Two simulators let the robot fall differently."
    LEFT_OUT = "SIM011 A part of the robot is not simulated, as the simulator cannot read it."
    CONVERSION_DIFFERS = "SIM012 The robot falls differently when it comes back from SDFormat."
    OTHER_DESCRIPTION = (
        "SIM013 A joint is elsewhere, or turns the other way, than in other files of the project that "
        "describe the robot, and have all its other joints in common."
    )

    @property
    def is_grave(self) -> bool:
        return self in {SimKind.NOT_LOADED, SimKind.UNSTABLE}


SIMULATED: tuple[RuleFacts, ...] = tuple(kind.facts for kind in SimKind)
"""The findings of simulations: comments and settings silence them like those of rules."""
