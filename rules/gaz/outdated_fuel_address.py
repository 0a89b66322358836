from collections.abc import Iterator

from sdfcheck import (
    IN_URDF_LINK,
    IN_VISUAL,
    IN_WORLD,
    Bad,
    Diagnostic,
    Good,
    Root,
    Rule,
    Severity,
    TextEdit,
    Value,
    make_fix,
    used,
)

OLD, NEW = "fuel.ignitionrobotics.org", "fuel.gazebosim.org"
MARK = f"//{OLD}/"
INCLUDE = "<include><uri>https://{}/1.0/openrobotics/models/{}</uri></include>"


class OutdatedFuelAddress(Rule):
    """A model or file is fetched from the former address of Fuel.

    The server moved with the rename to Gazebo. Its old host only redirects, and has been out of reach for days;
    fuel_tools 7 warns of it, and later releases no longer know it, so that models are kept apart in the cache
    and fetched again. The new host has the same paths, and releases before the rename fetch from it as well.
    """

    code = "GAZ017"
    name = "outdated-fuel-address"
    severity = Severity.WARNING
    remedy = """Write `https://fuel.gazebosim.org` for the former address.

    The paths stay the same. Models in the cache of the old host are fetched once more.
    """
    looks_at = (Root,)
    needs = (MARK,)
    scaffold = IN_WORLD
    sources = ("https://github.com/gazebosim/gz-fuel-tools/blob/main/Migration.md",)

    bad = (
        Bad(
            "<include><uri>«https://fuel.ignitionrobotics.org/1.0/openrobotics/models/post»</uri></include>",
            fixed=INCLUDE.format(NEW, "post"),
            says="`fuel.ignitionrobotics.org` is now `fuel.gazebosim.org`",
        ),
        Bad(
            "<include><uri>«https://fuel.ignitionrobotics.org/1.0/openrobotics/models/post»</uri></include>"
            + INCLUDE.format(OLD, "buoy").replace("<uri>", "<name>b</name><uri>"),
            fixed=INCLUDE.format(NEW, "post")
            + INCLUDE.format(NEW, "buoy").replace("<uri>", "<name>b</name><uri>"),
            says="(used 2 times)",
        ),
        Bad(
            "<geometry><mesh><uri>«https://fuel.ignitionrobotics.org/1.0/a/models/b/tip/files/c.dae»</uri></mesh>"
            "</geometry>",
            fixed=f"<geometry><mesh><uri>https://{NEW}/1.0/a/models/b/tip/files/c.dae</uri></mesh></geometry>",
            scaffold=IN_VISUAL,
        ),
        Bad(
            '<visual><geometry><mesh filename="«https://fuel.ignitionrobotics.org/1.0/a/models/b/tip/files/c.dae»"/>'
            "</geometry></visual>",
            fixed=f'<visual><geometry><mesh filename="https://{NEW}/1.0/a/models/b/tip/files/c.dae"/></geometry></visual>',
            scaffold=IN_URDF_LINK,
        ),
    )
    good = (
        Good(INCLUDE.format(NEW, "post")),
        Good(INCLUDE.format("fuel.ignitionrobotics.org.example", "post"), why="another server"),
    )

    @staticmethod
    def applies(root: Root) -> bool:
        return MARK in root.document.source.text and any(addresses(root))

    def check(self, root: Root) -> Iterator[Diagnostic]:
        found = list(addresses(root))
        edits = tuple(TextEdit(value.span, value.text.replace(MARK, f"//{NEW}/")) for value in found)
        fix = make_fix(f"write `{NEW}`", edits)
        yield self.diagnostic(found[0], f"`{OLD}` is now `{NEW}`{used(len(found))}", fix=fix)


def addresses(root: Root) -> Iterator[Value]:
    """The texts and attributes with the old host."""
    for element in root.all_elements():
        values = (element.own_value, *map(element.attribute, element.attributes))
        yield from (value for value in values if value is not None and MARK in value.text)
