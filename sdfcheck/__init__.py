"""Linter and converter for SDFormat, URDF and xacro robot descriptions.

Everything a program or a rule needs can be imported from here; it is loaded when it is
first used.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from sdfcheck import problems
    from sdfcheck.api import as_json, diff, fix, inertia, print, targets  # noqa: A004
    from sdfcheck.consumers.drake_limits import Ignored, ignored_by_drake
    from sdfcheck.consumers.gazebo import BuiltFrame, BuiltJoint, BuiltLink, BuiltShape, GazeboRobot
    from sdfcheck.consumers.reaction import REFUSES, Consumer, Reaction, Verdict, accepts, refuses, warns
    from sdfcheck.consumers.urdf_readers import (
        is_harmless,
        lacking,
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
    from sdfcheck.formats.suggest import suggest, suggest_in
    from sdfcheck.lint.call import lint
    from sdfcheck.lint.diagnostic import Diagnostic, Label, Missing, MissingKind, Origin, Severity
    from sdfcheck.lint.editing import EditError, edit
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
    from sdfcheck.lint.fix import Applicability, Edit, Fix
    from sdfcheck.lint.rule import Rule, Target, make_fix, rename, replace, write_instead
    from sdfcheck.lint.rulebook.vendor_rule import VendorRule
    from sdfcheck.lint.run import Run
    from sdfcheck.lint.wording import listed, named, used
    from sdfcheck.release import __version__
    from sdfcheck.robot.access.load import Unreadable, load, parse
    from sdfcheck.robot.access.lookup import NotFound
    from sdfcheck.robot.custom import Custom
    from sdfcheck.robot.errors import DescriptionError
    from sdfcheck.robot.frame import Frame
    from sdfcheck.robot.includes.included import Obstacle
    from sdfcheck.robot.includes.model_config import ConfigFault, ModelConfig
    from sdfcheck.robot.includes.uri_spelling import UriFault
    from sdfcheck.robot.model import Model
    from sdfcheck.robot.motion.mass_properties import MassProperties
    from sdfcheck.robot.motion.pose import Pose
    from sdfcheck.robot.motion.poses import PoseError
    from sdfcheck.robot.motion.tree import Tree
    from sdfcheck.robot.naming.frame_reference import FrameReference
    from sdfcheck.robot.naming.name import Name
    from sdfcheck.robot.node import Node
    from sdfcheck.robot.part import Part
    from sdfcheck.robot.parts.actuation import Transmission
    from sdfcheck.robot.parts.axis import Axis, Dynamics, Limit, Mimic
    from sdfcheck.robot.parts.control import ControlTransmission, Ros2Control
    from sdfcheck.robot.parts.control_component import ControlComponent, ControlInterface
    from sdfcheck.robot.parts.gazebo import GazeboBlock
    from sdfcheck.robot.parts.include import Include
    from sdfcheck.robot.parts.inertial import Inertial
    from sdfcheck.robot.parts.joint import Joint
    from sdfcheck.robot.parts.light import Light
    from sdfcheck.robot.parts.link import Link
    from sdfcheck.robot.parts.material import Material
    from sdfcheck.robot.parts.physics import Actor, Gripper, Physics, State
    from sdfcheck.robot.parts.placement import Placement
    from sdfcheck.robot.parts.plugin import Plugin
    from sdfcheck.robot.parts.resource import Resource
    from sdfcheck.robot.parts.sensor import Contact, Sensor
    from sdfcheck.robot.parts.setting import Setting
    from sdfcheck.robot.parts.shape import Collision, Geometry, Shape, Surface, Visual
    from sdfcheck.robot.root import Root
    from sdfcheck.robot.scope import Scope
    from sdfcheck.robot.semantics.semantics import Semantics
    from sdfcheck.robot.values import Flag, Number, Text, Vector
    from sdfcheck.robot.vendor.tag import VendorTag
    from sdfcheck.robot.vendor.value import VendorValue
    from sdfcheck.robot.world import World
    from sdfcheck.source.document import Document
    from sdfcheck.source.element import Element, Value
    from sdfcheck.source.text import Position, Source, Span
    from sdfcheck.source.wrong_usage import WrongUsage


_HOMES = {
    "sdfcheck.api": "as_json diff fix inertia print targets",
    "sdfcheck.convert.file_difference": "FileDifference",
    "sdfcheck.convert.loss": "Loss NotConvertible",
    "sdfcheck.convert.result": "Conversion",
    "sdfcheck.formats.namespaces": "Prefix PrefixDeclaration PrefixedName",
    "sdfcheck.formats.suggest": "suggest suggest_in",
    "sdfcheck.lint.diagnostic": "Diagnostic Label Missing MissingKind Origin Severity",
    "sdfcheck.lint.example": (
        "IN_COLLISION IN_JOINT IN_LINK IN_MODEL IN_ROBOT IN_URDF_JOINT IN_URDF_LINK IN_VISUAL IN_WORLD SDF Bad Good"
    ),
    "sdfcheck.lint.fix": "Applicability Edit Fix",
    "sdfcheck.consumers.gazebo": "BuiltFrame BuiltJoint BuiltLink BuiltShape GazeboRobot",
    "sdfcheck.consumers.drake_limits": "Ignored ignored_by_drake",
    "sdfcheck.consumers.reaction": "REFUSES Consumer Reaction Verdict accepts refuses warns",
    "sdfcheck.lint.rule": "Rule Target make_fix rename replace write_instead",
    "sdfcheck.lint.run": "Run",
    "sdfcheck.consumers.urdf_readers": "is_harmless lacking repeating undersized unexpanded unreadable",
    "sdfcheck.lint.rulebook.vendor_rule": "VendorRule",
    "sdfcheck.lint.wording": "listed named used",
    "sdfcheck.robot.access.load": "Unreadable load parse",
    "sdfcheck.release": "__version__",
    "sdfcheck.robot.custom": "Custom",
    "sdfcheck.lint.editing": "EditError edit",
    "sdfcheck.robot.errors": "DescriptionError",
    "sdfcheck.robot.frame": "Frame",
    "sdfcheck.robot.includes.included": "Obstacle",
    "sdfcheck.robot.includes.model_config": "ConfigFault ModelConfig",
    "sdfcheck.robot.access.lookup": "NotFound",
    "sdfcheck.robot.model": "Model",
    "sdfcheck.robot.motion.mass_properties": "MassProperties",
    "sdfcheck.robot.motion.pose": "Pose",
    "sdfcheck.robot.motion.poses": "PoseError",
    "sdfcheck.robot.motion.tree": "Tree",
    "sdfcheck.robot.naming.name": "Name",
    "sdfcheck.robot.node": "Node",
    "sdfcheck.robot.part": "Part",
    "sdfcheck.robot.parts.actuation": "Transmission",
    "sdfcheck.robot.parts.control": "ControlTransmission Ros2Control",
    "sdfcheck.robot.parts.control_component": "ControlComponent ControlInterface",
    "sdfcheck.robot.parts.axis": "Axis Dynamics Limit Mimic",
    "sdfcheck.robot.parts.gazebo": "GazeboBlock",
    "sdfcheck.robot.parts.include": "Include",
    "sdfcheck.robot.parts.inertial": "Inertial",
    "sdfcheck.robot.parts.joint": "Joint",
    "sdfcheck.robot.parts.light": "Light",
    "sdfcheck.robot.parts.link": "Link",
    "sdfcheck.robot.parts.material": "Material",
    "sdfcheck.robot.parts.physics": "Actor Gripper Physics State",
    "sdfcheck.robot.parts.placement": "Placement",
    "sdfcheck.robot.parts.plugin": "Plugin",
    "sdfcheck.robot.parts.resource": "Resource",
    "sdfcheck.robot.parts.sensor": "Contact Sensor",
    "sdfcheck.robot.parts.setting": "Setting",
    "sdfcheck.robot.parts.shape": "Collision Geometry Shape Surface Visual",
    "sdfcheck.robot.naming.frame_reference": "FrameReference",
    "sdfcheck.robot.root": "Root",
    "sdfcheck.robot.scope": "Scope",
    "sdfcheck.robot.semantics.semantics": "Semantics",
    "sdfcheck.robot.includes.uri_spelling": "UriFault",
    "sdfcheck.robot.values": "Flag Number Text Vector",
    "sdfcheck.robot.vendor.tag": "VendorTag",
    "sdfcheck.robot.vendor.value": "VendorValue",
    "sdfcheck.robot.world": "World",
    "sdfcheck.source.document": "Document",
    "sdfcheck.source.element": "Element Value",
    "sdfcheck.source.text": "Position Source Span",
    "sdfcheck.source.wrong_usage": "WrongUsage",
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
    "Conversion",
    "Custom",
    "DescriptionError",
    "Diagnostic",
    "Document",
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
    "Model",
    "ModelConfig",
    "Name",
    "Node",
    "NotConvertible",
    "NotFound",
    "Number",
    "Obstacle",
    "Origin",
    "Part",
    "Physics",
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
    "Transmission",
    "Tree",
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
    "edit",
    "fix",
    "ignored_by_drake",
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
    "refuses",
    "rename",
    "repeating",
    "replace",
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
