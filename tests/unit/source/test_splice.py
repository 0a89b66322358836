from contextlib import suppress
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from sdfcheck.source.decode import decode
from sdfcheck.source.splice import Unwritable, splice

LATIN = '<?xml version="1.0" encoding="latin-1"?><sdf a="1"/>'


def edited(data: bytes, old: str, new: str) -> bytes:
    at = decode(data, Path("a.sdf"))[0].text.index(old)
    return splice(data, [(at, at + len(old), new)])


@pytest.mark.parametrize(
    ("data", "expected"),
    [
        (b"<sdf>\r\n\r \n</sdf>", b"<x>\r\n\r \n</sdf>"),
        (b"\xef\xbb\xbf<!-- \xc3\xbc --><sdf>", b"\xef\xbb\xbf<!-- \xc3\xbc --><x>"),
        (b"<!-- \xfc\xe2\x82\xed\xa0\x80\xc3\xbc --><sdf>", b"<!-- \xfc\xe2\x82\xed\xa0\x80\xc3\xbc --><x>"),
        ("\ufeff<!-- ü --><sdf>".encode("utf-16-le"), "\ufeff<!-- ü --><x>".encode("utf-16-le")),
        ("\ufeff<!-- ü --><sdf>".encode("utf-32-be"), "\ufeff<!-- ü --><x>".encode("utf-32-be")),
        ("<!-- ü --><sdf>".encode("utf-16-be"), "<!-- ü --><x>".encode("utf-16-be")),
    ],
)
def test_only_the_edit_changes(data: bytes, expected: bytes) -> None:
    assert edited(data, "<sdf>", "<x>") == expected


def test_the_declared_encoding_is_kept() -> None:
    data = LATIN.replace("1.0", "ä").encode("latin-1")
    assert edited(data, '"1"', '"é"') == LATIN.replace("1.0", "ä").replace('"1"', '"é"').encode("latin-1")


def test_a_character_that_the_encoding_lacks_is_refused() -> None:
    with pytest.raises(Unwritable, match="iso8859-1 has no character for '€'"):
        edited(LATIN.encode(), '"1"', '"€"')


def test_bytes_that_decode_to_nothing_are_refused() -> None:
    data = b'<?xml version="1.0" encoding="shift_jis"?><sdf a="\x81"/>'
    with pytest.raises(Unwritable, match="not shift_jis throughout"):
        edited(data, "sdf", "x")


@settings(deadline=None)
@given(st.binary(max_size=60), st.integers(0, 60), st.integers(0, 8))
def test_any_bytes_keep_what_is_not_edited(data: bytes, at: int, length: int) -> None:
    text = decode(data, Path("a.sdf"))[0].text
    start = min(at, len(text))
    end = min(start + length, len(text))
    edits = [(start, end, text[start:end])] if text[start:end].isascii() else []
    with suppress(Unwritable):
        assert splice(data, edits) == data
