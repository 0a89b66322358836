"""Linting, called from programs."""

from __future__ import annotations

import os
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import TYPE_CHECKING

from sdfcheck.lint.config.configuration import Configuration
from sdfcheck.lint.config.settings import UNSET
from sdfcheck.lint.run import Run
from sdfcheck.lint.session import Options, run
from sdfcheck.robot.load import as_text

if TYPE_CHECKING:
    from concurrent.futures import Executor

    from typing_extensions import Unpack

    from sdfcheck.lint.config.settings import Given


def lint(  # noqa: PLR0913
    what: str | bytes | os.PathLike[str] | Iterable[os.PathLike[str]],
    *,
    name: str | os.PathLike[str] = "<text>",
    arguments: Mapping[str, str] | None = None,
    config: Path | None = None,
    isolated: bool = False,
    trust_config: bool = False,
    executor: Executor | None = None,
    **settings: Unpack[Given],
) -> Run:
    """Lint files, folders, or a text.

    ``what`` is a path, several paths, or a text: bytes, or a str that begins with ``<``. A text has
    ``name`` as its path. ``settings`` are those that the command takes, too, named as in a
    configuration: ``select``, ``extend_select``, ``ignore``, ``preview``, ``target``,
    ``model_paths``, ``package_paths``, ``packages``, ``env``. The others are options of the command.

    The workers of an ``executor`` lint portions of the files: processes, threads, or a cluster that
    has the same files. Files whose worker died are in ``skipped``, with the reason.

    Raises:
        sdfcheck.WrongUsage: a path does not exist, a rule is unknown, a configuration is faulty.
    """
    text, paths = text_or_paths(what)
    options = Options(
        configured(config, isolated=isolated, trust_config=trust_config, **settings),
        stdin=text,
        stdin_path=Path(name),
        arguments=tuple((arguments or {}).items()),
    )
    return _run(paths, options, executor)


def configured(
    config: Path | None, *, isolated: bool, trust_config: bool, **settings: Unpack[Given]
) -> Configuration:
    """The configuration with the settings of a caller.

    Raises: WrongUsage: a value is not of its setting's form, or the configuration is faulty.
    """
    given = UNSET
    if settings:
        from sdfcheck.lint.config.reading import read_given

        given = read_given(settings)
    return Configuration(config, isolated=isolated, trusted=trust_config, given=given)


def _run(paths: tuple[Path, ...], options: Options, executor: Executor | None) -> Run:
    if executor is None:
        return run(paths, options)
    from sdfcheck.lint.parallel import run_on

    return run_on(executor, paths, options)


def text_or_paths(
    what: str | bytes | os.PathLike[str] | Iterable[os.PathLike[str]],
) -> tuple[bytes | None, tuple[Path, ...]]:
    """The text or the paths."""
    text = as_text(what)
    if text is not None:
        return text, ()
    if isinstance(what, str | bytes | os.PathLike):
        return None, (Path(os.fsdecode(what)),)
    return None, tuple(Path(path) for path in what)
