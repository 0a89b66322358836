"""The words that a shell offers after an option or a word: rules, formats, targets, places of a format."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

_USUAL = ("sdf", "world", "model", "link", "joint")
"""The elements whose children are offered first."""

if TYPE_CHECKING:
    import click
    from click.shell_completion import CompletionItem


def rules(context: click.Context, parameter: click.Parameter, begun: str) -> list[CompletionItem]:
    """Families, codes and names; of a list, its last word is completed."""
    from sdfcheck.lint.rulebook.packs import load_index

    before, comma, word = begun.rpartition(",")
    facts = load_index().facts
    offered = [(family, "a family") for family in sorted({one.family for one in facts})]
    offered += [(one.code, one.name) for one in facts]
    offered += [(one.name, one.summary) for one in facts]
    return _items((f"{before}{comma}{text}", about) for text, about in offered if text.startswith(word))


def targets(context: click.Context, parameter: click.Parameter, begun: str) -> list[CompletionItem]:
    from sdfcheck.consumers.reaction import Consumer

    before, comma, word = begun.rpartition(",")
    names = (consumer.value for consumer in Consumer)
    return _items((f"{before}{comma}{name}", "") for name in names if name.startswith(word))


def formats(context: click.Context, parameter: click.Parameter, begun: str) -> list[CompletionItem]:
    from sdfcheck.report import OutputFormat

    return _items((form.value, "") for form in OutputFormat if form.value.startswith(begun))


def versions(context: click.Context, parameter: click.Parameter, begun: str) -> list[CompletionItem]:
    from sdfcheck.formats.sdf.version import NEWEST, OLDEST

    names = (f"1.{minor}" for minor in range(NEWEST.minor, OLDEST.minor - 1, -1))
    return _items((name, "") for name in names if name.startswith(begun))


def places(context: click.Context, parameter: click.Parameter, begun: str) -> list[CompletionItem]:
    """The continuations in the newest SDFormat, or another format: ``joint/ax`` → ``joint/axis``."""
    from sdfcheck.formats.describe.description import UnknownPlace
    from sdfcheck.formats.describe.place import describe
    from sdfcheck.formats.sdf.version import NEWEST

    above, slash, word = begun.rpartition("/")
    if ":" in word:
        return _items((name, "") for name in _of_vendors() if name.startswith(begun))
    try:
        found = [one for place in ([above] if above else _USUAL) for one in describe(place, NEWEST)]
    except UnknownPlace:
        return []
    names = {entry.name for one in found for entry in (*one.children, *(one.attributes if above else ()))}
    return _items((f"{above}{slash}{name}", "") for name in sorted(names) if name.startswith(word))


def _of_vendors() -> list[str]:
    """The names with the prefix of a vendor."""
    from sdfcheck.formats.vendor import BUILT_IN
    from sdfcheck.formats.vendor.definitions import DIALECTS
    from sdfcheck.formats.vendor.table import vendor

    return sorted({name for path in BUILT_IN for dialect in DIALECTS for name in vendor(path, dialect).tags})


def _items(offered: Iterable[tuple[str, str]]) -> list[CompletionItem]:
    from click.shell_completion import CompletionItem

    return [CompletionItem(text, help=about or None) for text, about in offered]
