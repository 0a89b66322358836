"""``<gazebo>`` blocks: their content goes where libsdformat puts it, and the names in it follow what was renamed."""

from __future__ import annotations

from collections.abc import Callable, Container, Iterator
from math import isfinite

import numpy as np

from sdfcheck.consumers.reaction import Consumer
from sdfcheck.convert.ledger import TEXT
from sdfcheck.convert.loss import LossKind
from sdfcheck.convert.migrate.up import renew
from sdfcheck.convert.urdf_to_sdf.plan import FOR_DRAKE, OF_JOINTS, Context, Given, legal, pose_of
from sdfcheck.convert.writer import NONE, SCRIPTS, WAS, numbers
from sdfcheck.formats.sdf.values import floats, number
from sdfcheck.formats.urdf.schema import TRUE, Setting, all_settings, settings
from sdfcheck.lint.diagnostic import Severity
from sdfcheck.robot.graph import PRESERVING, Model, text_of_setting
from sdfcheck.robot.motion.poses import Array, from_rpy, to_rpy, transform
from sdfcheck.robot.naming.references import NAMING
from sdfcheck.source.altered import Xml, copied
from sdfcheck.source.document import Comment, Element

# Copies of what is in ``<gazebo>`` blocks, as the version that is written has it.
#
# Names there must not have ``::`` in them, nor be those of two things in one link.


_SINGLE = frozenset({"light", "particle_emitter", "projector", "sensor"})
"""The parts of a link or joint that libsdformat looks up by name."""


def copied_entry(context: Context, entry: Element, holder: Xml) -> Xml:
    """The copy of an entry of a block, entered as such; ``holder`` is where it goes."""
    made = context.copied(entry)
    context.ledger.copy(entry)
    context.copies.append((entry, made, holder))
    _settle_names(context, entry, made, holder)
    for said in renew(made, context.options.version, entry):
        context.note(entry, LossKind.CHANGED_DEFAULT, *said)
    return made


def _settle_names(context: Context, entry: Element, made: Xml, holder: Xml) -> None:
    for node in _checked(made):
        own = node.attributes.get("name", "")
        if "::" in own:
            node.attributes["name"] = legal(own)
            _report(context, entry, node, own)
    own = made.attributes.get("name", "")
    if made.name not in _SINGLE or not own:
        return
    taken = {child.attributes.get("name") for child in holder.children(made.name)}
    number = 1
    while made.attributes["name"] in taken:
        number += 1
        made.attributes["name"] = f"{own}_{number}"
    if number > 1:
        _report(context, entry, made, own)


def _report(context: Context, entry: Element, node: Xml, own: str) -> None:
    message = f"{node.name} `{own}` of a <gazebo> block is named `{node.attributes['name']}`"
    context.note(entry, LossKind.RENAMED, message)


def _checked(node: Xml) -> Iterator[Xml]:
    """The elements whose names libsdformat checks: not those of plugins and custom elements, nor what is in them."""
    if node.name == "plugin" or ":" in node.name:
        return
    yield node
    for child in node.children():
        yield from _checked(child)


# Names that the content of ``<gazebo>`` blocks writes: of collisions, in the words of libsdformat, and of links.
#
# A contact sensor names a collision as libsdformat calls it, which is not what the result calls it. Of
# the parameters of plugins libsdformat rewrites two, with the offset of the link that is merged
# (parser_urdf.cc, ReduceSDFExtensionPluginFrameReplace); others stay as they are, and are reported.


_WITH_OFFSET = ("bodyName", "frameName")
"""Parameters of plugins in which the name of a link is rewritten."""
_ENDS = ("parent", "child")
_ORIGIN = ("xyzOffset", "rpyOffset")
_AXES = "xyz"


class FollowedNames:
    """Rewrites what a copy of a block's content calls by a name that the result has for nothing."""

    def __init__(self, context: Context, robot: Model) -> None:
        self.context = context
        built = robot.as_built_by(Consumer.GAZEBO)
        self.collisions = {
            shape.name: shape.origin.element for link in built.links.values() for shape in link.collisions
        }
        """The names that libsdformat gives to collisions → the collision."""
        self.gone = dict(self._gone())

    def _gone(self) -> Iterator[tuple[str, tuple[LossKind, str]]]:
        """The names of links and joints that were merged or renamed, with the reason."""
        plan = self.context.plan
        of_links = plan.names.links.keys() - {name for name in plan.names.links if plan.is_merged(name)}
        for name, new in plan.names.joints.items():
            if name in of_links:
                continue
            if name in plan.merged_joints:
                yield name, (LossKind.MERGED_LINK, f"joint `{name}` was merged")
            elif new != name:
                yield name, (LossKind.RENAMED, f"joint `{name}` is now named `{new}`")
        for name, new in plan.names.links.items():
            survivor = plan.home[name][0]
            if survivor != name:
                yield name, (LossKind.MERGED_LINK, f"link `{name}` is now part of link `{survivor}`")
            elif new != name and not plan.is_world(name):
                yield name, (LossKind.RENAMED, f"link `{name}` is now named `{new}`")

    def follow(self, entry: Element, made: Xml, holder: Xml) -> None:
        """Look at one element of a block, its copy, and the element that holds the copy."""
        for element, node in _pairs(entry, made):
            if element.name == "contact" and element.parent is not None and element.parent.name == "sensor":
                self._follow_collisions(element, node, holder)
            elif element.name == "plugin":
                self._follow_parameters(element, node)
            elif element.name in _ENDS:
                self._follow_scope(element, node)

    def _follow_scope(self, end: Element, made: Xml) -> None:
        """Rewrite the end of a joint in a model of a block that has got another name."""
        own, delimiter, rest = end.content.partition("::")
        if delimiter and own in self.context.own_names:
            made.write(f"{self.context.own_names[own]}::{rest}")
            self.context.note(
                end, LossKind.RENAMED, f"`{end.content}` is now `{made.content}`", Severity.INFO
            )

    def _follow_collisions(self, contact: Element, made: Xml, holder: Xml) -> None:
        for element, node in zip(contact.children("collision"), made.children("collision"), strict=False):
            own = node.content
            collision = self.collisions.get(own)
            written = None if collision is None else self.context.shapes.get(collision)
            if written is None or own in {
                part.attributes.get("name") for part in holder.children("collision")
            }:
                continue
            link, shape = written
            if link is holder:
                node.write(shape.attributes["name"])
                if node.content != own:
                    text = f"collision `{own}`, as libsdformat calls it, is named `{node.content}`"
                    self.context.note(element, LossKind.RENAMED, text, Severity.INFO)
            else:
                text = f"{contact.parent.title if contact.parent is not None else contact.title} gets no contacts: "
                text += f"collision `{shape.attributes['name']}` is in link `{link.attributes['name']}`"
                self.context.note(element, LossKind.DROPPED_SENSOR, text)

    def _follow_parameters(self, plugin: Element, made: Xml) -> None:
        for element, node in _pairs(plugin, made):
            found = self.gone.get(element.content)
            if found is None:
                continue
            kind, what = found
            if kind is LossKind.RENAMED and NAMING.search(element.name):
                node.write(self._renamed(element.content))
                text = f"<{element.name}> of {plugin.title} names `{node.content}`: {what}"
                self.context.note(element, kind, text, Severity.INFO)
                continue
            in_sensor = plugin.parent is not None and plugin.parent.name == "sensor"
            if element.parent is plugin and element.name in _WITH_OFFSET and not in_sensor:
                survivor, offset = self.context.plan.home.get(element.content, ("", np.eye(4)))
                if survivor in self.context.links:
                    self._move(plugin, made, offset)
                    self._mark(node, element)
                    node.write(self.context.plan.names.links[survivor])
                    text = f"<{element.name}> of {plugin.title} names `{node.content}`: {what}"
                    self.context.note(element, kind, text, Severity.INFO)
                    continue
            # A plugin of a sensor names the frame that it publishes in, which is there for others.
            is_frame = (
                element.name in _WITH_OFFSET
                and kind is LossKind.MERGED_LINK
                and self.context.options.has_frames
            )
            severity = Severity.INFO if is_frame else Severity.WARNING
            text = f"<{element.name}> of {plugin.title} stays as it is, but {what}"
            self.context.note(element, kind, text, severity)

    def _mark(self, node: Xml, before: Element | None) -> None:
        """Say on a parameter what it was."""
        if self.context.options.has_frames:
            node.attributes[WAS] = NONE if before is None or not before.content else before.content

    def _renamed(self, name: str) -> str:
        """The new name of a link or joint; a link goes before a joint of its name."""
        names = self.context.plan.names
        is_link = name in names.links and not self.context.plan.is_merged(name)
        return names.links[name] if is_link else names.joints[name]

    def _move(self, plugin: Element, made: Xml, offset: Array) -> None:
        """Write where the plugin is in the link that is left, 4×4 ``offset`` being the place of its own link."""
        if np.array_equal(offset, np.eye(4)):
            return
        given = {name: plugin.find(name) for name in _ORIGIN}
        values = {name: _three(one) for name, one in given.items()}
        for name, one in given.items():
            if one is not None and values[name] is None:
                text = f"<{name}> of {plugin.title} is not three numbers and stays as it is, "
                text += "but the link that it is measured from was merged"
                self.context.note(one, LossKind.MERGED_LINK, text)
        position, angles = values.values()
        if position is None or angles is None:
            return
        place = offset @ transform(from_rpy(*angles), position)
        rows = (tuple(map(float, place[:3, 3])), to_rpy(place[:3, :3]))
        for (name, one), row in zip(given.items(), rows, strict=True):
            self._mark(made.reach(name), one)
            made.reach(name).write(numbers(row))
            if one is not None:
                text = f"<{name}> of {plugin.title} is from the link that is left"
                self.context.note(one, LossKind.MERGED_LINK, text, Severity.INFO)


def _three(element: Element | None) -> tuple[float, ...] | None:
    """The numbers of an offset, zeros where it is not written; None where it is not three numbers."""
    found = (0.0, 0.0, 0.0) if element is None else floats(element.content)
    return found if found is not None and len(found) == len(_AXES) and all(map(isfinite, found)) else None


def _pairs(element: Element, node: Xml) -> Iterator[tuple[Element, Xml]]:
    """An element and its copy, and those in them, as long as they go together."""
    yield element, node
    for child, made in zip(element.children(), node.children(), strict=False):
        if child.name != made.name:
            return
        yield from _pairs(child, made)


# ``<gazebo>`` blocks: what they say of a link, a joint or the model goes where SDFormat has it.


_PLACED = frozenset({"sensor", "light", "projector", "audio_source", "particle_emitter"})
_BOUNDS = frozenset({"lower", "upper", "effort", "velocity", "damping", "friction"})


class Extensions:
    """Applies the blocks of a robot to what was written for its links and joints."""

    def __init__(self, context: Context) -> None:
        self.context = context

    def apply(self, block: Element, model: Xml) -> None:
        reference = block.attributes.get("reference", "").strip()
        self.context.ledger.take(block)
        plan = self.context.plan
        if not reference:
            self._each(block, model, self._model_part)
            return
        is_joint = reference in self.context.joints or reference in plan.merged_joints
        if is_joint:
            # A link of the same name takes what it can have.
            only = OF_JOINTS if reference in plan.home else None
            if reference in self.context.joints:
                self._each(block, self.context.joints[reference], self._joint_part, only)
            else:
                self._only_hints(block, reference, only)
        if reference in plan.home:
            self._of_link(block, reference, OF_JOINTS if is_joint else frozenset())
        elif not is_joint:
            gone = reference in plan.robot.joints
            called = f"no link or joint is called `{reference}`"
            self._unknown(block, f"joint `{reference}` has no counterpart" if gone else called)

    def _of_link(self, block: Element, link: str, others: frozenset[str]) -> None:
        """Put what a block says of a link where the link is now, without the settings that are ``others``'."""
        survivor, offset = self.context.plan.home[link]
        if survivor not in self.context.links:
            is_dropped = link in self.context.plan.dropped_links
            self._unknown(block, f"link `{link}` is left out" if is_dropped else f"`{link}` is the world")
            return
        part = _LinkPart(self.context, link, offset)
        wanted = {entry.name for entry in block.children()} - others if others else None
        self._each(block, self.context.links[survivor], part.put, wanted)

    def _each(
        self,
        block: Element,
        node: Xml,
        put: Callable[[Element, Xml], None],
        only: Container[str] | None = None,
    ) -> None:
        for entry in block.nodes:
            if isinstance(entry, Comment):
                if only is not OF_JOINTS and self.context.ledger.take_comment(entry):
                    node.extend(entry)
            elif isinstance(entry, Element) and (only is None or entry.name in only):
                put(entry, node)

    def _unknown(self, block: Element, reason: str) -> None:
        if any(True for _ in block.children()):
            text = f"a <gazebo> block is left out: {reason}"
            self.context.lose(block, LossKind.UNKNOWN_REFERENCE, text)

    def _only_hints(self, block: Element, joint: str, only: Container[str] | None) -> None:
        for entry in block.children():
            if entry.name in PRESERVING:
                self.context.ledger.take(entry, TEXT, "value")
            elif only is None or entry.name in only:
                text = f"<{entry.name}> is left out: joint `{joint}` was merged"
                self.context.lose(entry, LossKind.EXTENSION_NOT_CARRIED, text)

    # The model

    def _model_part(self, entry: Element, model: Xml) -> None:
        setting = all_settings().get(entry.name)
        if setting is not None and setting.about in {"link", "joint"}:
            text = f"<{entry.name}> outside a block for a {setting.about} has no effect; it is left out"
            self.context.lose(entry, LossKind.EXTENSION_NOT_CARRIED, text)
        elif setting is not None and setting.type == "flag":
            self.context.ledger.take(entry, TEXT, "value")
            if (value := self.context.translated(entry, setting)) is not None:
                model.reach(entry.name).write(value)
        elif entry.is_custom or self.context.allows(entry.name):
            self._native(entry, model)
        else:
            self.context.keep(entry, model, of_block=True)

    def _native(self, entry: Element, model: Xml) -> None:
        """Parts that are SDFormat already; their names must differ from those of the robot."""
        joint = self.context.plan.robot.joints.get(entry.attributes.get("name", ""))
        if entry.name == "frame" and joint is not None and joint.kind in {"floating", *FOR_DRAKE}:
            # It replaces the joint, in whose place it is, for libsdformat.
            self.context.ledger.take_whole(entry)
            return
        own = entry.attributes.get("name", "")
        if entry.name == "frame" and ("frame", own) in self.context.vendors.named:
            # It is there for Drake as well.
            self.context.ledger.take_whole(entry)
            return
        made = copied_entry(self.context, entry, model)
        model.append(made)
        if entry.is_custom:
            self.context.name_anew(entry, made, model)
        if entry.name not in {"link", "joint", "frame", "model"}:
            return
        own = made.attributes.get("name", "")
        name = made.attributes["name"] = self.context.plan.names.free(own)
        if entry.name == "link":
            self.context.own_links.add(name)
        if name != own:
            self.context.own_names[own] = name
            text = f"{entry.title} of a <gazebo> block is named `{name}`"
            self.context.note(entry, LossKind.RENAMED, text)

    # Joints

    def _joint_part(self, entry: Element, joint: Xml) -> None:
        context, name = self.context, entry.name
        if (setting := settings("joint").get(name)) is not None:
            self._joint_setting(entry, setting, joint)
        elif name == "axis":
            self._axis(entry, joint)
        elif name in PRESERVING:
            context.ledger.take(entry, TEXT, "value")
        elif entry.is_custom or (name != "pose" and context.allows(f"joint/{name}")):
            made = copied_entry(context, entry, joint)
            if (there := joint.find(name)) is not None and name == "physics":
                merge(made, there)
            else:
                joint.append(made)
        else:
            context.keep(entry, joint, of_block=True)

    def _axis(self, entry: Element, joint: Xml) -> None:
        """Limits and dynamics for Gazebo go before those of the joint; where it turns is for the joint to say."""
        context, axis = self.context, joint.find("axis")
        if axis is None:
            text = "<axis> means nothing on a fixed joint and is left out"
            context.lose(entry, LossKind.EXTENSION_NOT_CARRIED, text)
            return
        context.carry(entry, axis)
        for part in entry.children():
            if part.name not in {"limit", "dynamics"}:
                text = f"<{part.name}> is left out: the joint's own counts"
                context.lose(part, LossKind.EXTENSION_NOT_CARRIED, text)
                continue
            context.ledger.copy(part)
            merge(copied(part), axis.reach(part.name))
            for setting in part.children():
                if setting.name in _BOUNDS and (value := number(setting.content)) is not None:
                    context.overruled.setdefault(joint.attributes["name"], {})[setting.name] = value

    def _joint_setting(self, entry: Element, setting: Setting, joint: Xml) -> None:
        context, path = self.context, setting.counterparts[0]
        if path[-1] == "implicit_spring_damper" and not context.allows("joint/" + "/".join(path)):
            path = (*path[:-1], "cfm_damping")
        if path[0] == "axis" and joint.find("axis") is None:
            message = f"<{entry.name}> means nothing on a fixed joint and is left out"
            context.lose(entry, LossKind.EXTENSION_NOT_CARRIED, message)
            return
        context.ledger.take(entry, TEXT, "value")
        if (text := context.translated(entry, setting)) is not None:
            joint.reach(*path).write(text)


_ONCE = frozenset({"gravity", "self_collide", "enable_wind", "kinematic", "velocity_decay"})
"""Elements of which a link has one."""


class _LinkPart:
    """Puts what a block says of one link into the link that survives, in which it has a 4×4 pose."""

    def __init__(self, context: Context, reference: str, offset: Array) -> None:
        self.context = context
        self.reference = reference
        self.offset = offset

    def put(self, entry: Element, link: Xml) -> None:
        context, name = self.context, entry.name
        if (setting := settings("link").get(name)) is not None:
            self._setting(entry, setting, link)
        elif name in {"visual", "collision"}:
            self._of_shapes(entry)
        elif name == "material":
            self._script(entry)
        elif entry.is_custom or context.allows(f"link/{name}"):
            self._native(entry, link)
        else:
            context.keep(entry, link, of_block=True)

    def _setting(self, entry: Element, setting: Setting, link: Xml) -> None:
        self.context.ledger.take(entry, TEXT, "value")
        if (text := self.context.translated(entry, setting)) is None:
            return
        for path in setting.counterparts:
            if path[0] == "collision":
                for collision in self._some_parts(entry, "collision"):
                    collision.reach(*path[1:]).write(text)
            else:
                self._take_over(entry, link, path, text).write(text)

    def _take_over(self, entry: Element, link: Xml, path: tuple[str, ...], text: str) -> Xml:
        """The element of a setting; what another part of the same link has given otherwise before is reported."""
        first = self.context.given.get((id(link), path))
        node = link.reach(*path) if first is None else first.node
        if first is not None and first.link != self.reference and first.text != text:
            what, other = f"<{first.entry.name}> of link `{first.link}`", f"that of `{self.reference}`"
            message = f"{what} gives way to {other}: they are one link"
            self.context.note(first.entry, LossKind.MERGED_LINK, message)
        self.context.given[id(link), path] = Given(entry, self.reference, text, node)
        return node

    def _of_shapes(self, entry: Element) -> None:
        """The settings of a block for all visuals or collisions."""
        for part in self._some_parts(entry, entry.name):
            self.context.ledger.copy(entry)
            merge(copied(entry), part)

    def _some_parts(self, entry: Element, role: str) -> list[Xml]:
        """The shapes from the link that the block names, which a setting is about; reported if it reaches some not."""
        parts = self.context.shapes_of.get((self.reference, role), [])
        built = self.context.plan.shapes
        reached = parts if built is None else [part for part in parts if entry in built[part].settings]
        if reached and len(reached) < len(parts):
            text = f"Gazebo gives <{entry.name}> of link `{self.reference}` to some of its {role}s only"
            self.context.note(entry, LossKind.EXTENSION_NOT_CARRIED, text, Severity.INFO)
        if not reached:
            reason = f"Gazebo gives it to no {role} of" if parts else f"there is no {role} in"
            text = f"<{entry.name}> is left out: {reason} link `{self.reference}`"
            self.context.lose(entry, LossKind.EXTENSION_NOT_CARRIED, text, Severity.INFO)
        return [self.context.shapes[part][1] for part in reached]

    def _script(self, entry: Element) -> None:
        if not text_of_setting(entry):
            text = "<material> of a block is the name of a script, and this one has none; it is left out"
            self.context.lose(entry, LossKind.CHANGED_MATERIAL, text)
            return
        self.context.ledger.take(entry, TEXT, "value")
        visuals = self._some_parts(entry, "visual")
        for visual in visuals:
            material = visual.reach("material")
            if (script := material.find("script")) is not None:
                material.remove(script)
            made = Xml("script")
            made.add("name", text_of_setting(entry))
            made.add("uri", SCRIPTS)
            material.insert(0, made)
        if visuals and self.context.once("script"):
            name = text_of_setting(entry)
            text = f"material script `{name}` is for classic Gazebo; its successor shows the URDF's color"
            self.context.note(entry, LossKind.CHANGED_MATERIAL, text, Severity.INFO)

    def _native(self, entry: Element, link: Xml) -> None:
        made = copied_entry(self.context, entry, link)
        if entry.name in _ONCE:
            merge(made, self._take_over(entry, link, (entry.name,), made.content))
            return
        if entry.name in _PLACED and not np.array_equal(self.offset, np.eye(4)):
            self._move(entry, made)
        if entry.name in _PLACED:
            self.context.mark(made, self.reference)
        link.append(made)

    def _move(self, entry: Element, made: Xml) -> None:
        """Place something in the link that its own link was merged into."""
        written = entry.find("pose")
        if written is not None and written.attributes.get("relative_to"):
            return
        here = np.eye(4)
        text = self.context.numbers(written, 6) if written is not None and written.content else None
        if written is not None and text is not None:
            values = [float(part) for part in text.split()]
            if written.attributes.get("degrees", "").lower() in TRUE:
                values[3:] = [float(np.deg2rad(value)) for value in values[3:]]
            here = transform(from_rpy(*values[3:]), values[:3])
        pose = made.find("pose")
        if pose is None:
            pose = Xml("pose")
            made.insert(0, pose)
        pose.say(pose_of(self.offset @ here) or "0 0 0 0 0 0")


def merge(extra: Xml, into: Xml) -> None:
    """Write what is in one element into another: values replace, structures are joined."""
    into.attributes.update({k: v for k, v in extra.attributes.items() if k != "name"})
    if extra.content:
        into.write(extra.content)
    for node in extra.nodes:
        there = into.find(node.name) if isinstance(node, Xml) else None
        if isinstance(node, Xml) and there is not None and node.name not in {"plugin", "sensor"}:
            merge(node, there)
        else:
            into.extend(node)
