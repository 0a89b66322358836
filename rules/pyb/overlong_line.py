import re
from collections.abc import Iterator

from sdfcheck import Bad, Consumer, Diagnostic, Good, Root, Rule, Severity, refuses, warns

LONGEST = 8191
"""So many characters of a line are read at once (measured with PyBullet 3.2.7)."""
SHOWN = 30
WORD = re.compile(r"[^\s<>\"'=/]+")
ROBOT = f'<robot name="r"><!--{"x" * (LONGEST - 36)}-->{{}}</robot>'


class OverlongLine(Rule):
    """A line is longer than PyBullet reads at once, and it breaks the line inside of a word.

    After 8,191 characters it goes on in a new line. Where that is in the name of an element or attribute, it refuses
    the robot; where it is in a number, it takes the digits before for the number, without a word. Programs that write
    a robot into one line make such files. For others a line may be as long as it likes.
    """

    code = "PYB002"
    name = "overlong-line"
    severity = Severity.WARNING
    remedy = """Write each element into a line of its own.

    `xmllint --format` does that for a whole file.
    """
    default = False
    looks_at = (Root,)
    scaffold = ROBOT
    sources = (
        "https://github.com/bulletphysics/bullet3/blob/master/examples/Importers/ImportURDFDemo/BulletUrdfImporter.cpp",
    )

    bad = (
        Bad(
            '<link name="«ar»m_2"/>',
            says="after 8191 characters PyBullet breaks the line, here inside of `arm_2`",
        ),
    )
    good = (
        Good('\n<link name="arm_2"/>', why="the line is shorter"),
        Good('<!-- none --><link name="arm_2"/>', why="a remark may be broken"),
    )

    @staticmethod
    def applies(root: Root) -> bool:
        return root.is_urdf and any(True for _ in breaks(root))

    def check(self, root: Root) -> Iterator[Diagnostic]:
        source = root.document.source
        for at in breaks(root):
            text = source.text
            tag = text[text.rfind("<", 0, at) : at]
            is_value = (tag.count('"') if '"' in tag else tag.count("'")) % 2 == 1
            word = next(found[0] for found in WORD.finditer(text, max(0, at - SHOWN)) if found.end() > at)
            yield self.diagnostic(
                source.span(at - 1, at + 1),
                f"after {LONGEST} characters PyBullet breaks the line, here inside of `{word[-SHOWN:]}`",
                affects={Consumer.PYBULLET: warns("reads another value") if is_value else refuses()},
            )
            return


def breaks(root: Root) -> Iterator[int]:
    """Where it breaks lines inside of the words of tags."""
    text = root.document.source.text
    start = 0
    while len(text) - start > LONGEST:
        end = text.find("\n", start)
        end = len(text) if end < 0 else end
        for at in range(start + LONGEST, end, LONGEST):
            if text.isascii() and is_in_tag(text, at) and WORD.match(text, at - 1) and WORD.match(text, at):
                yield at
        start = end + 1


def is_in_tag(text: str, at: int) -> bool:
    """Is a place between the ends of a tag?"""
    opened = text.rfind("<", 0, at)
    return opened > text.rfind(">", 0, at) and text[opened + 1 : opened + 2] not in {"!", "?"}
