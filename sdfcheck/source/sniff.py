"""The kind of a file, recognized by its first bytes.

``.sdf`` is shared with molecules, delay annotations and databases, and ``model.config``
with anything, so a suffix alone decides nothing.
"""

from __future__ import annotations

import codecs
import re
from collections.abc import Mapping, Sequence
from enum import Enum
from pathlib import Path

from sdfcheck.source.text import pattern

HEAD = 65536
"""How many bytes of a file are worth looking at."""


class Kind(Enum):
    """The kinds of content of a file."""

    SDF = "sdf"
    URDF = "urdf"
    XACRO = "xacro"
    MODEL_CONFIG = "model-config"
    SDF_SPECIFICATION = "sdf-specification"
    SRDF = "srdf"
    MJCF = "mjcf"
    WEBOTS = "webots"
    MISSPELT_ROOT = "misspelled-root"
    OTHER_XML = "other-xml"
    BROKEN_XML = "broken-xml"
    CHEMISTRY = "chemistry"
    TEMPLATE = "template"
    LFS_POINTER = "lfs-pointer"
    BINARY = "binary"
    EMPTY = "empty"
    NOT_XML = "not-xml"

    @property
    def description(self) -> str:
        """The end of the sentence "this looks like …"."""
        return _DESCRIPTIONS[self]


_DESCRIPTIONS: Mapping[Kind, str] = {
    Kind.SDF: "SDFormat",
    Kind.URDF: "URDF",
    Kind.XACRO: "xacro",
    Kind.MODEL_CONFIG: "a model.config",
    Kind.SDF_SPECIFICATION: "a part of the SDFormat specification itself",
    Kind.SRDF: "SRDF (MoveIt semantics)",
    Kind.MJCF: "MJCF (MuJoCo)",
    Kind.WEBOTS: "a configuration of devices for Webots",
    Kind.MISSPELT_ROOT: "a robot description with a misspelled root element",
    Kind.OTHER_XML: "XML of another kind",
    Kind.BROKEN_XML: "broken XML",
    Kind.CHEMISTRY: "a chemical structure-data file",
    Kind.TEMPLATE: "a template that is not rendered yet",
    Kind.LFS_POINTER: "a Git LFS pointer",
    Kind.BINARY: "binary content",
    Kind.EMPTY: "an empty file",
    Kind.NOT_XML: "no XML",
}


class Treatment(Enum):
    """The treatments of a file.

    LINT: lint it; a file that is not a robot description at all gets a diagnostic. SKIP: say
    nothing. NOTICE: say that it was not linted, and go on. WARN: the same, and that
    something should be done about it. REFUSE: report a failure of the run.
    """

    LINT = "lint"
    SKIP = "skip"
    NOTICE = "notice"
    WARN = "warn"
    REFUSE = "refuse"


_TREATMENTS: Mapping[Kind, tuple[Treatment, Treatment]] = {
    Kind.SDF: (Treatment.LINT, Treatment.LINT),
    Kind.URDF: (Treatment.LINT, Treatment.LINT),
    Kind.XACRO: (Treatment.LINT, Treatment.LINT),
    Kind.MODEL_CONFIG: (Treatment.LINT, Treatment.LINT),
    Kind.SDF_SPECIFICATION: (Treatment.SKIP, Treatment.NOTICE),
    Kind.SRDF: (Treatment.LINT, Treatment.LINT),
    Kind.MJCF: (Treatment.SKIP, Treatment.NOTICE),
    Kind.WEBOTS: (Treatment.SKIP, Treatment.NOTICE),
    Kind.MISSPELT_ROOT: (Treatment.LINT, Treatment.LINT),
    Kind.OTHER_XML: (Treatment.SKIP, Treatment.NOTICE),
    Kind.BROKEN_XML: (Treatment.LINT, Treatment.LINT),
    Kind.CHEMISTRY: (Treatment.SKIP, Treatment.NOTICE),
    Kind.TEMPLATE: (Treatment.SKIP, Treatment.NOTICE),
    Kind.LFS_POINTER: (Treatment.WARN, Treatment.WARN),
    Kind.BINARY: (Treatment.SKIP, Treatment.REFUSE),
    Kind.EMPTY: (Treatment.LINT, Treatment.LINT),
    Kind.NOT_XML: (Treatment.SKIP, Treatment.LINT),
}
"""Kind → treatment in a walk, and treatment of a file that was named."""

ROOTS = ("sdf", "robot", "model")
# Only robot descriptions have these suffixes, so other content is a mistake.
_UNSHARED_SUFFIXES = frozenset({".urdf", ".world", ".xacro"})
_OF_STAGE = ".world"
"""The suffix of what Stage reads, too, in a language of its own."""
_SUFFIXES = _UNSHARED_SUFFIXES | {".sdf"}
TEMPLATE_SUFFIXES = frozenset({".em", ".erb", ".in", ".j2", ".jinja", ".jinja2", ".rsdf"})

_WIDE_MARKS = (
    (codecs.BOM_UTF8, "utf-8"),
    (codecs.BOM_UTF32_LE, "utf-32"),
    (codecs.BOM_UTF32_BE, "utf-32"),
    (codecs.BOM_UTF16_LE, "utf-16"),
    (codecs.BOM_UTF16_BE, "utf-16"),
    (b"<\0", "utf-16-le"),
    (b"\0<", "utf-16-be"),
)
_LFS = "version https://git-lfs.github.com/spec/"
_NAME_END = frozenset(" \t\r\n/>")
_ROOTS = {
    "sdf": Kind.SDF,
    "robot": Kind.URDF,
    "element": Kind.SDF_SPECIFICATION,
    "mujoco": Kind.MJCF,
    "mujocoinclude": Kind.MJCF,
}
_ROBOT_TAGS = ("<sdf", "<robot", "<world", "<model")
_SRDF_TAGS = frozenset({"disable_collisions", "group_state", "virtual_joint", "disable_default_collisions"})
_BODY = frozenset({"link", "joint"})
_TAG = pattern(r"<(/?)([A-Za-z_][\w:.-]*)[^<>]*?(/?)>")
_TEMPLATE_TAGS = ("<%", "{% ", "{%-")
_BARE = pattern(r"\s\$[A-Za-z_]\w*\s*/?>")
"""Attributes that a program fills in: ``<origin $POSE/>``, as in ``string.Template`` of Python."""
_TEMPLATE_MARKS = (*_TEMPLATE_TAGS, "{{", "@")
_CONFIGURED = pattern(r"[\s\">]@[A-Z][A-Z0-9_]*@[\s\"<]")
"""A value that CMake or a script writes."""


def treatment(kind: Kind, path: Path, *, named: bool) -> Treatment:
    """The treatment of a file of this kind that was found in a walk, or named on the command line."""
    unshared = _UNSHARED_SUFFIXES if kind is Kind.OTHER_XML else _UNSHARED_SUFFIXES - {_OF_STAGE}
    if kind in {Kind.NOT_XML, Kind.OTHER_XML} and path.suffix.lower() in unshared:
        return Treatment.LINT
    return _TREATMENTS[kind][named]


def sniff(head: bytes, path: Path) -> Kind:
    """The kind of the file at ``path``, judged by its first bytes (at most :data:`HEAD` are looked at)."""
    text = _text(head[:HEAD])
    start = _content_start(text)
    if text.startswith("<", start):
        return _sniff_xml(text, start, path)
    content = text.strip("\0 \t\r\n\ufeff")
    if not content:
        return Kind.EMPTY
    if content.startswith(_LFS):
        return Kind.LFS_POINTER
    if "\0" in text or _is_garbled(text[:4096]):
        return Kind.BINARY
    if _is_chemistry(text):
        return Kind.CHEMISTRY
    if _is_template(text, path):
        return Kind.TEMPLATE
    if content.startswith("<") or any(tag in text for tag in _ROBOT_TAGS):
        return Kind.BROKEN_XML
    return Kind.NOT_XML


def _text(head: bytes) -> str:
    """The head as text; Latin-1 keeps every ASCII character, and names here are ASCII."""
    for mark, encoding in _WIDE_MARKS:
        if head.startswith(mark):
            return head.decode(encoding, "replace").lstrip("\ufeff")
    return head.decode("latin-1")


def _content_start(text: str) -> int:
    """Where the root element should start: after spaces, declarations and comments."""
    place = 0
    while True:
        while place < len(text) and text[place] in " \t\r\n":
            place += 1
        if text.startswith("<!--", place):
            end = text.find("-->", place + 4) + 3
        elif text.startswith("<?", place):
            end = text.find("?>", place + 2) + 2
        elif text.startswith("<!DOCTYPE", place):
            end = _doctype_end(text, place)
        else:
            return place
        if end <= place:
            return len(text)
        place = end


def _doctype_end(text: str, place: int) -> int:
    """Just after a document type, whose internal subset may hold angle brackets; 0 if it never ends."""
    close = text.find(">", place) + 1
    subset = text.find("[", place, close) if close else -1
    if subset < 0:
        return close
    end = text.find("]", subset) + 1
    return text.find(">", end) + 1 if end else 0


MADE_BY_XACRO = "autogenerated by xacro from "
"""In the remark that xacro writes before the root: calls that are left in such a file mean nothing to who reads it."""


def _sniff_xml(text: str, start: int, path: Path) -> Kind:
    if _is_template(text, path):
        return Kind.TEMPLATE
    name = _tag_name(text, start)
    if not name:
        broken = any(tag in text for tag in _ROBOT_TAGS)
        return Kind.BROKEN_XML if broken else Kind.NOT_XML
    suffixes = [suffix.lower() for suffix in path.suffixes[-2:]]
    suffix = suffixes[-1] if suffixes else ""
    if name == "robot" and (beside := _beside_a_robot(text, suffixes)) is not None:
        return beside
    if name not in _ROOTS and suffix in _SUFFIXES and _is_misspelt(name, suffix, text, start):
        return Kind.MISSPELT_ROOT
    is_result = suffix == ".urdf" and MADE_BY_XACRO in text[:start]
    if (
        ".xacro" in suffixes
        or (_uses_xacro(text) and not is_result)
        or (name == "robot" and _is_xacro_part(text))
    ):
        return Kind.XACRO
    if name in _ROOTS:
        # Settings for MuJoCo that are before the robot, not in it.
        is_before = name == "mujoco" and suffix == ".urdf" and "<robot" in text
        return Kind.OTHER_XML if is_before else _ROOTS[name]
    # Two of its three signs are enough.
    if sum((name == "model", "<sdf" in text, path.name.lower() == "model.config")) > 1:
        return Kind.MODEL_CONFIG
    forgotten_root = name in {"model", "world"} and suffix in {".sdf", ".world"}
    # The root of SDFormat 1.0 to 1.2.
    old_root = name == "gazebo" and "version" in text[start : text.find(">", start)]
    return Kind.SDF if forgotten_root or old_root else Kind.OTHER_XML


def _beside_a_robot(text: str, suffixes: Sequence[str]) -> Kind | None:
    """The kind of a file whose root is a robot too, and which says something about the robot of another file."""
    if ".srdf" in suffixes:
        return Kind.SRDF
    if not _holds(text, ("<webots", *(f"<{name}" for name in _SRDF_TAGS))):
        return None
    parts = _parts(text)
    if not _BODY.isdisjoint(parts):
        return None
    if not _SRDF_TAGS.isdisjoint(parts):
        return Kind.SRDF
    return Kind.WEBOTS if "webots" in parts and "gazebo" not in parts else None


def _parts(text: str) -> set[str]:
    """The names of the root's children; what xacro generates counts as its own."""
    names = set()
    depth = 0
    for end, name, is_empty in _TAG.findall(_without_comments(text)):
        if name.startswith("xacro:"):
            continue
        if depth == 1 and not end:
            names.add(name)
        depth += -1 if end else not is_empty
    return names


def _tag_name(text: str, start: int) -> str:
    """The name of the tag that starts there; empty if there is not one."""
    end = start + 1
    while end < len(text) and text[end] not in _NAME_END:
        end += 1
    name = text[start + 1 : end]
    return name if name.replace(":", "_").replace("-", "_").replace(".", "_").isidentifier() else ""


def _is_misspelt(name: str, suffix: str, text: str, start: int) -> bool:
    """Whether the root was meant to be the root of a robot description."""
    if suffix == ".xacro" and (name == "root" or " name=" not in text[start : text.find(">", start)]):
        return False  # what other files include may have any root
    return name not in ROOTS and suggested_root(name) is not None


def suggested_root(name: str) -> str | None:
    """The root element whose name is a misspelling away from this one."""
    from sdfcheck.source.scanner.pairing import alike

    local = name.rpartition(":")[2]
    return next((root for root in ROOTS if local == root or alike(name, root)), None)


def _holds(text: str, words: tuple[str, ...]) -> bool:
    """Whether one of the words is in the text outside of comments."""
    found = [word for word in words if word in text]
    if not found:
        return False
    bare = _without_comments(text)
    return any(word in bare for word in found)


def _is_xacro_part(text: str) -> bool:
    """Whether a robot without a body has values for xacro: only another file can include that."""
    return "xmlns:xacro" in text and "${" in text and _BODY.isdisjoint(_parts(text))


def _uses_xacro(text: str) -> bool:
    """Whether a tag of xacro is outside of comments, and of values that lack their `&lt;`."""
    return "<xacro:" in text and re.search(r">[^<>]*<xacro:", _without_comments(text)) is not None


def _without_comments(text: str) -> str:
    pieces = []
    place = 0
    while (start := text.find("<!--", place)) >= 0:
        pieces.append(text[place:start])
        place = text.find("-->", start + 4) + 3
        if place < 3:
            return "".join(pieces)
    pieces.append(text[place:])
    return "".join(pieces)


def _is_template(text: str, path: Path) -> bool:
    """Whether template code is left; most of its marks count only if the file's name says template."""
    if "@" in text and _CONFIGURED.search(_without_comments(text)):
        return True
    if path.suffix.lower() in TEMPLATE_SUFFIXES:
        return _holds(text, _TEMPLATE_MARKS)
    if "$" in text and "xacro" not in text and len(_BARE.findall(text)) > 1:
        return True
    if "%" not in text or not _holds(text, _TEMPLATE_TAGS):
        return False
    is_one_value = "<%=" in text and sum(map(text.count, _TEMPLATE_TAGS)) == 1
    return not (is_one_value and path.suffix.lower() in _SUFFIXES)


def _is_chemistry(text: str) -> bool:
    lines = text.splitlines()
    return (len(lines) > 3 and lines[3].rstrip().endswith(("V2000", "V3000"))) or any(
        line.startswith(("M  END", "$$$$")) for line in lines
    )


def _is_garbled(sample: str) -> bool:
    controls = sum(character < "\t" or "\r" < character < " " for character in sample)
    return controls > len(sample) // 10
