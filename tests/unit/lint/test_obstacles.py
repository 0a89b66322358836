"""Errors stop a conversion where the format's own parser refuses the file."""

from __future__ import annotations

from pathlib import Path

import pytest

import sdfcheck
from sdfcheck.consumers.reaction import REFUSES, Consumer, Reaction, accepts, drops
from sdfcheck.lint.diagnostic import Diagnostic, Severity
from sdfcheck.lint.targets import OWN_CONSUMER, obstacles, own_consumer
from sdfcheck.source.document import read
from sdfcheck.source.sniff import Kind
from sdfcheck.source.text import Source

WELDED = "<link name='a'/><joint name='a' type='fixed'><parent link='world'/><child link='a'/></joint>"


def stops(
    affects: dict[str, Reaction],
    kind: Kind,
    severity: Severity = Severity.ERROR,
    elsewhere: frozenset[str] = frozenset(),
) -> bool:
    span = Source(Path("r"), "<robot/>").span(0, 0)
    reactions = tuple(affects.items())
    return bool(
        obstacles(
            [Diagnostic("XYZ001", "odd-flaw", severity, "odd", span, affects=reactions)],
            OWN_CONSUMER.get(kind),
            elsewhere,
        )
    )


@pytest.mark.parametrize(
    ("affects", "urdf", "sdf"),
    [
        ({}, False, False),
        ({"drake": REFUSES}, False, False),
        ({"urdfdom": REFUSES, "gazebo": REFUSES}, True, True),
        ({"urdfdom": accepts("takes it"), "gazebo": REFUSES}, False, True),
        ({"urdfdom": drops("the rest of the link")}, False, False),
    ],
)
def test_the_own_consumer_decides(affects: dict[str, Reaction], urdf: bool, sdf: bool) -> None:
    assert stops(affects, Kind.URDF) is urdf
    assert stops(affects, Kind.SDF) is sdf


def test_warnings_and_what_is_elsewhere_do_not_stop() -> None:
    refused = {"urdfdom": REFUSES}
    assert not stops(refused, Kind.URDF, Severity.WARNING)
    assert not stops(refused, Kind.URDF, elsewhere=frozenset({"XYZ"}))
    assert stops(refused, Kind.URDF, elsewhere=frozenset({"XY"}))


@pytest.mark.parametrize(
    ("text", "consumer"),
    [
        ("<robot name='r'/>", Consumer.URDFDOM),
        ("<robot name='r' xmlns:drake='d'><drake:joint name='j' type='ball'/></robot>", Consumer.DRAKE),
        ("<sdf version='1.9'><drake:joint name='j' type='ball'/></sdf>", Consumer.GAZEBO),
        (f"<robot name='r'>{WELDED}</robot>", Consumer.URDFDOM),
        (f"<robot name='r' xmlns:drake='d'>{WELDED}</robot>", Consumer.DRAKE),
        (f"<robot name='r'>{WELDED}<transmission type='SimpleTransmission'/></robot>", Consumer.DRAKE),
        (f"<robot name='r' xmlns:drake='d'><link name='world'/>{WELDED}</robot>", Consumer.URDFDOM),
    ],
)
def test_a_robot_that_only_drake_can_build_is_for_drake(text: str, consumer: Consumer) -> None:
    assert own_consumer(read(text.encode(), Path("r"))) is consumer


def test_errors_of_others_are_warnings_in_a_robot_for_drake() -> None:
    def found(start: str) -> list[tuple[str, str]]:
        run = sdfcheck.lint(start + WELDED + "</robot>", isolated=True, select=["JNT001", "NAM002"])
        return sorted((each.code, each.severity.value) for each in run.diagnostics)

    assert found("<robot name='r'>") == [("JNT001", "error"), ("NAM002", "error")]
    assert found("<robot name='r' xmlns:drake='d'>") == [("JNT001", "warning"), ("NAM002", "warning")]
