"""The table of a pack is enough: its tags are converted, described, completed and renamed as built-in ones are."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest

import sdfcheck
from sdfcheck.convert.loss import LossKind
from sdfcheck.convert.result import Conversion
from sdfcheck.lsp.completion import complete
from sdfcheck.lsp.hover import hover
from sdfcheck.lsp.names import occurrences
from sdfcheck.lsp.rename import Target, rename
from sdfcheck.lsp.workspace import Buffer, Choices, Workspace
from sdfcheck.source.splice import replaced

TABLE = """\
vendor	MuJoCo	https://example.org/mujoco
reads	sdf	lenient
reads	urdf	strict
unknown	sdf	ignored
unknown	urdf	ignored

armature	double	0	range=[0,inf]
 sdf	model/joint/axis/dynamics	text	0
 urdf	robot/joint/dynamics	attribute	0
camera	word		choices=front,rear
 sdf	model/link	attribute	0
 urdf	robot/link	attribute	0
exclude
 sdf	model		*
 urdf	robot		*
 @body1	name	1		ref=link
 @body2	name	1		ref=link
follows	name		ref=joint
 sdf	model/joint	text	0
 urdf	robot/joint	attribute	0
skin	double
 sdf	model/link	text	0
tendon	double
 urdf	robot/joint	attribute	0
"""
MASS = '<inertial><mass value="1"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial>'
SKIN = (
    '<sdf version="1.11" xmlns:mujoco="https://example.org/mujoco"><model name="m"><link name="a">'
    "<mujoco:skin>1</mujoco:skin></link></model></sdf>"
)
JOINT = (
    '<joint name="{}" type="continuous"{}><parent link="a"/><child link="{}"/>'
    '<dynamics damping="1" friction="0"{}/></joint>'
)


def urdf(*inside: str, a: str = "", follower: str = "", dynamics: str = "", b: str = "b") -> str:
    """Joint and link ``b`` share their name, which SDFormat does not allow."""
    return (
        f'<robot name="r" xmlns:mujoco="https://example.org/mujoco"><link name="a"{a}>{MASS}</link>'
        f'<link name="{b}">{MASS}</link><link name="c">{MASS}</link>'
        f"{JOINT.format('b', '', b, dynamics)}{JOINT.format('k', follower, 'c', '')}{''.join(inside)}</robot>"
    )


@pytest.fixture
def table(tmp_path: Path) -> Path:
    path = tmp_path / "tables" / "mujoco.vendor.txt"
    path.parent.mkdir()
    path.write_text(TABLE, encoding="utf-8")
    (tmp_path / "sdfcheck.toml").write_text('plugins = ["tables/"]\n')
    return path


def converted(text: str, to: str, table: Path) -> Conversion:
    done = sdfcheck.convert(text, to, tables=[table])
    assert done.verification is not None
    assert done.verification.is_equal, done.verification.differences
    assert LossKind.UNACCOUNTED_ITEM not in {loss.kind for loss in done.losses}
    return done


@pytest.mark.parametrize(
    ("source", "there", "again"),
    [
        (
            urdf(dynamics=' mujoco:armature="0.1"', b="d"),
            "<mujoco:armature>0.1</mujoco:armature>",
            'mujoco:armature="0.1"',
        ),
        (
            urdf(a=' mujoco:camera="front"', b="d"),
            '<link name="a" mujoco:camera="front">',
            'mujoco:camera="front"',
        ),
        (
            urdf(follower=' mujoco:follows="b"', b="d"),
            "<mujoco:follows>b</mujoco:follows>",
            'mujoco:follows="b"',
        ),
        (
            urdf('<mujoco:exclude body1="a" body2="d"/>', b="d"),
            '<mujoco:exclude body1="a" body2="d"/>',
            '<mujoco:exclude body1="a" body2="d"/>',
        ),
    ],
    ids=["an attribute and an element", "two attributes", "a name", "two elements"],
)
def test_there_and_back(source: str, there: str, again: str, table: Path) -> None:
    done = converted(source, "sdf", table)
    assert there in done.text
    assert not done.losses
    back = converted(done.text, "urdf", table)
    assert again in back.text
    assert not back.losses


def test_names_follow_the_parts_that_they_name(table: Path) -> None:
    source = urdf('<mujoco:exclude body1="a" body2="b"/>', follower=' mujoco:follows="b"')
    done = sdfcheck.convert(sdfcheck.parse(source, tables=[table]), "sdf")
    assert "<mujoco:follows>b_joint</mujoco:follows>" in done.text
    assert '<mujoco:exclude body1="a" body2="b"/>' in done.text
    assert any("`b` is now `b_joint`" in loss.message for loss in done.losses)


def test_names_of_merged_links_follow(table: Path) -> None:
    fixed = '<joint name="f" type="fixed"><parent link="c"/><child link="tip"/></joint>'
    tip = f'<link name="tip">{MASS}</link>'
    source = urdf(tip, fixed, '<mujoco:exclude body1="a" body2="tip"/>', b="d")
    done = sdfcheck.convert(source, "sdf", like=sdfcheck.Consumer.GAZEBO, tables=[table])
    assert '<mujoco:exclude body1="a" body2="c"/>' in done.text


def test_names_follow_from_version_to_version(table: Path) -> None:
    source = (
        '<sdf version="1.6" xmlns:mujoco="https://example.org/mujoco"><model name="m"><link name="a"/>'
        '<link name="j"/><link name="k"/><joint name="j" type="fixed"><parent>a</parent><child>j</child></joint>'
        '<joint name="l" type="fixed"><parent>a</parent><child>k</child>'
        '<mujoco:follows>j</mujoco:follows></joint><mujoco:exclude body1="a" body2="j"/></model></sdf>'
    )
    done = sdfcheck.convert(source, "sdf", version="1.9", tables=[table])
    assert '<joint name="j_joint"' in done.text
    assert "<mujoco:follows>j_joint</mujoco:follows>" in done.text
    assert 'body2="j"' in done.text


@pytest.mark.parametrize(
    ("source", "to", "message"),
    [
        (
            urdf(follower=' mujoco:tendon="3"', b="d"),
            "sdf",
            "MuJoCo does not read attribute `mujoco:tendon` of joint `k` there in SDFormat",
        ),
        (
            SKIN,
            "urdf",
            "MuJoCo has `mujoco:skin` in SDFormat only: it is kept as a gazebo extension",
        ),
    ],
)
def test_tags_of_one_format_alone_are_kept_and_reported(
    source: str, to: str, message: str, table: Path
) -> None:
    done = converted(source, to, table)
    assert message in {loss.message for loss in done.losses}
    assert "mujoco:tendon" in done.text or "mujoco:skin" in done.text


def test_without_the_table_nothing_is_known_of_the_prefix() -> None:
    done = sdfcheck.convert(urdf(dynamics=' mujoco:armature="0.1"', b="d"), "sdf")
    assert 'mujoco:armature="0.1"' in done.text


def test_renaming_in_python(table: Path) -> None:
    text = urdf('<mujoco:exclude body1="a" body2="d"/>', follower=' mujoco:follows="b"', b="d")
    robot = sdfcheck.edit(text, tables=[table])
    robot.rename(robot.model(0).link("d"), "hand")
    robot.rename(robot.model(0).joint("b"), "elbow")
    assert 'mujoco:follows="elbow"' in robot.text
    assert 'body2="hand"' in robot.text


def test_a_table_that_cannot_be_read(tmp_path: Path) -> None:
    table = tmp_path / "mujoco.vendor.txt"
    table.write_text("armature\tdouble\n")
    with pytest.raises(sdfcheck.WrongUsage, match=r"mujoco.vendor.txt:1: the line `vendor` comes first"):
        sdfcheck.parse(urdf(), tables=[table])


# In the editor


class Editor:
    """A text that is open, in which ``|`` marks the cursor."""

    def __init__(self, workspace: Workspace, folder: Path, marked: str) -> None:
        self.workspace, self.offset, self.text = workspace, marked.index("|"), marked.replace("|", "")
        path = folder / "r.urdf"
        self.buffer: Buffer = workspace.open(path.as_uri(), path, self.text, 1)
        document = workspace.document(path)
        assert document is not None
        self.document = document

    @property
    def offered(self) -> dict[str, str]:
        return {item.label: item.detail for item in complete(self.workspace, self.buffer, self.offset).items}

    @property
    def hover(self) -> str:
        found = hover(self.document, self.offset, (), self.workspace)
        return "" if found is None else found.text

    def renamed(self, name: str) -> str:
        named = occurrences(self.document).at(self.offset)
        assert named is not None
        edits = rename(self.workspace, self.document, Target(named, named.span), name)
        return replaced(self.text, [(edit.span.start, edit.span.end, edit.text) for edit in edits])


@pytest.fixture
def workspace(table: Path) -> Iterator[Workspace]:
    made = Workspace()
    made.choose(Choices(trust=True))
    yield made
    made.close()


@pytest.mark.parametrize(
    ("marked", "label"),
    [
        (urdf("<|"), "mujoco:exclude"),
        (urdf(a=" |"), "mujoco:camera"),
        (urdf(dynamics=" |"), "mujoco:armature"),
        (urdf("<mujoco:exclude |/>"), "body2"),
        (urdf('<mujoco:exclude body1="|"/>', b="d"), "d"),
        (urdf(follower=' mujoco:follows="|"'), "b"),
        (urdf(a=' mujoco:camera="|"'), "rear"),
    ],
)
def test_completion(marked: str, label: str, workspace: Workspace, tmp_path: Path) -> None:
    assert label in Editor(workspace, tmp_path, marked).offered


def test_completion_without_trust_knows_no_table(table: Path, tmp_path: Path) -> None:
    workspace = Workspace()
    assert "mujoco:exclude" not in Editor(workspace, tmp_path, urdf("<|")).offered
    workspace.close()


def test_hover(workspace: Workspace, tmp_path: Path) -> None:
    text = urdf('<mujoco:excl|ude body1="a" body2="b"/>')
    assert "**`mujoco:exclude`** · MuJoCo, URDF element" in Editor(workspace, tmp_path, text).hover
    text = urdf(dynamics=' mujoco:arma|ture="1"')
    assert "range at least 0" in Editor(workspace, tmp_path, text).hover


def test_rename(workspace: Workspace, tmp_path: Path) -> None:
    text = urdf('<mujoco:exclude body1="a" body2="d"/>', follower=' mujoco:follows="b"', b="d")
    joint = Editor(workspace, tmp_path, text.replace('name="b"', 'name="|b"'))
    after = text.replace('name="b"', 'name="elbow"').replace('mujoco:follows="b"', 'mujoco:follows="elbow"')
    assert joint.renamed("elbow") == after
    link = Editor(workspace, tmp_path, text.replace('body2="d"', 'body2="|d"'))
    assert link.renamed("hand") == text.replace('"d"', '"hand"')
