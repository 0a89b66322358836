"""Bytes to text: the text is right, and the defect says where it is not what was declared."""

from __future__ import annotations

from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from sdfcheck.source.decode import EncodingDefect, EncodingKind, decode

PATH = Path("example.sdf")
DECLARED = '<?xml version="1.0" encoding="{}"?><sdf name="Wörld"/>'


def decoded(data: bytes) -> tuple[str, list[EncodingDefect]]:
    source, defects = decode(data, PATH)
    return source.text, defects


@pytest.mark.parametrize("encoding", ["UTF-8", "utf-8", "utf8"])
def test_utf8_is_read_whatever_its_spelling(encoding: str) -> None:
    text = DECLARED.format(encoding)
    assert decoded(text.encode()) == (text, [])


@pytest.mark.parametrize("encoding", ["ISO-8859-1", "latin-1", "windows-1252", "cp437"])
def test_a_declared_encoding_is_used(encoding: str) -> None:
    text = DECLARED.format(encoding)
    assert decoded(text.encode(encoding)) == (text, [])


def test_a_byte_order_mark_is_no_part_of_the_text() -> None:
    assert decoded(b"\xef\xbb\xbf<sdf/>") == ("<sdf/>", [])


@pytest.mark.parametrize("encoding", ["utf-16", "utf-16-le", "utf-16-be", "utf-32", "utf-32-le", "utf-32-be"])
def test_wide_encodings_are_read_and_reported(encoding: str) -> None:
    text, (defect,) = decoded("<sdf name='Wörld'/>".encode(encoding))
    assert text == "<sdf name='Wörld'/>"
    assert defect.kind is EncodingKind.WIDE
    assert defect.actual == encoding[:6].upper()
    assert defect.span.text == "<"


def test_latin1_without_declaration_is_read_as_such_at_its_first_byte() -> None:
    text, (defect,) = decoded("<!-- für -->\n<sdf name='Wörld'/>".encode("latin-1"))
    assert text == "<!-- für -->\n<sdf name='Wörld'/>"
    assert defect.kind is EncodingKind.UNDECODABLE
    assert (defect.span.text, defect.declared, defect.actual) == ("ü", "UTF-8", "Latin-1")


def test_utf8_beside_latin1_stays_what_it_is() -> None:
    text, (defect,) = decoded("Größe ".encode() + "Größe".encode("latin-1"))
    assert text == "Größe Größe"
    assert defect.span.start == 8


def test_bytes_that_a_declared_encoding_does_not_know() -> None:
    text, (defect,) = decoded(b'<?xml version="1.0" encoding="shift_jis"?><sdf n="\xff"/>')
    assert defect.kind is EncodingKind.UNDECODABLE
    assert (defect.span.text, defect.declared, defect.actual) == ("\ufffd", "shift_jis", "")
    assert text.endswith('"\ufffd"/>')


@pytest.mark.parametrize(
    ("encoding", "kind"),
    [
        ("utf-16", EncodingKind.DISAGREEMENT),
        ("UTF-32LE", EncodingKind.DISAGREEMENT),
        ("us-ascii", EncodingKind.DISAGREEMENT),
        ("klingon", EncodingKind.UNKNOWN_ENCODING),
        ("utf-7", EncodingKind.UNKNOWN_ENCODING),
        ("rot13", EncodingKind.UNKNOWN_ENCODING),
        ("unicode_escape", EncodingKind.UNKNOWN_ENCODING),
        ("punycode", EncodingKind.UNKNOWN_ENCODING),
    ],
)
def test_wrong_declarations_are_reported_at_the_name(encoding: str, kind: EncodingKind) -> None:
    text, (defect,) = decoded(DECLARED.format(encoding).encode())
    assert text == DECLARED.format(encoding)
    assert (defect.kind, defect.span.text, defect.actual) == (kind, encoding, "UTF-8")


def test_a_mark_and_a_declaration_that_disagree() -> None:
    _, (defect,) = decoded(b"\xef\xbb\xbf" + DECLARED.format("ISO-8859-1").encode())
    assert defect.kind is EncodingKind.DISAGREEMENT


def test_ascii_is_a_part_of_utf8() -> None:
    assert decoded(b'<?xml version="1.0" encoding="ascii"?><sdf/>')[1] == []


def test_a_declaration_further_down_is_none() -> None:
    assert decoded(b'<sdf/><?xml version="1.0" encoding="klingon"?>')[1] == []


def test_surrogates_and_nul_bytes_survive() -> None:
    assert decoded(b"a\0b")[0] == "a\0b"
    text, (defect,) = decoded(b"\xed\xa0\x80")
    assert len(text) == 3
    assert defect.span.start == 0


@given(st.binary(max_size=200))
def test_any_bytes_give_a_text_and_places_in_it(data: bytes) -> None:
    source, defects = decode(data, PATH)
    for defect in defects:
        assert 0 <= defect.span.start <= defect.span.end <= len(source.text) + 1
