"""The problem of a value that was not accepted at once, if it has one."""

from __future__ import annotations

from collections.abc import Iterator

from sdfcheck.formats import history, problems
from sdfcheck.formats.choices import Verdict
from sdfcheck.formats.near_names import suggest
from sdfcheck.formats.reading import Outcome, Reading
from sdfcheck.formats.schema import Definition, RowInVersion
from sdfcheck.formats.sdf.text_pieces import cut_text, part
from sdfcheck.formats.sdf.values import read_at
from sdfcheck.formats.version import NEWEST
from sdfcheck.source.document import Element, Value

_KINDS = {Outcome.MISREAD: problems.MisreadValue, Outcome.WRONG_COUNT: problems.WrongComponentCount}


def text_problems(element: Element, definition: Definition) -> Iterator[object]:
    """The problems of the text of an element that holds a value."""
    newest = history.in_version(definition, NEWEST) or definition
    value = element.own_value
    rotation = element.attribute("rotation_format") if "rotation_format" in newest.attributes else None
    degrees = element.attribute("degrees")
    if rotation is not None and degrees is not None and _exclude_each_other(rotation, degrees):
        yield problems.ConflictingRotation(degrees, rotation)
    elif not value.text:
        # An empty pose is a usual way to leave it at the default; an empty number is not.
        if definition.needs_value or definition.type not in {"pose", "string"}:
            yield problems.MalformedValue(value, definition, read_at(definition, ""), element.span)
    elif cut := cut_text(element):
        yield problems.CutText(value, cut)
    elif rotation is not None:
        yield from judge(value, newest, read_at(newest, value.text, rotation.text.strip() or "euler_rpy"))
    elif not definition.accepts(value.text) and (
        newest.type != definition.type or not newest.accepts(value.text)
    ):
        yield from judge(value, definition, read_at(definition, value.text))


def _exclude_each_other(rotation: Value, degrees: Value) -> bool:
    return rotation.text.strip() == "quat_xyzw" and degrees.text.strip().lower() in {"true", "1"}


def judge(value: Value, definition: RowInVersion, reading: Reading) -> Iterator[object]:
    """Turn a reading into the problem that it is."""
    if reading.outcome is Outcome.NOT_A_CHOICE:
        yield from _choice(value, definition, reading)
    else:
        yield from problem_of(value, definition, reading)


def problem_of(value: Value, definition: RowInVersion, reading: Reading) -> Iterator[object]:
    """The problem of a number or truth value, if there is one."""
    if reading.is_fine:
        return
    span = part(value, reading.start, reading.end)
    if reading.outcome is Outcome.OUT_OF_RANGE:
        instead = reading.range.instead if reading.range else None
        yield problems.ValueOutOfRange(value, span, str(reading.range), reading.refused, instead)
    elif reading.outcome is Outcome.NOT_FINITE:
        yield problems.ValueOutOfRange(value, span, "finite", reading.refused)
    else:
        kind = _KINDS.get(reading.outcome, problems.MalformedValue)
        yield kind(value, definition, reading, span)


def _choice(value: Value, definition: RowInVersion, reading: Reading) -> Iterator[problems.UnknownChoice]:
    """A value that is not in the list of the version, which need not keep anybody from reading it."""
    choices = definition.choices
    assert choices is not None
    doubtful = reading.verdict in {Verdict.UNKNOWN, Verdict.WRONG_CASE, Verdict.REMOVED}
    # Of what is in its own list libsdformat makes what it can, whatever the version.
    in_list = choices.library and reading.verdict is not Verdict.UNKNOWN
    if not reading.refused and (in_list or not doubtful):
        return
    candidates = choices.library or choices.listed
    suggestion = suggest(value.text.strip(), candidates)
    yield problems.UnknownChoice(value, candidates, suggestion, reading.refused)
