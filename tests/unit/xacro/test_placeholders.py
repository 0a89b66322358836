"""A file that xacro refuses is judged as far as it can be expanded; nothing that depends on the rest is."""

from __future__ import annotations

from pathlib import Path

import pytest

import sdfcheck
from sdfcheck.source.document import read
from sdfcheck.source.sniff import Kind
from sdfcheck.xacro.expansion import Expander, Expansion, Surroundings
from sdfcheck.xacro.problems import ExpansionFailure, Failure
from sdfcheck.xacro.process.watch import Limits

XACRO = 'xmlns:xacro="http://www.ros.org/wiki/xacro"'
MASS = '<inertial><mass value="1"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial>'
TWO = f'<link name="a">{MASS}</link><link name="b">{MASS}</link>'
LOST = '<joint name="j" type="fixed"><parent link="a"/><child link="lost"/></joint>'


def written(folder: Path, content: str, root: str = 'name="r"') -> Path:
    (folder / ".git").mkdir(exist_ok=True)  # no other folder belongs to the project
    file = folder / "robot.urdf.xacro"
    file.write_text(f"<robot {root} {XACRO}>{content}</robot>")
    return file


def found(folder: Path, content: str, root: str = 'name="r"') -> list[tuple[str, str]]:
    run = sdfcheck.lint(written(folder, content, root), isolated=True)
    errors = [each for each in run.diagnostics if each.severity is not sdfcheck.Severity.INFO]
    return [(each.code, each.span.text) for each in errors]


def partly(folder: Path, content: str, limits: Limits | None = None) -> Expansion:
    file = written(folder, content)
    document = read(file.read_bytes(), file, Kind.XACRO)
    with Expander(Surroundings(limits=limits or Limits())) as expander:
        return expander.expand_partly(document)


def kinds(expansion: Expansion) -> list[Failure]:
    return [each.kind for each in expansion.problems if isinstance(each, ExpansionFailure)]


@pytest.mark.parametrize(
    ("content", "root", "cause"),
    [
        ('<xacro:arg name="n" default="r"/>', 'name="$(arg n)"', ("XAC001", "$(arg n)")),
        ("<gazebo><plugin name='p' filename='l.so'><f>$(arg f)</f></plugin></gazebo>", 'name="r"', None),
        (
            "<gazebo><plugin name='p' filename='l.so'><f>$(env NO_SUCH)</f></plugin></gazebo>",
            'name="r"',
            None,
        ),
        (
            "<gazebo><plugin name='p' filename='l.so'><f>$(find no_such)/f</f></plugin></gazebo>",
            'name="r"',
            ("XAC007", "no_such"),
        ),
        ('<transmission name="t"><x>${1 / 0}</x></transmission>', 'name="r"', ("XAC001", "${1 / 0}")),
        ('<transmission name="t"><xacro:gone/></transmission>', 'name="r"', ("XAC003", "gone")),
    ],
)
def test_references_are_judged_where_all_links_are_known(
    tmp_path: Path, content: str, root: str, cause: tuple[str, str] | None
) -> None:
    reported = found(tmp_path, content + TWO + LOST, root)
    assert ("JNT001", "lost") in reported
    assert cause is None or reported.count(cause) == 1


@pytest.mark.parametrize(
    "content",
    [
        '<link name="$(arg p)lost"/>',
        '<xacro:include filename="$(find no_such)/urdf/lost.xacro"/>',
        '<xacro:include filename="lost.xacro"/>',
        '<xacro:if value="$(arg p)"><link name="lost"/></xacro:if>',
        '<xacro:unless value="${1 / 0}"><link name="lost"/></xacro:unless>',
        '<xacro:gone><link name="x"/></xacro:gone>',
        '<xacro:macro name="m" params="n"><link name="${n}"/></xacro:macro><xacro:m/>',
        '<xacro:macro name="m" params="n:=x"><link name="${n}"/></xacro:macro><xacro:m nn="lost"/>',
    ],
)
def test_references_are_not_judged_where_links_may_be_missing(tmp_path: Path, content: str) -> None:
    codes = {code for code, _ in found(tmp_path, TWO + LOST + content)}
    assert codes
    assert all(code.startswith("XAC") for code in codes)


@pytest.mark.parametrize(
    "definition",
    [
        '<xacro:property name="size" value="$(arg s)"/>',
        '<xacro:property name="size" value="${$(arg s) - 1}"/>',
        '<xacro:property name="size" value="${gone}"/>',
        "<xacro:property name=\"size\" value=\"${xacro.load_yaml('gone.yaml')['s']}\"/>",
        '<xacro:if value="$(arg s)"><xacro:property name="size" value="1"/></xacro:if>',
        (
            '<xacro:property name="size" value="-1"/>'
            '<xacro:if value="$(arg s)"><xacro:property name="size" value="1"/></xacro:if>'
        ),
        (
            '<xacro:macro name="m" params=""><xacro:if value="$(arg s)">'
            '<xacro:property name="size" value="-1" scope="parent"/></xacro:if></xacro:macro><xacro:m/>'
        ),
        ('<xacro:include filename="$(find no_such)/s.xacro"/><xacro:property name="size" default="-1"/>'),
    ],
)
@pytest.mark.parametrize("use", ["${size}", "${-abs(size)}", "${[size][0]}", "${'-' + str(size)}"])
def test_no_finding_comes_from_a_placeholder(tmp_path: Path, definition: str, use: str) -> None:
    link = f'<link name="c">{MASS}<visual><geometry><sphere radius="{use}"/></geometry></visual></link>'
    codes = {code for code, _ in found(tmp_path, definition + link)}
    assert codes
    assert all(code.startswith("XAC") for code in codes)


def test_names_with_a_placeholder_are_not_compared(tmp_path: Path) -> None:
    macro = '<xacro:macro name="m" params="n"><link name="${n}_x"/></xacro:macro>'
    calls = '<xacro:m n="$(arg p)"/><xacro:m n="$(arg p)"/>'
    assert [code for code, _ in found(tmp_path, macro + calls)] == ["XAC001"]


def test_mass_that_is_not_known_may_be_there(tmp_path: Path) -> None:
    links = '<link name="a"/><link name="b"><inertial><mass value="$(arg m)"/></inertial></link>'
    joint = '<joint name="j" type="fixed"><parent link="a"/><child link="b"/></joint>'
    assert "URD013" not in [code for code, _ in found(tmp_path, links + joint)]


def test_a_block_is_not_evaluated_where_it_is_put(tmp_path: Path) -> None:
    macro = (
        '<xacro:macro name="m" params="*block"><xacro:property name="gone" value="1"/>'
        '<xacro:insert_block name="block"/></xacro:macro>'
    )
    done = partly(tmp_path, macro + '<xacro:m><link name="${gone}"/></xacro:m>')
    assert done.text is not None
    assert '<link name="${gone}"/>' in done.text


def test_one_argument_and_one_folder_are_one_problem_each(tmp_path: Path) -> None:
    links = "".join(f'<link name="$(arg p)_{number}"/>' for number in range(3))
    tables = "".join(f"<link name=\"${{xacro.load_yaml('no_such/{number}.yaml')}}\"/>" for number in range(3))
    assert kinds(partly(tmp_path, links + tables)) == [Failure.ARGUMENT, Failure.FILE]


def test_few_failures_are_reported(tmp_path: Path) -> None:
    content = "".join(f'<link name="${{{number} / 0}}"/>' for number in range(100))
    assert len(partly(tmp_path, content).problems) == 8


@pytest.mark.parametrize(
    "content",
    [
        '<link name="${python.type(1)}"/>',
        "<link name=\"${xacro.load_yaml('/etc/passwd')}\"/>",
        '<xacro:property name="x" value="${().__class__}"/><link name="${x}"/>',
        '<link name="${10 ** 10 ** 10}"/>',
        '<xacro:macro name="m" params=""><xacro:m/></xacro:macro><xacro:m/>',
    ],
)
def test_nothing_goes_on_after_what_is_refused(tmp_path: Path, content: str) -> None:
    done = partly(tmp_path, f'<link name="$(arg p)"/>{content}')
    assert done.document is None
    assert kinds(done) in (
        [Failure.REFUSED],
        [Failure.LIMIT],
        [Failure.RECURSION],
    )


def test_the_time_is_limited_as_ever(tmp_path: Path) -> None:
    loop = '<link name="${python.sum(1 for a in range(10**4) for b in range(10**4))}"/>'
    done = partly(tmp_path, f'<link name="$(arg p)"/>{loop}', Limits(cpu=1, wall=3))
    assert kinds(done) == [Failure.LIMIT]


def test_elements_without_the_prefix_are_taken_as_if_they_had_it(tmp_path: Path) -> None:
    (tmp_path / "part.xacro").write_text(f'<robot {XACRO}><property name="size" value="-1"/></robot>')
    content = (
        '<xacro:include filename="part.xacro"/><macro name="m" params="n"><link name="${n}"><visual><geometry>'
        '<sphere radius="${size}"/></geometry></visual></link></macro><if value="true"><m n="b"/></if>'
        '<if value="false"><link name="lost"/></if>'
    )
    reported = found(tmp_path, content + f'<link name="a">{MASS}</link>' + LOST)
    assert reported.count(("XAC012", "macro")) == 1
    assert ("SCH014", "${size}") in reported
    assert ("JNT001", "lost") in reported


def test_expand_refuses_what_xacro_refuses(tmp_path: Path) -> None:
    file = written(tmp_path, TWO + "<gazebo><x>$(arg f)</x></gazebo>")
    document = read(file.read_bytes(), file, Kind.XACRO)
    with Expander() as expander:
        assert expander.expand(document).document is None


def test_settings_of_gazebo_in_a_branch_are_not_urdf(tmp_path: Path) -> None:
    branch = '<gazebo><xacro:if value="false"><light name="l" type="point"/></xacro:if></gazebo>'
    assert found(tmp_path, f'<link name="a">{MASS}</link>{branch}') == []


def test_an_element_that_is_left_may_hold_what_is_lacking(tmp_path: Path) -> None:
    links = '<link name="a"><inertial><mass value="1"/><xacro:gone/></inertial></link>'
    assert found(tmp_path, f'<xacro:include filename="$(find no_such)/i.xacro"/>{links}') == [
        ("XAC007", "no_such")
    ]


def test_shapes_of_links_that_are_not_known_may_hold_the_mass(tmp_path: Path) -> None:
    off = MASS.replace("<mass", '<origin xyz="1 0 0"/><mass')
    box = '<collision><geometry><box size="0.1 0.1 0.1"/></geometry></collision>'
    link = f'<link name="a">{off}{box}</link>'
    assert ("INR013", "1 0 0") in found(tmp_path, link)
    assert ("INR013", "1 0 0") not in found(tmp_path, f'{link}<link name="$(arg p)b"/>')


def test_comments_before_elements_of_xacro_are_dropped(tmp_path: Path) -> None:
    content = '<!-- one: two --><xacro:arg name="a" default=""/><link name="a"><x>$(arg p)</x></link>'
    done = partly(tmp_path, content)
    assert done.text is not None
    assert "one: two" not in done.text


def test_a_name_with_a_hyphen_is_one_problem(tmp_path: Path) -> None:
    content = f'<xacro:property name="wheel-radius" value="1"/><link name="a">{MASS}<visual><geometry>'
    content += '<sphere radius="${wheel-radius}"/></geometry></visual></link>'
    assert found(tmp_path, content) == [("XAC001", "wheel-radius")]


@pytest.mark.parametrize(("call", "wrong"), [('n="c" sice="2"', "sice"), ('n="c"', "xacro:m")])
def test_a_call_with_wrong_parameters_goes_on(tmp_path: Path, call: str, wrong: str) -> None:
    macro = (
        '<xacro:macro name="m" params="n size{}"><link name="${{n}}"><inertial><mass value="-1"/></inertial><visual>'
        '<geometry><sphere radius="${{size}}"/></geometry></visual></link></xacro:macro>'
    ).format(":=-1" if "sice" in call else "")
    reported = found(tmp_path, f"{macro}<xacro:m {call}/>")
    assert ("XAC008", wrong) in reported
    assert {text for code, text in reported if not code.startswith("XAC")} == {"-1", "inertial"}


def test_an_argument_that_a_package_may_declare_is_not_missing(tmp_path: Path) -> None:
    include = '<xacro:include filename="$(find no_such)/arguments.xacro"/>'
    assert found(tmp_path, f'{include}<link name="$(arg p)a"/>') == [("XAC007", "no_such")]


PACKAGE = '<xacro:include filename="$(find own)/urdf/parts.xacro"/>'


def package(folder: Path) -> Path:
    (folder / "package.xml").write_text("<package><name>own</name></package>")
    (folder / "urdf").mkdir()
    return folder / "urdf"


def test_a_template_is_read_in_place_of_what_a_build_makes_of_it(tmp_path: Path) -> None:
    templates = package(tmp_path)
    template = '<robot xmlns:xacro="http://ros.org/wiki/xacro"><link name="tip"/>{}</robot>'
    joint = '<joint name="j" type="fixed"><parent link="tip"/><child link="{}"/></joint>'
    (templates / "parts.xacro.in").write_text(
        template.format('@MORE@<xacro:property name="v" value="${@N@}"/>')
    )
    assert found(tmp_path, PACKAGE + '<link name="base"/>' + joint.format("base")) == []
    made = joint.format("made")  # the build may put it in the place of @MORE@
    assert found(tmp_path, PACKAGE + '<link name="base"/>' + made) == []
    assert found(tmp_path, PACKAGE + '<link name="base" frame="a"/>') == [("URD002", "frame")]
    assert found(tmp_path, PACKAGE.replace("parts", "lost") + '<link name="base"/>')[0][0] == "XAC001"


def test_a_folder_without_content_may_be_a_submodule(tmp_path: Path) -> None:
    own = package(tmp_path)
    (tmp_path / "arms/ur").mkdir(parents=True)
    mesh = '<link name="l"><visual><geometry><mesh filename="../arms/ur/m/a.stl"/></geometry></visual></link>'
    near = '<xacro:include filename="../arms/ur/urdf/a.xacro"/>'
    path = written(own, near + mesh)
    run = sdfcheck.lint(path, isolated=True)
    assert [(each.code, each.severity.value) for each in run.diagnostics] == [("XAC001", "warning")]
    assert {each.missing.kind for each in run.missing if each.missing} == {sdfcheck.MissingKind.SUBMODULE}
    path = written(own, mesh)
    assert [each.missing and each.missing.name for each in sdfcheck.lint(path, isolated=True).missing] == [
        str(Path("../arms/ur"))
    ]
    path = written(own, '<xacro:include filename="$(find ur)/urdf/a.xacro"/>' + mesh)
    assert found(own, '<xacro:include filename="$(find ur)/urdf/a.xacro"/>')[0] == ("XAC007", "ur")
    (tmp_path / "arms/ur/README").write_text("")
    assert found(own, near)[0][0] == "XAC001"
    assert sdfcheck.lint(path, isolated=True).missing == ()


def test_joints_of_hardware_are_included_in_ros2_control(tmp_path: Path) -> None:
    joints = '<robot><joint name="j"><command_interface name="position"/><state_interface name="v"/></joint></robot>'
    (tmp_path / ".git").mkdir()
    (tmp_path / "control_joints.xacro").write_text(joints)
    (tmp_path / "robot.urdf.xacro").write_text(
        '<robot name="r" xmlns:xacro="http://ros.org/wiki/xacro"><link name="l"/><ros2_control name="c" type="system">'
        '<xacro:include filename="control_$(arg version).xacro"/></ros2_control></robot>'
    )
    run = sdfcheck.lint(tmp_path / "control_joints.xacro", isolated=True)
    assert run.diagnostics == ()


def test_a_key_that_is_lacking_is_one_problem(tmp_path: Path) -> None:
    (tmp_path / "a.yaml").write_text("size: 1")
    yaml = '<xacro:property name="c" value="${xacro.load_yaml(file)}"/>'
    uses = "".join(
        f'<link name="l{n}" x="${{c[\'{key}\']}}"/>' for n, key in enumerate(("mass", "mass", "size"))
    )
    literal = '<xacro:property name="file" value="a.yaml"/>'
    path = written(tmp_path, literal + yaml + uses)
    (error,) = (each for each in sdfcheck.lint(path, isolated=True).diagnostics if each.code == "XAC001")
    assert "the YAML has no key `mass`" in error.message
    assert error.severity is sdfcheck.Severity.ERROR
    given = '<xacro:arg name="f" default="a.yaml"/><xacro:property name="file" value="$(arg f)"/>'
    path = written(tmp_path, given + yaml + uses)
    (warning,) = (each for each in sdfcheck.lint(path, isolated=True).diagnostics if each.code == "XAC001")
    assert warning.severity is sdfcheck.Severity.WARNING
    assert "the default of argument `f` is `a.yaml`" in warning.message


def test_a_file_that_an_argument_has_to_name_may_be_there(tmp_path: Path) -> None:
    read = '<xacro:property name="c" value="${xacro.load_yaml(file)}"/><link name="l${c}"/>'
    macro = f'<xacro:macro name="arm" params="file">{read}</xacro:macro>'
    call = '<xacro:arm file="$(arg speeds)"/>'
    path = written(tmp_path, f'<xacro:arg name="speeds" default=""/>{macro}{call}')
    (warning,) = (each for each in sdfcheck.lint(path, isolated=True).diagnostics if each.code == "XAC001")
    assert warning.severity is sdfcheck.Severity.WARNING
    assert "the default of argument `speeds` is empty" in warning.message
