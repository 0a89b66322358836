import re
from collections.abc import Iterator

from sdfcheck import Bad, Consumer, Diagnostic, Good, Root, Rule, Severity, accepts, replace

_MISSPELLED = re.compile(r"\D*0*1[.,]0*(\d+)(?!\d)")
"""A version of SDFormat, perhaps with spaces around it, a leading zero, a third number or a comma."""


class UnknownVersion(Rule):
    """The file declares a version of the format that does not exist.

    libsdformat looks the version up as a text: `1.6.0`, `1.06` and ` 1.6` are all unknown
    to it, as is everything before 1.2. The load fails, and where the text does not begin
    with a number the program crashes. Older releases, as the one in Drake, convert 1.0 as well.
    """

    code = "SCH002"
    name = "unknown-version"
    severity = Severity.ERROR
    remedy = """Declare a version of SDFormat: two numbers, from 1.2 to 1.12.

    It is the version of the format, not that of libsdformat or Gazebo: libsdformat 14 reads 1.11,
    libsdformat 12 reads 1.9.
    """
    looks_at = (Root,)
    selects = ("sdf:sdf", "urdf:robot")
    scaffold = '<sdf version="{}"><model name="m"><link name="base"/></model></sdf>'

    bad = (
        Bad("«1.6.0»", fixed="1.6", unsafe=True, says="did you mean `1.6`?"),
        Bad("«1.13»", says="version `1.13` is not known"),
        Bad("«1.0»", says="version `1.0` is not known"),
        Bad("«1,9»", fixed="1.9", unsafe=True, says="did you mean `1.9`?"),
    )
    good = (Good("1.2", why="the oldest that consumers convert"), Good("1.10", why="ten, not one"))

    @staticmethod
    def applies(root: Root) -> bool:
        version = root.version
        if version is None or version in root.known_versions:
            return False
        # An SDFormat file with an empty version has none.
        return root.is_urdf or bool(version.strip())

    def check(self, root: Root) -> Iterator[Diagnostic]:
        value, known = root.element.attribute("version"), root.known_versions
        if value is None:
            return
        message = f"version `{value.text}` is not known"
        listed = f"known are {known[0]} to {known[-1]}"
        meant = meant_version(value.text, is_urdf=root.is_urdf)
        if meant not in known:
            affects = {Consumer.DRAKE: accepts("converts it")} if value.text == "1.0" else {}
            yield self.diagnostic(value, message, help=listed, affects=affects)
            return
        fix = replace(value, meant, f"declare version {meant}", unsafe=True)
        yield self.diagnostic(value, message, meant=meant, fix=fix, help=listed)


def meant_version(text: str, *, is_urdf: bool) -> str:
    """The version that a misspelled one seems to mean; it need not exist."""
    if is_urdf:
        return text.strip() if "." in text else f"{text}.0"
    found = _MISSPELLED.match(text)
    return f"1.{found[1]}" if found else ""
