"""The content that ``<gazebo>`` blocks of a URDF file may have: SDFormat, and settings of libsdformat.

libsdformat copies what a block holds into the link, joint or model that the block is about, and reads
the result as SDFormat; the settings it translates. Source: libsdformat 17's parser_urdf.cc,
checked against what it does.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache

from sdfcheck.formats.schema import Definition
from sdfcheck.formats.sdf.schema import SDF, schema
from sdfcheck.formats.table import Row
from sdfcheck.formats.urdf.schema import extension
from sdfcheck.formats.urdf.survey import survey
from sdfcheck.formats.version import NEWEST
from sdfcheck.source.document import Document, Element

_SHAPES = ("visual", "collision")
"""The values of these are added to all shapes of the link."""
_CONTROL = "ros2_control\t\t\t*\t\topen=yes\n @name\t\tstring\t0\t\n @type\t\tstring\t0\t"
"""URDF, for which rules of its own say where it belongs."""
_SETTING = "{}\t\t\t*\t\topen=yes\n @value\t\tstring\t0\t"


def extensions(document: Document) -> Iterator[tuple[Element, Definition]]:
    """The blocks that libsdformat reads, each with what it may hold.

    It drops those for a name that is not that of a link or joint.
    """
    surveyed = survey(document)
    blocks = surveyed.top("gazebo")
    if not blocks:
        return
    names = {
        kind: {element.text_of("name", "") for element in surveyed.top(kind)} for kind in ("link", "joint")
    }
    for found in blocks:
        reference = found.text_of("reference", "")
        kinds = (
            tuple(kind for kind, known in names.items() if reference in known) if reference else ("model",)
        )
        if kinds:
            yield found, _content(kinds)


@cache
def _content(kinds: tuple[str, ...]) -> Definition:
    """The content that a block about parts of these kinds may have: none of it is required."""
    newest, block = schema(NEWEST), SDF.table.block
    content = Definition(None, newest, block(kinds[0]), block(kinds[0]))
    for kind in kinds[1:]:
        content.children.update(Definition(None, newest, block(kind), block(kind)).children)
    rows = [Row(_CONTROL), *(Row(_SETTING.format(name)) for name in extension().children)]
    for name, row in ((row.name, row) for row in rows):
        content.children[name] = Definition(content, newest, row, row)
    for name in _SHAPES if "link" in kinds else ():
        shape = Definition(content, newest, block(name), block(name))
        content.children[name] = _nothing_required(shape)
    return _nothing_required(content)


def _nothing_required(definition: Definition) -> Definition:
    _ = definition.children  # builds what is changed here
    definition.required_attributes = definition.needed_children = ()
    return definition
