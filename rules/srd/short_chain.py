from collections.abc import Iterator
from itertools import pairwise

from sdfcheck import Bad, Diagnostic, Good, Rule, Semantics, Severity
from sdfcheck_rules.srd.scaffold import FILE

SOLVER = "arm:\n  kinematics_solver: {}\n  kinematics_solver_timeout: 0.05\n"
KDL = SOLVER.format("kdl_kinematics_plugin/KDLKinematicsPlugin")
GROUP = '<robot name="arm"><group name="{}"><chain base_link="base" tip_link="link{}"/></group></robot>'

BODY = '<group name="{}"><link name="base"/></group>'


def arm(count: int) -> str:
    """A robot with so many joints one after the other."""
    links = ["base", *(f"link{number}" for number in range(1, count + 1))]
    joints = "".join(
        f'<joint name="joint{number}" type="revolute"><parent link="{parent}"/><child link="{child}"/>'
        '<axis xyz="0 1 0"/><limit lower="-1" upper="1" effort="9" velocity="1"/></joint>'
        for number, (parent, child) in enumerate(pairwise(links), 1)
    )
    parts = "".join(f'<link name="{link}"/>' for link in links)
    return f'<robot name="arm">{parts}{joints}</robot>'


class ShortChain(Rule):
    """A group is solved for places and directions, and has less than six joints, or none.

    An arm with four or five joints reaches a place in few directions only. The solver of KDL asks for both, and finds
    nothing for nearly all poses: the marker in RViz does not move or jumps back, and `setPoseTarget` fails. Goals for
    joints are not affected. A group of links without a joint that turns or slides, such as the body of a drone, has no
    solver: MoveIt says that it is not a chain, or that its joint has more than one degree of freedom.
    """

    code = "SRD020"
    name = "short-chain"
    severity = Severity.INFO
    remedy = """Add `position_only_ik: true` to the group in `kinematics.yaml`, if the direction does not matter.

    Then positions alone are solved. "Approximate IK solutions" in RViz come near a pose. Solvers such as `bio_ik`, or
    one that is generated for the arm, take goals of fewer dimensions. A group without joints needs no solver: remove
    it.
    """
    looks_at = (Semantics,)
    scaffold = "{}"
    sources = (
        "https://moveit.picknik.ai/main/doc/examples/kinematics_configuration/kinematics_configuration_tutorial.html",
    )

    bad = (
        Bad(
            '<robot name="arm"><virtual_joint name="fly" type="floating" parent_frame="map" child_link="base"/>'
            + BODY.format("«arm»")
            + "</robot>",
            file=FILE,
            files={"arm.urdf": arm(4), "kinematics.yaml": KDL},
            says="group `arm` has no joint that its solver could move",
        ),
        Bad(
            GROUP.format("«arm»", 4),
            file=FILE,
            files={"arm.urdf": arm(4), "kinematics.yaml": KDL},
            says="group `arm` has 4 joints, and its solver asks for six: it finds no solution for most poses",
        ),
    )
    good = (
        Good(
            GROUP.format("arm", 4).replace("</robot>", BODY.format("arm2") + "</robot>"),
            file=FILE,
            files={"arm.urdf": arm(4)},
            why="nothing solves it",
        ),
        Good(GROUP.format("arm", 6), file=FILE, files={"arm.urdf": arm(6), "kinematics.yaml": KDL}),
        Good(
            GROUP.format("arm", 4),
            file=FILE,
            files={"arm.urdf": arm(4), "kinematics.yaml": f"{KDL}  position_only_ik: true\n"},
        ),
        Good(
            GROUP.format("arm", 4),
            file=FILE,
            files={"arm.urdf": arm(4), "kinematics.yaml": SOLVER.format("bio_ik/BioIKKinematicsPlugin")},
            why="another solver",
        ),
    )

    @staticmethod
    def applies(semantics: Semantics) -> bool:
        return bool(semantics.chained) and any(True for _ in semantics.short_chains)

    def check(self, semantics: Semantics) -> Iterator[Diagnostic]:
        for value, count in semantics.short_chains:
            group = f"group `{value.text.strip()}` has"
            if not count:
                message = f"{group} no joint that its solver could move"
                yield self.diagnostic(value, message, severity=Severity.WARNING)
                continue
            what = f"{group} {count} joints, and its solver asks for six"
            yield self.diagnostic(value, f"{what}: it finds no solution for most poses")
