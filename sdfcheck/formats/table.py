"""Reading data/sdf.txt: the lines as they stand, parsed block by block when somebody asks."""

from __future__ import annotations

from functools import cache
from pathlib import Path

from sdfcheck.formats.version import NEWEST

_FILE = Path(__file__).with_name("data") / "sdf.txt"


class Row:
    """One line: an element or attribute over all versions, and the lines below it."""

    __slots__ = ("default", "extras", "life", "multiplicity", "name", "rows", "type")

    def __init__(self, line: str) -> None:
        fields = line.split("\t")
        if len(fields) < 5:
            fields += [""] * (5 - len(fields))
        self.name, self.life, self.type, self.multiplicity, self.default = fields[:5]
        self.extras = fields[5:]
        self.rows: list[Row] = []

    def extra(self, key: str) -> str:
        """The text of a ``key=value`` field, empty without one."""
        start = f"{key}="
        for field in self.extras:
            if field.startswith(start):
                return field[len(start) :]
        return ""

    def lives(self, minor: int) -> bool:
        """Whether version 1.``minor`` has it, given that it has the parent."""
        return not self.life or any(first <= minor <= last for first, last in spans(self.life))


def at(field: str, minor: int) -> str:
    """What a field of the form ``first|5:later`` says in version 1.``minor``."""
    if "|" not in field:
        return field
    value, *changes = field.split("|")
    for change in changes:
        since, _, later = change.partition(":")
        if int(since) > minor:
            break
        value = later
    return value


def newest_name(top: Row) -> str:
    """What the element of a definition is called, lastly."""
    return at(top.extra("name"), NEWEST.minor) or top.name


def spans(life: str) -> list[tuple[int, int]]:
    """The minor versions of a life such as ``2-6,10``, both ends included."""
    found = []
    for span in life.split(","):
        first, _, last = span.partition("-")
        found.append((int(first), int(last or first)))
    return found


@cache
def block(stem: str) -> Row:
    """One definition, with everything in it."""
    lines = _blocks()[stem].split("\n")
    top = Row(lines[0])
    path = [top]
    for line in lines[1:]:
        text = line.lstrip(" ")
        row = Row(text)
        del path[len(line) - len(text) :]
        path[-1].rows.append(row)
        path.append(row)
    return top


def stems() -> list[str]:
    return sorted(_blocks())


@cache
def _blocks() -> dict[str, str]:
    text = _FILE.read_text("utf-8")
    lines = text[text.rindex("\n# ") + 1 :].partition("\n")[2].rstrip("\n")
    blocks: dict[str, str] = {}
    start = 0
    while start < len(lines):
        # A block goes on as long as its lines are indented.
        end = lines.find("\n", start)
        while end != -1 and lines[end + 1] == " ":
            end = lines.find("\n", end + 1)
        whole = lines[start:] if end == -1 else lines[start:end]
        blocks[whole[: whole.index("\t")]] = whole
        start += len(whole) + 1
    return blocks
