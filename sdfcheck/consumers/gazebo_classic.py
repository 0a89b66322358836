"""Elements and plugins that only Gazebo Classic reads."""

from __future__ import annotations

import re
from collections.abc import Iterator

from sdfcheck.consumers.gazebo_names import elements
from sdfcheck.consumers.gazebo_problems import ClassicOnlyElement
from sdfcheck.source.document import Document
from sdfcheck.source.element import Element, Value
from sdfcheck.source.sniff import Kind

_ELEMENTS = {
    "audio": ("world",),
    "audio_sink": ("link",),
    "audio_source": ("link",),
    "camera": ("gui",),
    "gripper": ("model",),
    "population": ("world",),
    "road": ("world",),
    "state": ("world",),
}
"""Element → the parents in which it is meant."""

_SENSORS = frozenset(("multicamera", "rfid", "rfidtag", "sonar", "wireless_receiver", "wireless_transmitter"))
_PLUGIN = re.compile(r"libgazebo_\w+\.so|lib\w+Plugin\.so")
"""The bridges to ROS, and the plugins that came with it, such as ``libDiffDrivePlugin.so``."""


def classic_only(document: Document) -> Iterator[ClassicOnlyElement]:
    """Each kind once, at its first use."""
    found: dict[str, list[Element | Value]] = {}
    for target, what in _uses(document):
        found.setdefault(what, []).append(target)
    for what, targets in found.items():
        yield ClassicOnlyElement(targets[0], what, len(targets))


def _uses(document: Document) -> Iterator[tuple[Element | Value, str]]:
    if document.kind is Kind.SDF:
        yield from _standard(document)
    for element in elements(document):
        if element.name == "plugin":
            file = element.attribute("filename")
            if file is not None and _PLUGIN.fullmatch(file.text.strip()):
                yield file, f"plugin `{file.text.strip()}`"


def _standard(document: Document) -> Iterator[tuple[Element | Value, str]]:
    from sdfcheck.formats.sdf.survey import survey

    index = survey(document).index
    for name, parents in sorted(_ELEMENTS.items()):
        for element in index.get(name, ()):
            if element.parent is not None and element.parent.name in parents:
                yield element, f"`{name}` in `{element.parent.name}`"
    for sensor in index.get("sensor", ()):
        kind = sensor.attribute("type")
        if kind is not None and kind.text.strip() in _SENSORS:
            yield kind, f"sensor type `{kind.text.strip()}`"
