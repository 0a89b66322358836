"""XML Schema and RELAX NG that are made from the tables."""

from __future__ import annotations

import shutil
import subprocess
from functools import cache
from pathlib import Path

import pytest
from lxml import etree

from sdfcheck.formats.export import definitions, name_of, rng, xsd
from sdfcheck.formats.sdf.schema import schema
from sdfcheck.formats.version import NEWEST, Version

FIXTURES = Path(__file__).parents[3] / "fixtures"
SOUND = ("diff_drive/model.sdf", "two_link_arm/model.sdf", "workcell/workcell.world")
VERSIONS = [Version(1, minor) for minor in range(2, 13)]


@cache
def by_xsd(version: Version) -> etree.XMLSchema:
    return etree.XMLSchema(etree.fromstring(xsd(version).encode()))


@cache
def by_rng(version: Version) -> etree.RelaxNG:
    return etree.RelaxNG(etree.fromstring(rng(version).encode()))


def verdicts(text: str, version: Version = NEWEST) -> tuple[bool, bool]:
    """What XML Schema and RELAX NG say."""
    tree = etree.fromstring(text.encode())
    return by_xsd(version).validate(tree), by_rng(version).validate(tree)


def model(inside: str, version: Version = NEWEST) -> tuple[bool, bool]:
    return verdicts(f'<sdf version="{version}"><model name="m">{inside}</model></sdf>', version)


@pytest.mark.parametrize("version", VERSIONS, ids=str)
def test_every_version_compiles_and_takes_a_model(version: Version) -> None:
    assert model('<link name="l"><pose>0 0 1 0 0 0</pose></link>', version) == (True, True)
    assert model('<lnk name="l"/>', version) == (False, False)


def test_of_the_version_that_is_declared() -> None:
    assert verdicts('<sdf version="1.6"/>') == (False, False)
    assert verdicts("<sdf/>") == (False, False)
    assert model('<link name="l"/><include merge="true"><uri>a</uri></include>', Version(1, 8)) == (
        False,
        False,
    )
    assert model('<link name="l"/><include merge="true"><uri>a</uri></include>', Version(1, 9)) == (
        True,
        True,
    )


@pytest.mark.parametrize(
    "inside",
    [
        '<joint type="fixed" name="j"><child>b</child><parent>a</parent></joint><link name="a"/><link name="b"/>',
        '<pose degrees="true">0 0 0\n  0 90 0</pose><static>True</static>',
        '<pose rotation_format="quat_xyzw">0 0 0 0 0 0 1</pose>',
        '<model name="n"><model name="o"><link name="l"/></model></model>',
        '<plugin filename="f" name="p" x="1">text<a><link/></a> more</plugin>',
        '<plugin filename="f"/>',
        '<link name="l" p:k="1" xmlns:p="urn:p"><p:a><link/></p:a><p:a/></link>',
        '<pose p:k="1" xmlns:p="urn:p">0 0 0 0 0 0</pose>',
        '<joint type="Revolute" name="j"><parent>a</parent><child>b</child><axis><xyz>0 0 1.</xyz></axis></joint>',
        '<joint type="prismatic" name="j"><parent>a</parent><child>b</child>{}</joint>'.format(
            "<axis><xyz>1 0 0</xyz><limit><lower>-inf</lower><upper>+1e3</upper></limit></axis>"
        ),
        '<link name="l"><visual name="v"><geometry><box><size> 1 .5\t1 </size></box></geometry></visual></link>',
        "<self_collide/><!-- nothing: the default -->",
    ],
)
def test_sound(inside: str) -> None:
    assert model(inside) == (True, True)


@pytest.mark.parametrize(
    "inside",
    [
        "<link/>",
        '<link name=""/>',
        '<link name="l" kind="x"/>',
        "<pose>0 0 0</pose>",
        "<pose>0 0 0 0 0 0,5</pose>",
        "<static>yes</static>",
        '<joint type="hinge" name="j"><parent>a</parent><child>b</child></joint>',
        '<link name="l"><visual name="v"><geometry><sphere><radius>-1</radius></sphere></geometry></visual></link>',
        '<link name="l">text</link>',
        '<plugin name="p"/>',
    ],
)
def test_unsound(inside: str) -> None:
    assert model(inside) == (False, False)


@pytest.mark.parametrize(
    "inside",
    [
        "<static>true</static><static>false</static>",
        '<joint type="fixed" name="j"><parent>a</parent></joint>',
        '<link name="l"><visual name="v"><geometry><box/></geometry></visual></link>',
    ],
)
def test_only_relax_ng_counts(inside: str) -> None:
    assert model(inside) == (True, False)


def test_polylines_make_one_shape() -> None:
    line = "<polyline><height>1</height><point>0 0</point><point>0 1</point></polyline>"
    shape = f'<link name="l"><visual name="v"><geometry>{line}{line}</geometry></visual></link>'
    assert model(shape) == (True, True)


def test_an_older_document_may_name_a_newer_sensor() -> None:
    inside = '<link name="l"><sensor name="s" type="lidar"/></link>'
    assert model(inside, Version(1, 5)) == (True, True)


@pytest.mark.parametrize("version", VERSIONS, ids=str)
def test_names_of_definitions_are_their_own(version: Version) -> None:
    for name, definition in definitions(schema(version)).items():
        assert name == name_of(definition)
        for child in definition.children.values():
            found = definitions(schema(version))[name_of(child)] if version == NEWEST else child
            assert (found.place, found.type) == (child.place, child.type)


@pytest.mark.skipif(shutil.which("xmllint") is None, reason="xmllint is not installed")
@pytest.mark.parametrize("file", SOUND)
def test_xmllint_agrees(file: str, tmp_path: Path) -> None:
    path = FIXTURES / "robots" / file
    version = Version.parse(etree.parse(path).getroot().get("version", ""))
    assert version is not None
    for option, text in (("--schema", xsd(version)), ("--relaxng", rng(version))):
        written = tmp_path / option
        written.write_text(text, encoding="utf-8")
        command = ["xmllint", "--noout", option, str(written), str(path)]
        child = subprocess.run(command, capture_output=True, text=True, check=False)
        assert child.returncode == 0, child.stderr
