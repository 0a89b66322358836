import re
from collections.abc import Iterator

from sdfcheck import SDF, Bad, Diagnostic, Element, Good, Rule, Severity, replace

UPWARD = re.compile(r"(?:[-+]?0*\.?0*\s+){2}\+?0*(?:[1-9][0-9]*\.?[0-9]*|\.0*[1-9][0-9]*)")
"""Two zeros and a number above zero."""
WORLD = '<world name="w"><gravity>{}</gravity></world>'


class UpwardGravity(Rule):
    """The gravity of a world points up.

    It is a vector in the frame of the world, whose z axis points up: everything that is not fixed rises. `0 0 9.8` is
    the number of the textbook with the sign lost.
    """

    code = "SCH034"
    name = "upward-gravity"
    severity = Severity.WARNING
    remedy = """Give the third number a minus: `0 0 -9.8`."""
    looks_at = (Element,)
    selects = ("sdf:world/gravity",)
    needs = ("<gravity",)
    scaffold = SDF

    bad = (
        Bad(
            WORLD.format("«0 0 9.8»"),
            fixed=WORLD.format("0 0 -9.8"),
            unsafe=True,
            says="gravity of 9.8 m/s² points up",
        ),
    )
    good = (
        Good(WORLD.format("0 0 -9.8")),
        Good(WORLD.format("0 0 0")),
        Good(WORLD.format("0 9.8 0"), why="another axis is meant to point down"),
    )

    @staticmethod
    def applies(element: Element) -> bool:
        return UPWARD.fullmatch(element.content.strip()) is not None

    def check(self, element: Element) -> Iterator[Diagnostic]:
        value = element.own_value
        *others, up = value.text.split()
        meant = " ".join((*others, f"-{up.lstrip('+')}"))
        fix = replace(value, meant, f"write `{meant}`", unsafe=True)
        yield self.diagnostic(value, f"gravity of {up} m/s² points up", fix=fix)
