from collections.abc import Iterator

from sdfcheck import IN_MODEL, REFUSES, SDF, Bad, Consumer, Diagnostic, Good, Rule, Severity, problems


class WorldAsChild(Rule):
    """The child of a joint is the world.

    A joint moves its child, and the world does not move. libsdformat refuses the file.
    Swap the ends: the world can be a parent.
    """

    code = "JNT003"
    name = "world-as-child"
    severity = Severity.ERROR
    affects = {
        Consumer.GAZEBO: REFUSES,
        Consumer.DRAKE: {"sdf": REFUSES},
        Consumer.URDFDOM: REFUSES,
        Consumer.MUJOCO: REFUSES,
    }
    explains = (problems.WorldAsChild,)
    scaffold = IN_MODEL

    bad = (
        Bad(
            '<joint name="j" type="fixed"><parent>base</parent><child>«world»</child></joint>',
            says="the child of joint `j` is the world",
        ),
        Bad(
            '<world name="w"><model name="m"><link name="l"/></model><frame name="f"/>'
            '<joint name="j" type="fixed"><parent>m</parent><child>«f»</child></joint></world>',
            scaffold=SDF,
            says="the child `f` of joint `j` is attached to the world",
        ),
    )
    good = (Good('<joint name="j" type="fixed"><parent>world</parent><child>base</child></joint>'),)

    def check(self, problem: problems.WorldAsChild) -> Iterator[Diagnostic]:
        child, joint = problem.child, problem.joint
        if child.text.strip() == "world":
            message = f"the child of {joint.title} is the world"
        else:
            message = f"the child `{child.text}` of {joint.title} is attached to the world"
        yield self.diagnostic(child, message)
