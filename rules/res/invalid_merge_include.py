from collections.abc import Iterator

from sdfcheck import IN_MODEL, IN_WORLD, Bad, Diagnostic, Good, Include, Rule, Severity, listed

NOT_INTO_WORLDS = ("link", "gripper")
ARM = '<sdf version="1.12"><model name="arm"><link name="l"/></model></sdf>'
LAMP = '<sdf version="1.12"><light name="lamp" type="point"/></sdf>'
SET = '<sdf version="1.12"><model name="set"><model name="arm"><link name="l"/></model></model></sdf>'


class InvalidMergeInclude(Rule):
    """A merged model cannot become a part of the model or world that includes it.

    Only models merge, into models (from version 1.9) and worlds (from 1.10). A world has
    no links and grippers of its own, so it takes models that hold nothing but nested
    models, frames and joints. libsdformat refuses everything else.
    """

    code = "RES009"
    name = "invalid-merge-include"
    severity = Severity.ERROR
    remedy = """Leave out `merge="true"`, or include a model that holds only what can be merged.

    A world takes nested models, frames and joints from a merged model; put its links into a model inside of
    it. For a light or actor, an ordinary include is right.
    """
    looks_at = (Include,)
    scaffold = IN_WORLD

    bad = (
        Bad(
            '<include merge="«true»"><uri>arm.sdf</uri></include>',
            files={"arm.sdf": ARM},
            says="a world cannot take link `l`",
        ),
        Bad(
            '<include merge="«true»"><uri>lamp.sdf</uri></include>',
            files={"lamp.sdf": LAMP},
            says="a light cannot be merged",
        ),
        Bad(
            '<frame name="f"><include merge="«true»"><uri>arm.sdf</uri></include></frame>',
            scaffold=IN_MODEL,
            files={"arm.sdf": ARM},
            says="nothing can be merged into frame `f`",
            also=("SCH003",),
        ),
    )
    good = (
        Good('<include merge="true"><uri>arm.sdf</uri></include>', scaffold=IN_MODEL, files={"arm.sdf": ARM}),
        Good('<include merge="true"><uri>set.sdf</uri></include>', files={"set.sdf": SET}),
        Good('<include merge="false"><uri>lamp.sdf</uri></include>', files={"lamp.sdf": LAMP}),
    )

    @staticmethod
    def applies(include: Include) -> bool:
        if not include.is_merged or include.brought is None:
            return False
        into = include.element.parent.name if include.element.parent is not None else ""
        if include.found.kind != "model" or into not in {"model", "world"}:
            return True
        return into == "world" and any(kind in NOT_INTO_WORLDS for kind, _ in include.merged_parts)

    def check(self, include: Include) -> Iterator[Diagnostic]:
        kind, into, merge = include.found.kind, include.element.parent, include.attribute("merge")
        if into is None or merge is None:
            return
        if kind != "model":
            article = "an" if kind == "actor" else "a"
            message = f"{article} {kind} cannot be merged, only a model can"
        elif into.name == "world":
            parts = [f"{kind} `{name}`" for kind, name in include.merged_parts if kind in NOT_INTO_WORLDS]
            message = f"a world cannot take {listed(parts, most=3)} from a merged model"
        else:
            message = f"nothing can be merged into {into.title}"
        yield self.diagnostic(merge, message)
