"""Files that exceed the limits: each ends in a problem with a place."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest

from sdfcheck.source.document import read
from sdfcheck.source.sniff import Kind
from sdfcheck.xacro.expansion import Expander, Surroundings
from sdfcheck.xacro.problems import ExpansionFailure, Failure, Problem, UndefinedProperty, XacroIncludeCycle
from sdfcheck.xacro.process.watch import Limits

HEAD = '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">'
REACH = "(lambda: [c for c in ().__class__.__base__.__subclasses__()][0])()"


@pytest.fixture(scope="module")
def expander() -> Iterator[Expander]:
    with Expander(Surroundings(limits=Limits(cpu=1, wall=4, memory=400_000_000, output=5_000_000))) as one:
        yield one


def problem(expander: Expander, folder: Path, body: str) -> Problem:
    path = folder / "r.xacro"
    path.write_text(f"{HEAD}\n{body}\n</robot>")
    expansion = expander.expand(read(path.read_bytes(), path, Kind.XACRO))
    assert expansion.text is None, expansion.text
    (found,) = expansion.problems
    return found


def failure(expander: Expander, folder: Path, body: str) -> ExpansionFailure:
    found = problem(expander, folder, body)
    assert isinstance(found, ExpansionFailure), found
    assert "Traceback" not in found.detail
    return found


@pytest.mark.parametrize(
    ("body", "place"),
    [
        ("<a b=\"${'x' * 10**9}\"/>", "${'x' * 10**9}"),
        ("<a b=\"${'x' * 10**8}\"/>", "${'x' * 10**8}"),
        ('<a b="${[0] * 10**10}"/>', "${[0] * 10**10}"),
        ('<a b="${len([x for x in range(10**12)])}"/>', None),
        (
            '<xacro:property name="p" value="${[y for x in range(10**9) for y in [0] if 0]}"/><a b="${p}"/>',
            None,
        ),
    ],
)
def test_greed_for_memory_and_time(expander: Expander, tmp_path: Path, body: str, place: str | None) -> None:
    found = failure(expander, tmp_path, body)
    assert found.kind is Failure.LIMIT
    assert found.span.begin.line == 2
    if place:
        assert found.span.text == place


def test_a_computation_that_python_cannot_interrupt(expander: Expander, tmp_path: Path) -> None:
    found = failure(expander, tmp_path, '<a/>\n<b c="${python.sum(range(10**15))}"/>')
    assert found.kind is Failure.LIMIT
    assert (found.span.text, found.span.begin.line) == ("b", 3)


def test_macros_that_grow_without_end(expander: Expander, tmp_path: Path) -> None:
    body = "".join(
        f'<xacro:macro name="m{n}" params=""><xacro:m{n + 1}/><xacro:m{n + 1}/></xacro:macro>'
        for n in range(40)
    )
    found = failure(
        expander, tmp_path, f'{body}<xacro:macro name="m40" params=""><a/></xacro:macro>\n<xacro:m0/>'
    )
    assert found.kind is Failure.LIMIT


def test_a_macro_that_calls_itself(expander: Expander, tmp_path: Path) -> None:
    body = '<xacro:macro name="m" params="n">\n<xacro:m n="${n}"/></xacro:macro>\n<xacro:m n="1"/>'
    found = failure(expander, tmp_path, body)
    assert found.kind is Failure.RECURSION
    assert found.span.begin.line == 3
    assert [step.span.begin.line for step in found.origins] == [4]


def test_a_file_that_includes_itself(expander: Expander, tmp_path: Path) -> None:
    found = problem(expander, tmp_path, '<xacro:include filename="r.xacro"/>')
    assert isinstance(found, XacroIncludeCycle)
    assert found.span.text == "r.xacro"


def test_a_property_made_of_itself(expander: Expander, tmp_path: Path) -> None:
    found = failure(expander, tmp_path, '<xacro:property name="p" value="${p + 1}"/><a b="${p}"/>')
    assert "circular" in found.detail
    assert found.span.begin.line == 2


@pytest.mark.parametrize(
    "code",
    [
        "().__class__",
        REACH,
        "(x for x in [1]).gi_frame.f_back",
        "[f.gi_code for f in [(x for x in [1])]]",
        "(lambda: (lambda: ().__class__)())()",
    ],
)
def test_expressions_that_reach_for_the_interpreter(expander: Expander, tmp_path: Path, code: str) -> None:
    found = failure(expander, tmp_path, f'<a b="${{{code}}}"/>')
    assert found.kind is Failure.REFUSED
    assert found.span.text.startswith("${")


def test_eval_with_all_of_python(expander: Expander, tmp_path: Path) -> None:
    # `)` ends a substitution, but a property may bring one in.
    body = '<xacro:property name="end" value=")"/>\n<a b="$(eval open(\'/etc/hostname\'${end}.read(${end}"/>'
    found = failure(expander, tmp_path, body)
    assert found.span.begin.line == 3
    assert "open" in found.detail


@pytest.mark.parametrize("tag", ["!meters", "!degrees"])
def test_expressions_in_yaml(expander: Expander, tmp_path: Path, tag: str) -> None:
    (tmp_path / "v.yaml").write_text(f'length: {tag} "{REACH}"\n')
    found = failure(expander, tmp_path, "<a b=\"${xacro.load_yaml('v.yaml').length}\"/>")
    assert found.kind is Failure.REFUSED


@pytest.mark.parametrize("text", ["a: [1", "a: !unknown 3", "a:\n\t- b", "\x01"])
def test_malformed_yaml(expander: Expander, tmp_path: Path, text: str) -> None:
    (tmp_path / "v.yaml").write_text(text)
    found = failure(expander, tmp_path, "<a b=\"${xacro.load_yaml('v.yaml').a}\"/>")
    assert found.detail.startswith("malformed YAML")
    assert found.span.text == "${xacro.load_yaml('v.yaml').a}"


def test_files_outside_the_project(expander: Expander, tmp_path: Path) -> None:
    secret = tmp_path / "secret.yaml"
    secret.write_text("token: hidden")
    inside = tmp_path / "project" / "urdf"
    inside.mkdir(parents=True)
    (inside.parent / ".git").mkdir()
    (inside / "link.yaml").symlink_to(secret)
    for name in (str(secret), "../../secret.yaml", "link.yaml"):
        found = failure(expander, inside, f"<a b=\"${{xacro.load_yaml('{name}').token}}\"/>")
        assert found.kind is Failure.REFUSED
        assert "outside of the project" in found.detail


def test_a_folder_is_no_file(expander: Expander, tmp_path: Path) -> None:
    found = failure(expander, tmp_path, "<a b=\"${xacro.load_yaml('')}\"/>")
    assert found.kind is Failure.FILE
    assert found.detail.endswith("is a directory")


def test_the_environment_stays_outside(
    expander: Expander, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("SECRET_TOKEN", "hidden")
    found = failure(expander, tmp_path, '<a b="$(env SECRET_TOKEN)"/>')
    assert (found.kind, found.detail) == (Failure.WITHHELD, "SECRET_TOKEN")
    monkeypatch.delenv("OTHER_TOKEN", raising=False)
    assert failure(expander, tmp_path, '<a b="$(env OTHER_TOKEN)"/>').kind is Failure.VARIABLE
    path = tmp_path / "o.xacro"
    path.write_text(f'{HEAD}<a b="$(optenv SECRET_TOKEN none)"/></robot>')
    text = expander.expand(read(path.read_bytes(), path, Kind.XACRO)).text
    assert text is not None
    assert 'b="none"' in text


@pytest.mark.parametrize(
    ("body", "kind", "place"),
    [
        ('<a b="x $(arg size) y"/>', Failure.ARGUMENT, "$(arg size)"),
        ('<xacro:include filename="none.xacro"/>', Failure.FILE, "none.xacro"),
        ("<a b=\"${xacro.load_yaml('none.yaml')}\"/>", Failure.FILE, "${xacro.load_yaml('none.yaml')}"),
        ('<a b="${1 / 0}"/>', Failure.EXPRESSION, "${1 / 0}"),
        ('<a b="${1 +}"/>', Failure.EXPRESSION, "${1 +}"),
        ("<a>${[][0]}</a>", Failure.EXPRESSION, "${[][0]}"),
        ('<xacro:if value="perhaps"/>', Failure.EXPRESSION, "perhaps"),
        ('<xacro:property name="a b" value="1"/>', Failure.EXPRESSION, "a b"),
        ('<xacro:macro params="x"/>', Failure.EXPRESSION, "xacro:macro"),
        ('<a b="$(dirname)"/>', Failure.EXPRESSION, "$(dirname)"),
        ('<a b="$(nonsense x)"/>', Failure.EXPRESSION, "$(nonsense x)"),
    ],
)
def test_plain_mistakes_have_a_place(
    expander: Expander, tmp_path: Path, body: str, kind: Failure, place: str
) -> None:
    found = failure(expander, tmp_path, body)
    assert (found.kind, found.span.text) == (kind, place), found
    assert found.detail


def test_a_malformed_include_is_reported_at_the_include(expander: Expander, tmp_path: Path) -> None:
    (tmp_path / "bad.xacro").write_text("<robot>\n<a></b></robot>")
    found = failure(expander, tmp_path, '<xacro:include filename="bad.xacro"/>')
    assert found.kind is Failure.SYNTAX
    assert found.cause is not None
    assert (found.span.text, found.cause.begin.line) == ("bad.xacro", 2)


def test_a_lazy_property_is_reported_at_its_definition(expander: Expander, tmp_path: Path) -> None:
    body = '<xacro:property name="half" value="${lenght / 2}"/>\n<a b="${half}"/>'
    found = problem(expander, tmp_path, body)
    assert isinstance(found, UndefinedProperty)
    assert (found.span.text, found.span.begin.line) == ("lenght", 2)


def test_the_process_goes_on_after_a_failure(expander: Expander, tmp_path: Path) -> None:
    failure(expander, tmp_path, '<a b="${9 ** 9 ** 9}"/>')
    path = tmp_path / "good.xacro"
    path.write_text(f"{HEAD}<a/></robot>")
    assert expander.expand(read(path.read_bytes(), path, Kind.XACRO)).text is not None
