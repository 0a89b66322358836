"""Where a pack is: a folder, an entry point of an installed distribution, or an import name."""

from __future__ import annotations

import os
import re
from functools import cache
from importlib import util
from pathlib import Path
from zlib import crc32

from sdfcheck.formats.vendor import SUFFIX
from sdfcheck.lint.rulebook.pack import Pack, PackError
from sdfcheck.lint.rulebook.plugins.place import described
from sdfcheck.lint.run import BUILT_IN

GROUP = "sdfcheck.rules"
"""The entry points by which installed packs are known."""


def find_pack(name: str | Path) -> Pack:
    """Locate a pack: a folder if the name is a path, else an entry point, else a package or module.

    Raises: PackError: the pack is not found.
    """
    if isinstance(name, Path) or "/" in name or os.sep in name:
        return _in_folder(Path(name))
    module = None if name == BUILT_IN else _entry_point(name)
    return _imported(name, module or name)


def _in_folder(folder: Path) -> Pack:
    if not folder.is_dir():
        raise PackError("no such folder", str(folder))
    real = folder.resolve()
    # Two folders of one name are two packs.
    package = f"sdfcheck_plugin_{re.sub(r'[^0-9A-Za-z]', '_', real.name)}_{crc32(str(real).encode()):08x}"
    return Pack(str(folder), Path(os.path.abspath(folder)), package)


def _entry_point(name: str) -> str | None:
    """The module that an installed distribution declares under a name; None if none does."""
    from importlib.metadata import entry_points

    modules = sorted({point.value.strip() for point in entry_points(group=GROUP, name=name)})
    if len(modules) > 1:
        raise PackError(f"several installed packages declare it: {', '.join(modules)}", name)
    if modules and not re.fullmatch(r"\w+(\.\w+)*", modules[0]):
        raise PackError(
            f"its entry point `{modules[0]}` should name a package or module and nothing in it", name
        )
    return modules[0] if modules else None


def _imported(name: str, module: str) -> Pack:
    try:
        spec = util.find_spec(module)
    except KeyboardInterrupt:
        raise
    except BaseException as error:  # the packages around it are imported, and may fail in any way
        raise PackError(described(error), name) from error
    if spec is not None and spec.submodule_search_locations:
        return Pack(name, Path(next(iter(spec.submodule_search_locations))), module)
    if spec is not None and spec.origin is not None and spec.origin.endswith(".py"):
        return Pack(name, Path(spec.origin).parent, module, Path(spec.origin))
    if module != name:
        raise PackError(f"its entry point names `{module}`, which cannot be imported", name)
    raise PackError(f"no folder, no entry point `{GROUP}` and no package of that name is there", name)


def read_tables(pack: Pack) -> list[Path]:
    """The tables of a pack's vendors; raises PackError for one that cannot be read."""
    paths = [] if pack.file is not None else sorted(pack.folder.glob(f"*{SUFFIX}"))
    if paths:
        from sdfcheck.formats.vendor.definitions import BadTable
        from sdfcheck.formats.vendor.table import check_tables

        try:
            check_tables(paths)
        except BadTable as error:
            raise PackError(str(error), pack.name) from None
    return paths


@cache
def tables_of(plugins: tuple[str | Path, ...]) -> tuple[Path, ...]:
    """The tables of all plugins; none of one that cannot be loaded, which linting reports."""
    return tuple(table for plugin in plugins for table in _readable(plugin))


def _readable(plugin: str | Path) -> list[Path]:
    try:
        return read_tables(find_pack(plugin))
    except PackError:
        return []
