"""Where the mass of a description is: of every link, every model, and all of it."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from enum import Enum

import numpy as np

from sdfcheck.robot.graph import Link, Model, Scope
from sdfcheck.robot.motion.flatten import mechanism_of
from sdfcheck.robot.motion.mass import MassProperties, joined
from sdfcheck.robot.motion.origin import PoseError
from sdfcheck.robot.motion.poses import Array, written_pose
from sdfcheck.source.errors import DescriptionError


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
    """A link's mass properties in the frame of its model; None where they are unknown or missing."""

    name: str
    origin: MassOrigin
    body: MassProperties | None
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
    total: MassProperties | None
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
    total: MassProperties | None
    notes: tuple[str, ...] = ()

    @property
    def is_complete(self) -> bool:
        return not self.notes and all(model.is_complete for model in self.models if not model.is_static)

    def walk(self) -> Iterator[ModelMass]:
        for model in self.models:
            yield from model.walk()


def mass_report(scopes: Sequence[Scope]) -> MassReport:
    """Measure what a file describes: the worlds and models at its top.

    Raises DescriptionError for a URDF whose numbers cannot be read.
    """
    robot = scopes[0] if scopes else None
    if isinstance(robot, Model) and robot.is_urdf:
        model = _urdf_model(robot)
        return MassReport((model,), model.total)
    return _Reader().read(scopes)


class _Reader:
    def read(self, roots: Sequence[Scope]) -> MassReport:
        models: list[ModelMass] = []
        moving: list[MassProperties | None] = []
        notes: list[str] = []
        for root in roots:
            if isinstance(root, Model):
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
        return MassReport(tuple(models), joined(moving), tuple(notes))

    def model(self, scope: Model, name: str) -> ModelMass:
        links = tuple(map(self.link, (node for node in scope.nodes.values() if isinstance(node, Link))))
        models, bodies, notes = self.inner(scope, f"{name}::")
        total = joined([*(link.body for link in links), *bodies])
        return ModelMass(name, scope.is_static, links, tuple(models), total, tuple(notes))

    def inner(
        self, scope: Scope, prefix: str
    ) -> tuple[list[ModelMass], list[MassProperties | None], list[str]]:
        """The models in a scope, their totals in its frame, and the links without known mass properties."""
        models: list[ModelMass] = []
        bodies: list[MassProperties | None] = []
        notes = [] if scope.is_complete else ["an include could not be read"]
        for frame in scope.nodes.values():
            if not isinstance(frame, Model):
                continue
            name = prefix + frame.name
            if not frame.is_readable:
                notes.append(f"model `{name}` could not be read")
                continue
            measured = self.model(frame, name)
            models.append(measured)
            try:
                bodies.append(_placed(measured.total, frame.root.poses.in_scope(frame)))
            except PoseError as error:
                bodies.append(None)
                notes.append(f"model `{name}` has no place: {error}")
        return models, bodies, notes

    def link(self, frame: Link) -> LinkMass:
        name = frame.name
        try:
            pose = frame.root.poses.in_scope(frame)
            body = frame.mass_properties
            if frame.is_urdf:
                return _of_urdf(frame.name, body, pose)
        except (PoseError, DescriptionError) as error:
            return LinkMass(name, MassOrigin.UNKNOWN, None, str(error))
        if body is None:
            return LinkMass(
                name, MassOrigin.DEFAULT, MassProperties(1.0, np.zeros(3), np.eye(3)).seen_from(pose)
            )
        origin = MassOrigin.AUTOMATIC if frame.inertial.is_automatic else MassOrigin.WRITTEN
        return LinkMass(name, origin, body.seen_from(pose))


def _urdf_model(model: Model) -> ModelMass:
    robot = mechanism_of(model)
    links = tuple(_of_urdf(link.name, link.body, link.pose) for link in robot.links.values())
    return ModelMass(robot.name, False, links, (), joined([link.body for link in links]))


def _of_urdf(name: str, body: MassProperties | None, pose: Array) -> LinkMass:
    if body is None:
        return LinkMass(name, MassOrigin.NONE, None)
    return LinkMass(name, MassOrigin.WRITTEN, body.seen_from(pose))


def _placed(body: MassProperties | None, pose: Array) -> MassProperties | None:
    return None if body is None else body.seen_from(pose)
