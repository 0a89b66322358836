"""The vectors are facts of GitHub's own tests (github/codeql-action, `fingerprints.test.ts`)."""

from __future__ import annotations

import pytest

from sdfcheck.report.formats.sarif import line_hashes

WITH_END = [
    "e9496ae3ebfced30:1",
    "fb7c023a8b9ccb3f:1",
    "ce8ba1a563dcdaca:1",
    "e20e36e16fcb0cc8:1",
    "b3edc88f2938467e:1",
    "c8e28b0b4002a3a0:1",
    "c129715d7a2bc9a3:1",
]


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("", ["c129715d7a2bc9a3:1"]),
        (
            " a\nb\n  \t\tc\n d",
            ["271789c17abda88f:1", "54703d4cd895b18:1", "180aee12dab6264:1", "a23a3dc5e078b07b:1"],
        ),
        (
            " hello; \t\nworld!!!\n\n\n  \t\tGreetings\n End",
            [
                "8b7cf3e952e7aeb2:1",
                "b1ae1287ec4718d9:1",
                "bff680108adb0fcc:1",
                "c6805c5e1288b612:1",
                "b86d3392aea1be30:1",
                "e6ceba753e1a442:1",
            ],
        ),
        (" hello; \t\nworld!!!\n\n\n  \t\tGreetings\n End\n", WITH_END),
        (" hello; \t\nworld!!!\r\r\r  \t\tGreetings\r End\r", WITH_END),
        (" hello; \t\r\nworld!!!\r\n\r\n\r\n  \t\tGreetings\r\n End\r\n", WITH_END),
    ],
)
def test_hashes_are_those_of_github(text: str, expected: list[str]) -> None:
    assert list(line_hashes(text, range(1, 10)).values()) == expected


def test_lines_that_hash_alike_are_counted() -> None:
    text = "<link/>\n" * 40
    first, second, last = (line_hashes(text, [line])[line] for line in (1, 2, 40))
    assert first.endswith(":1")
    assert second == first.replace(":1", ":2")
    assert last.endswith(":1")


def test_only_the_next_hundred_units_count() -> None:
    same = [line_hashes("😀" * 50 + rest, [1])[1] for rest in ("", "a", "\nb")]
    assert len(set(same)) == 1
    assert line_hashes("😀" * 49 + "a", [1]) != line_hashes("😀" * 49 + "b", [1])
