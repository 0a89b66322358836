from collections.abc import Iterator

from sdfcheck import Bad, Consumer, Diagnostic, Good, Rule, Severity, problems, refuses
from sdfcheck_rules.drk.effect import affects, consequence
from sdfcheck_rules.drk.scaffolds import COLLISION, ROBOT, ROBOT_JOINT

BOX = "<geometry><box><size>1 1 1</size></box></geometry>"


class CrashesDrake(Rule):
    """The file ends the process that loads it with Drake, or ends it unread.

    An empty type of a transmission is a segmentation fault; most others are assertions, which end a
    C++ program and tell no place in the file. A negative damping is refused, and so is a file that
    holds neither exactly one model nor exactly one world.
    """

    code = "DRK015"
    name = "crashes-drake"
    severity = Severity.ERROR
    default = False
    affects = {Consumer.DRAKE: refuses("crashes or aborts")}
    explains = (problems.CrashesDrake,)
    scaffold = COLLISION

    bad = (
        Bad(
            '<transmission><«type»/><joint name="j"/><actuator name="m"/></transmission>',
            says="a transmission of empty type: Drake crashes",
            scaffold=ROBOT,
        ),
        Bad(
            '<joint name="j" type="revolute"><parent link="a"/><child link="b"/>'
            '<limit lower="-1" upper="1" effort="1" velocity="«-1»"/></joint>',
            says="a negative velocity limit: Drake aborts",
            scaffold=ROBOT_JOINT,
        ),
        Bad(
            f"{BOX}<surface><«friction»><torsional/></friction></surface><drake:proximity_properties>"
            "<drake:mu_dynamic>0.5</drake:mu_dynamic></drake:proximity_properties>",
            says="a friction without `ode` beside `drake:mu_dynamic`: Drake aborts",
        ),
        Bad(
            "<geometry><plane><normal>«0 0 0»</normal></plane></geometry>",
            says="a plane without direction: Drake aborts",
        ),
        Bad(
            '<«sdf» version="1.9"><light name="sun" type="directional"/></sdf>',
            says="a file with neither model nor world: Drake refuses the file",
            scaffold="",
        ),
        Bad(
            '<sdf version="1.9"><world name="w"/><«model» name="m"><link name="l"/></model></sdf>',
            says="a model beside a world: Drake refuses the file",
            scaffold="",
        ),
        Bad(
            '<sdf version="1.9"><world name="w"/><«world» name="v"/></sdf>',
            says="a second world: Drake refuses the file",
            scaffold="",
        ),
    )
    good = (
        Good(
            '<transmission><type>SimpleTransmission</type><joint name="j"/><actuator name="m"/>'
            "</transmission>",
            scaffold=ROBOT,
        ),
        Good(
            f"{BOX}<surface><friction><torsional/></friction></surface>",
            why="only Drake's own friction trips it",
        ),
        Good(
            "<geometry><heightmap><uri>a.png</uri><texture><normal>flat.png</normal></texture></heightmap></geometry>"
            "<surface><friction><ode><mu>0.2</mu></ode></friction></surface>",
            why="Drake makes nothing of a heightmap",
        ),
    )

    def check(self, problem: problems.CrashesDrake) -> Iterator[Diagnostic]:
        message = f"{problem.what}: {consequence(problem.effect)}"
        yield self.diagnostic(problem.target, message, affects=affects(problem.effect))
