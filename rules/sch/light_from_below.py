from collections.abc import Iterator

from sdfcheck import IN_WORLD, Bad, Diagnostic, Good, Light, Rule, Severity, World

SUN = '<light name="sun" type="directional"><direction>{}</direction></light>'
LAMP = '<light name="lamp" type="point"><pose>0 0 3 0 0 0</pose></light>'


class LightFromBelow(Rule):
    """The only light of a world shines up.

    The direction of a light is where it shines to. The ground, and all that is seen from above, stays dark, and cameras
    see next to nothing.
    """

    code = "SCH037"
    name = "light-from-below"
    severity = Severity.WARNING
    remedy = """Write where the light shines to, with a negative last number: `-0.5 0.1 -0.9` for a sun.

    The pose of a directional light turns its direction; where it is does not matter.
    """
    looks_at = (World,)
    needs = ("directional",)
    scaffold = IN_WORLD

    bad = (Bad(SUN.format("«0 0 1»"), says="light `sun` shines up, and there is no other light"),)
    good = (
        Good(SUN.format("0 0 -1")),
        Good(SUN.format("0 0 1") + LAMP, why="for the looks, beside another one"),
        Good(SUN.format("1 0 0"), why="at dawn"),
        Good(SUN.format("0 0 1").replace("<dir", "<pose>0 0 0 3.14 0 0</pose><dir"), why="turned around"),
    )

    @staticmethod
    def applies(world: World) -> bool:
        return len(world.root.elements.get("light", ())) == len(world.lights) == 1 and is_rising(world)

    def check(self, world: World) -> Iterator[Diagnostic]:
        light = world.lights[0]
        message = f"{light.title} shines up, and there is no other light"
        yield self.diagnostic(light.direction, message)


def is_rising(world: World) -> bool:
    """Is its light a sun that shines up, in a world to which no include brings another one?"""
    light: Light = world.lights[0]
    direction, pose = light.direction, light.find("pose")
    turned = pose is not None and set(pose.content.split()[3:5]) - {"0", "0.0", "-0"}
    uris = [include.find("uri") for include in world.children("include")]
    brings = not world.is_complete or any(uri is None or "sun" in uri.content.lower() for uri in uris)
    return (
        light.type == "directional" and len(direction) == 3 and direction[2] > 0 and not turned and not brings
    )
