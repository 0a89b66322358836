from pathlib import Path

import pytest

from sdfcheck.source.sniff import HEAD, Kind, Treatment, sniff, treatment

ETHANOL = b"ethanol\n  RDKit\n\n  9  8  0     0  0  0  0  0  0999 V2000\n> <PUBCHEM_ID>\n1\n\nM  END\n$$$$\n"


@pytest.mark.parametrize(
    ("name", "content", "kind"),
    [
        ("a.sdf", b'<?xml version="1.0"?>\n<sdf version="1.9"></sdf>', Kind.SDF),
        ("a.sdf", b'\n\n<?xml version="1.0"?><!-- > <robot> --><sdf version="1.9"/>', Kind.SDF),
        ("a.sdf", b'\xef\xbb\xbf<sdf version="1.9"/>', Kind.SDF),
        ("a.sdf", '\ufeff<sdf version="1.9"/>'.encode("utf-16-le"), Kind.SDF),
        ("a.sdf", '<sdf version="1.9"/>'.encode("utf-16"), Kind.SDF),
        ("a.sdf", '<sdf version="1.9"/>'.encode("utf-16-be"), Kind.SDF),
        ("a.sdf", b'<!DOCTYPE sdf [<!ENTITY a "<b>">]><sdf/>', Kind.SDF),
        ("a.sdf", b'<!DOCTYPE sdf SYSTEM "x.dtd"><sdf/>', Kind.SDF),
        ("a.sdf", b'<sdf version="1.9"/>\0', Kind.SDF),
        ("a.sdf", b'<gazebo version="1.0"><world/></gazebo>', Kind.SDF),
        ("a.urdf", b'<robot name="r"><link name="@NAME@"/></robot>', Kind.TEMPLATE),
        ("a.urdf", b'<robot name="a@b.org"><!-- "@NAME@" --><link name="b@c@d"/></robot>', Kind.URDF),
        ("a.world", b"<world name='w'/>", Kind.SDF),
        ("a.urdf", b'<robot name="r"/>', Kind.URDF),
        ("a.urdf", b'<robot xmlns:xacro="http://www.ros.org/wiki/xacro" name="r"/>', Kind.URDF),
        ("a.urdf", b'<robot name="r"><!-- <xacro:leg/> <group_state/> --></robot>', Kind.URDF),
        ("a.urdf", b'<robot name="r"><xacro:leg/></robot>', Kind.XACRO),
        ("a.SDF.XACRO", b'<sdf version="1.9"/>', Kind.XACRO),
        ("a.xacro", b"<root/>", Kind.XACRO),
        ("a.xacro.urdf", b'<robot name="r"/>', Kind.XACRO),
        ("model.config", b'<model><name>m</name><sdf version="1.9">m.sdf</sdf></model>', Kind.MODEL_CONFIG),
        ("model.config", b"<configuration/>", Kind.OTHER_XML),
        ("a.sdf", b'<element name="link" required="0"/>', Kind.SDF_SPECIFICATION),
        ("a.sdf", b'<plugin name="p" filename="f"/>', Kind.OTHER_XML),
        ("a.urdf", b'<robt name="r"/>', Kind.MISSPELT_ROOT),
        ("a.world", b'<sdff version="1.9"/>', Kind.MISSPELT_ROOT),
        ("a.sdf", b'<SDF version="1.9"/>', Kind.MISSPELT_ROOT),
        ("a.xacro", b'<rboot name="r"/>', Kind.MISSPELT_ROOT),
        ("a.xacro", b"<robots/>", Kind.XACRO),
        ("a.xacro", b'<root name="r"/>', Kind.XACRO),
        ("a.xml", b'<robt name="r"/>', Kind.OTHER_XML),
        ("a.srdf", b'<robot name="r"/>', Kind.SRDF),
        ("a.srdf.xacro", b'<robot name="r"/>', Kind.SRDF),
        ("a.xml", b'<robot name="r"><group_state name="s"/></robot>', Kind.SRDF),
        (
            "a.xml",
            b'<robot name="r"><xacro:macro name="m"><disable_collisions link1="a"/></xacro:macro></robot>',
            Kind.SRDF,
        ),
        (
            "a.urdf",
            b'<robot name="r"><gazebo><plugin><disable_collisions_on_attach/></plugin></gazebo></robot>',
            Kind.URDF,
        ),
        (
            "a.urdf",
            b'<robot name="r"><link name="l"/><disable_collisions link1="l" link2="l"/></robot>',
            Kind.URDF,
        ),
        (
            "a.urdf",
            b'<robot name="r"><gazebo><plugin><group_state/></plugin></gazebo></robot>',
            Kind.URDF,
        ),
        ("a.urdf", b'<robot name="r"><webots><device/></webots><ros2_control/></robot>', Kind.WEBOTS),
        ("a.urdf", b'<robot name="r"><webots/><link name="l"/></robot>', Kind.URDF),
        ("a.xacro", b'<robot name="r"><webots/><gazebo/></robot>', Kind.XACRO),
        (
            "a.urdf",
            b'<robot xmlns:xacro="x"><material name="m"><color rgba="${1/2} 0 0 1"/></material></robot>',
            Kind.XACRO,
        ),
        ("a.urdf", b'<robot xmlns:xacro="x"><link name="${l}"/></robot>', Kind.URDF),
        ("a.xml", b'<mujoco model="m"/>', Kind.MJCF),
        ("a.sdf", b'?xml version="1.0"?>\n<sdf version="1.9"/>', Kind.BROKEN_XML),
        ("a.sdf", b'<<sdf version="1.9"/>', Kind.BROKEN_XML),
        ("a.sdf", b'<?xml version="1.0"?>\n', Kind.BROKEN_XML),
        ("a.sdf", b"<!-- never closed <sdf/>", Kind.BROKEN_XML),
        ("a.sdf", ETHANOL, Kind.CHEMISTRY),
        ("a.sdf", b'(DELAYFILE (SDFVERSION "3.0"))', Kind.NOT_XML),
        ("a.urdf", b"robot: {links: []}", Kind.NOT_XML),
        ("a.sdf", b"<sdf><% if x %></sdf>", Kind.TEMPLATE),
        ("a.sdf", b"{% set x = 1 %}<sdf/>", Kind.TEMPLATE),
        ("a.sdf", b"<sdf><!-- <% %> --></sdf>", Kind.SDF),
        ("a.sdf.jinja", b"<sdf>{{ x }}</sdf>", Kind.TEMPLATE),
        ("a.sdf.in", b"<sdf>@X@</sdf>", Kind.TEMPLATE),
        ("a.sdf.in", b"<sdf></sdf>", Kind.SDF),
        ("a.sdf", b"<sdf>{{ json }} me@home</sdf>", Kind.SDF),
        ("a.sdf", b"version https://git-lfs.github.com/spec/v1\noid sha256:0\nsize 3\n", Kind.LFS_POINTER),
        ("a.sdf", b"\x01\0\0\0SQLCE", Kind.BINARY),
        ("a.sdf", bytes(range(1, 256)), Kind.BINARY),
        ("a.sdf", b"", Kind.EMPTY),
        ("a.sdf", b"\xef\xbb\xbf \r\n", Kind.EMPTY),
    ],
)
def test_content_decides(name: str, content: bytes, kind: Kind) -> None:
    assert sniff(content, Path(name)) is kind


def test_only_the_head_is_looked_at() -> None:
    content = b"<robot>" + b" " * HEAD + b"<xacro:leg/></robot>"
    assert sniff(content, Path("a.urdf")) is Kind.URDF


@pytest.mark.parametrize(
    ("kind", "name", "walked", "named"),
    [
        (Kind.SDF, "a.sdf", Treatment.LINT, Treatment.LINT),
        (Kind.CHEMISTRY, "a.sdf", Treatment.SKIP, Treatment.NOTICE),
        (Kind.LFS_POINTER, "a.sdf", Treatment.WARN, Treatment.WARN),
        (Kind.NOT_XML, "a.sdf", Treatment.SKIP, Treatment.LINT),
        (Kind.NOT_XML, "model.config", Treatment.SKIP, Treatment.LINT),
        (Kind.NOT_XML, "a.URDF", Treatment.LINT, Treatment.LINT),
        (Kind.NOT_XML, "stage.world", Treatment.SKIP, Treatment.LINT),
        (Kind.OTHER_XML, "a.urdf", Treatment.LINT, Treatment.LINT),
        (Kind.OTHER_XML, "a.sdf", Treatment.SKIP, Treatment.NOTICE),
        (Kind.MISSPELT_ROOT, "a.sdf", Treatment.LINT, Treatment.LINT),
        (Kind.BINARY, "a.urdf", Treatment.SKIP, Treatment.REFUSE),
        (Kind.EMPTY, "a.sdf", Treatment.LINT, Treatment.LINT),
    ],
)
def test_treatment(kind: Kind, name: str, walked: Treatment, named: Treatment) -> None:
    assert treatment(kind, Path(name), named=False) is walked
    assert treatment(kind, Path(name), named=True) is named


def test_every_kind_has_a_treatment() -> None:
    for kind in Kind:
        treatment(kind, Path("a.sdf"), named=True)
