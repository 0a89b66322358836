"""``--verify-with``: consumers read source and result as well."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from sdfcheck.cli.main import main
from sdfcheck.consumers.engines import Answer, Engine, Outcome, Question, is_installed
from sdfcheck.convert.independent import Judge, _text_without_shapes, second_opinion
from sdfcheck.convert.result import Comparison, Conversion
from sdfcheck.convert.urdf_to_sdf.conversion import urdf_to_sdf
from sdfcheck.convert.urdf_to_sdf.options import Options
from sdfcheck.source.document import read
from sdfcheck.source.errors import WrongUsage
from sdfcheck.source.sniff import Kind
from sdfcheck.xacro.expansion import Expander

pytest.importorskip("yourdfpy")

BOX = '<inertial><mass value="1"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial>'
ARM = f"""\
<robot name="arm">
  <link name="base">{BOX}</link><link name="arm">{BOX}</link><link name="hand">{BOX}</link>
  <joint name="turn" type="continuous">
    <origin xyz="0.1 0.2 0.3" rpy="0.4 0.5 0.6"/><parent link="base"/><child link="arm"/><axis xyz="0 0 1"/>
  </joint>
  <joint name="slide" type="prismatic">
    <origin xyz="0 0 1" rpy="0 1 0"/><parent link="arm"/><child link="hand"/><axis xyz="0 1 0"/>
    <limit lower="0" upper="1" effort="1" velocity="1"/>
  </joint>
</robot>
"""


def convert(command: str, source: Path, result: Path, *options: str) -> int:
    given = ["--isolated", str(source), "-o", str(result), "--verify-with", "yourdfpy", *options]
    return main(["convert", command, *given])


def test_it_reads_urdf_and_xacro_that_become_sdf_and_urdf_that_sdf_becomes(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    urdf, sdf, back = (tmp_path / name for name in ("arm.urdf", "arm.sdf", "back.urdf"))
    urdf.write_text(ARM)
    xacro = tmp_path / "arm.urdf.xacro"
    xacro.write_text(
        ARM.replace('name="arm">', 'name="arm" xmlns:xacro="http://ros.org/wiki/xacro">', 1).replace(
            "0.1 0.2 0.3", "${1 / 8} 0 0"
        )
    )
    assert convert("urdf-to-sdf", urdf, sdf) == 0
    assert convert("sdf-to-urdf", sdf, back) == 0
    assert convert("urdf-to-sdf", xacro, tmp_path / "x.sdf") == 0
    assert capsys.readouterr().err.count(", also by yourdfpy\n") == 3


def test_it_contradicts_a_result_that_is_another_robot() -> None:
    document = read(ARM.encode(), Path("arm.urdf"), Kind.URDF)
    done = urdf_to_sdf(document, Options())
    assert second_opinion(done, document, [Judge.YOURDFPY]) == ([], {})
    (comparison,) = done.comparisons
    turn = comparison.result.joints["turn"]
    turned = replace(turn, axes=(replace(turn.axes[0], direction=-turn.axes[0].direction),))
    joints = {**comparison.result.joints, "turn": turned}
    result = replace(comparison.result, joints=joints)
    wrong = Comparison(comparison.source, result, comparison.correspondence)
    conversion = Conversion(done.text, done.document, comparisons=(wrong,))
    found = second_opinion(conversion, document, [Judge.YOURDFPY])
    assert {one.name for one in found.differences} == {"arm", "hand"}


def answering(monkeypatch: pytest.MonkeyPatch, *answers: Answer) -> list[str]:
    """The consumers give these answers, one after the other; returned are the texts that they are asked about."""
    waiting, texts = list(answers), list[str]()

    def ask(_: Engine, question: Question, __: object) -> Answer:
        texts.append(question.path.read_text())
        return waiting.pop(0)

    monkeypatch.setattr("sdfcheck.convert.independent.ask", ask)
    return texts


SOUND: dict[str, object] = {"poses": [{}], "bodies": {}, "joints": {}}
UNREADABLE = Answer(Engine.YOURDFPY, Outcome.REFUSED, error="no such thing")


def test_a_source_that_it_cannot_read_is_reported(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    answering(monkeypatch, UNREADABLE, UNREADABLE)
    urdf = tmp_path / "arm.urdf"
    urdf.write_text(ARM)
    assert convert("urdf-to-sdf", urdf, tmp_path / "arm.sdf") == 1
    said = capsys.readouterr()
    assert "nothing was compared: yourdfpy does not read the source: no such thing" in said.out + said.err
    assert not (tmp_path / "arm.sdf").exists()


def test_others_go_on_where_one_cannot_read_the_source(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    fine = Answer(Engine.PINOCCHIO, Outcome.ACCEPTED, result=SOUND)
    answering(monkeypatch, UNREADABLE, UNREADABLE, fine)
    urdf = tmp_path / "arm.urdf"
    urdf.write_text(ARM)
    assert convert("urdf-to-sdf", urdf, tmp_path / "arm.sdf", "--verify-with", "pinocchio") == 0
    expected = "also by pinocchio (yourdfpy does not read the source: no such thing)"
    assert expected in capsys.readouterr().err


def test_a_source_whose_shapes_cannot_be_read_is_compared_without_them(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    fine = Answer(Engine.DRAKE, Outcome.ACCEPTED, result=SOUND)
    texts = answering(
        monkeypatch, Answer(Engine.DRAKE, Outcome.REFUSED, error="no such mesh"), fine, fine, fine
    )
    urdf = tmp_path / "arm.urdf"
    shape = '<visual><geometry><mesh filename="a.stl"/></geometry></visual>'
    urdf.write_text(ARM.replace("</link>", f"{shape}</link>", 1))
    line = ["convert", "urdf-to-sdf", "--isolated", "--no-lint", str(urdf), "-o", str(tmp_path / "arm.sdf")]
    assert main([*line, "--verify-with", "drake"]) == 0
    assert ["visual" in text for text in texts] == [True, True, False, False]
    assert texts[2] == ARM


def test_the_shapes_of_an_expanded_robot_are_left_out_of_what_xacro_wrote(tmp_path: Path) -> None:
    path = tmp_path / "r.urdf.xacro"
    macro = (
        '<xacro:macro name="m" params="n"><link name="${n}"><visual><geometry/></visual></link></xacro:macro>'
    )
    text = f'<robot name="r" xmlns:xacro="http://ros.org/wiki/xacro">{macro}<xacro:m n="a"/><xacro:m n="b"/></robot>'
    with Expander() as expander:
        document = expander.expand(read(text.encode(), path, Kind.XACRO)).document
    assert document is not None
    left = read(_text_without_shapes(document).encode(), path, Kind.URDF)
    assert [each.name for each in left.elements] == ["robot", "link", "link"]
    assert not left.problems


def test_a_result_that_it_alone_refuses_is_not_written(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    crash = Answer(Engine.DRAKE, Outcome.CRASHED, error="it ended by SIGSEGV")
    answering(monkeypatch, *[Answer(Engine.DRAKE, Outcome.ACCEPTED, result=SOUND), crash] * 2)
    urdf = tmp_path / "arm.urdf"
    urdf.write_text(ARM)
    line = ["convert", "urdf-to-sdf", "--isolated", str(urdf), "-o", str(tmp_path / "arm.sdf")]
    assert main([*line, "--verify-with", "drake"]) == 1
    assert "reading of `drake` fails: it ended by SIGSEGV" in capsys.readouterr().out
    assert not (tmp_path / "arm.sdf").exists()


def test_without_the_library_the_conversion_is_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    document = read(ARM.encode(), Path("arm.urdf"), Kind.URDF)
    done = urdf_to_sdf(document, Options())
    answering(monkeypatch, Answer(Engine.PYBULLET, Outcome.MISSING, error=Engine.PYBULLET.advice))
    with pytest.raises(WrongUsage, match=r"not installed: pip install 'sdfcheck\[pybullet\]'"):
        second_opinion(done, document, [Judge.PYBULLET])


def test_names_of_consumers_are_checked(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    urdf = tmp_path / "arm.urdf"
    urdf.write_text(ARM)
    assert main(["convert", "urdf-to-sdf", str(urdf), "--verify-with", "drak"]) == 2
    assert "--verify-with: unknown consumer `drak`; did you mean `drake`?" in capsys.readouterr().err


@pytest.mark.peers
@pytest.mark.parametrize("judge", list(Judge), ids=lambda judge: judge.value)
def test_each_consumer_agrees_with_a_conversion(judge: Judge) -> None:
    if not is_installed(judge.engine):
        pytest.skip(f"not installed: {judge.engine.advice}")
    document = read(ARM.encode(), Path("arm.urdf"), Kind.URDF)
    assert second_opinion(urdf_to_sdf(document, Options()), document, [judge]) == ([], {})
    heavier = read(ARM.replace('mass value="1"', 'mass value="2"').encode(), Path("arm.urdf"), Kind.URDF)
    done = urdf_to_sdf(heavier, Options())
    other = urdf_to_sdf(document, Options())
    mixed = Conversion(other.text, other.document, comparisons=tuple(
        Comparison(one.source, two.result, one.correspondence)
        for one, two in zip(done.comparisons, other.comparisons, strict=True)
    ))  # fmt: skip
    assert {one.what for one in second_opinion(mixed, heavier, [judge]).differences} == {"mass"}
