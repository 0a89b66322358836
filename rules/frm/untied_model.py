from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Model, Rule, Severity

MASS = "<inertial><mass>1</mass></inertial>"
LIDAR = f'<link name="eye">{MASS}<sensor name="s" type="imu"/></link>'
ROVER = f'<sdf version="1.9"><model name="rover"><link name="body">{MASS}</link>{{}}</model></sdf>'
TIED = '<joint name="j" type="fixed"><parent>body</parent><child>lidar::eye</child></joint>'


class UntiedModel(Rule):
    """A model with sensors is in a robot, and no joint ties it to the robot.

    A model in a model is placed there, and nothing else: at the first step it falls, or stays behind while the robot
    drives on. A joint ties it; an include in an `<include merge="true">` makes its links those of the robot, and they
    need a joint as well.
    """

    code = "FRM013"
    name = "untied-model"
    severity = Severity.WARNING
    remedy = """Add a fixed joint from a link of the robot to one of the model: `<child>lidar::link</child>`.

    The name before `::` is that of the include, or else of the model in the file.
    """
    looks_at = (Model,)
    selects = ("sdf:model",)
    scaffold = ROVER

    bad = (
        Bad(
            f'<«model» name="lidar">{LIDAR}</model>',
            says="no joint ties model `lidar` to model `rover`: its sensors do not move with the robot",
        ),
    )
    good = (
        Good(f'<model name="lidar">{LIDAR}</model>{TIED}'),
        Good(f'<model name="box"><link name="l">{MASS}</link></model>', why="a thing of its own"),
        Good(
            f'<model name="lidar">{LIDAR}{TIED.replace("lidar::", "")}</model>',
            why="the joint is in the wrong model, and reported there",
        ),
        Good(f'<static>true</static><model name="lidar">{LIDAR}</model>'),
    )

    @staticmethod
    def applies(model: Model) -> bool:
        return next(untied(model), None) is not None

    def check(self, model: Model) -> Iterator[Diagnostic]:
        for each in untied(model):
            message = f"no joint ties {each.title} to {model.title}: its sensors do not move with the robot"
            yield self.diagnostic(each if each.include is None else each.include, message)


def untied(model: Model) -> Iterator[Model]:
    """The models in a robot that have sensors, and that nothing in the file ties to it or looks for."""
    if not model.models or not model.links or model.may_be_static or not model.is_complete:
        return
    text = model.document.source.text
    ends = {name for joint in model.joints for name in (joint.parent_name, joint.child_name)}
    for each in model.models:
        if each.may_be_static or not any(link.sensors for link in each.links):
            continue
        if any(joint.parent is None for joint in each.joints):  # reported there
            continue
        if each.name not in ends and f"{each.name}::" not in text:
            yield each
