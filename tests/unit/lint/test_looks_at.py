"""Rules that look at objects of the robot, and the conditions that are asked before their checks."""

from __future__ import annotations

import sys
from collections.abc import Iterable, Iterator
from pathlib import Path
from types import ModuleType
from typing import ClassVar, NamedTuple

import pytest

from sdfcheck.consumers.reaction import REFUSES, Affects, Consumer
from sdfcheck.lint.config.settings import UNSET
from sdfcheck.lint.diagnostic import Diagnostic, Severity
from sdfcheck.lint.engine import Dispatch
from sdfcheck.lint.one_file import lint_source
from sdfcheck.lint.rule import Rule
from sdfcheck.lint.rulebook.pack import describe
from sdfcheck.lint.rulebook.packs import RuleIndex, load_index
from sdfcheck.lint.select import ActiveRules, select
from sdfcheck.lint.subjects import Subjects, is_extension
from sdfcheck.source.document import Document, Element, read
from sdfcheck.source.text import Span

TEXT = '<sdf version="1.12"><model name="m"><link name="a"/><link name="bb"/><frame name="cc"/></model></sdf>'


class Link(NamedTuple):
    element: Element
    name: str

    @property
    def span(self) -> Span:
        return self.element.span


class Frame(NamedTuple):
    element: Element
    name: str

    @property
    def span(self) -> Span:
        return self.element.span


KINDS = {"Link": Link, "Frame": Frame}


class Root:
    """A view of a document that has links and frames."""

    def __init__(self, document: Document) -> None:
        self.document = document

    def each(self, kind: str) -> Iterable[object]:
        for element in self.document.elements:
            if element.name.title() == kind:
                yield KINDS[kind](element, str(element.attributes["name"]))

    def made_of(self, elements: Iterable[Element], kind: str) -> Iterable[object]:
        return (each for each in self.each(kind) if any(each.element is e for e in elements))  # type: ignore[attr-defined]


class LongName(Rule):
    """A name is long."""

    code = "XYZ001"
    name = "long-name"
    severity = Severity.WARNING
    looks_at = (Link, Frame)
    bad = ()
    good = ()

    @staticmethod
    def applies(named: Link | Frame) -> bool:
        return len(named.name) > 1

    def check(self, named: Link | Frame) -> Iterator[Diagnostic]:
        yield self.diagnostic(named, f"long name {named.name}")


class AnyLink(Rule):
    """There is a link, seen as an element and as an object."""

    code = "XYZ002"
    name = "any-link"
    severity = Severity.INFO
    default = False
    affects: ClassVar[Affects] = {Consumer.DRAKE: REFUSES}
    looks_at = (Element, Link)
    selects = ("sdf:model/link", "urdf:robot/link")
    bad = ()
    good = ()

    def check(self, link: Element | Link) -> Iterator[Diagnostic]:
        if isinstance(link, Element):
            yield self.diagnostic(link, "an element")
        else:
            yield self.diagnostic(link.element, f"the object {link.name}")


class LinkInModel(Rule):
    """A link is in a model, seen as an object."""

    code = "XYZ004"
    name = "link-in-model"
    severity = Severity.INFO
    looks_at = (Link, Frame)
    selects = ("sdf:model/link", "urdf:joint/frame")
    bad = ()
    good = ()

    def check(self, named: Link | Frame) -> Iterator[Diagnostic]:
        yield self.diagnostic(named, f"{type(named).__name__} {named.name}")


class Broken(Rule):
    """The condition or the check fails."""

    code = "XYZ003"
    name = "broken"
    severity = Severity.INFO
    looks_at = (Link, Frame)
    bad = ()
    good = ()

    @staticmethod
    def applies(named: Link | Frame) -> bool:
        return bool(1 / (len(named.name) - 1))

    def check(self, named: Link | Frame) -> Iterator[Diagnostic]:
        yield self.diagnostic(named.element, f"fine {named.name}")
        raise ValueError(named.name)


@pytest.fixture(autouse=True)
def root(monkeypatch: pytest.MonkeyPatch) -> None:
    module = ModuleType("sdfcheck.robot.root")
    module.root_of = lambda document: document.view(Root)  # type: ignore[attr-defined]
    module.ELEMENTS = {}  # type: ignore[attr-defined]
    monkeypatch.setitem(sys.modules, module.__name__, module)
    monkeypatch.delenv("SDFCHECK_DEBUG", raising=False)


def lint(*rules: type[Rule], text: str = TEXT, severity: Severity | None = None) -> list[Diagnostic]:
    index = RuleIndex([describe(rule) for rule in rules])
    levels = {rule.code: severity for rule in rules if severity is not None}
    found = lint_source(text.encode(), Path("a.sdf"), None, Dispatch(index, ActiveRules(index.facts, levels)))
    return [d for d in found.diagnostics if d.code.startswith("XYZ") or d.code == "INT001"]


def test_objects_of_several_classes_are_looked_at() -> None:
    found = lint(LongName)
    assert [(d.message, d.span.text) for d in found] == [("long name bb", "link"), ("long name cc", "frame")]
    assert {d.severity for d in lint(LongName, severity=Severity.ERROR)} == {Severity.ERROR}


def test_selectors_narrow_the_objects() -> None:
    assert [d.message for d in lint(LinkInModel)] == ["Link a", "Link bb"]
    assert lint(LinkInModel, text='<sdf version="1.12"><world name="w"/></sdf>') == []


def test_objects_and_elements_are_looked_at_together() -> None:
    messages = [d.message for d in lint(AnyLink)]
    assert sorted(messages) == ["an element", "an element", "the object a", "the object bb"]
    assert [d.message for d in lint(AnyLink, text='<robot name="r"><link name="a"/></robot>')] == [
        "an element",
        "the object a",
    ]


def test_check_runs_only_where_the_condition_applies(monkeypatch: pytest.MonkeyPatch) -> None:
    seen: list[str] = []

    def check(self: Rule, named: Link) -> tuple[()]:
        seen.append(named.name)
        return ()

    monkeypatch.setattr(LongName, "check", check)
    assert lint(LongName) == []
    assert seen == ["bb", "cc"]


def test_a_rule_whose_condition_never_applies_is_not_loaded(monkeypatch: pytest.MonkeyPatch) -> None:
    conditions = ModuleType("conditions_of_nobody")
    conditions.CONDITIONS = {"XYZ001": lambda named: False}  # type: ignore[attr-defined]
    monkeypatch.setitem(sys.modules, conditions.__name__, conditions)
    facts = describe(LongName)._replace(module="rule_that_is_not_there")
    index = RuleIndex([facts], conditions=[conditions.__name__])
    dispatch = Dispatch(index, ActiveRules(index.facts, {}))
    found = lint_source(TEXT.encode(), Path("a.sdf"), None, dispatch).diagnostics
    assert found == []


def test_without_the_module_of_conditions_the_rules_are_loaded() -> None:
    facts = describe(LongName)
    index = RuleIndex([facts], conditions=["sdfcheck_rules.conditions_that_nobody_wrote"])
    index._rules[facts.code] = LongName()
    assert index.condition(facts) == LongName.applies


def test_a_failing_condition_is_one_diagnostic() -> None:
    (first, *rest) = lint(Broken, LongName)
    assert (first.code, first.severity) == ("INT001", Severity.ERROR)
    assert "XYZ003 broken failed at " in first.message
    assert "ZeroDivisionError" in first.message
    assert [d.code for d in rest] == ["XYZ001", "XYZ001"]


def test_a_failing_check_is_one_diagnostic(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delattr(Broken, "applies")
    failure, before = lint(Broken, severity=Severity.WARNING)
    assert (failure.code, failure.severity) == ("INT001", Severity.ERROR)
    assert "ValueError: a" in failure.message
    assert (before.message, before.severity) == ("fine a", Severity.WARNING)


def test_a_rule_for_one_simulator_runs_for_its_target_only() -> None:
    index = RuleIndex([describe(AnyLink), describe(LongName)])
    for targets, codes in (((), {"XYZ001"}), (("drake",), {"XYZ001", "XYZ002"})):
        dispatch = Dispatch(index, select(index.facts, UNSET, targets))
        found = lint_source(TEXT.encode(), Path("a.sdf"), None, dispatch).diagnostics
        assert {d.code for d in found} == codes


@pytest.mark.parametrize("text", ["<model><name>long</name></model>", "", "<!-- nothing -->"])
def test_other_documents_have_no_objects(text: str) -> None:
    assert lint(LongName, AnyLink, text=text) == []


def test_elements_in_gazebo_blocks_are_extensions() -> None:
    text = b'<robot name="r"><link name="a"/><gazebo reference="a"><mu1 value="1"/></gazebo></robot>'
    document = read(text, Path("r.urdf"))
    root = document.root
    assert root is not None
    of_robot, of_gazebo = root.find("link"), next(each for each in root.below if each.name == "mu1")
    assert is_extension(of_gazebo, document)
    assert not is_extension(of_robot, document)


@pytest.mark.parametrize(
    "file", ["diff_drive/model.sdf", "desk_arm/desk_arm.urdf", "diff_drive/model.config"]
)
def test_subjects_that_do_not_occur_in_a_kind_of_document_are_none(file: str) -> None:
    path = Path(__file__).parents[3] / "fixtures" / "robots" / file
    document = read(path.read_bytes(), path)
    groups = [Subjects(each.looks_at, each.selects, each.needs) for each in load_index().facts]
    looking = [group for group in groups if group.looks_at or group.selects]
    absent = [group for group in looking if not group.occur_in(document.kind)]
    assert 0 < len(absent) < len(looking)
    assert not any(group.of(document) for group in absent)
