"""Where the mass of a description is: of every link, every model, and all of it."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from enum import Enum

import numpy as np

from sdfcheck.robot.poses import PoseError, Poses, written_pose
from sdfcheck.robot.robot import Body
from sdfcheck.robot.rotations import Array
from sdfcheck.robot.scopes import Frame, Scope, scopes
from sdfcheck.robot.sdf_robot import RobotError, body_of
from sdfcheck.robot.urdf_robot import read_urdf_robot
from sdfcheck.source.document import Document
from sdfcheck.source.sniff import Kind


class MassOrigin(Enum):
    """Where a link's mass properties come from."""

    WRITTEN = "written"
    AUTOMATIC = "automatic"
    DEFAULT = "default"
    """Nothing is written: simulators take 1 kg and unit moments."""
    NONE = "none"
    """Nothing is written, and the format then means no mass."""
    UNKNOWN = "unknown"


@dataclass(frozen=True, slots=True)
class LinkMass:
    """A link's mass properties in the frame of its model; None where they are unknown, or there are none."""

    name: str
    origin: MassOrigin
    body: Body | None
    note: str = ""


@dataclass(frozen=True, slots=True)
class ModelMass:
    """A model, named from the top (``arm::hand``), with its links and nested models.

    ``total`` is in the model's own frame, all joints at zero; it lacks what is unknown.
    """

    name: str
    is_static: bool
    links: tuple[LinkMass, ...]
    models: tuple[ModelMass, ...]
    total: Body | None
    notes: tuple[str, ...] = ()

    @property
    def is_complete(self) -> bool:
        unknown = any(link.origin is MassOrigin.UNKNOWN for link in self.links)
        return not unknown and not self.notes and all(model.is_complete for model in self.models)

    def walk(self) -> Iterator[ModelMass]:
        """The model and those in it, outside in."""
        yield self
        for model in self.models:
            yield from model.walk()


@dataclass(frozen=True, slots=True)
class MassReport:
    """The models of a document; ``total`` is of those that are not static.

    It is in the frame of the world, or in that of the model where there is only one.
    """

    models: tuple[ModelMass, ...]
    total: Body | None
    notes: tuple[str, ...] = ()

    @property
    def is_complete(self) -> bool:
        return not self.notes and all(model.is_complete for model in self.models if not model.is_static)

    def walk(self) -> Iterator[ModelMass]:
        for model in self.models:
            yield from model.walk()


def mass_report(document: Document) -> MassReport:
    """Measure an SDF or URDF document.

    Raises RobotError for a URDF whose numbers cannot be read.
    """
    if document.kind is Kind.URDF:
        model = _urdf_model(document)
        return MassReport((model,), model.total)
    return _Reader().read(document)


class _Reader:
    def __init__(self) -> None:
        self.poses = Poses()

    def read(self, document: Document) -> MassReport:
        models: list[ModelMass] = []
        moving: list[Body | None] = []
        notes: list[str] = []
        roots = scopes(document).roots
        for root in roots:
            if root.kind == "model":
                measured = self.model(root, root.name)
                pose = written_pose(root.element.find("pose")) if len(roots) > 1 else np.eye(4)
                models.append(measured)
                if not measured.is_static:
                    moving.append(_placed(measured.total, pose))
                continue
            found, bodies, missing = self.inner(root, "")
            models += found
            moving += [body for model, body in zip(found, bodies, strict=True) if not model.is_static]
            notes += missing
        return MassReport(tuple(models), _joined(moving), tuple(notes))

    def model(self, scope: Scope, name: str) -> ModelMass:
        links = tuple(self.link(frame) for frame in scope.links())
        models, bodies, notes = self.inner(scope, f"{name}::")
        total = _joined([*(link.body for link in links), *bodies])
        return ModelMass(name, scope.is_static, links, tuple(models), total, tuple(notes))

    def inner(self, scope: Scope, prefix: str) -> tuple[list[ModelMass], list[Body | None], list[str]]:
        """The models in a scope, their totals in its frame, and what could not be told of them."""
        models: list[ModelMass] = []
        bodies: list[Body | None] = []
        notes = [] if scope.complete else ["an include could not be read"]
        for frame in scope.frames.values():
            if frame.kind != "model":
                continue
            name = prefix + frame.name
            if frame.inner is None:
                notes.append(f"model `{name}` could not be read")
                continue
            measured = self.model(frame.inner, name)
            models.append(measured)
            try:
                bodies.append(_placed(measured.total, self.poses.in_scope(frame)))
            except PoseError as error:
                bodies.append(None)
                notes.append(f"model `{name}` has no place: {error}")
        return models, bodies, notes

    def link(self, frame: Frame) -> LinkMass:
        name = frame.name
        try:
            pose = self.poses.in_scope(frame)
            if frame.element.document.kind is Kind.URDF:
                return _urdf_link(frame, pose)
            body = body_of(frame, self.poses)
        except (PoseError, RobotError) as error:
            return LinkMass(name, MassOrigin.UNKNOWN, None, str(error))
        if body is None:
            return LinkMass(name, MassOrigin.DEFAULT, Body(1.0, np.zeros(3), np.eye(3)).seen_from(pose))
        inertial = frame.element.find("inertial")
        assert inertial is not None
        automatic = inertial.attributes.get("auto", "").strip().lower() in {"true", "1"}
        origin = MassOrigin.AUTOMATIC if automatic else MassOrigin.WRITTEN
        return LinkMass(name, origin, body.seen_from(pose))


def _urdf_model(document: Document) -> ModelMass:
    robot = read_urdf_robot(document)
    links = tuple(_of_urdf(link.name, link.body, link.pose) for link in robot.links.values())
    return ModelMass(robot.name, False, links, (), _joined([link.body for link in links]))


def _urdf_link(frame: Frame, pose: Array) -> LinkMass:
    """A link of a URDF model that an SDF file includes."""
    robot = frame.element.document.view(read_urdf_robot)
    return _of_urdf(frame.name, robot.links[frame.name].body, pose)


def _of_urdf(name: str, body: Body | None, pose: Array) -> LinkMass:
    if body is None:
        return LinkMass(name, MassOrigin.NONE, None)
    return LinkMass(name, MassOrigin.WRITTEN, body.seen_from(pose))


def _placed(body: Body | None, pose: Array) -> Body | None:
    return None if body is None else body.seen_from(pose)


def _joined(bodies: list[Body | None]) -> Body | None:
    total: Body | None = None
    for body in bodies:
        if body is not None:
            total = body if total is None else total.joined_with(body)
    return total
