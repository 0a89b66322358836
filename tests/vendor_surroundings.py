"""The standard elements around a vendor's tags in documents made for tests."""

from __future__ import annotations

from sdfcheck.formats.vendor.definitions import Step

BOX = {
    "sdf": "<geometry><box><size>1 1 1</size></box></geometry>",
    "urdf": '<geometry><box size="1 1 1"/></geometry>',
}

_MASS = '<inertial><mass value="1"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial>'
_OF_DEFORMABLES = ("<drake:deformable_properties", "<drake:wall_boundary")
_LIMIT = '<limit lower="-1" upper="1" effort="5" velocity="2"/>'


def model(inner: str) -> str:
    """An SDF model of links a, b, c, d, and a joint k between the last two."""
    links = "".join(f'<link name="{name}"/>' for name in "abcd")
    k = (
        '<joint name="k" type="revolute"><parent>c</parent><child>d</child>'
        "<axis><xyz>0 0 1</xyz></axis></joint>"
    )
    whole = f'<model name="m">{links}{k}{inner}</model>'
    return f'<sdf version="1.9" xmlns:drake="http://drake.mit.edu">{whole}</sdf>'


def robot(inner: str) -> str:
    """The same in URDF."""
    links = "".join(f'<link name="{name}">{_MASS}</link>' for name in "abcd")
    k = f'<joint name="k" type="revolute"><parent link="c"/><child link="d"/>{_LIMIT}</joint>'
    return f'<robot name="m" xmlns:drake="http://drake.mit.edu">{links}{k}{inner}</robot>'


TOPS = {"model": model, "robot": robot}


def link(step: Step, inner: str, is_sdf: bool) -> str:
    """A link l, deformable where what is in it asks for that."""
    if step.attribute or any(tag in inner for tag in _OF_DEFORMABLES):
        own = "" if _OF_DEFORMABLES[0] in inner else "<drake:deformable_properties/>"
        mesh = "<geometry><mesh><uri>dummy.vtk</uri></mesh></geometry>"
        return f'<link name="l"><collision name="c">{mesh}</collision>{own}{inner}</link>'
    return f'<link name="l">{"" if is_sdf else _MASS}{inner}</link>'


def joint(step: Step, inner: str, is_sdf: bool) -> str:
    """A joint j between a and b."""
    kind = "revolute" if not step.values or "revolute" in step.values else step.values[0]
    if is_sdf:
        ends = "<parent>a</parent><child>b</child>"
        ends += "" if inner.startswith("<axis") else "<axis><xyz>0 0 1</xyz></axis>"
    else:
        ends = '<parent link="a"/><child link="b"/>'
        ends += "" if "<limit" in inner else _LIMIT
    return f'<joint name="j" type="{kind}">{ends}{inner}</joint>'


PARTS = {"joint": joint, "link": link}
