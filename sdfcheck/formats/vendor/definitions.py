"""Tables of vendors' own elements and attributes: what a prefix brings, and how tags carry their values.

The layout of such a table is described in docs/vendor-tables.md. One for Drake is built in
(``data/drake.txt``); packs of rules bring others. A table is read when a document uses
its prefix, which is the beginning of the file's name.
"""

from __future__ import annotations

from enum import Enum

from sdfcheck.formats.table import Range
from sdfcheck.source.document import Element, Value
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.sniff import Kind

# How tags carry their values: as text, in an attribute, in a plain child.


_USUAL = ("value", "name", "link", "xyz", "axis")


def value_at(element: Element, carrier: str) -> Value | None:
    """The value in the shape ``text``, ``@attribute`` or ``/child``; None if it is not there."""
    if carrier == "text":
        return element.own_value
    if carrier[0] == "@":
        return element.attribute(carrier[1:])
    child = element.find(carrier[1:])
    return None if child is None else child.own_value


def value_elsewhere(element: Element, wanted: str) -> tuple[str, Value] | None:
    """A value that is in another shape than the one that is read."""
    if wanted != "text" and element.content:
        return "text", element.own_value
    for name in _USUAL:
        if wanted != f"@{name}" and (value := element.attribute(name)) is not None:
            return f"@{name}", value
    return None


DIALECTS = {"sdf": Kind.SDF, "urdf": Kind.URDF}


class Outcome(Enum):
    """The reaction of a consumer to a defect; any other word is the value that it takes instead."""

    ERROR = "error"
    ABORT = "abort"
    CRASH = "crash"
    IGNORED = "ignored"
    ACCEPTED = "accepted"
    READ = "read"


class Effect(NamedTuple):
    outcome: Outcome
    value: str = ""
    """The value that is read instead."""

    @classmethod
    def of(cls, word: str) -> Effect:
        known = {outcome.value: outcome for outcome in Outcome}
        return cls(known[word]) if word in known else cls(Outcome.READ, word)

    @property
    def refused(self) -> bool:
        """The consumer does not get to the end of the file."""
        return self.outcome in {Outcome.ERROR, Outcome.ABORT, Outcome.CRASH}


REFUSED = Effect(Outcome.ERROR)
IGNORED = Effect(Outcome.IGNORED)


class BadTable(ValueError):
    """A table that cannot be read; the text is fit for the user."""


class Keys:
    """The ``key=value`` fields of a line, of one dialect."""

    __slots__ = ("_fields", "dialect")

    def __init__(self, fields: list[tuple[str, str]], dialect: str) -> None:
        self._fields = fields
        self.dialect = dialect

    def all(self, key: str) -> list[str]:
        return [value for name, value in self._fields if name == key]

    def text(self, key: str) -> str:
        return next(iter(self.all(key)), "")

    def words(self, key: str) -> tuple[str, ...]:
        return tuple(filter(None, self.text(key).split(",")))

    def effect(self, key: str) -> Effect | None:
        """One word for both dialects, or ``sdf:word,urdf:word``."""
        text = self.text(key)
        if text.startswith(tuple(f"{dialect}:" for dialect in DIALECTS)):
            text = dict(part.split(":", 1) for part in text.split(",")).get(self.dialect, "")
        return Effect.of(text) if text else None


class Step(NamedTuple):
    """One element of a path, from the inside out.

    ``attribute`` must be one of ``values``; without values it is a child that must be there.
    """

    name: str
    attribute: str = ""
    values: tuple[str, ...] = ()

    def holds(self, element: Element) -> bool:
        if not self.attribute:
            return True
        if self.values:
            return element.attributes.get(self.attribute, "").strip() in self.values
        return element.has(self.attribute)


class Slot:
    """Something that holds one value: an attribute, the text of an element, a plain child."""

    __slots__ = (
        "bad",
        "choices",
        "default",
        "lacking",
        "name",
        "nonzero",
        "plain",
        "range",
        "references",
        "required",
        "scoped",
        "type",
        "unique",
        "unit",
        "wrong",
    )

    def __init__(self, name: str, fields: tuple[str, str, str], keys: Keys) -> None:
        self.name = name
        """``@attribute``, ``/child``, or empty for the element's own text."""
        self.type, required, self.default = fields
        self.type = keys.text("type") or self.type
        self.required = required in {"1", "+"}
        self.unit = keys.text("unit")
        interval = keys.text("range")
        self.nonzero = interval == "nonzero"
        self.range = Range.within(interval) if interval and not self.nonzero else None
        self.choices = keys.words("choices")
        self.wrong = keys.effect("wrong") or REFUSED
        """The reaction to a value out of range."""
        self.bad = keys.effect("bad") or REFUSED
        """The reaction to a word that is not one of the choices."""
        self.lacking = keys.effect("lacking")
        """The reaction to a missing value, if that is not a mistake to the consumer."""
        self.references = keys.words("ref")
        """The kinds of thing that the value may name."""
        self.scoped = keys.dialect in keys.words("scoped")
        """Names of parts of nested models are understood."""
        self.plain = keys.effect("plain")
        self.unique = keys.effect("unique")

    def __repr__(self) -> str:
        return f"Slot({self.name or 'text'}: {self.type})"


class Place:
    """One place of a tag in one dialect: its parent, and how the value is carried there."""

    __slots__ = ("carrier", "needed", "otherwise", "path", "since", "single", "slot", "text")

    def __init__(self, text: str, carrier: str, multiplicity: str, keys: Keys, slot: Slot | None) -> None:
        self.text = text
        self.path = _steps(text)
        self.carrier = carrier
        """``text``, ``@name``, ``/child``, ``attribute`` for a tag that is one; empty without value."""
        self.needed = multiplicity in {"1", "+"}
        self.single = multiplicity in {"0", "1"}
        self.otherwise = keys.effect("else")
        """The reaction where the parents are right and the conditions on them do not hold."""
        self.since = keys.text("since")
        self.slot = slot

    def __repr__(self) -> str:
        return f"Place({self.text})"

    def encloses(self, parent: Element) -> bool:
        """Do the names of the parents fit?"""
        at: Element | None = parent
        for step in self.path:
            if at is None or at.name != step.name:
                return False
            at = at.parent
        return True

    def holds(self, parent: Element) -> bool:
        """Given that they fit: are the conditions on them met?"""
        at: Element | None = parent
        for step in self.path:
            if at is None or not step.holds(at):
                return False
            at = at.parent
        return True


class Elsewhere(NamedTuple):
    """A note for users of the other dialect: this one has no such tag."""

    effect: Effect
    use: str
    within: tuple[str, ...]
    """The parents in which the effect holds; empty: everywhere."""


class Tag:
    """The meaning of a prefixed name in one dialect."""

    __slots__ = ("absent", "attributes", "keys", "name", "parts", "places", "since")

    def __init__(self, name: str, keys: Keys) -> None:
        self.name = name
        self.keys = keys
        self.since = keys.text("since")
        self.places: list[Place] = []
        self.absent: Elsewhere | None = None
        self.attributes: dict[str, Slot] = {}
        self.parts: dict[str, Slot] = {}
        """Plain children that hold a value."""

    def __repr__(self) -> str:
        return f"Tag({self.name})"


class Vendor:
    """The table of one prefix, as one dialect has it."""

    __slots__ = (
        "has_own_rules",
        "ignored_in",
        "is_lenient",
        "name",
        "namespace",
        "prefix",
        "release",
        "tags",
        "unknown",
        "version",
    )

    def __init__(self, prefix: str, name: str, namespace: str, keys: Keys) -> None:
        self.prefix = prefix
        self.name = name
        self.namespace = namespace
        self.release = keys.text("release")
        """The newest release of the consumer that the table knows."""
        self.version = keys.text("version")
        """The attribute of the root that says what release a document is written for."""
        self.has_own_rules = keys.text("rules") == "own"
        """A pack has rules of its own about these tags."""
        self.is_lenient = True
        """Numbers are taken from the front of a text, and 0 where there is none."""
        self.unknown = IGNORED
        self.ignored_in: tuple[str, ...] = ()
        self.tags: dict[str, Tag] = {}

    def __repr__(self) -> str:
        return f"Vendor({self.prefix})"

    def effect_in(self, parent: Element | None) -> Effect:
        """The reaction of the consumer to a tag unknown in ``parent`` (None: an attribute)."""
        if self.unknown == IGNORED or (parent is None and "@" in self.ignored_in):
            return IGNORED
        names = [] if parent is None else [each.name for each in (parent, *parent.around)]
        chain = "/".join(reversed(names))
        for path in self.ignored_in:
            inside = path.removesuffix("/*")
            if f"/{chain}".endswith(f"/{path}") or (inside != path and f"/{inside}/" in f"/{chain}/"):
                return IGNORED
        return self.unknown


def _steps(text: str) -> tuple[Step, ...]:
    """``model/joint[type=screw]/axis`` from the inside out."""
    found = []
    depth, start = 0, 0
    for index, letter in enumerate(f"{text}/"):
        depth += {"[": 1, "]": -1}.get(letter, 0)
        if letter == "/" and depth == 0:
            found.append(_step(text[start:index]))
            start = index + 1
    return tuple(reversed(found))


def _step(text: str) -> Step:
    name, _, condition = text.removesuffix("]").partition("[")
    attribute, _, values = condition.partition("=")
    return Step(name, attribute, tuple(filter(None, values.split(","))))
