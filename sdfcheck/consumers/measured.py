"""The table of reactions: what each consumer does with the defect of each built-in rule.

A line of ``data/reactions.txt`` has rule, consumer, dialect, manner and words, and says so where
it is not measured. ``make reactions`` gives each rule's examples to the consumers that are
installed: whether they take them is measured, and the words are kept where they agree. Index and
pages of the rules are made from it; only :data:`ON_REQUEST` are looked up while documents are
linted. A consumer that reads URDF through urdfdom does as urdfdom does, where nothing else was measured.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping
from functools import cache
from pathlib import Path

from sdfcheck.consumers.reaction import ON_REQUEST, READS, Consumer, Manner, Reaction
from sdfcheck.source.record import NamedTuple

FILE = Path(__file__).with_name("data") / "reactions.txt"
CONSUMERS = tuple(sorted(map(Consumer, ON_REQUEST), key=lambda consumer: consumer.value))
THROUGH: Mapping[Consumer, Consumer] = {
    Consumer.ROS: Consumer.URDFDOM,
    Consumer.PINOCCHIO: Consumer.URDFDOM,
}
"""Consumer → the one whose parser it uses."""
AS_PARSER = "as urdfdom"
"""Written in the place of a reaction: it is that of the parser, which may depend on the case."""
UNKNOWN = Reaction(Manner.UNMEASURED, "nobody has measured what it does")
TAKEN = Manner.ACCEPT.value
"""Written in the place of a reaction: it takes the examples as they are, and nothing is said of it."""


class Place(NamedTuple):
    """The place of a row in the table."""

    code: str
    consumer: str
    dialect: str


class Table:
    """The table, as it is written."""

    __slots__ = ("rows", "unmeasured", "versions")

    def __init__(self, text: str) -> None:
        self.rows: dict[str, dict[str, dict[str, str]]] = {}
        """Rule → consumer → dialect → reaction."""
        self.unmeasured: set[Place] = set()
        """Where no run of the consumer has shown it."""
        self.versions: dict[str, str] = {}
        """Consumer → what it was measured with."""
        for line in text.splitlines():
            if line.startswith("#"):
                consumer, _, version = line.removeprefix("#").strip().partition(": ")
                self.versions[consumer] = version
            elif line:
                code, consumer, dialect, manner, words, *marks = line.split("\t")
                said = f"{manner}: {words}" if words else manner
                self.rows.setdefault(code, {}).setdefault(consumer, {})[dialect] = said
                if marks:
                    self.unmeasured.add(Place(code, consumer, dialect))

    def __iter__(self) -> Iterator[tuple[Place, str]]:
        for code, own in self.rows.items():
            for consumer, by in own.items():
                for dialect, said in by.items():
                    yield Place(code, consumer, dialect), said

    def render(self) -> str:
        lines = [f"# {name}: {version}" for name, version in sorted(self.versions.items())]
        for place, said in sorted(self):
            mark = (Manner.UNMEASURED.value,) if place in self.unmeasured else ()
            manner, _, words = said.partition(": ")
            lines.append("\t".join((*place, manner, words, *mark)))
        return "\n".join(lines) + "\n"


@cache
def table() -> Table:
    """The table that comes with sdfcheck."""
    return Table(FILE.read_text("utf-8"))


def always_known(code: str) -> dict[str, dict[str, str]]:
    """Consumer → dialect → reaction, of those that are known without being asked for; without :data:`TAKEN`."""
    found: dict[str, dict[str, str]] = {}
    for consumer, by in sorted(table().rows.get(code, {}).items()):
        known = {dialect: said for dialect, said in sorted(by.items()) if said != TAKEN}
        if known and consumer not in ON_REQUEST:
            found[consumer] = known
    return found


def is_measured(consumer: Consumer) -> bool:
    """Whether the table knows anything of a consumer."""
    return consumer.value in table().versions


def concerns(code: str, targets: Collection[str]) -> bool:
    """Whether a measured consumer among ``targets`` minds a rule's defect."""
    rows = table().rows.get(code, {})
    said = (one for name in ON_REQUEST.intersection(targets) for one in rows.get(name, {}).values())
    return any(one != AS_PARSER and not Reaction.of(one).is_harmless for one in said)


def with_measured(
    code: str, affects: Mapping[str, Mapping[str, str]], targets: Collection[str], *, is_error: bool
) -> dict[str, Mapping[str, str]]:
    """The reactions to a rule's defect, with those of the measured consumers among ``targets``.

    A reaction to an error that nobody has measured is :data:`UNKNOWN`, unless the error is about one consumer alone.
    """
    found = dict(affects)
    is_about_one = len(affects) == 1
    rows = table().rows.get(code, {})
    for consumer in CONSUMERS:
        if consumer.value not in targets:
            continue
        own = dict(rows.get(consumer.value, {}))
        for dialect in READS[consumer]:
            parser = THROUGH.get(consumer)
            if parser is not None and dialect not in own:
                own[dialect] = AS_PARSER
            if own.get(dialect) == AS_PARSER and parser is not None:
                own[dialect] = affects.get(parser.value, {}).get(dialect, "accept: takes it as it is")
            elif dialect not in own and is_error and not is_about_one:
                own[dialect] = str(UNKNOWN)
        found[consumer.value] = own  # also a harmless one, for it may be another in some case
    return found


def in_this_case(code: str, own: Mapping[str, Reaction], targets: Collection[str]) -> dict[str, Reaction]:
    """The reactions of measured consumers among ``targets`` to one finding, where it has ``own`` reactions.

    They do as their parser does, unless the finding itself says what they do in this case.
    """
    rows, changed = table().rows.get(code, {}), {}
    for consumer in CONSUMERS:
        name, parser = consumer.value, THROUGH.get(consumer)
        if name not in targets:
            continue
        through = rows.get(name, {}).get("urdf", AS_PARSER if parser else "") == AS_PARSER
        if name in own:
            changed[name] = own[name]
        elif through and parser is not None and parser.value in own:
            changed[name] = own[parser.value]
    return changed
