"""Options that several commands share, and the words that a shell offers after them."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Mapping, Sequence
from functools import wraps
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeVar

import click

from sdfcheck.cli.parts.terminal import pair
from sdfcheck.formats.version import NEWEST, OLDEST, VERSIONS, Version
from sdfcheck.lint.config.settings import GIVEN, UNSET, Field, Settings, Shape
from sdfcheck.source.errors import WrongUsage

if TYPE_CHECKING:
    from click.shell_completion import CompletionItem


# The words that a shell offers after an option or a word: rules, formats, targets, places of a format.


_USUAL = ("sdf", "world", "model", "link", "joint")
"""The elements whose children are offered first."""


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
    names = map(str, reversed(VERSIONS))
    return _items((name, "") for name in names if name.startswith(begun))


def places(context: click.Context, parameter: click.Parameter, begun: str) -> list[CompletionItem]:
    """The continuations in the newest SDFormat, or another format: ``joint/ax`` → ``joint/axis``."""
    from sdfcheck.formats.describe import UnknownPlace, describe

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
    from sdfcheck.formats.vendor.definitions import DIALECTS
    from sdfcheck.formats.vendor.table import vendors

    return sorted({name for dialect in DIALECTS for table in vendors(None, dialect) for name in table.tags})


def _items(offered: Iterable[tuple[str, str]]) -> list[CompletionItem]:
    from click.shell_completion import CompletionItem

    return [CompletionItem(text, help=about or None) for text, about in offered]


# ``--sdf-version``: a version of SDFormat, the same for all commands.


def sdf_version(
    help: str, oldest: Version = OLDEST, *, name: str = "sdf_version", required: bool = False
) -> Callable[[F], F]:
    """The option, passed as a ``Version`` from ``oldest`` on; by default the newest."""

    def parsed(context: click.Context, parameter: click.Parameter, given: str) -> Version:
        known = Version.parse(given)
        if known is None or known < oldest:
            raise WrongUsage(f"unknown version `{given}` of SDFormat (choose from {oldest} to {NEWEST})")
        return known

    default: dict[str, Any] = {"required": True} if required else {"default": str(NEWEST)}
    shown = "" if required else f"  [default: {NEWEST}]"  # click says itself what is required
    return click.option(
        "--sdf-version",
        name,
        cls=Renamed,
        old=["--to"],
        metavar="VERSION",
        callback=parsed,
        shell_complete=versions,
        help=f"{help}: {oldest} to {NEWEST}.{shown}",
        **default,
    )


# Options that several commands share.


PATH = click.Path(path_type=Path)
F = TypeVar("F", bound=Callable[..., Any])
_STDOUT = Path("-")


class Renamed(click.Option):
    """An option that is also understood by its ``old`` spellings, which no help lists."""

    def __init__(self, *args: Any, old: Sequence[str], **kwargs: Any) -> None:
        super().__init__(*args, **kwargs)
        self.old = tuple(old)

    def add_to_parser(self, parser: Any, ctx: click.Context) -> None:
        listed = self.opts
        self.opts = [*listed, *self.old]
        try:
            super().add_to_parser(parser, ctx)
        finally:
            self.opts = listed


class _Forms(click.Choice):  # type: ignore[type-arg, unused-ignore]
    """A choice of forms, of which some had another name."""

    def __init__(self, choices: Sequence[str], old: Mapping[str, str]) -> None:
        super().__init__(choices)
        self._old = old

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> Any:
        return super().convert(self._old.get(value, value), param, ctx)


def together(*options: Callable[[Any], Any]) -> Callable[[F], F]:
    """Several options as one, in this order."""

    def add(command: F) -> F:
        for option in reversed(options):
            command = option(command)
        return command

    return add


_CONFIGURATION = together(
    click.option("--config", type=PATH, metavar="FILE", help="Use this configuration file and no other."),
    click.option("--isolated", is_flag=True, help="Use no configuration file."),
    click.option(
        "--trust-config",
        is_flag=True,
        help="Let the configuration that is found run code (plugins), write files, and read elsewhere.",
    ),
)


def configured(command: Callable[..., Any]) -> Any:
    """``--config``, ``--isolated`` and ``--trust-config``, passed as one ``configuration``."""

    @wraps(command)
    def with_configuration(
        *, config: Path | None, isolated: bool, trust_config: bool, **given: Any
    ) -> object:
        from sdfcheck.lint.config.configuration import Configuration

        if config is not None and isolated:
            raise WrongUsage("--config and --isolated exclude each other")
        if isolated and trust_config:
            raise WrongUsage("--isolated and --trust-config exclude each other")
        configuration = Configuration(config, isolated=isolated, trusted=trust_config)
        return command(configuration=configuration, **given)

    return _CONFIGURATION(with_configuration)


def colored(help: str = "When to color.") -> Callable[[F], F]:
    """``--color``: auto, always or never."""
    kind = click.Choice(["auto", "always", "never"])
    return click.option("--color", type=kind, default="auto", help=help)


def formatted(help: str, *choices: str, old: Mapping[str, str] | None = None) -> Callable[[F], F]:
    """``--output-format``, passed as ``form``: one of the choices, by default the first.

    ``old``: former names of choices.
    """
    return click.option(
        "--output-format",
        "form",
        cls=Renamed,
        old=["--format"],
        type=_Forms(choices, old or {}),
        default=choices[0],
        help=f"{help}  [default: {choices[0]}]",
    )


def reported(help: str) -> Callable[[Any], Any]:
    """``--output-format`` of reports on findings, each with the file that it goes to."""
    return click.option(
        "--output-format",
        cls=Renamed,
        old=["--format"],
        multiple=True,
        metavar="FORMAT[=FILE]",
        shell_complete=formats,
        help=help,
    )


def _to_file(context: click.Context, parameter: click.Parameter, value: Path | None) -> Path | None:
    return None if value == _STDOUT else value


def written(help: str = "Write it there instead of to stdout.") -> Callable[[F], F]:
    """``-o``, ``--output-file``: a file; None for stdout."""
    return click.option(
        "-o",
        "--output-file",
        cls=Renamed,
        old=["--output"],
        type=PATH,
        callback=_to_file,
        metavar="FILE",
        help=help,
    )


def _commas(
    context: click.Context, parameter: click.Parameter, value: tuple[str, ...]
) -> tuple[str, ...] | None:
    """Lists may be given in one option or in several; None if none is given."""
    if not value:
        return None
    return tuple(word.strip() for text in value for word in text.split(",") if word.strip())


def _consumers(
    context: click.Context, parameter: click.Parameter, value: tuple[str, ...]
) -> tuple[str, ...] | None:
    names = _commas(context, parameter, value)
    if names:
        from sdfcheck.lint.select import check_targets

        check_targets(names)
    return names


def targeted(help: str) -> Callable[[Any], Any]:
    """``--target``: a list of consumers, or None."""
    return click.option(
        "--target",
        multiple=True,
        callback=_consumers,
        metavar="CONSUMERS",
        help=f"{help}: gazebo, drake, urdfdom, mujoco, ros, pybullet, pinocchio, isaac.",
        shell_complete=targets,
    )


def settable(*names: str) -> Callable[[Any], Any]:
    """The options of settings, as these are declared."""
    return together(*(_settable(GIVEN[name]) for name in names))


def _settable(field: Field) -> Callable[[Any], Any]:
    flag, _, metavar = field.option.partition(" ")
    if field.shape == Shape.FLAG:
        return click.option(f"{flag}/--no-{flag[2:]}", field.attribute, default=None, help=field.summary)
    if field.shape == Shape.TARGETS:
        return targeted(field.summary.rstrip("."))
    more: dict[str, Any] = {"type": PATH} if field.shape == Shape.PATHS else {}
    if field.shape == Shape.SELECTORS:
        more = {"callback": _commas, "shell_complete": rules}
    return click.option(flag, field.attribute, multiple=True, metavar=metavar, help=field.summary, **more)


def taken(given: dict[str, Any]) -> Settings:
    """Takes the settings out of what click has read.

    Raises:
        WrongUsage: an option names nothing.
    """
    own = {name: given.pop(name) for name in GIVEN if name in given}
    own["packages"] = tuple(
        (name, Path(path))
        for name, path in (pair(text, "=", "--package name=path") for text in own["packages"])
    )
    for name in ("packages", "package_paths", "model_paths"):
        for path in own[name]:
            folder = path[1] if name == "packages" else path
            if not os.path.isdir(folder):
                reason = "not a folder" if os.path.lexists(folder) else "no such folder"
                raise WrongUsage(f"{GIVEN[name].option.partition(' ')[0]}: {reason}: {folder}")
    return UNSET._replace(**{name: value for name, value in own.items() if value is not None})


limited = click.option(
    "--time-limit",
    type=click.FloatRange(min=0, min_open=True),
    default=60.0,
    metavar="SECONDS",
    help="How long a consumer that is run may take for a question.  [default: 60]",
)
"""``--time-limit``."""


def path(flag: str, help: str) -> Callable[[Any], Any]:
    """An option for a file."""
    return click.option(flag, type=PATH, metavar="FILE", help=help)


def require_file(file: Path) -> None:
    """Make sure that an input is a file, or a pipe that a shell gave.

    Raises: WrongUsage: the file does not exist, or is a folder, another pipe or a device.
    """
    if not os.path.isfile(file):
        from sdfcheck.files.regular import descriptor, oddity

        if descriptor(file) is not None and not os.path.isdir(file):
            return
        raise WrongUsage(f"{file}: {oddity(file)}" if os.path.lexists(file) else f"no such file: {file}")
