"""The formats of services that write beside the lines of a change."""

from __future__ import annotations

from sdfcheck.lint.diagnostic import Severity
from sdfcheck.lint.fix import Fix, TextEdit
from sdfcheck.release import HOME
from sdfcheck.report import OutputFormat, render
from tests.unit.report.runs import diagnostic, fixed, marked, parsed, rich_diagnostic, run


def test_github() -> None:
    text = "<a>\n<«b»/>"
    found = fixed(
        diagnostic(text, path="50%, a:b.sdf", message="50% of: a,\nb", severity=Severity.WARNING), "c"
    )
    assert render(OutputFormat.GITHUB, run(found)) == (
        "::warning file=50%25%2C a%3Ab.sdf,line=2,endLine=2,col=2,endColumn=3,title=NAM901 taken-name"
        "::50%25 of: a,␊b%0Ahelp: write `c` (safe fix)\n"
    )


def test_github_gets_no_columns_over_several_lines() -> None:
    found = diagnostic("<a>«\n::error::»", severity=Severity.INFO, help="::stop")
    assert render(OutputFormat.GITHUB, run(found)) == (
        "::notice file=arm.sdf,line=1,endLine=2,title=NAM901 taken-name::name `a` is taken%0Ahelp: ::stop\n"
    )


def test_github_gets_the_gravest_first_and_a_count_of_the_rest() -> None:
    found = [
        diagnostic("«a»", severity=severity, message=f"{number}")
        for number, severity in enumerate([Severity.INFO, Severity.WARNING, Severity.ERROR] * 4)
    ]
    lines = render(OutputFormat.GITHUB, run(*found)).splitlines()
    messages = [int(line.rpartition("::")[2]) for line in lines[:-1]]
    assert messages == [2, 5, 8, 11, 1, 4, 7, 10, 0, 3, 6, 9]
    assert lines[-1] == "::notice::2 more in the log of this step"
    assert "more" not in render(OutputFormat.GITHUB, run(*found[:10]))


def test_azure() -> None:
    found = fixed(
        diagnostic("<a>\n<«b»/>", path="50%;[a].sdf", message="50% of: a;\nb]", severity=Severity.WARNING),
        "c",
    )
    assert render(OutputFormat.AZURE, run(found)) == (
        "##vso[task.logissue type=warning;sourcepath=50%AZP25%3B[a%5D.sdf;linenumber=2;columnnumber=2;code=NAM901;]"
        "50%AZP25 of: a;␊b]%0Ahelp: write `c` (safe fix)\n"
    )


def test_azure_gets_the_gravest_first_and_infos_as_lines() -> None:
    info = diagnostic("«a»", severity=Severity.INFO, message="##vso[task.complete]")
    assert render(OutputFormat.AZURE, run(info, diagnostic("«a»"))).splitlines() == [
        "##vso[task.logissue type=error;sourcepath=arm.sdf;linenumber=1;columnnumber=1;code=NAM901;]name `a` is taken",
        "arm.sdf:1:1: info: #<U+0023>vso[task.complete] [NAM901]",
    ]


def test_a_name_is_no_command_of_azure() -> None:
    evil = "##vso[task.setvariable variable=x]y"
    text = render(OutputFormat.AZURE, run(diagnostic("«a»", message=f"{evil}\n{evil}", help=evil, path=evil)))
    assert text.count("##vso[") == 1
    assert text.count("\n") == 1


def test_gitlab() -> None:
    (issue,) = parsed(OutputFormat.GITLAB, rich_diagnostic())
    fingerprint = issue.pop("fingerprint")
    assert len(fingerprint) == 64
    assert issue == {
        "description": "NAM901: name `a` is taken",
        "check_name": "NAM901",
        "severity": "major",
        "location": {
            "path": "arm.sdf",
            "positions": {"begin": {"line": 2, "column": 5}, "end": {"line": 2, "column": 6}},
        },
    }
    assert parsed(OutputFormat.GITLAB) == []


def test_gitlab_fingerprints_differ_and_outlive_a_moved_line() -> None:
    twice, once = diagnostic("«a»"), diagnostic("«a»", code="SCH902")
    first = [issue["fingerprint"] for issue in parsed(OutputFormat.GITLAB, twice, twice, once)]
    moved = [
        issue["fingerprint"] for issue in parsed(OutputFormat.GITLAB, diagnostic("\n\n «a»"), twice, once)
    ]
    assert len(set(first)) == 3
    assert moved == first


def test_gitlab_paths_are_never_whole() -> None:
    (issue,) = parsed(OutputFormat.GITLAB, diagnostic("«a»", path="/elsewhere/arm.sdf"))
    assert issue["location"]["path"] == "elsewhere/arm.sdf"


def test_rdjson_counts_bytes() -> None:
    found = rich_diagnostic()
    (there, _) = marked("«x»", "other.sdf")
    assert found.fix is not None
    edits = (*found.fix.edits, TextEdit(there, "y"), TextEdit(found.span.source.span(0, 0), "z"))
    log = parsed(OutputFormat.RDJSON, found._replace(fix=Fix("fix it", edits)))
    place = {"start": {"line": 2, "column": 8}, "end": {"line": 2, "column": 9}}
    top = {"start": {"line": 1, "column": 1}, "end": {"line": 1, "column": 1}}
    assert log == {
        "source": {"name": "sdfcheck", "url": HOME},
        "diagnostics": [
            {
                "message": "name `a` is taken",
                "location": {"path": "arm.sdf", "range": place},
                "severity": "ERROR",
                "code": {"value": "NAM901"},
                "suggestions": [{"range": top, "text": "z"}, {"range": place, "text": "c"}],
            }
        ],
    }


def test_rdjson_in_ascii_counts_the_same() -> None:
    (issue,) = parsed(OutputFormat.RDJSON, diagnostic("<a>\n\t<«b»/>"))["diagnostics"]
    assert issue["location"]["range"] == {"start": {"line": 2, "column": 3}, "end": {"line": 2, "column": 4}}
    assert "suggestions" not in issue
