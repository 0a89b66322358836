import re
from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Model, Rule, Severity, World

NUMBER = re.compile(r"\d+")


class CopiedName(Rule):
    """A model or world has the number of another one in its name.

    Its folder, or the file of a world, has the same name with another number: the file was copied, and the name was
    forgotten. An include without `<name>` takes the name in the file, so that both models in one world clash; topics
    and services of a world have its name in them.
    """

    code = "NAM008"
    name = "copied-name"
    severity = Severity.WARNING
    remedy = """Give the model the name of its folder, the world that of its file.

    If the folder was renamed, rename the model in it, and what refers to it by that name.
    """
    looks_at = (Model, World)
    scaffold = '<sdf version="1.12">{}</sdf>'

    bad = (
        Bad(
            '<model name="«buoy_1»"><link name="l"/></model>',
            file="buoy_2/model.sdf",
            says="model `buoy_1` is in the folder `buoy_2`",
        ),
        Bad('<world name="«cave_3»"/>', file="cave_4.sdf", says="world `cave_3` is in the file `cave_4.sdf`"),
    )
    good = (
        Good('<model name="buoy"><link name="l"/></model>', file="buoy_2/model.sdf", why="a version of it"),
        Good('<model name="Buoy_2"><link name="l"/></model>', file="buoy_2/model.sdf"),
        Good(
            '<model name="buoy_1"><link name="l"/></model>',
            file="buoy_2/buoy_1.sdf",
            why="the file is named after it",
        ),
        Good(
            '<world name="w"><model name="buoy_1"><link name="l"/></model></world>',
            file="buoy_2/model.sdf",
            why="it is not the model of the folder",
        ),
    )

    @staticmethod
    def applies(part: Model | World) -> bool:
        return bool(home(part))

    def check(self, part: Model | World) -> Iterator[Diagnostic]:
        where = f"in the folder `{home(part)}`" if isinstance(part, Model) else f"in the file `{home(part)}`"
        yield self.diagnostic(part.attribute("name") or part, f"{part.title} is {where}")


def home(part: Model | World) -> str:
    """The folder or file whose name has other numbers than that of a model or world; empty if they agree."""
    parent, path = part.element.parent, part.document.path
    if parent is None or parent.name != "sdf" or not NUMBER.search(part.name):
        return ""
    if isinstance(part, World):
        place, name = path.name, path.stem
    else:
        place = name = path.parent.name if path.name.startswith("model") else ""
    is_like = NUMBER.sub("#", name.lower()) == NUMBER.sub("#", part.name.lower())
    return place if is_like and name.lower() != part.name.lower() else ""
