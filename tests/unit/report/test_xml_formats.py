from __future__ import annotations

from lxml import etree

from sdfcheck.lint.diagnostic import Label, Missing, MissingKind, Severity
from sdfcheck.lint.run import Gate
from sdfcheck.report import OutputFormat, render
from tests.unit.report.runs import diagnostic, marked, run

NASTY = "<\"&'>\x00\x1b\x9b\ud800\ufffe\n\t]]>é😀"
LEGAL = "<\"&'>\ufffd\ufffd\x9b\ufffd\ufffd\n\t]]>é😀"


def test_junit() -> None:
    sample = run(diagnostic("\n «a»", message=NASTY), diagnostic("«b»", path="other.sdf"), files=2)
    root = etree.fromstring(render(OutputFormat.JUNIT, sample).encode())
    assert dict(root.items()) == {"name": "sdfcheck", "tests": "3", "failures": "2", "errors": "0"}
    suites = {suite.get("name"): suite for suite in root}
    assert list(suites) == ["arm.sdf", "arm2.sdf", "other.sdf"]
    assert suites["arm2.sdf"].get("failures") == "0"
    assert [(case.get("name"), len(case)) for case in suites["arm2.sdf"]] == [("sdfcheck", 0)]
    (case,) = suites["arm.sdf"]
    (failure,) = case
    assert (case.get("name"), case.get("classname")) == ("NAM901 taken-name 2:2", "arm.sdf")
    assert failure.get("type") == "error"
    assert failure.get("message") == f"NAM901 {LEGAL}"
    assert (failure.text or "").startswith("arm.sdf:2:2: error: <\"&'>␀␛<U+009B>")


def test_junit_fails_for_what_fails_the_run() -> None:
    sample = run(
        diagnostic("«a»"),
        diagnostic("«b»", severity=Severity.INFO),
        diagnostic("«c»", severity=Severity.WARNING, missing=Missing(MissingKind.MODEL, "sun")),
    )

    def outcomes(gate: Gate) -> list[str]:
        root = etree.fromstring(render(OutputFormat.JUNIT, sample._replace(gate=gate)).encode())
        (suite,) = root
        found = [case[0].tag for case in suite]
        assert int(suite.get("failures", "")) == int(root.get("failures", "")) == found.count("failure")
        assert int(suite.get("skipped", "")) == found.count("skipped")
        return found

    assert outcomes(Gate()) == ["failure", "system-out", "skipped"]
    assert outcomes(Gate(Severity.INFO)) == ["failure", "failure", "skipped"]
    assert outcomes(Gate(missing=True)) == ["failure", "system-out", "failure"]


def test_warnings_fail_a_run_when_there_are_more_than_are_tolerated() -> None:
    found = [diagnostic("«a»", severity=Severity.WARNING) for _ in range(2)]
    assert len(run(*found, gate=Gate(warnings=1)).failing) == 2
    assert run(*found, gate=Gate(warnings=2)).failing == ()
    assert run(*found, gate=Gate(Severity.ERROR)).failing == ()


def test_services_are_not_warned_of_what_other_computers_may_have() -> None:
    lacking = diagnostic("«c»", severity=Severity.WARNING, missing=Missing(MissingKind.MODEL, "sun"))
    for form, expected in (
        (OutputFormat.GITHUB, "::notice "),
        (OutputFormat.CHECKSTYLE, 'severity="info"'),
        (OutputFormat.RDJSON, '"severity": "INFO"'),
        (OutputFormat.GITLAB, '"severity": "info"'),
        (OutputFormat.SARIF, '"level": "note"'),
        (OutputFormat.AZURE, "warning: name"),
    ):
        assert expected in render(form, run(lacking)), form
    assert "::warning " in render(OutputFormat.GITHUB, run(lacking, gate=Gate(missing=True)))


def test_checkstyle() -> None:
    sample = run(
        diagnostic("\n «a»", message=NASTY, severity=Severity.INFO),
        diagnostic("«b»", path="a & b.sdf"),
        files=3,
    )
    root = etree.fromstring(render(OutputFormat.CHECKSTYLE, sample).encode())
    assert (root.tag, root.get("version")) == ("checkstyle", "4.3")
    assert [file.get("name") for file in root] == ["a & b.sdf", "arm.sdf"]
    assert dict(root[1][0].items()) == {
        "line": "2",
        "column": "2",
        "severity": "info",
        "message": LEGAL,
        "source": "sdfcheck.NAM901",
    }


def test_labels_without_a_file_of_their_own_stay_with_the_diagnostic() -> None:
    (there, _) = marked("«x»", "included.sdf")
    sample = run(diagnostic("«a»")._replace(labels=(Label(there, "there"),)))
    assert "included.sdf" not in render(OutputFormat.CHECKSTYLE, sample)
    assert "included.sdf" not in render(OutputFormat.JUNIT, sample)
