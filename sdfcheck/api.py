"""The commands as functions: fix, compare, judge, measure, write."""

from __future__ import annotations

import json
import os
from collections.abc import Iterable
from pathlib import Path
from typing import TYPE_CHECKING, Any

from sdfcheck.robot.load import opened
from sdfcheck.robot.root import Root, root_of
from sdfcheck.source.errors import WrongUsage

if TYPE_CHECKING:
    from typing_extensions import Unpack

    from sdfcheck.convert.file_difference import FileDifference
    from sdfcheck.lint.config.settings import Given
    from sdfcheck.lint.diagnostic import Diagnostic
    from sdfcheck.lint.fix.fixer import FixedFile
    from sdfcheck.lint.run import Run
    from sdfcheck.lint.targets import Row
    from sdfcheck.robot.motion.mass_report import MassReport
    from sdfcheck.source.document import Document

Description = Root | str | bytes | os.PathLike[str]
"""A path, a text (bytes, or a str that begins with ``<``), or what :func:`sdfcheck.load` gave."""


def fix(
    what: str | os.PathLike[str] | Iterable[os.PathLike[str]],
    *,
    unsafe: bool = False,
    write: bool = True,
    config: Path | None = None,
    isolated: bool = False,
    trust_config: bool = False,
    **settings: Unpack[Given],
) -> tuple[FixedFile, ...]:
    """Apply the fixes of what ``lint`` finds in files and folders.

    Each result has the ``path``, the bytes ``before`` and ``after``, how many fixes were applied (``fixed``)
    and, where none could be, the ``refusal``. Only bytes inside the fixes change. ``unsafe``: apply those as
    well that may change the robot. ``write=False`` leaves the files alone. The rest is as for ``lint``.

    Raises:
        sdfcheck.WrongUsage: a path does not exist, a rule is unknown, a configuration is faulty.
        OSError: a file cannot be written.
    """
    from sdfcheck.files.overwrite import overwrite
    from sdfcheck.lint.call import configured, text_or_paths
    from sdfcheck.lint.fix.fixer import fix_files
    from sdfcheck.lint.session import Options, run

    text, paths = text_or_paths(what)
    if text is not None:
        raise WrongUsage("only files are fixed: give a path")
    options = Options(configured(config, isolated=isolated, trust_config=trust_config, **settings))
    changed = tuple(fix_files(run(paths, options), paths, options, unsafe=unsafe))
    for each in changed:
        if write and each.fixed:
            overwrite(each.path, each.after, instead=True)
    return changed


def diff(a: Description, b: Description, *, tolerance: float = 1e-9) -> FileDifference:
    """The changes in the robot from ``a`` to ``b``, not in the text; they may be of different formats.

    The result has ``changes`` by model: each a ``kind`` (added, removed, changed, renamed), the
    ``part``, its ``name``, ``what`` of it, ``before`` and ``after``. Smaller differences than
    ``tolerance`` (m, rad; relative for others) do not count.

    Raises:
        OSError, sdfcheck.Unreadable: as for ``load``.
        sdfcheck.DescriptionError: a number or a pose cannot be worked out.
    """
    from sdfcheck.convert.file_difference import compare_files

    return compare_files(_document(a), _document(b), tolerance=tolerance)


def targets(
    what: str | os.PathLike[str],
    *,
    config: Path | None = None,
    isolated: bool = False,
    trust_config: bool = False,
) -> tuple[Row, ...]:
    """What Gazebo, Drake, urdfdom, MuJoCo and others make of a file, one row each.

    A row has the simulator (``consumer``), its ``verdict``, and the ``reasons``: diagnostics with
    what the simulator does about them.

    Raises sdfcheck.WrongUsage for a path that is not there or is not a robot description.
    """
    from sdfcheck.consumers.reaction import Consumer
    from sdfcheck.files.regular import read_named
    from sdfcheck.lint.call import configured
    from sdfcheck.lint.session import Options, run
    from sdfcheck.lint.targets import matrix
    from sdfcheck.source.sniff import sniff

    path = Path(what)
    every = [consumer.value for consumer in Consumer]
    configuration = configured(config, isolated=isolated, trust_config=trust_config, target=every)
    data = read_named(path, configuration.settings_for(path).size_limit)
    return matrix(run([path], Options(configuration)), sniff(data, path), path)


def inertia(what: Description) -> MassReport:
    """Mass (kg), center of mass (m) and inertia (kg·m²): of each link and model, and in total.

    In the frame of each model, all joints at zero; automatic inertias are computed.

    Raises:
        OSError, sdfcheck.Unreadable: as for ``load``.
        sdfcheck.DescriptionError: the numbers of a URDF cannot be read.
    """
    from sdfcheck.robot.motion.mass_report import mass_report

    return mass_report(root_of(_document(what)).scopes)


def print(  # noqa: A001 - the command's name
    what: Description,
    *,
    degrees: bool | None = None,
    snap: float | None = None,
    precision: int | None = None,
    expand_includes: bool = False,
    expand_auto_inertials: bool = False,
) -> str:
    """The description in canonical form: the same robot, written one way.

    ``degrees``: write angles of poses in degrees (True), radians (False) or as they are.
    ``snap``: turn angles within so many degrees of a whole degree into that. ``precision``:
    round to so many significant digits.

    Raises:
        OSError, sdfcheck.Unreadable: as for ``load``.
        sdfcheck.WrongUsage: the text is broken, the format cannot hold what is asked for, or the
            result would be another robot.
    """
    from sdfcheck.convert.canonical import CanonicalStyle, NumberStyle, canonical

    style = CanonicalStyle(NumberStyle(degrees, snap, precision), expand_includes, expand_auto_inertials)
    return canonical(_document(what), style).text


def as_json(what: Run | Diagnostic) -> Any:
    """A run or one diagnostic as the command writes it with ``--output-format json``: dicts, lists, numbers, texts."""
    from sdfcheck.lint.rulebook.packs import load_index
    from sdfcheck.lint.run import Run
    from sdfcheck.report.formats.json import diagnostic_lines, render
    from sdfcheck.report.paths import Paths

    if isinstance(what, Run):
        return json.loads(render(what))
    (line,) = diagnostic_lines(Run((what,), (), rules=load_index().facts), Paths())
    return json.loads(line)


def _document(what: Description) -> Document:
    return (what if isinstance(what, Root) else opened(what)).document
