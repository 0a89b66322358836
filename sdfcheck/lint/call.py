"""Linting, called from programs."""

from __future__ import annotations

import os
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from sdfcheck.files.library import SearchPaths
from sdfcheck.lint.config.configuration import Configuration
from sdfcheck.lint.run import Run
from sdfcheck.lint.select import Choice, check_targets
from sdfcheck.lint.session import Options, run
from sdfcheck.robot.load import as_text

if TYPE_CHECKING:
    from concurrent.futures import Executor


def lint(  # noqa: PLR0913
    what: str | bytes | os.PathLike[str] | Iterable[os.PathLike[str]],
    *,
    select: Sequence[str] | None = None,
    extend_select: Sequence[str] = (),
    ignore: Sequence[str] = (),
    preview: bool | None = None,
    target: Sequence[str] | None = None,
    name: str | os.PathLike[str] = "<text>",
    arguments: Mapping[str, str] | None = None,
    model_paths: Sequence[Path] = (),
    package_paths: Sequence[Path] = (),
    config: Path | None = None,
    isolated: bool = False,
    trust_config: bool = False,
    executor: Executor | None = None,
) -> Run:
    """Lint files, folders, or a text.

    ``what`` is a path, several paths, or a text: bytes, or a str that begins with ``<``. A text has
    ``name`` as its path. The other arguments are options of the command.

    The workers of an ``executor`` lint portions of the files: processes, threads, or a cluster that
    has the same files. Files whose worker died are in ``skipped``, with the reason.

    Raises:
        sdfcheck.WrongUsage: a path does not exist, a rule is unknown, a configuration is faulty.
    """
    text, paths = text_or_paths(what)
    options = options_of(
        Configuration(config, isolated=isolated, trusted=trust_config),
        select=select,
        extend_select=extend_select,
        ignore=ignore,
        preview=preview,
        target=target,
        search=SearchPaths(tuple(model_paths), tuple(package_paths)),
    )
    options = options._replace(stdin=text, stdin_path=Path(name), arguments=tuple((arguments or {}).items()))
    return _run(paths, options, executor)


def options_of(  # noqa: PLR0913
    configuration: Configuration,
    *,
    select: Sequence[str] | None = None,
    extend_select: Sequence[str] = (),
    ignore: Sequence[str] = (),
    preview: bool | None = None,
    target: Sequence[str] | None = None,
    search: SearchPaths | None = None,
) -> Options:
    """The options of the command; raises WrongUsage for an unknown target."""
    if target:
        check_targets(tuple(target))
    return Options(
        configuration,
        Choice(tuple(select) if select is not None else None, tuple(extend_select), tuple(ignore), preview),
        tuple(target) if target is not None else None,
        search=search or SearchPaths(),
    )


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
