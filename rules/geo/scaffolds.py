"""Pieces of robots for the examples of this family."""

from __future__ import annotations

ARM = (
    '<robot name="r"><link name="base"><visual><geometry><box size="0.2 0.2 0.1"/></geometry></visual></link>'
    '<link name="arm">{}</link><joint name="j" type="revolute"><origin xyz="0 0 0.3"/><parent link="base"/>'
    '<child link="arm"/><axis xyz="0 0 1"/><limit lower="-1" upper="1" effort="1" velocity="1"/></joint></robot>'
)
"""A robot of two links whose joint is 0.3 m up; for the content of the second link."""


def wedge(length: float) -> str:
    """An OBJ file with one triangle of this length along x, a tenth along y and z."""
    side = length / 10
    return f"v 0 0 0\nv {length} 0 0\nv 0 {side} {side}\nf 1 2 3\n"


def mesh(kind: str, file: str, attributes: str = "") -> str:
    """A visual or collision with a mesh in URDF."""
    return f'<{kind}><geometry><mesh filename="{file}"{attributes}/></geometry></{kind}>'
