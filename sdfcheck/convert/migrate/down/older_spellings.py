"""Elements with another name in older versions, and the values that they write otherwise."""

from __future__ import annotations

import math
from pathlib import PurePosixPath

from sdfcheck.convert.loss import LossKind
from sdfcheck.convert.migrate.migration import Migration, title
from sdfcheck.convert.migrate.node import Node
from sdfcheck.convert.migrate.up.upward import STATES
from sdfcheck.convert.writer import number
from sdfcheck.formats.sdf.version import Version

_ENDLESS = {"inf", "+inf", "infinity"}


def rename_states(migration: Migration) -> None:
    """Below 1.12."""
    older = {new: old for old, new in STATES.items()}
    for state in migration.root.of("state"):
        for node in [*state.standard()]:
            if node.name in older:
                node.rename(older[node.name])


def write_limits(migration: Migration) -> None:
    """Below 1.10: no limit is ±1e16 for positions and -1 for effort and velocity."""
    for limit in migration.root.of("limit"):
        for child in limit.children():
            text = child.content.lower()
            endless, below = text in _ENDLESS, text.removeprefix("-") in _ENDLESS and text[:1] == "-"
            if child.name in {"effort", "velocity"} and (endless or below):
                child.write("-1")
            elif child.name in {"lower", "upper"} and (endless or below):
                child.write("-1e16" if below else "1e16")


def write_thread_pitch(migration: Migration) -> None:
    """Below 1.10: radians per meter, left-handed."""
    for joint in migration.root.of("joint"):
        pitch, old = joint.find("screw_thread_pitch"), joint.find("thread_pitch")
        if pitch is None:
            continue
        try:
            turned = number(-2 * math.pi / float(pitch.content))
        except (ValueError, ZeroDivisionError):
            continue
        if old is not None:
            old.write(turned)
            migration.merge(pitch)
        else:
            pitch.rename("thread_pitch")
            pitch.write(turned)


def name_plugins(migration: Migration) -> None:
    """Below 1.10 a plugin has a name."""
    for plugin in migration.root.of("plugin"):
        if not (plugin.get("name") or "").strip():
            name = PurePosixPath(plugin.get("filename") or "plugin").stem.removeprefix("lib")
            plugin.set("name", name)
            migration.note(
                plugin, f"{title(plugin)} was given this name: older consumers want one", LossKind.RENAMED
            )


def rename_sensors(migration: Migration) -> None:
    """navsat was gps before 1.7, lidar ray before 1.6."""
    words = {"navsat": "gps"} if migration.goes_below(7) else {}
    if migration.goes_below(6):
        words |= {"lidar": "ray", "gpu_lidar": "gpu_ray"}
    for sensor in migration.root.of("sensor"):
        kind = (sensor.get("type") or "").strip()
        if kind in words:
            sensor.set("type", words[kind])
        for child in sensor.children():
            if child.name in words and sensor.find(words[child.name]) is None:
                child.rename(words[child.name])


def rename_frame_ids(migration: Migration) -> None:
    """Below 1.12 only cameras say in which frame they see."""
    for sensor in migration.root.of("sensor"):
        frame_id, camera = sensor.find("frame_id"), sensor.find("camera")
        if frame_id is not None and camera is not None and camera.find("optical_frame_id") is None:
            frame_id.remove()
            frame_id.rename("optical_frame_id")
            camera.append(frame_id)


def put_gravity_into_physics(migration: Migration) -> None:
    """Below 1.6 gravity and the magnetic field are physics, and there is one physics."""
    for world in migration.root.children("world"):
        physics = world.children("physics")
        kept = next((p for p in physics if (p.get("default") or "").lower() in {"true", "1"}), None)
        kept = kept or (physics[0] if physics else None)
        for other in physics:
            if other is not kept:
                migration.drop(other, f"{title(other)} is left out: {migration.target} has one physics")
        fields = [node for name in ("gravity", "magnetic_field") if (node := world.find(name)) is not None]
        if fields and kept is None:
            kept = Node("physics", '<physics type="ode">')
            world.append(kept, before=fields[0])
        for node in fields:
            assert kept is not None
            if kept.find(node.name) is None:
                node.remove()
                kept.append(node)
            else:
                migration.drop(node, f"{title(node)} is left out: the physics has its own")


def drop_frames(migration: Migration) -> None:
    """Below 1.7 nothing can depend on a frame any more; those of older sources are another thing."""
    if migration.source < Version(1, 7):
        return
    for holder in [migration.root, *migration.root.of("model", "world")]:
        for frame in holder.children("frame"):
            if frame.origin is not None and frame.origin.name != "frame":
                migration.merge(frame)  # it stood for a merged model, as an include that is written out says
                continue
            text = f"{title(frame)} is left out: before 1.7 nothing can be relative to it"
            migration.drop(frame, text, LossKind.DROPPED_FRAME)


def put_canonical_links_first(migration: Migration) -> None:
    """Below 1.7 a model moves with its first link."""
    for model in migration.root.of("model"):
        name, links = (model.get("canonical_link") or "").strip(), model.children("link")
        if not name:
            continue
        named = next((link for link in links if link.get("name") == name), None)
        if named is None:
            migration.lose(model, f"canonical link `{name}` cannot be kept", LossKind.REORDERED)
        elif named is not links[0]:
            named.remove()
            model.append(named, before=links[0])
            migration.note(named, f"link `{name}` comes first: the model moves with it", LossKind.REORDERED)
        model.unset("canonical_link")
