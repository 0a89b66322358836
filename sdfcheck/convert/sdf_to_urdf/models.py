"""The parts of models in addition to links and joints: nested models, includes, frames, flags."""

from __future__ import annotations

from sdfcheck.convert.ledger import TEXT
from sdfcheck.convert.loss import LossKind
from sdfcheck.convert.sdf_to_urdf.comments import carry_around, carry_comments
from sdfcheck.convert.sdf_to_urdf.context import Context
from sdfcheck.convert.sdf_to_urdf.custom import carry_custom
from sdfcheck.convert.sdf_to_urdf.extensions import keep_frame, model_extensions, of_frame
from sdfcheck.convert.sdf_to_urdf.joints import add_fixed
from sdfcheck.lint.diagnostic import Severity
from sdfcheck.robot.frame import MergedFrame
from sdfcheck.robot.model import Model
from sdfcheck.source.element import Element


def enter_models(context: Context) -> list[Element]:
    """Enter the models themselves and keep what extensions can hold of them; returns their elements."""
    elements = [context.scope.element]
    if context.scope.place is not context.scope.element:
        _enter_include(context, context.scope.place, "")
    _enter(context, context.scope.element, "")
    for name, frame in context.frames.items():
        if isinstance(frame, Model) and frame.is_readable:
            message = f"model `{name}` is made a part of the robot; its names begin with `{name.replace('::', '__')}__`"
            context.ledger.note(LossKind.MERGED_MODEL, frame.place, message, Severity.INFO)
            brought, scope = frame.element, name
        elif isinstance(frame, MergedFrame):
            brought, scope = frame.model.element, name.rpartition("::")[0]
        else:
            continue
        if frame.place.name == "include":
            _enter_include(context, frame.place, scope)
        elements.append(brought)
        _enter(context, brought, scope)
    for element in elements:
        _report_missing(context, element)
    return elements


def _report_missing(context: Context, model: Element) -> None:
    for include in model.children("include"):
        if not context.ledger.is_entered(include):
            message = f"{include_title(include)} is left out: it cannot be read"
            context.ledger.lose(LossKind.UNKNOWN_REFERENCE, include, message)


def _enter(context: Context, model: Element, scope: str) -> None:
    pose = model.find("pose")
    context.ledger.take(model)
    if model is not context.scope.element:
        static = model.find("static")
        context.ledger.take(pose)
        context.ledger.take(static, TEXT)
        if static is not None and static.content.lower() in {"true", "1"} and not context.scope.is_static:
            message = f"{model.title} is static, and what it is part of is not: it moves with it"
            context.ledger.note(LossKind.DROPPED_ELEMENT, static, message)
    model_extensions(context, model, scope)
    carry_custom(context, context.root, model, scope)
    carry_around(context, context.root, model)


def _enter_include(context: Context, include: Element, scope: str) -> None:
    model_extensions(context, include, scope)
    context.ledger.take_parts(include, "uri", "pose")
    for name in ("name", "static", "placement_frame"):
        context.ledger.take(include.find(name), TEXT)
    for parameters in include.children("experimental:params"):
        context.ledger.take_whole(parameters)
    message = f"{include_title(include)} is written out"
    context.ledger.note(LossKind.EXPANDED_INCLUDE, include, message, Severity.INFO)


def include_title(include: Element) -> str:
    """The name of an include's content in a sentence."""
    uri = include.find("uri")
    return f"what `{uri.content}` brings" if uri is not None else "what is included"


def add_frames(context: Context) -> None:
    """Write frames as massless links if that is wanted, else keep them as they are."""
    for name, frame in context.frames.items():
        if frame.kind != "frame":
            continue
        place = context.read.frames.get(name)
        if place is None:
            message = f"frame `{name}` is left out: it moves with no link"
            context.ledger.lose(LossKind.DROPPED_FRAME, frame.element, message)
            continue
        link, pose = place
        own, pose = context.frame_names[name], of_frame(context, link, pose)
        if not context.options.frames:
            keep_frame(context, own, context.links[link], pose, frame)
            continue
        carry_comments(context, context.root, frame.element)
        context.root.add("link", name=own)
        add_fixed(context, f"{own}_joint", context.links[link], own, pose)
        context.ledger.take_parts(frame.element, "pose")
