from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Link, Root, Rule, Severity

BALL = '<collision name="c"><geometry><sphere><radius>0.1</radius></sphere></geometry></collision>'
BODY = f'<link name="body">{BALL}</link>'
IN_MODEL = f'<sdf version="1.9"><model name="m">{{}}{BODY}</model></sdf>'
SENSOR = '<sensor name="s" type="imu"/>'
BODILESS = frozenset({"pose", "inertial", "sensor"})
"""Parts of a link that touch nothing; others may say that it is to stay where it is."""
HELD = '<joint name="j" type="fixed"><parent>body</parent><child>foot</child></joint>'


class FallingLink(Rule):
    """A link of a model has no shape, and no joint ties it to the others.

    To Gazebo it is a body of 1 kg that touches nothing: it falls without end, and the pose of the model goes with it
    where it is the first link. Such a link is meant to be a frame, as `base_footprint` is in URDF, or carries a sensor
    that falls with it and measures weightlessness.
    """

    code = "FRM012"
    name = "falling-link"
    severity = Severity.WARNING
    remedy = """Add a fixed joint to the link, or make it a `<frame attached_to="…">`.

    A frame (SDFormat 1.7 and newer) is a name for a place and has no mass.
    """
    looks_at = (Link,)
    selects = ("sdf:model/link",)
    scaffold = IN_MODEL

    bad = (
        Bad(
            '<«link» name="foot"/>',
            says="nothing holds link `foot`, which has no shape: it falls without end",
        ),
        Bad(
            f'<«link» name="foot">{SENSOR}</link>',
            says="nothing holds link `foot`, which has no shape: it falls without end, with its sensor",
        ),
    )
    good = (
        Good(f'<link name="foot"/>{HELD}'),
        Good('<static>true</static><link name="foot"/>'),
        Good('<link name="foot"><gravity>false</gravity></link>'),
        Good(BODY.replace("body", "foot"), why="a thing of its own"),
        Good(
            '<link name="foot"/>', scaffold=IN_MODEL.replace(BODY, ""), why="a model of one link is a marker"
        ),
    )

    @staticmethod
    def applies(link: Link) -> bool:
        if any(True for each in link.children() if each.name not in BODILESS) or link.may_be_static:
            return False
        model = link.model
        root = link.root
        is_tied = not isinstance(root, Root) or link.name in root.tied_names
        return model.has_collisions and model.is_complete and not is_tied

    def check(self, link: Link) -> Iterator[Diagnostic]:
        message = f"nothing holds {link.title}, which has no shape: it falls without end"
        yield self.diagnostic(link, message + (", with its sensor" if link.has("sensor") else ""))
