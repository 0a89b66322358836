from collections.abc import Iterator

from sdfcheck import IN_MODEL, Bad, Consumer, Diagnostic, Good, Link, Rule, Severity, warns


class MissingInertial(Rule):
    """A link that moves has a shape and no `<inertial>`.

    libsdformat gives it 1 kg and moments of 1 kg·m² each, whatever its size; Drake takes
    the same. A cup of that inertia turns like a barrel. For a part of the scenery, say
    `<static>true</static>`; from 1.11 on `<inertial auto="true"/>` computes it.
    """

    code = "INR004"
    name = "missing-inertial"
    severity = Severity.WARNING
    looks_at = (Link,)
    affects = {
        Consumer.GAZEBO: warns("takes 1 kg and unit inertia"),
        Consumer.DRAKE: warns("takes 1 kg and unit inertia"),
    }
    scaffold = IN_MODEL

    bad = (
        Bad(
            '<«link» name="cup"><collision name="c"><geometry><sphere><radius>0.05</radius></sphere></geometry>'
            "</collision></link>",
            says="`cup`",
        ),
    )
    good = (
        Good('<link name="mark"/>', why="no shape: nothing to weigh"),
        Good(
            '<sdf version="1.12"><model name="wall"><static>true</static><link name="l"><collision name="c">'
            "<geometry><box><size>1 1 1</size></box></geometry></collision></link></model></sdf>",
            why="a static model does not move",
            scaffold="",
        ),
    )

    @staticmethod
    def applies(link: Link) -> bool:
        if link.has("inertial") or link.is_urdf or link.may_be_static:
            return False  # In URDF what a link without inertial means depends on its joint.
        return (link.has("collision") or link.has("visual")) and not link.misspells("inertial")

    def check(self, link: Link) -> Iterator[Diagnostic]:
        message = f"link `{link.name}` has no inertial: simulators take 1 kg and unit inertia"
        yield self.diagnostic(link, message)
