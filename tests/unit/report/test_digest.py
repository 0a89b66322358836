"""Views: repeated findings grouped, findings about this computer together, an overview of large runs."""

from __future__ import annotations

from sdfcheck.lint.diagnostic import Diagnostic, Missing, MissingKind, Severity
from sdfcheck.report import OutputFormat, render
from sdfcheck.report.digest import grouped
from sdfcheck.report.summary import View
from tests.unit.report.runs import diagnostic, fixed, run

FOLDING = View(Severity.WARNING, folds=True)
INFO = diagnostic("«a»", code="STY903", name="dull-thing", severity=Severity.INFO)


def found(line: int, *, path: str = "arm.sdf", **fields: object) -> Diagnostic:
    return diagnostic("\n" * (line - 1) + "«a»", path=path, **fields)


def missing(kind: MissingKind, name: str, uses: int = 1) -> Diagnostic:
    return diagnostic("«a»", severity=Severity.WARNING, missing=Missing(kind, name, uses))


def full(*diagnostics: Diagnostic, view: View = FOLDING) -> str:
    return render(OutputFormat.FULL, run(*diagnostics), view=view)


def test_a_few_alike_are_shown_one_by_one() -> None:
    assert [group.size for group in grouped(map(found, range(1, 4)))] == [1, 1, 1]


def test_many_alike_in_a_file_are_one_with_the_lines_of_the_others() -> None:
    text = full(*map(found, range(1, 12)))
    assert text.count("error[NAM901]") == 1
    assert "= and: 10 more in this file: 2:1, 3:1, 4:1, 5:1, 6:1, 7:1, 8:1, 9:1, …\n" in text
    assert text.endswith("Found 11 errors in 1 file.\n")


def test_many_alike_in_a_run_are_one_with_places_in_other_files() -> None:
    text = full(found(1), *(found(2, path=f"{name}.sdf") for name in "bcdef"))
    assert "= and: 5 more in 5 files: b.sdf:2:1, c.sdf:2:1, d.sdf:2:1, …\n" in text


def test_long_paths_are_shown_by_their_ends() -> None:
    folder = "package://robot_with_a_long_name_description/meshes"
    alike = [found(number, message=f"mesh `{folder}/part_{number}.stl` is missing") for number in range(1, 5)]
    assert "file: 2:1 `…/meshes/part_2.stl`, 3:1 `…/meshes/part_3.stl`, 4:1 `…/meshes/" in full(*alike)


def test_names_and_numbers_do_not_set_findings_apart_and_are_said_with_their_places() -> None:
    alike = [found(number, message=f"`{name}` is not 7") for number, name in enumerate("wxyz", 1)]
    assert "= and: 3 more in this file: 2:1 `x`, 3:1 `y`, 4:1 `z`\n" in full(*alike)
    unlike = [found(5, message="something else")]
    assert [group.size for group in grouped([*alike, *unlike])] == [4, 1]
    graver = [each._replace(severity=Severity.WARNING) for each in alike]
    assert [group.size for group in grouped([*alike, *graver])] == [4, 4]


def test_infos_are_counted_and_not_shown() -> None:
    for kind in (OutputFormat.FULL, OutputFormat.CONCISE):
        text = render(kind, run(found(1), INFO), view=FOLDING)
        assert "STY903" not in text
        assert text.endswith("1 error and 1 info in 1 file (infos are shown with --min-severity info).\n")
        assert "STY903" in render(kind, run(found(1), INFO), view=FOLDING._replace(least=Severity.INFO))
        errors = render(kind, run(INFO), view=FOLDING)
        assert errors == "Found 1 info in 1 file (infos are shown with --min-severity info).\n"


def test_files_not_on_this_computer_are_one_block() -> None:
    text = full(
        missing(MissingKind.PACKAGE, "arm_description", 3),
        missing(MissingKind.MODEL, "sun"),
        missing(MissingKind.MODEL, "table"),
        missing(MissingKind.REMOTE, "https://fuel.gazebosim.org/a"),
        missing(MissingKind.REMOTE, "https://fuel.gazebosim.org/b"),
        missing(MissingKind.LFS, "arm.stl"),
        missing(MissingKind.LFS, "leg.stl", 2),
    )
    assert "NAM901" not in text
    assert "  1 package (needed 3 times): `arm_description`\n" in text
    assert "ROS_PACKAGE_PATH" in text
    assert "  1 model (needed 1 time): `table`\n" in text
    assert "GZ_SIM_RESOURCE_PATH" in text
    assert "  1 standard model of Gazebo (needed 1 time): `sun`\n" in text
    assert "  2 addresses on the network (needed 2 times)" in text
    assert "  2 Git LFS files (needed 3 times): `leg.stl` and `arm.stl`\n" in text
    assert "fetch them with `git lfs pull`" in text
    assert text.endswith("Nothing else found in 1 file.\n")


def test_without_folding_each_is_shown_and_counted() -> None:
    alike = [*map(found, range(1, 6)), missing(MissingKind.MODEL, "table")]
    text = full(*alike, view=View(Severity.WARNING))
    assert text.count("[NAM901]") == 6
    assert text.endswith("Found 5 errors and 1 warning in 1 file.\n")


def many() -> list[Diagnostic]:
    errors = [found(line, code=f"SCH{line:03}", name=f"flaw-{line}") for line in range(1, 41)]
    warnings = [found(50, code="JNT901", severity=Severity.WARNING), fixed(found(60, code="XML901"), "b")]
    return [*errors, *warnings]


def test_a_large_run_begins_with_what_to_do_first() -> None:
    text = full(*many())
    fix, errors, warnings = (text.index(word) for word in ("Fix first:", "Errors:", "Warnings:"))
    assert text.startswith("42 findings in 1 file, by rule\n")
    assert fix < text.index("XML901") < errors < text.index("SCH001") < warnings < text.index("JNT901")
    assert "  20  of 20 other rules\n" in text
    assert "more not shown: see them with --no-fold" in text
    assert len(text.splitlines()) < 200


def test_infos_that_a_fix_corrects_are_counted_apart() -> None:
    text = full(*many(), INFO, fixed(INFO, "b"), fixed(INFO, "c"))
    assert "3 infos of 1 rule: not shown, and rarely urgent; `--fix` corrects 2 of them\n" in text
    assert "not shown, and rarely urgent\n" in full(*many(), INFO)


def test_the_number_of_findings_can_be_limited() -> None:
    text = full(*many(), view=FOLDING._replace(most=2))
    assert text.count("error[") == 2
    assert "40 more not shown" in text
    assert full(*many(), view=View()).count("error[") == 41
    concise = render(OutputFormat.CONCISE, run(*many()), view=FOLDING._replace(most=2)).splitlines()
    assert len(concise) == 4


def test_other_formats_show_everything() -> None:
    everything = run(*map(found, range(1, 12)), INFO, missing(MissingKind.MODEL, "sun"))
    for kind in OutputFormat:
        if not kind.is_text:
            assert render(kind, everything, view=FOLDING._replace(most=1)) == render(kind, everything)
