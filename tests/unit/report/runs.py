"""Small runs to render: documents with their places marked as in the examples of rules."""

from __future__ import annotations

import json
import re
from pathlib import Path
from typing import Any

from sdfcheck.consumers.reaction import ignores, refuses
from sdfcheck.lint.diagnostic import Diagnostic, Label, Origin, Severity
from sdfcheck.lint.fix import Applicability, Fix, TextEdit
from sdfcheck.lint.run import RuleFacts, Run
from sdfcheck.report import OutputFormat, render
from sdfcheck.source.text import Source, Span

_MARK = re.compile("[«»{}]")


def marked(text: str, path: str = "arm.sdf") -> tuple[Span, list[Span]]:
    """The span between ``«»`` and those between ``{}``, of a source without the marks."""
    source = Source(Path(path), _MARK.sub("", text))
    opened: list[int] = []
    primary, others = source.span(0, 0), []
    for number, match in enumerate(_MARK.finditer(text)):
        offset = match.start() - number
        if match[0] in "«{":
            opened.append(offset)
            continue
        span = source.span(opened.pop(), offset)
        if match[0] == "»":
            primary = span
        else:
            others.append(span)
    return primary, others


def diagnostic(text: str, *labels: str, path: str = "arm.sdf", **fields: Any) -> Diagnostic:
    """A diagnostic at ``«»``, with the labels at ``{}`` in their order."""
    span, places = marked(text, path)
    return Diagnostic(
        **{
            "code": "NAM901",
            "name": "taken-name",
            "severity": Severity.ERROR,
            "message": "name `a` is taken",
            "span": span,
            "labels": tuple(Label(place, label) for place, label in zip(places, labels, strict=True)),
            **fields,
        }
    )


def fixed(found: Diagnostic, text: str, *, safe: bool = True) -> Diagnostic:
    """The diagnostic with a fix that replaces its span."""
    applicability = Applicability.SAFE if safe else Applicability.UNSAFE
    return found._replace(fix=Fix(f"write `{text}`", (TextEdit(found.span, text),), applicability))


def facts(code: str = "NAM901", name: str = "taken-name", **fields: Any) -> RuleFacts:
    return RuleFacts(
        **{
            "code": code,
            "name": name,
            "family": code[:3],
            "severity": Severity.ERROR,
            "summary": "Two things have one name.",
            "fixable": "",
            "default": True,
            "selects": (),
            "explains": (),
            "affects": {
                "gazebo": {"sdf": "reject: rejects it", "urdf": "reject: rejects it"},
                "drake": {"sdf": "reject: aborts"},
            },
            "module": "pack.taken_name",
            **fields,
        }
    )


def run(*diagnostics: Diagnostic, files: int = 1, **fields: Any) -> Run:
    paths = tuple(
        Path("arm.sdf") if number == 1 else Path(f"arm{number}.sdf") for number in range(1, files + 1)
    )
    return Run(diagnostics, paths, **fields)


def rich_diagnostic() -> Diagnostic:
    """One with everything; characters of several bytes are before the defect."""
    call, _ = marked("«call»", "world.xacro")
    found = fixed(diagnostic("<é>\n\t<𐐀>«a»</𐐀>{b}\n", "here"), "c")
    affects = (("drake", refuses("aborts")), ("gazebo", ignores("it")))
    return found._replace(help="rename it", origins=(Origin(call, "included here"),), affects=affects)


def parsed(format: OutputFormat, *diagnostics: Diagnostic, **fields: Any) -> Any:
    """The report of the run as a program reads it."""
    return json.loads(render(format, run(*diagnostics, **fields)))


def shown(found: Diagnostic, **fields: Any) -> str:
    """The lines of one diagnostic, without its heading and the closing line."""
    text = render(OutputFormat.FULL, run(found, **fields))
    heading, body = text.split("\n", 1)
    assert heading == "error[NAM901]: name `a` is taken"
    return body.rpartition("\n\n")[0]
