"""The summary in Markdown, and what names cannot do in it."""

from __future__ import annotations

from sdfcheck.lint.diagnostic import Missing, MissingKind, Severity
from sdfcheck.report import OutputFormat, render
from tests.unit.report.runs import diagnostic, facts, fixed, rich_diagnostic, run


def test_a_summary() -> None:
    warning = diagnostic("«a»", code="SCH902", name="odd-thing", severity=Severity.WARNING)
    sample = run(rich_diagnostic(), fixed(warning, "b"), diagnostic("«a»", path="b.sdf"), rules=(facts(),))
    assert render(OutputFormat.MARKDOWN, sample).splitlines() == [
        "## sdfcheck",
        "",
        "Found 2 errors and 1 warning in 1 file (2 fixable with --fix).",
        "",
        "### Fix first: `sdfcheck lint --fix` corrects these without changing a robot",
        "",
        "| Findings | Rule | Files | First |",
        "|---:|---|---:|---|",
        "| 1 | NAM901 taken-name | 1 | `arm.sdf:2:5` |",
        "| 1 | SCH902 odd-thing | 1 | `arm.sdf:1:1` |",
        "",
        "### Errors: a simulator refuses the file, or builds another robot",
        "",
        "| Findings | Rule | Files | First |",
        "|---:|---|---:|---|",
        "| 1 | NAM901 taken-name | 1 | `b.sdf:1:1` |",
        "",
        "### Consumers",
        "",
        "| Consumer | Findings | Files that it refuses |",
        "|---|---:|---:|",
        "| Drake | 1 | 1 |",
        "| Gazebo | 1 | 0 |",
        "",
        "<details>",
        "<summary>Findings</summary>",
        "",
        "|  | Message | Place | Rule |",
        "|---|---|---|---|",
        "| error | name `a` is taken | `arm.sdf:2:5` | NAM901 taken-name |",
        "| error | name `a` is taken | `b.sdf:1:1` | NAM901 taken-name |",
        "| warning | name `a` is taken | `arm.sdf:1:1` | SCH902 odd-thing |",
        "",
        "</details>",
    ]


def test_a_clean_run() -> None:
    assert render(OutputFormat.MARKDOWN, run()) == "## sdfcheck\n\nAll clear: 1 file, no findings.\n"


def test_rules_link_to_their_pages() -> None:
    known = facts(module="sdfcheck_rules.names.taken_name")
    assert f"[NAM901 taken-name]({known.page})" in render(
        OutputFormat.MARKDOWN, run(diagnostic("«a»"), rules=(known,))
    )


def test_names_are_neither_markup_nor_cells() -> None:
    message = "name `a|b<c>` and `x` *is* [taken](http://x) <img> & ``"
    text = render(OutputFormat.MARKDOWN, run(diagnostic("«a»", message=message, path="a|`b`<i>.sdf")))
    (row,) = (line for line in text.splitlines() if line.startswith("| error"))
    assert row.split(" | ")[1:3] == [
        r"name <code>a\|b&lt;c&gt;</code> and `x` \*is\* \[taken\](http://x) &lt;img&gt; &amp; <code></code>",
        r"<code>a\|\`b\`&lt;i&gt;.sdf:1:1</code>",
    ]


def test_much_is_cut_off() -> None:
    found = [diagnostic("«a»", code=f"ABC{at:03}", message="x" * 10_000 + f"{at}") for at in range(300)]
    text = render(OutputFormat.MARKDOWN, run(*found))
    assert "And 280 other rules." in text
    assert "200 other findings not shown." in text
    assert len(text) < 100_000


def test_repeated_findings_are_one_row() -> None:
    found = [diagnostic("«a»", message=f"name `a{at}` is taken") for at in range(9)]
    assert "| error | name `a0` is taken (and 8 more) |" in render(OutputFormat.MARKDOWN, run(*found))


def test_files_not_on_this_computer_are_apart() -> None:
    lacking = diagnostic("«a»", missing=Missing(MissingKind.PACKAGE, "<b>"))
    text = render(OutputFormat.MARKDOWN, run(lacking))
    assert "### " not in text
    assert "&lt;b&gt;" in text
