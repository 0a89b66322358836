"""Includes written out: URDF converted, parameters carried out, places in the files where they were."""

from __future__ import annotations

from pathlib import Path

import pytest

from sdfcheck.convert.include_expansion import needs_writing_out
from sdfcheck.convert.migrate.migrate import written_out
from sdfcheck.files.library import Library
from sdfcheck.source.document import Document, Element, read

PART = """\
<sdf version="1.12"><model name="part">
  <link name="a"><gravity>true</gravity></link>
  <link name="b"/>
  <model name="inner">
    <link name="c"><visual name="v"><transparency>0</transparency><geometry><box/></geometry></visual></link>
  </model>
  <joint name="j" type="fixed"><parent>a</parent><child>b</child></joint>
</model></sdf>
"""
ROBOT = '<robot name="part"><link name="a"/><gazebo><plugin filename="p" name="p"/></gazebo></robot>'


def included(folder: Path, parameters: str = "", file: str = "part.sdf") -> Document:
    (folder / "part.sdf").write_text(PART)
    (folder / "part.urdf").write_text(ROBOT)
    params = f"<experimental:params>{parameters}</experimental:params>" if parameters else ""
    text = f"""\
<sdf version="1.12" xmlns:experimental="urn:experimental">
<model name="m">
<include><uri>{file}</uri>{params}</include>
</model></sdf>
"""
    document = read(text.encode(), folder / "m.sdf")
    document.library = Library()
    return document


def below(document: Document, name: str) -> Element:
    """The only element of a name."""
    (element,) = (element for element in document.elements if element.name == name)
    return element


@pytest.mark.parametrize(
    ("parameters", "present", "absent"),
    [
        ('<link element_id="a"><gravity action="modify">false</gravity></link>', "<gravity>false", "<gravity>true"),
        ('<link element_id="a" action="modify"><gravity>false</gravity></link>', "<gravity>false", "<gravity>true"),
        ('<link element_id="a"><gravity action="remove"/></link>', '<link name="a"/>', "<gravity>"),
        ('<link element_id="b" action="remove"/>', '<link name="a"', '<link name="b"'),
        ('<link element_id="b" action="modify" name="z"/>', '<link name="z"/>', '<link name="b"'),
        ('<link element_id="inner::c"><visual name="n" action="modify"><transparency>1</transparency></visual></link>',
         "<transparency>1</transparency>", "<transparency>0</transparency>"),
        ('<link element_id="b" action="replace" name="z"><kinematic>1</kinematic></link>',
         '<link name="z">', '<link name="b"'),
        ('<link element_id="inner::c"><gravity action="add">0</gravity></link>', "<gravity>0</gravity>", "element_id"),
        ('<frame element_id="" name="f" action="add"/>', '<frame name="f"/>', "action"),
        ('<joint element_id="j"><pose action="add">1 0 0 0 0 0</pose></joint>', "<pose>1 0 0", "experimental:params"),
    ],
)  # fmt: skip
def test_parameters(tmp_path: Path, parameters: str, present: str, absent: str) -> None:
    document = included(tmp_path, parameters)
    assert not needs_writing_out(document)
    done, expansion = written_out(document)
    assert not expansion.notes
    assert present in done.source.text
    assert absent not in done.source.text


def test_faulty_parameters_are_not_carried_out(tmp_path: Path) -> None:
    document = included(tmp_path, '<link element_id="none" action="remove"/>')
    done, expansion = written_out(document)
    (note,) = expansion.notes
    assert done is document
    assert "at fault" in note


def test_urdf_becomes_a_model(tmp_path: Path) -> None:
    document = included(tmp_path, file="part.urdf")
    assert needs_writing_out(document)
    done, _ = written_out(document)
    assert '<model name="part">' in done.source.text
    plugin = below(done, "plugin")
    assert plugin.span.source is document.source
    assert plugin.span.begin.line == 3


def test_places_are_those_of_the_included_file(tmp_path: Path) -> None:
    document = included(tmp_path, '<link element_id="b" action="remove"/>')
    done, _ = written_out(document)
    joint = below(done, "joint")
    assert joint.span.source.path.name == "part.sdf"
    assert joint.span.begin.line == 7


def test_plain_includes_need_no_writing_out(tmp_path: Path) -> None:
    assert not needs_writing_out(included(tmp_path))


def test_an_include_of_nothing_hides_no_other(tmp_path: Path) -> None:
    document = included(tmp_path, file="none.sdf</uri></include><include><uri>part.urdf")
    assert needs_writing_out(document)
