from __future__ import annotations

from textwrap import dedent

from sdfcheck.lint.diagnostic import Label, Origin, Severity
from sdfcheck.report import OutputFormat, render
from tests.unit.report.runs import diagnostic, facts, fixed, marked, run, shown


def test_a_whole_report() -> None:
    first = fixed(diagnostic('<model name="«a»"/>'), "b")
    second = diagnostic(
        "<«x»/>", path="world.sdf", code="SCH902", severity=Severity.WARNING, message="`x` is nothing"
    )
    assert render(OutputFormat.FULL, run(first, second, files=3, rules=(facts(),))) == dedent(
        """\
        error[NAM901]: name `a` is taken
         --> arm.sdf:1:14
          |
        1 | <model name="a"/>
          |              ^
          = help: write `b` (safe fix)
          = more: sdfcheck rule taken-name

        warning[SCH902]: `x` is nothing
         --> world.sdf:1:2
          |
        1 | <x/>
          |  ^

        Found 1 error and 1 warning in 3 files (1 fixable with --fix).
        """
    )


def test_a_clean_run_is_one_line() -> None:
    assert render(OutputFormat.FULL, run(files=12)) == "All clear: 12 files, no findings.\n"


def test_labels_in_other_files_get_frames_of_their_own() -> None:
    (there, _), (later, _) = marked("<b>\n  <«c»/>", "parts/leg.sdf"), marked("\n\n\n«d»", "foot.sdf")
    found = diagnostic("«a» {b}", "near")
    found = found._replace(labels=(Label(later, "last"), *found.labels, Label(there, "far")))
    assert shown(found) == (
        " --> arm.sdf:1:1\n"
        "  |\n"
        "1 | a b\n"
        "  | ^ - near\n"
        " ::: foot.sdf:4:1\n"
        "  |\n"
        "4 | d\n"
        "  | - last\n"
        " ::: parts/leg.sdf:2:4\n"
        "  |\n"
        "2 |   <c/>\n"
        "  |    - far"
    )


def test_a_file_that_changed_between_two_readings_does_not_fail() -> None:
    (before, _) = marked("x" * 50 + "\n" * 30 + "«y»")
    found = diagnostic("«a»")._replace(labels=(Label(before, "then"),))
    assert "31 | y\n   | - then" in shown(found)


def test_remarks() -> None:
    call, _ = marked("<robot>\n  «<leg/>»", "robot.xacro")
    found = fixed(diagnostic("«a»"), "b", safe=False)._replace(
        help="names are unique in a model",
        origins=(Origin(call, "in macro `leg`, called here"), Origin(call, "included here")),
    )
    assert shown(found, rules=(facts(),)).splitlines()[-5:] == [
        "  = help: write `b` (unsafe fix)",
        "  = help: names are unique in a model",
        "  = note: in macro `leg`, called here: robot.xacro:2:3",
        "  = note: included here: robot.xacro:2:3",
        "  = more: sdfcheck rule taken-name",
    ]


def test_the_rule_is_named_where_there_is_a_page_about_it() -> None:
    assert shown(diagnostic("«a»"), rules=(facts(),)).endswith("\n  = more: sdfcheck rule taken-name")
    assert "sdfcheck rule" not in shown(diagnostic("«a»"))


def test_the_content_of_a_file_never_acts_on_the_terminal() -> None:
    evil = "\x1b[31m\x9b2J\x07\u202e\u200b\ud800"
    found = diagnostic(f"<a {evil}«b»/>", path=f"{evil}.sdf", message=f"{evil}\nname", help=evil)
    for kind in (OutputFormat.FULL, OutputFormat.CONCISE):
        text = render(kind, run(found))
        assert all(character.isprintable() for character in text.replace("\n", ""))
        assert "␛[31m<U+009B>2J␇<U+202E><U+200B><U+D800>␊name" in text
    *_, code, mark = render(OutputFormat.FULL, run(found._replace(help=None))).split("\n\n")[0].splitlines()
    assert code.index("b/") == mark.index("^")


def test_colors() -> None:
    found = fixed(diagnostic("«a» {b}", "here"), "c")
    plain = render(OutputFormat.FULL, run(found))
    colored = render(OutputFormat.FULL, run(found), color=True)
    assert "\x1b" not in plain
    assert "\x1b[1;31merror[NAM901]\x1b[0m\x1b[1m: name `a` is taken\x1b[0m\n" in colored
    assert " \x1b[1;31m^\x1b[0m \x1b[34m- here\x1b[0m\n" in colored
    for code in ("1;31", "1;34", "34", "1", "0"):
        colored = colored.replace(f"\x1b[{code}m", "")
    assert colored == plain
