"""Joints of SDFormat that are elements of Drake's own in URDF."""

from __future__ import annotations

import pytest

from sdfcheck.source.sniff import Kind
from tests.unit.convert.test_vendor_tags import faults, sdf, to_urdf


@pytest.mark.parametrize(
    ("source", "result"),
    [
        (
            sdf(joint="<joint name='j' type='ball'><parent>a</parent><child>b</child><axis><xyz>0 0 1</xyz>"
                      "<dynamics><damping>0.5</damping></dynamics></axis></joint>"),
            '<parent link="a"/><child link="b"/><dynamics damping="0.5"/></drake:joint>',
        ),
        (
            sdf(joint="<drake:joint name='j' type='curvilinear'><drake:parent>a</drake:parent>"
                      "<drake:child>b</drake:child><drake:initial_tangent><xyz>0 1 0</xyz></drake:initial_tangent>"
                      "<drake:curves><drake:line_segment><drake:length>1</drake:length></drake:line_segment></drake:curves></drake:joint>"),
            '<drake:initial_tangent xyz="0 1 0"/><drake:curves><drake:line_segment length="1"/></drake:curves>',
        ),
    ],
    ids=["damped-ball", "curvilinear"],
)  # fmt: skip
def test_sdf_becomes_urdf(source: str, result: str) -> None:
    written = to_urdf(source)
    assert result in written
    assert faults(written, Kind.URDF) == []
