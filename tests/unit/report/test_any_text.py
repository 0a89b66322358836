"""For any content of a file and any places, every format renders and none acts on a terminal."""

from __future__ import annotations

from pathlib import Path

from hypothesis import given, settings
from hypothesis import strategies as st

from sdfcheck.lint.diagnostic import Label
from sdfcheck.report import OutputFormat, render
from sdfcheck.source.text import Source, Span
from tests.unit.report.runs import diagnostic, fixed, run

TEXTS = st.text(st.sampled_from("ab<>&/\"' \t\n\r\x00\x1b\x9b🤖é\u0301\u200d\u202e\ud800%:,]"), max_size=60)


@st.composite
def spans(draw: st.DrawFn) -> Span:
    source = Source(Path("arm.sdf"), draw(TEXTS) + "x" * draw(st.sampled_from([0, 0, 300])))
    start = draw(st.integers(0, len(source.text)))
    return source.span(start, draw(st.integers(start, len(source.text))))


@settings(max_examples=60, deadline=None)
@given(spans(), st.lists(st.builds(Label, spans(), TEXTS), max_size=3), TEXTS)
def test_any_text(span: Span, labels: list[Label], message: str) -> None:
    found = diagnostic("")._replace(span=span, labels=tuple(labels), message=message)
    for kind in OutputFormat:
        text = render(kind, run(fixed(found, message)))
        text.encode()
        assert all(character.isprintable() or character in "\n\u200d" for character in text)
