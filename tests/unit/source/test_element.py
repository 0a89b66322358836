"""The object model: names as written, values with their places."""

from __future__ import annotations

from pathlib import Path

import pytest

from sdfcheck.source.document import Element, read

# Once with all prefixes declared, once with none: they are read as text either way.
BODY = (
    '<world name="W" flatland:type="2d" xml:lang="en"><!-- c --><flatland:description>of <b/> it</flatland:description>'
    '<model name="M1"><link name="L1" flatland:str="A" flatland:int="5"/><link name="L2"/><mass> 1.5 </mass>'
    "<static>true</static><flatland:gear><flatland:ratio>3</flatland:ratio></flatland:gear></model></world>"
)
DECLARED = f'<sdf version="1.6" xmlns:flatland="http://example.org/flatland">{BODY}</sdf>'
UNDECLARED = f'<sdf version="1.6">{BODY}</sdf>'
FAULTY = f'<sdf version="1.6">{BODY}<!-- -- --></sdf>'


@pytest.fixture(params=[DECLARED, UNDECLARED, FAULTY], ids=["declared", "undeclared", "faulty"])
def world(request: pytest.FixtureRequest) -> Element:
    root = read(request.param.encode(), Path("example.sdf")).root
    assert root is not None
    found = root.find("world")
    assert found is not None
    return found


def model_of(world: Element) -> Element:
    found = world.find("model")
    assert found is not None
    return found


def test_names_are_as_written(world: Element) -> None:
    assert [child.name for child in world.children()] == ["flatland:description", "model"]
    assert [child.is_custom for child in world.children()] == [True, False]
    assert world.attributes == {"name": "W", "flatland:type": "2d", "xml:lang": "en"}


def test_finding_children(world: Element) -> None:
    model = model_of(world)
    assert world.has("flatland:description")
    assert not world.has("description")
    assert world.find("nothing") is None
    assert [link.attributes["name"] for link in model.children("link")] == ["L1", "L2"]
    assert model.parent == world


def test_next_siblings(world: Element) -> None:
    link = model_of(world).find("link")
    assert link is not None
    assert (second := link.next("link")) is not None
    assert second.attributes["name"] == "L2"
    assert second.next("link") is None
    assert (mass := second.next()) is not None
    assert mass.name == "mass"
    assert (gear := mass.next("flatland:gear")) is not None
    assert gear.next() is None


def test_typed_values(world: Element) -> None:
    model = model_of(world)
    link = model.find("link")
    assert link is not None
    assert link.get("flatland:int", int) == 5
    assert link.get("flatland:int") == "5"
    assert link.get("flatland:str") == "A"
    assert link.get("int") is None
    assert model.get("mass", float) == 1.5
    assert model.get("static", bool) is True
    assert (gear := model.find("flatland:gear")) is not None
    assert gear.get("flatland:ratio", int) == 3


def test_a_value_of_another_type_says_where(world: Element) -> None:
    with pytest.raises(ValueError, match=r"example\.sdf:1:\d+: flatland:str is 'A', not int"):
        world.find("model").find("link").get("flatland:str", int)  # type: ignore[union-attr]
    with pytest.raises(ValueError, match="not bool"):
        model_of(world).get("mass", bool)


def test_numbers(world: Element) -> None:
    model = model_of(world)
    assert (mass := model.number("mass")) is not None
    assert mass.number == 1.5
    assert mass.span.text == "1.5"
    assert model.number("static") is None
    assert model.number("nothing") is None


def test_values_know_where_they_are(world: Element) -> None:
    value = world.attribute("flatland:type")
    assert value is not None
    assert (value.text, value.span.text, value.name_span.text) == ("2d", "2d", "flatland:type")
    assert world.attribute("type") is None


def test_the_content_ends_at_the_first_child(world: Element) -> None:
    description = world.find("flatland:description")
    assert description is not None
    assert description.content == "of"


def test_a_title_has_the_name_if_there_is_one(world: Element) -> None:
    assert world.title == "world `W`"
    assert (mass := model_of(world).find("mass")) is not None
    assert mass.title == "`mass`"


def test_a_default_namespace_changes_no_name() -> None:
    root = read(b'<sdf xmlns="urn:x" version="1.6"><model/></sdf>', Path("example.sdf")).root
    assert root is not None
    assert root.name == "sdf"
    assert root.has("model")
    assert root.attributes == {"version": "1.6"}
