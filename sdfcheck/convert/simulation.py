"""Lets a robot run in simulators, and reports what goes wrong, at its place in the text.

A simulator gets each model as URDF without visuals, with meshes found by us; SDFormat is converted.
Its measurements (:mod:`sdfcheck.consumers.engines.behavior`) become findings of the family SIM.
Its own doings (convex hulls, masses that it invents) are named as such.
"""

from __future__ import annotations

import math
import os
import shutil
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np
from lxml import etree

from sdfcheck.consumers.engines import Answer, Engine, Limits, Outcome, Question, ask_all
from sdfcheck.consumers.engines.behavior import ALIKE
from sdfcheck.consumers.engines.staging import Stage
from sdfcheck.convert.loss import NotConvertible
from sdfcheck.files.library import library_of
from sdfcheck.files.uris import locate
from sdfcheck.lint.diagnostic import Diagnostic, Label, Moment, Origin, Severity, counted
from sdfcheck.lint.kinds import SimKind
from sdfcheck.robot.motion.flatten import mechanism_of
from sdfcheck.robot.motion.mechanism import Geometry, Joint, Link, Mechanism
from sdfcheck.robot.motion.poses import inverse
from sdfcheck.robot.root import root_of
from sdfcheck.robot.semantics import files_of_robots
from sdfcheck.source.document import read
from sdfcheck.source.errors import DescriptionError, WrongUsage
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.sniff import Kind

if TYPE_CHECKING:
    from pathlib import Path

    from sdfcheck.files.library import Library
    from sdfcheck.robot.graph import Model
    from sdfcheck.source.document import Document, Element
    from sdfcheck.source.text import Span
    from sdfcheck.xacro.expansion import Expander


_MESHES = {
    Engine.MUJOCO: (".stl", ".obj", ".msh"),
    Engine.PYBULLET: (".stl", ".obj", ".dae"),
    Engine.DRAKE: (".obj", ".vtk", ".gltf"),
}
"""The meshes that a simulator reads for collisions."""
_HULLS = {Engine.MUJOCO, Engine.PYBULLET, Engine.DRAKE}
"""The simulators that take the convex hull of a mesh."""
_TITLES = {Engine.MUJOCO: "MuJoCo", Engine.PYBULLET: "PyBullet", Engine.DRAKE: "Drake"}
TIME_STEP = 0.001
_DEPTH = 0.005
"""m: parts that overlap less only touch."""
_DEEP = 0.02
"""m: so deep a part is not by the hulls of meshes alone."""
_SHALLOW = 0.15
"""Of how thick the thinner part is: plain shapes are rounder or squarer than parts."""
_NEAR = 3
"""Joints between two parts: with more, the others, too, decide whether they meet."""
_WEAK = 2.0
"""Times the effort of a joint: springs and balance weights, of which the text says nothing, hold less."""
_SMALL = 0.05
"""Of the mass of the robot: so much more matters little."""
_APART = 0.02
"""Of the size of the robot: runs that differ more are not alike."""
_TILT = math.radians(25)
_GAIN = 0.05
"""Of the energy with which the robot can fall: more is not rounding."""
GRAVITY = 9.81
_SEMANTICS = 200
"""So many SRDF files are looked at, no more."""
_DESCRIPTIONS = 12
"""So many other descriptions of a robot are compared with it, no more."""
_ALIKE_JOINTS = 3
"""So many joints are equal in two descriptions of one robot, and all but one."""
_ARM = 6
"""Joints: robots of two names with no more in common may be arms of one family, with one length for another."""
_EQUAL = 0.001
"""m, and of turns and directions: numbers of two descriptions are rounded."""


class Settings(NamedTuple):
    """How to simulate."""

    engines: tuple[Engine, ...]
    seconds: float = 2.0
    limits: Limits = Limits(120.0)


Progress = Callable[[str], object]


def simulate(
    document: Document, settings: Settings, expander: Expander, progress: Progress = lambda _: None
) -> list[Diagnostic]:
    """The findings about all models of a description, sorted by place.

    ``expander`` expands other descriptions of the robot that are written in xacro.

    Raises:
        MissingEngine: a simulator is not installed.
    """
    found: list[Diagnostic] = []
    with Stage() as stage:
        for model in _models(document):
            if model.is_static:
                continue
            found += _simulated(model, settings, stage, expander, progress)
    return sorted(found, key=lambda one: one.sort_key)


class MissingEngine(Exception):
    """A simulator that is not installed; the text says how to install it."""


def _models(document: Document) -> Iterator[Model]:
    root = root_of(document)
    yield from root.models
    for world in root.worlds:
        yield from world.models


def _simulated(
    model: Model, settings: Settings, stage: Stage, expander: Expander, progress: Progress
) -> Iterator[Diagnostic]:
    try:
        subject = Subject(model)
    except (DescriptionError, NotConvertible, WrongUsage) as error:
        span = model.element.span  # of an include that leads nowhere
        if not isinstance(error, WrongUsage):
            span = error.loss.span if isinstance(error, NotConvertible) else error.element.span
        yield Diagnostic(
            SimKind.NOT_LOADED.code,
            SimKind.NOT_LOADED.title,
            Severity.ERROR,
            f"model `{model.name}` cannot be simulated: {error}",
            span,
        )
        return
    runs: dict[Engine, Mapping[str, Any]] = {}
    for engine in settings.engines:
        progress(f"{model.name} in {_TITLES[engine]}")
        trial = Trial(subject, engine, settings, stage)
        yield from trial.findings()
        if trial.measured:
            runs[engine] = trial.measured
            yield from trial.compared_with_conversion()
    yield from _disagreements(subject, runs)
    yield from _contradictions(subject, expander)


class Subject:
    """A model, as the numbers that are written, and as URDF."""

    def __init__(self, model: Model) -> None:
        self.model = model
        self.document = model.document
        self.robot: Mechanism = mechanism_of(model)
        self.converted = self.document.kind is Kind.SDF
        self.links = {name: name for name in self.robot.links}
        """Names in URDF → names in the text."""
        self.joints = {name: name for name in self.robot.joints}
        if self.converted:
            self._convert()
        else:
            self.text = self.document.source.text

    def _convert(self) -> None:
        from sdfcheck.convert.sdf_to_urdf import Options, convert

        written = self.model.element.get("name") or ""  # an include may give it another name
        done = convert(self.document, Options(model=written), verified=False)
        self.text = done.text
        for comparison in done.comparisons:
            to = comparison.correspondence
            self.links = {to.link(name).link: name for name in comparison.source.links}
            self.joints = {
                to.joint_of_axis(name, 0)[0]: name
                for name in comparison.source.joints
                if name not in to.dropped_joints
            }

    @cached_property
    def returned(self) -> str | None:
        """The robot that comes back when URDF is converted to SDFormat; None of SDFormat, and where that is refused."""
        from sdfcheck.convert.sdf_to_urdf import convert
        from sdfcheck.convert.urdf_to_sdf.conversion import urdf_to_sdf
        from sdfcheck.convert.urdf_to_sdf.options import Options

        if self.converted:
            return None
        try:
            there = urdf_to_sdf(self.document, Options(), verified=False)
            result = read(there.text.encode("utf-8", "surrogateescape"), self.document.path, Kind.SDF)
            return convert(result, verified=False).text
        except NotConvertible:
            return None

    @cached_property
    def groups(self) -> dict[str, str]:
        """Link → the first of the links that are rigidly connected with it."""
        group = {name: name for name in (*self.robot.links, "world")}

        def top(name: str) -> str:
            while group[name] != name:
                name = group[name]
            return name

        for joint in self.robot.joints.values():
            if not joint.moves and joint.parent in group and joint.child in group:
                group[top(joint.child)] = top(joint.parent)
        return {name: top(name) for name in group}

    @cached_property
    def followers(self) -> dict[str, tuple[str, float, float]]:
        """The joints, as URDF calls them, that go where another one goes: that one, the multiplier and the offset."""
        found: dict[str, tuple[str, float, float]] = {}
        urdf = {name: each for each, name in self.joints.items()}
        for joint in self.robot.joints.values():
            multiplier, offset, at = 1.0, 0.0, joint
            for _ in self.robot.joints:
                mimic = at.axes[0].mimic if at.axes else None
                if mimic is None or mimic.leader not in self.robot.joints:
                    break
                offset += multiplier * (mimic.offset - mimic.multiplier * mimic.reference)
                multiplier *= mimic.multiplier
                at = self.robot.joints[mimic.leader]
            if at is not joint and joint.name in urdf and at.name in urdf:
                found[urdf[joint.name]] = (urdf[at.name], multiplier, offset)
        return found

    @cached_property
    def loose(self) -> set[str]:
        """The links, as URDF calls them, that a joint carries for which URDF has no word: simulators differ in it."""
        found = {joint.child for joint in self.robot.joints.values() if joint.kind == "ball"}
        for _ in self.robot.links:
            found |= {joint.child for joint in self.robot.joints.values() if joint.parent in found}
        return {urdf for urdf, name in self.links.items() if name in found}

    @cached_property
    def movers(self) -> list[str]:
        """The names of the joints that move."""
        return [joint.name for joint in self.robot.joints.values() if joint.moves]

    @cached_property
    def moved(self) -> set[str]:
        """The links that are moved by a joint of their own."""
        return {joint.child for joint in self.robot.joints.values() if joint.moves}

    @cached_property
    def _carriers(self) -> dict[str, Joint]:
        return {joint.child: joint for joint in self.robot.joints.values()}

    def joints_between(self, a: str, b: str) -> int:
        """How many joints that move are between two links."""
        return len(self._way(a) ^ self._way(b))

    def _way(self, link: str) -> set[str]:
        """The joints that move it."""
        way: dict[str, bool] = {}
        while (joint := self._carriers.get(link)) is not None and joint.name not in way:
            way[joint.name], link = joint.moves, joint.parent
        return {name for name, moves in way.items() if moves}

    def mass_with(self, link: str) -> float:
        """That of a link and all that are rigidly connected with it."""
        bodies = (
            each.body for name, each in self.robot.links.items() if self.groups[name] == self.groups[link]
        )
        return sum(body.mass for body in bodies if body is not None)

    @cached_property
    def massless_movers(self) -> list[str]:
        """The links without mass that move."""
        held = {self.groups[name] for name in ("world", *self.robot.roots()) if name in self.groups}
        return [
            name
            for name, link in self.robot.links.items()
            if (link.body is None or not link.body.mass) and self.groups[name] not in held
        ]

    @cached_property
    def neighbors(self) -> set[frozenset[str]]:
        """Pairs of groups with a joint between them, or a chain of links that collide with nothing."""
        below: dict[str, set[str]] = {}
        for joint in self.robot.joints.values():
            if joint.parent in self.groups and joint.child in self.groups:
                below.setdefault(self.groups[joint.parent], set()).add(self.groups[joint.child])
        solid = {
            self.groups[name]
            for name, link in self.robot.links.items()
            if any(shape.role == "collision" for shape in link.geometries)
        }
        found: set[frozenset[str]] = set()
        for group, under in below.items():
            waiting, seen = list(under), set(under)
            for each in waiting:
                found.add(frozenset((group, each)))
                further = below.get(each, set()) - seen if each not in solid else set()
                seen |= further
                waiting += further
        return found

    @cached_property
    def disabled(self) -> set[frozenset[str]]:
        """Pairs of links whose collisions an SRDF file of the project turns off."""
        library = library_of(self.document)
        found: set[frozenset[str]] = set()
        if library is None or not os.path.exists(self.document.path):
            return found
        for path in library.packages(self.document.path).files(".srdf", _SEMANTICS):
            semantics = library.document(path)
            root = semantics.root if semantics is not None else None
            if root is None or root.get("name") != self.model.name:
                continue
            for element in root.children("disable_collisions"):
                found.add(frozenset((element.get("link1") or "", element.get("link2") or "")))
        return found

    def may_touch(self, a: str, b: str) -> bool:
        """Are two links neighbors, rigidly connected, or meant to be ignored?"""
        if a not in self.groups or b not in self.groups:
            return True
        pair = frozenset((self.groups[a], self.groups[b]))
        return len(pair) == 1 or pair in self.neighbors or frozenset((a, b)) in self.disabled

    @cached_property
    def size(self) -> float:
        """How far the links are apart, in m; at least 0.1."""
        places = [link.pose[:3, 3] for link in self.robot.links.values()]
        return max(0.1, *(float(np.linalg.norm(place - places[0])) for place in places)) if places else 0.1

    @cached_property
    def mass(self) -> float:
        return sum(link.body.mass for link in self.robot.links.values() if link.body is not None)

    def has_mesh(self, link: str) -> bool:
        """Does a link, or what is fixed to it, collide with a mesh?"""
        own = self.robot.links.get(link)
        return own is not None and any(
            one.role == "collision" and one.kind == "mesh" for one in own.geometries
        )

    def thickness(self, link: str) -> float:
        """The least length of its thickest plain collision shape (m); 0 without one."""
        own = self.robot.links.get(link)
        shapes = [] if own is None else [one for one in own.geometries if one.role == "collision"]
        return max(
            (
                min(one.size) if one.kind == "box" else min(2 * one.size[0], *one.size[1:], math.inf)
                for one in shapes
                if one.kind in {"box", "cylinder", "sphere"}
            ),
            default=0.0,
        )

    @cached_property
    def wheels(self) -> set[str]:
        """The links that turn without end, and are round."""
        found = set()
        for joint in self.robot.joints.values():
            turns = joint.kind in {"continuous", "revolute"} and bool(joint.axes)
            if turns and joint.child in self.robot.links and math.isinf(joint.axes[0].upper):
                shapes = self.robot.links[joint.child].geometries
                if any(one.role == "collision" and one.kind in {"cylinder", "sphere"} for one in shapes):
                    found.add(joint.child)
        return found

    @cached_property
    def mobile_base(self) -> str:
        """The root link of a robot with wheels that nothing holds; empty for others."""
        roots = self.robot.roots()
        held = any(joint.parent == "world" for joint in self.robot.joints.values())
        return roots[0] if len(roots) == 1 and len(self.wheels) > 1 and not held else ""


class Trial:
    """A model in one simulator."""

    def __init__(self, subject: Subject, engine: Engine, settings: Settings, stage: Stage) -> None:
        self.subject, self.engine, self.settings, self.stage = subject, engine, settings, stage
        self.title = _TITLES[engine]
        self.measured: Mapping[str, Any] = {}
        self.left_out: list[tuple[str, str]] = []
        """Links whose collision meshes are not simulated, and why."""
        name = f"{subject.document.path.name.partition('.')[0] or 'robot'}.urdf"
        self.path = stage.write("", name)
        self._write(self.path, subject.text)

    def _write(self, path: Path, text: str) -> None:
        """Write the URDF that the simulator gets: no visuals, meshes by absolute paths, nothing merged."""
        tree = etree.fromstring(
            text.encode("utf-8", "surrogateescape"),
            etree.XMLParser(resolve_entities=False, no_network=True, recover=True),
        )
        for link in tree.iterfind("link"):
            for visual in link.findall("visual"):
                link.remove(visual)
            for collision in link.findall("collision"):
                reason = self._unreadable(collision, path.parent)
                if reason:
                    link.remove(collision)
                    self.left_out.append((link.get("name", ""), reason))
        if self.engine is Engine.MUJOCO:
            self._set_compiler(tree)
        path.write_text(etree.tostring(tree, encoding="unicode"), encoding="utf-8", errors="surrogateescape")

    def _unreadable(self, collision: Any, folder: Path) -> str:
        """Finds the mesh of a collision; says why it cannot be simulated."""
        for mesh in collision.iter("mesh"):
            uri = mesh.get("filename", "").strip()
            path = locate(self.subject.document, uri).path if uri else None
            if path is None:
                return f"`{uri}` is not found"
            if path.suffix.lower() not in _MESHES[self.engine]:
                return f"{self.title} does not read a `{path.suffix}` file"
            place = folder / f"{len(list(folder.iterdir()))}-{path.name}"
            try:
                os.symlink(path.resolve(), place)
            except OSError:
                shutil.copyfile(path, place)
            mesh.set("filename", str(place))
        return ""

    def _is_ball(self, name: str) -> bool:
        joint = self.subject.robot.joints.get(name)
        return joint is not None and joint.kind == "ball"

    def _set_compiler(self, tree: Any) -> None:
        extension = tree.find("mujoco")
        if extension is None:
            extension = etree.SubElement(tree, "mujoco")
        compiler = extension.find("compiler")
        if compiler is None:
            compiler = etree.SubElement(extension, "compiler")
        for joint in tree.iterfind("joint"):
            name = joint.get("name", "")
            if self._is_ball(self.subject.joints.get(name, name)) and joint.get("type") == "floating":
                joint.set("type", "spherical")  # its own word
        compiler.attrib.pop("meshdir", None)
        compiler.attrib.update({"strippath": "false", "fusestatic": "false"})

    def findings(self) -> Iterator[Diagnostic]:
        """Ask, and judge the answers."""
        facts, held, *stood = self._answers()
        if not facts.is_accepted:
            yield self._refused(facts)
            return
        for link, why in self.left_out:
            text = f"collides with nothing in {self.title}: {why}"
            yield self._at_link(SimKind.LEFT_OUT, link, text, "info")
        if facts.result:
            if not self.subject.converted:
                yield from self._masses(facts.result["bodies"])
            yield from self._joints(facts.result["joints"])
        if not held.is_accepted or held.error:
            yield self._refused(held)
            return
        self.measured = held.result
        yield from self._overlaps(held.result["overlaps"])
        yield from self._sweep(**held.result["sweep"])
        yield from self._loads(held.result["loads"])
        if held.result["overlaps"]:
            return  # these push, so that nothing else is as it was meant
        yield from self._fall(held.result["fall"])
        for answer in stood:
            yield from self._stand(answer.result.get("stand", {}))

    def _answers(self) -> list[Answer]:
        """The measurements: the numbers, the behavior, and on the ground."""
        settings = self._experiments("overlaps", "fall", "sweep", "loads")
        asked: list[tuple[str, dict[str, Any]]] = [
            ("facts", {"configurations": [{}]}),
            ("behave", settings),
        ]
        if root := self.subject.mobile_base:
            asked.append(("behave", self._experiments("stand") | {"root": self._in_urdf(root)}))
        questions = [Question(self.path, action, given) for action, given in asked]
        answers = list(ask_all(self.engine, questions, self.settings.limits))
        if answers[0].outcome is Outcome.MISSING:
            raise MissingEngine(f"{self.title} is not installed: {answers[0].error}")
        return answers

    def _experiments(self, *names: str) -> dict[str, Any]:
        return {
            "experiments": names,
            "seconds": self.settings.seconds,
            "time_step": TIME_STEP,
            "followers": self.subject.followers,
        }

    def compared_with_conversion(self) -> Iterator[Diagnostic]:
        """Whether the robot falls as it did when it has been SDFormat, where nothing touches.

        Links without mass, to which simulators give one as they like, are not those that come back.
        """
        before = self.measured["fall"].get("early")
        is_comparable = len(self.subject.robot.roots()) == 1 and not self.subject.massless_movers
        if self.measured["overlaps"] or not before or not is_comparable or self.subject.returned is None:
            return
        path = self.stage.write("", self.path.name)
        self._write(path, self.subject.returned)
        settings = self._experiments("fall") | {"seconds": ALIKE}
        (answer,) = ask_all(self.engine, [Question(path, "behave", settings)], self.settings.limits)
        model = self.subject.model
        if not answer.is_accepted or answer.error:
            text = f"model `{model.name}`: {self.title} does not load what comes back from SDFormat: {answer.error}"
            yield self._found(SimKind.CONVERSION_DIFFERS, model.element, text, "warning")
            return
        name, apart = _farthest(before, answer.result["fall"].get("early", {}))
        if apart > _APART * self.subject.size + 0.005:
            text = (
                f"is {_length(apart)} elsewhere after {ALIKE:g} s in {self.title} when the robot was SDFormat "
                "in between: `sdfcheck convert` says what was changed"
            )
            yield self._at_link(SimKind.CONVERSION_DIFFERS, self._name(name), text)

    def _refused(self, answer: Answer) -> Diagnostic:
        why = answer.error.replace(str(self.path), self.subject.document.path.name)
        verb = "does not load it" if answer.outcome is Outcome.REFUSED else "cannot run it"
        after = ", as URDF" if self.subject.converted else ""
        text = f"model `{self.subject.model.name}`: {self.title} {answer.version} {verb}{after}: {why}"
        found = self._found(SimKind.NOT_LOADED, self.subject.model.element, text, "error")
        return found._replace(help=f"look for the reason with `sdfcheck lint --target {self.engine.value}`")

    def _masses(self, bodies: Mapping[str, Any]) -> Iterator[Diagnostic]:
        given: dict[str, float] = {}
        for name, own in self.subject.robot.links.items():
            body = bodies.get(self._in_urdf(name))
            if body is None:
                continue
            if own.body is None and body[0] > 0:
                given[name] = body[0]
                continue
            mass = own.body.mass if own.body is not None else 0.0
            is_hollow = not body[0] and not mass and own.geometries and name in self.subject.moved
            if is_hollow and self.subject.mass_with(name) <= self.subject.mass / 2:
                text = f"moves, has shapes, and a mass of 0, which {self.title} takes as it is"
                yield self._at_link(SimKind.OTHER_MASS, name, text)
                continue
            if not math.isclose(body[0], mass, rel_tol=1e-3, abs_tol=1e-6):
                text = f"has {body[0]:g} kg in {self.title}, and {mass:g} kg here"
                yield self._at_link(SimKind.OTHER_MASS, name, text)
            elif own.body is not None and not self.subject.converted:
                moments, written = np.array(body[2]), own.body.moments
                scale = max(float(np.abs(written).max()), 1e-12)
                if not float(np.abs(moments - written).max()) <= 1e-2 * scale:
                    yield self._at_link(
                        SimKind.OTHER_MASS, name, f"has other moments of inertia in {self.title} than here"
                    )

        movers = [name for name in self.subject.massless_movers if name in given]
        for name in [*movers, *given][:1]:
            more = f"; so have {counted(len(given) - 1, 'other link')}" if len(given) > 1 else ""
            text = f"has no mass here, and {given[name]:.4g} kg by {self.title}'s own choice{more}"
            # That of the root link, which is held, changes nothing.
            matters = sum(given[mover] for mover in movers) > _SMALL * self.subject.mass
            yield self._at_link(SimKind.OTHER_MASS, name, text, "warning" if matters else "info")

    def _joints(self, joints: Mapping[str, Any]) -> Iterator[Diagnostic]:
        for urdf, name in self.subject.joints.items():
            own = self.subject.robot.joints[name]
            if own.kind not in {"revolute", "prismatic", "continuous"} or not own.axes:
                continue
            if urdf not in joints:
                yield self._at_joint(SimKind.OTHER_JOINT, own, f"is not in {self.title}")
                continue
            there = joints[urdf]["lower"], joints[urdf]["upper"]
            here = own.axes[0].lower, own.axes[0].upper
            if own.kind != "continuous" and not all(map(_as_good_as, here, there)):
                ranges = [f"{a:g} to {b:g}" if b - a < 1e9 else "no range" for a, b in (here, there)]
                text = f"has {ranges[1]} in {self.title}, and {ranges[0]} here"
                is_unsaid = not any(here)  # some write that for no limits
                yield self._at_joint(SimKind.OTHER_JOINT, own, text, "info" if is_unsaid else "warning")

    def _overlaps(self, pairs: Iterable[Sequence[Any]]) -> Iterator[Diagnostic]:
        for a, b, depth, point in pairs:
            one, other = self._name(a), self._name(b)
            if depth > _DEPTH and not self.subject.may_touch(one, other):
                own, note = self._severity(one, other, depth)
                text = f"overlaps link `{other}` by {_length(depth)} at the start in {self.title}{note}"
                label = self._label(other, "the other link")
                yield self._at_link(SimKind.START_OVERLAP, one, text, own, label, self._moment({}, point))

    def _severity(self, a: str, b: str, depth: float) -> tuple[str, str]:
        """That of an overlap, and what the simulator has to do with it."""
        if self.engine in _HULLS and (self.subject.has_mesh(a) or self.subject.has_mesh(b)):
            return "info", ", which takes the convex hulls of meshes"
        is_shallow = depth < _SHALLOW * min(map(self.subject.thickness, (a, b)))
        return "info" if is_shallow else "warning", ""

    def _fall(self, fall: Mapping[str, Any]) -> Iterator[Diagnostic]:
        subject = self.subject
        if not fall["finite"]:
            text = f"positions are not finite in {self.title} after {fall['time']:.2g} s"
            yield self._found(
                SimKind.UNSTABLE, subject.model.element, f"model `{subject.model.name}`: {text}", "error"
            )
            return
        scale = max(subject.mass * GRAVITY * subject.size, 1e-3)
        gain = fall["highest"] - fall["energy"]
        fastest = max(fall["fastest"].items(), key=lambda item: item[1], default=("", 0.0))
        bound = 3 * math.sqrt(4 * GRAVITY * subject.size) + 2 * GRAVITY * self.settings.seconds
        if gain > _GAIN * scale:
            text = f"gains {gain:.3g} J from nothing in {self.title} while it falls with its root link held"
            yield self._at_link(SimKind.UNSTABLE, self._name(fastest[0]), text, "warning")
        elif fastest[1] > bound:
            text = f"moves at {fastest[1]:.3g} m/s in {self.title}, faster than falling explains"
            yield self._at_link(SimKind.UNSTABLE, self._name(fastest[0]), text, "warning")
        else:
            half, double = fall["steps"]
            name, apart = _farthest(half, double)
            if apart > _APART * subject.size + 0.005:
                text = (
                    f"is {_length(apart)} elsewhere after 0.2 s in {self.title} with {2 * TIME_STEP:g} s as "
                    f"time step than with {TIME_STEP / 2:g} s"
                )
                yield self._at_link(SimKind.STEP_DEPENDENT, self._name(name), text, "warning")

    def _sweep(self, met: Iterable[Sequence[Any]], mirrored: Iterable[Sequence[Any]]) -> Iterator[Diagnostic]:
        rows = [row for row in met if self._is_meeting(row)]
        barred = {row[0] for row in mirrored if self._is_meeting(row)}
        deepest = {row[0]: row for row in sorted(rows, key=lambda row: row[3])}
        free = {
            self.subject.joints[joint]: row
            for joint, row in deepest.items()
            if joint not in barred and row[3] > _DEEP and row[6] > 1
        }
        twins = {each.mirror.name for each in self.subject.model.joints if each.mirror and each.name in free}
        for row in rows:
            joint, a, b, depth, position, point, count, steps = row
            one, other = self._name(a), self._name(b)
            own = self.subject.robot.joints[self.subject.joints[joint]]
            severity, note = self._severity(one, other, depth)
            unit = "m" if own.kind == "prismatic" else "rad"
            text = f"moves link `{one}` {_length(depth)} into `{other}` at {position:.3g} {unit}"
            often = f" ({count} of {steps} positions) in {self.title}{note}"
            is_near = self.subject.joints_between(one, other) <= _NEAR
            severity = severity if is_near and 2 * count > steps else "info"
            if row is free.get(own.name) and own.name not in twins:
                severity, often = "warning", f"{often}; with the opposite axis it would meet nothing"
            moment = self._moment({own.name: position}, point)
            yield self._at_joint(SimKind.COLLIDING_JOINT, own, text + often, severity, moment)

    def _is_meeting(self, row: Sequence[Any]) -> bool:
        """Are two parts in one another on a joint's way, which should not?"""
        joint, a, b, depth, *_ = row
        return (
            joint in self.subject.joints
            and depth > _DEPTH
            and not self.subject.may_touch(self._name(a), self._name(b))
        )

    def _loads(self, loads: Mapping[str, Mapping[str, float]]) -> Iterator[Diagnostic]:
        for urdf, name in self.subject.joints.items():
            own = self.subject.robot.joints[name]
            effort = own.axes[0].effort if own.axes else math.inf
            unit = "N" if own.kind == "prismatic" else "N·m"
            if not 0 < effort < math.inf:
                continue
            start, most = (loads[each].get(urdf, 0.0) for each in ("start", "most"))
            if start > effort * 1.001:
                text = f"needs {start:.3g} {unit} to hold the robot where it starts, and has {effort:g}"
                severity = "warning" if start > _WEAK * effort else "info"
                yield self._at_joint(SimKind.WEAK_JOINT, own, f"{text} ({self.title})", severity)
            elif most > effort * 1.001:
                text = f"needs up to {most:.3g} {unit} to hold the robot, and has {effort:g}"
                yield self._at_joint(SimKind.WEAK_JOINT, own, f"{text} ({self.title})", "info")

    def _stand(self, stood: Mapping[str, Any]) -> Iterator[Diagnostic]:
        if not stood.get("touches") or "tilt" not in stood:
            return
        root = self.subject.mobile_base
        touching = {self._name(name) for name in stood["touches"]}
        after = f"within {self.settings.seconds:g} s on level ground in {self.title}"
        if stood["tilt"] > _TILT:
            text = f"tips over: it tilts by {math.degrees(stood['tilt']):.0f}° {after}"
            yield self._at_link(SimKind.TIPPING, root, text)
        elif touching.isdisjoint(self.subject.wheels):
            names = ", ".join(f"`{name}`" for name in sorted(touching)[:3])
            text = f"stands on {names} and not on its wheels, {after}"
            yield self._at_link(SimKind.TIPPING, root, text)

    def _moment(self, moved: Mapping[str, float], point: Sequence[float]) -> Moment:
        """The robot where it starts, but for some joints; the point is in the frame of its root link."""
        robot = self.subject.robot
        axes = {name: joint.axes[0] for name, joint in robot.joints.items() if joint.axes}
        start = {
            name: min(max(0.0, axis.lower), axis.upper)
            for name, axis in axes.items()
            if axis.lower <= axis.upper
        }
        positions = {name: float(at) for name, at in {**start, **moved}.items() if at}
        root = next((robot.links[name].pose for name in robot.roots() if name in robot.links), np.eye(4))
        place = root @ np.array([*point, 1.0])
        return Moment(tuple(sorted(positions.items())), (tuple(map(float, place[:3])),))

    def _name(self, urdf: str) -> str:
        return self.subject.links.get(urdf, urdf)

    def _in_urdf(self, name: str) -> str:
        return next((urdf for urdf, own in self.subject.links.items() if own == name), name)

    def _label(self, link: str, text: str) -> tuple[Label, ...]:
        own = self.subject.robot.links.get(link)
        return (Label(_place(own.element), text),) if own is not None else ()

    def _at_link(
        self,
        kind: SimKind,
        name: str,
        text: str,
        severity: str = "warning",
        labels: tuple[Label, ...] = (),
        moment: Moment | None = None,
    ) -> Diagnostic:
        link = self.subject.robot.links.get(name)
        element = link.element if link is not None else self.subject.model.element
        return self._found(kind, element, f"link `{name}` {text}", severity, labels)._replace(moment=moment)

    def _at_joint(
        self, kind: SimKind, joint: Joint, text: str, severity: str = "warning", moment: Moment | None = None
    ) -> Diagnostic:
        found = self._found(kind, joint.element, f"joint `{joint.name}` {text}", severity)
        return found._replace(moment=moment)

    def _found(
        self, kind: SimKind, element: Element, text: str, severity: str, labels: tuple[Label, ...] = ()
    ) -> Diagnostic:
        return _diagnostic(kind, element, text, Severity(severity), labels)


def _diagnostic(
    kind: SimKind, element: Element, text: str, severity: Severity, labels: tuple[Label, ...] = ()
) -> Diagnostic:
    origins = tuple(Origin(step.span, step.text) for step in element.document.origins(element))
    return Diagnostic(kind.code, kind.title, severity, text, _place(element), labels, None, None, origins)


def _place(element: Element) -> Span:
    """The name of an element, or the element."""
    value = element.attribute("name")
    return value.span if value is not None else element.span


def _given(element: Element, name: str) -> Span:
    """The numbers of a child element in URDF, or the name of the element."""
    child = element.find(name)
    value = None if child is None else child.attribute("xyz")
    return value.span if value is not None else _place(element)


def _as_good_as(a: float, b: float) -> bool:
    """Are two bounds equal? So large ones mean none."""
    return math.isclose(a, b, rel_tol=1e-3, abs_tol=1e-4) or (min(abs(a), abs(b)) >= 1e9 and a * b > 0)


def _length(length: float) -> str:
    return f"{1000 * length:.3g} mm" if length < 1 else f"{length:.3g} m"


def _farthest(a: Mapping[str, Any], b: Mapping[str, Any]) -> tuple[str, float]:
    """The link that is farthest from where it is in another run, and how far."""
    apart = {
        name: math.dist([row[3] for row in a[name][:3]], [row[3] for row in b[name][:3]])
        for name in a
        if name in b
    }
    return max(apart.items(), key=lambda item: item[1], default=("", 0.0))


def _disagreements(subject: Subject, runs: Mapping[Engine, Mapping[str, Any]]) -> Iterator[Diagnostic]:
    """Simulators that let the robot fall differently, where nothing touches."""
    quiet = {engine: run["fall"] for engine, run in runs.items() if not run["overlaps"]}
    first, *others = quiet or {Engine.MUJOCO: {}}
    for other in others:
        early = (quiet[engine].get("early", {}) for engine in (first, other))
        ends = ({name: pose for name, pose in each.items() if name not in subject.loose} for each in early)
        name, apart = _farthest(*ends)
        if apart > _APART * subject.size + 0.005:
            link = subject.robot.links.get(subject.links.get(name, name))
            text = (
                f"link `{subject.links.get(name, name)}` is {_length(apart)} elsewhere after 0.2 s in "
                f"{_TITLES[other]} than in {_TITLES[first]}"
            )
            element = link.element if link is not None else subject.model.element
            yield _diagnostic(SimKind.ENGINES_DISAGREE, element, text, Severity.WARNING)


# Other descriptions of the robot in the project.


class _Difference(NamedTuple):
    """A joint that another description has otherwise, and that one's joint.

    ``what`` says how, and ``where`` which element of URDF does; both are empty where either may be right.
    """

    joint: Joint
    other: Joint
    what: str = ""
    where: str = ""


class _Comparison(NamedTuple):
    """The joints that another description has where a robot has them, by name, and the one that it has otherwise."""

    equal: frozenset[str]
    odd: _Difference | None


def _contradictions(subject: Subject, expander: Expander) -> Iterator[Diagnostic]:
    """The joints that other descriptions of the robot have otherwise, if more do than not, and all others alike."""
    compared = [_compared(subject.robot, other) for other in _other_descriptions(subject, expander)]
    alike = [each for each in compared if each is not None]
    for joint in subject.robot.joints.values():
        against = [(each.odd, len(each.equal)) for each in alike if each.odd and each.odd.joint is joint]
        if len(against) <= sum(joint.name in each.equal for each in alike):
            continue
        found, count = against[0]
        file = found.other.element.document.path.name
        more = f", and in {counted(len(against) - 1, 'other file')}" if len(against) > 1 else ""
        yield _diagnostic(
            SimKind.OTHER_DESCRIPTION,
            joint.element,
            f"joint `{joint.name}` {found.what} in `{file}`{more}, where {count} other joints are as they are here",
            Severity.WARNING,
            (Label(_place(found.other.element), "the joint there"),),
        )._replace(
            span=_given(joint.element, found.where),
            help="correct the one that is wrong: `sdfcheck diff` shows all that differs",
        )


def _other_descriptions(subject: Subject, expander: Expander) -> Iterator[Mechanism]:
    """The robots of the project's other files that have its joints, those in the nearest files first."""
    library, path = library_of(subject.document), subject.document.path
    if library is None or library.search.is_alone or len(subject.movers) <= _ALIKE_JOINTS:
        return
    count = 0
    for file in files_of_robots(subject.document, library.packages(path), (".urdf", ".sdf", ".xacro")):
        try:
            other = None if file.samefile(path) else _description(subject, library, file, expander)
            yield from () if other is None else map(mechanism_of, _models(other))
        except (OSError, DescriptionError, WrongUsage):
            continue
        count += other is not None
        if count == _DESCRIPTIONS:
            return


def _description(subject: Subject, library: Library, file: Path, expander: Expander) -> Document | None:
    """The description in a file, expanded; None where it has not the joints, or as xacro not the robot's name."""
    text = library.read(file, subject.document).decode("utf-8", "replace")
    if "<xacro:" not in text:
        is_about_it = sum(f'"{name}"' in text for name in subject.movers) > _ALIKE_JOINTS
        return library.document(file, of=subject.document) if is_about_it else None
    if f'name="{subject.model.name}"' not in text:
        return None
    written = library.document(file, Kind.XACRO, subject.document)
    expanded = None if written is None else expander.expand(written).document
    if expanded is not None:
        expanded.library = library
    return expanded


def _compared(robot: Mechanism, other: Mechanism) -> _Comparison | None:
    """The joints of a robot and another one; None where that is not the same robot, but for one joint."""
    equal, odd = set(), []
    for joint in robot.joints.values():
        there = other.joints.get(joint.name)
        if there is None or not joint.axes or joint.parent not in robot.links:
            continue
        if (there.kind, there.parent, there.child) != (joint.kind, joint.parent, joint.child):
            continue
        found = _difference(robot, joint, other, there)
        if found is None:
            equal.add(joint.name)
        else:
            odd.append(found)
    if len(odd) > 1 or len(equal) < _ALIKE_JOINTS:
        return None
    is_namesake = robot.name == other.name or len(equal) > _ARM
    clear = [each for each in odd if each.where == "axis" or (each.where and is_namesake)]
    return _Comparison(frozenset(equal), clear[0] if clear else None)


def _difference(robot: Mechanism, joint: Joint, other: Mechanism, there: Joint) -> _Difference | None:
    """The way in which a joint is not as in another robot; None where it is."""
    own, its = (
        inverse(each.links[one.parent].pose) @ one.pose for each, one in ((robot, joint), (other, there))
    )
    apart = math.dist(own[:3, 3], its[:3, 3])
    along = float(joint.axes[0].direction @ there.axes[0].direction)
    unclear = _Difference(joint, there)
    if not np.allclose(own[:3, :3], its[:3, :3], atol=_EQUAL) or abs(along) < 1 - _EQUAL:
        return unclear
    if along < 0:
        is_clear = apart <= _EQUAL and not _is_exchanged(joint, there)
        return unclear._replace(what="moves the other way than", where="axis") if is_clear else unclear
    if apart <= _EQUAL:
        return None
    ends = (joint.parent, joint.child)
    is_clear = apart > _DEPTH and all(_is_alike(robot.links[end], other.links[end]) for end in ends)
    what = f"is {_length(apart)} from where it is"
    return unclear._replace(what=what, where="origin") if is_clear else unclear


def _is_exchanged(joint: Joint, other: Joint) -> bool:
    """Do two joints with opposite axes go to the same places, by their limits?"""
    own, its = joint.axes[0], other.axes[0]
    ends = (own.lower, own.upper), (-its.upper, -its.lower)
    return abs(own.lower + own.upper) > _EQUAL and all(map(_as_good_as, *ends))


def _is_alike(link: Link, other: Link) -> bool:
    """Have two links the same shapes at the same places, meshes by their names and the sizes of their files?"""
    pairs = zip(link.geometries, other.geometries, strict=False)
    return 0 < len(link.geometries) == len(other.geometries) and all(
        a.kind == b.kind
        and a.is_as_large_as(b, _EQUAL)
        and np.allclose(a.pose, b.pose, atol=_EQUAL)
        and _file(a) == _file(b)
        for a, b in pairs
    )


def _file(shape: Geometry) -> tuple[str, int]:
    """The name of a mesh and the size of its file, 0 where it is not found."""
    path = locate(shape.element.document, shape.uri).path if shape.uri else None
    size = os.path.getsize(path) if path is not None and os.path.isfile(path) else 0
    return shape.uri.replace("\\", "/").rpartition("/")[2] if size else shape.uri, size
