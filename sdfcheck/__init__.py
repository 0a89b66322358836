"""Linter and converter for SDFormat, URDF and xacro robot descriptions.

Everything a program or a rule needs can be imported from here; it is loaded when it is
first used.
"""

from __future__ import annotations

TYPE_CHECKING = False  # `typing` takes long to load, and until `run` is reached an interrupt is a traceback
if TYPE_CHECKING:
    from typing import Any

    from sdfcheck import problems
    from sdfcheck.api import as_json, diff, fix, inertia, print, targets  # noqa: A004
    from sdfcheck.consumers.gazebo import BuiltFrame, BuiltJoint, BuiltLink, BuiltShape, GazeboRobot
    from sdfcheck.consumers.reaction import (
        REFUSES,
        Consumer,
        Reaction,
        Verdict,
        accepts,
        drops,
        ignores,
        refuses,
        warns,
    )
    from sdfcheck.consumers.urdf_readers import (
        Ignored,
        ignored_by_drake,
        is_harmless,
        lacking,
        recurring,
        repeating,
        undersized,
        unexpanded,
        unreadable,
    )
    from sdfcheck.convert.call import convert
    from sdfcheck.convert.file_difference import FileDifference
    from sdfcheck.convert.loss import Loss, NotConvertible
    from sdfcheck.convert.result import Conversion
    from sdfcheck.formats.namespaces import Prefix, PrefixDeclaration, PrefixedName
    from sdfcheck.formats.near_names import suggest, suggest_in
    from sdfcheck.lint.call import lint
    from sdfcheck.lint.diagnostic import (
        Diagnostic,
        Label,
        Missing,
        MissingKind,
        Origin,
        Severity,
        listed,
        named,
        used,
    )
    from sdfcheck.lint.editing import Edit, EditError, edit
    from sdfcheck.lint.example import (
        IN_COLLISION,
        IN_JOINT,
        IN_LINK,
        IN_MODEL,
        IN_ROBOT,
        IN_URDF_JOINT,
        IN_URDF_LINK,
        IN_VISUAL,
        IN_WORLD,
        SDF,
        Bad,
        Good,
    )
    from sdfcheck.lint.fix import Applicability, Fix, TextEdit
    from sdfcheck.lint.rule import Rule, Target, make_fix, rename, replace, rewrite, write_instead
    from sdfcheck.lint.rulebook.vendor_rule import VendorRule
    from sdfcheck.lint.run import Run
    from sdfcheck.release import __version__
    from sdfcheck.robot.controllers import ControllerNeed, Mistyped, Parameter, Unreached
    from sdfcheck.robot.graph import (
        Actor,
        Axis,
        Collision,
        Contact,
        ControlComponent,
        ControlInterface,
        ControlTransmission,
        Drive,
        Dynamics,
        GazeboBlock,
        Gripper,
        Include,
        Inertial,
        Joint,
        Light,
        Limit,
        Link,
        Mimic,
        Model,
        Physics,
        Plugin,
        Ros2Control,
        Scope,
        Sensor,
        Shape,
        State,
        Transmission,
        Tree,
        Visual,
        World,
    )
    from sdfcheck.robot.includes.included import Obstacle
    from sdfcheck.robot.includes.model_config import ConfigFault, ModelConfig
    from sdfcheck.robot.includes.uri_spelling import UriFault
    from sdfcheck.robot.load import Unreadable, load, parse
    from sdfcheck.robot.motion.mass import MassProperties
    from sdfcheck.robot.motion.origin import PoseError
    from sdfcheck.robot.motion.poses import Pose
    from sdfcheck.robot.naming.name import Name
    from sdfcheck.robot.part import Custom, Frame, Node, NotFound, Part, Placement, Setting
    from sdfcheck.robot.resources import Pieces, Resource
    from sdfcheck.robot.root import FrameReference, Root
    from sdfcheck.robot.semantics import Semantics
    from sdfcheck.robot.shapes import Geometry, Material, Surface
    from sdfcheck.robot.values import Flag, Number, Text, Vector
    from sdfcheck.robot.vendor import VendorTag, VendorValue
    from sdfcheck.source.document import Document, Element, Value
    from sdfcheck.source.errors import DescriptionError, WrongUsage
    from sdfcheck.source.text import Position, Source, Span


_HOMES = {
    "sdfcheck.api": "as_json diff fix inertia print targets",
    "sdfcheck.consumers.gazebo": "BuiltFrame BuiltJoint BuiltLink BuiltShape GazeboRobot",
    "sdfcheck.consumers.reaction": "REFUSES UNFOUND Consumer Reaction Verdict accepts drops ignores refuses warns",
    "sdfcheck.consumers.urdf_readers": (
        "Ignored ignored_by_drake is_harmless lacking recurring repeating undersized unexpanded unreadable"
    ),
    "sdfcheck.convert.file_difference": "FileDifference",
    "sdfcheck.convert.loss": "Loss NotConvertible",
    "sdfcheck.convert.result": "Conversion",
    "sdfcheck.formats.namespaces": "Prefix PrefixDeclaration PrefixedName",
    "sdfcheck.formats.near_names": "suggest suggest_in",
    "sdfcheck.lint.diagnostic": "Diagnostic Label listed Missing MissingKind named Origin Severity used",
    "sdfcheck.lint.editing": "Edit EditError edit",
    "sdfcheck.lint.example": (
        "IN_COLLISION IN_JOINT IN_LINK IN_MODEL IN_ROBOT IN_URDF_JOINT IN_URDF_LINK IN_VISUAL IN_WORLD "
        "SDF Bad Good"
    ),
    "sdfcheck.lint.fix": "Applicability Fix TextEdit",
    "sdfcheck.lint.rule": "Rule Target make_fix rename replace rewrite write_instead",
    "sdfcheck.lint.rulebook.vendor_rule": "VendorRule",
    "sdfcheck.lint.run": "Run",
    "sdfcheck.release": "__version__",
    "sdfcheck.robot.graph": (
        "Model Scope World Tree Transmission ControlTransmission Ros2Control ControlComponent "
        "ControlInterface Axis Dynamics Limit Mimic Joint GazeboBlock Include Inertial Link Light "
        "Contact Sensor Collision Shape Visual Actor Gripper Physics State Plugin Drive"
    ),
    "sdfcheck.robot.controllers": "ControllerNeed Mistyped Parameter Unreached",
    "sdfcheck.robot.includes.included": "Obstacle",
    "sdfcheck.robot.includes.model_config": "ConfigFault ModelConfig",
    "sdfcheck.robot.includes.uri_spelling": "UriFault",
    "sdfcheck.robot.load": "Unreadable load parse",
    "sdfcheck.robot.motion.mass": "MassProperties",
    "sdfcheck.robot.motion.origin": "PoseError",
    "sdfcheck.robot.motion.poses": "Pose",
    "sdfcheck.robot.naming.name": "Name",
    "sdfcheck.robot.part": "Custom Frame NotFound Node Part Placement Setting",
    "sdfcheck.robot.resources": "Pieces Resource",
    "sdfcheck.robot.root": "FrameReference Root",
    "sdfcheck.robot.semantics": "Semantics",
    "sdfcheck.robot.shapes": "Material Geometry Surface",
    "sdfcheck.robot.values": "Flag Number Text Vector",
    "sdfcheck.robot.vendor": "VendorTag VendorValue",
    "sdfcheck.source.document": "Document Element Value",
    "sdfcheck.source.errors": "DescriptionError WrongUsage",
    "sdfcheck.source.text": "Position Source Span",
}
_HOME_OF = {name: module for module, names in _HOMES.items() for name in names.split()}

__all__ = [
    "IN_COLLISION",
    "IN_JOINT",
    "IN_LINK",
    "IN_MODEL",
    "IN_ROBOT",
    "IN_URDF_JOINT",
    "IN_URDF_LINK",
    "IN_VISUAL",
    "IN_WORLD",
    "REFUSES",
    "SDF",
    "UNFOUND",
    "Actor",
    "Applicability",
    "Axis",
    "Bad",
    "BuiltFrame",
    "BuiltJoint",
    "BuiltLink",
    "BuiltShape",
    "Collision",
    "ConfigFault",
    "Consumer",
    "Contact",
    "ControlComponent",
    "ControlInterface",
    "ControlTransmission",
    "ControllerNeed",
    "Conversion",
    "Custom",
    "DescriptionError",
    "Diagnostic",
    "Document",
    "Drive",
    "Dynamics",
    "Edit",
    "EditError",
    "Element",
    "FileDifference",
    "Fix",
    "Flag",
    "Frame",
    "FrameReference",
    "GazeboBlock",
    "GazeboRobot",
    "Geometry",
    "Good",
    "Gripper",
    "Ignored",
    "Include",
    "Inertial",
    "Joint",
    "Label",
    "Light",
    "Limit",
    "Link",
    "Loss",
    "MassProperties",
    "Material",
    "Mimic",
    "Missing",
    "MissingKind",
    "Mistyped",
    "Model",
    "ModelConfig",
    "Name",
    "Node",
    "NotConvertible",
    "NotFound",
    "Number",
    "Obstacle",
    "Origin",
    "Parameter",
    "Part",
    "Physics",
    "Pieces",
    "Placement",
    "Plugin",
    "Pose",
    "PoseError",
    "Position",
    "Prefix",
    "PrefixDeclaration",
    "PrefixedName",
    "Reaction",
    "Resource",
    "Root",
    "Ros2Control",
    "Rule",
    "Run",
    "Scope",
    "Semantics",
    "Sensor",
    "Setting",
    "Severity",
    "Shape",
    "Source",
    "Span",
    "State",
    "Surface",
    "Target",
    "Text",
    "TextEdit",
    "Transmission",
    "Tree",
    "Unreached",
    "Unreadable",
    "UriFault",
    "Value",
    "Vector",
    "VendorRule",
    "VendorTag",
    "VendorValue",
    "Verdict",
    "Visual",
    "World",
    "WrongUsage",
    "__version__",
    "accepts",
    "as_json",
    "convert",
    "diff",
    "drops",
    "edit",
    "fix",
    "ignored_by_drake",
    "ignores",
    "inertia",
    "is_harmless",
    "lacking",
    "lint",
    "listed",
    "load",
    "make_fix",
    "named",
    "parse",
    "print",
    "problems",
    "recurring",
    "refuses",
    "rename",
    "repeating",
    "replace",
    "rewrite",
    "suggest",
    "suggest_in",
    "targets",
    "undersized",
    "unexpanded",
    "unreadable",
    "used",
    "warns",
    "write_instead",
]


def __getattr__(name: str) -> Any:
    from importlib import import_module

    if name in {"convert", "lint", "problems"}:
        return import_module(f"sdfcheck.{name}")
    if name not in _HOME_OF:
        raise AttributeError(f"module 'sdfcheck' has no attribute {name!r}")
    value = globals()[name] = getattr(import_module(_HOME_OF[name]), name)
    return value


def __dir__() -> list[str]:
    return sorted(__all__)
