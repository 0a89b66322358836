from collections.abc import Iterator

from sdfcheck import IN_LINK, IN_MODEL, Bad, Diagnostic, Good, Root, Rule, Severity
from sdfcheck_rules.nam.taken import is_reserved

_ROOT = "__root__"
_REFUSED = frozenset({"custom_rpy", "placement_frame"})
"""Elsewhere a reference to it is one to a frame that is not there."""

IMU = (
    '<sensor name="s" type="imu"><imu><orientation_reference_frame><localization>CUSTOM</localization>'
    "{}</orientation_reference_frame></imu></sensor>"
)


class ReservedName(Rule):
    """A name is one of those that libsdformat keeps for itself.

    `world`, and whatever begins and ends with two underscores, are names of implicit
    frames. libsdformat refuses to give them to anything (1.7 on, in files of all versions),
    in URDF, too, but for a link `world`.
    """

    code = "NAM003"
    name = "reserved-name"
    severity = Severity.ERROR
    remedy = """Choose another name.

    To fix something to the world, name `world` as the parent of a joint; to be a root that does not move, a
    link of a URDF may be called `world`. `__model__` and the like can be referred to in poses, but not
    given to anything.
    """
    looks_at = (Root,)
    scaffold = IN_MODEL

    bad = (
        Bad('<link name="«world»"/>', says="the name `world` is reserved"),
        Bad('<frame name="«__tip__»"/>', says="the name `__tip__` is reserved"),
        Bad(
            '<custom_rpy parent_frame="«__root__»">0 0 0</custom_rpy>',
            scaffold=IN_LINK.format(IMU),
            says="`__root__` cannot be referred to",
        ),
        Bad(
            '<robot name="«world»"><link name="a"/></robot>', scaffold="", says="the name `world` is reserved"
        ),
    )
    good = (
        Good('<frame name="__tip"/>', why="reserved are names with underscores at both ends"),
        Good('<link name="worlds"/>'),
        Good('<plugin name="__p__" filename="p"/>', why="the names of plugins are free"),
    )

    @staticmethod
    def applies(root: Root) -> bool:
        is_referred_to = _ROOT in root.document.source.text
        return is_referred_to or any(is_reserved(name, root) for name in root.names.special)

    def check(self, root: Root) -> Iterator[Diagnostic]:
        for name in root.names.special:
            if is_reserved(name, root):
                known = "reserved are `world` and names that begin and end with two underscores"
                yield self.diagnostic(name.value, f"the name `{name.name}` is reserved", help=known)
        if _ROOT in root.document.source.text:
            for value in root.names.references:
                if value.text.strip() == _ROOT and value.element.name in _REFUSED:
                    yield self.diagnostic(value, f"`{_ROOT}` cannot be referred to")
