"""Rights of a configuration without a person's consent, and where a person gives it.

A configuration that is found beside the files has the author that they have. It decides how
they are linted; it may run code, write files and lead out of its repository only if somebody
trusts it: on the command line, or in a configuration of their own.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

from sdfcheck.files.packages import Packages, is_shared, project_root
from sdfcheck.files.regular import is_below, read_regular
from sdfcheck.lint.config.reading import parse_toml
from sdfcheck.lint.config.settings import ConfigFile
from sdfcheck.source.errors import WrongUsage
from sdfcheck.source.text import shown

KEY = "trusted"
"""The key of a person's own configuration: folders whose configurations are trusted."""


def require_trust(files: Sequence[ConfigFile], settings: Mapping[str, Any]) -> None:
    """Make sure that what a found configuration asks for is harmless, or its folder trusted.

    ``files`` are the one that was found and those that it extends, ``settings`` what they settle.

    Raises:
        WrongUsage: it is neither, or a person's own configuration is faulty.
    """
    path = files[0].path
    for key, effect in _reach(path, settings):
        if _is_trusted(path.parent):
            return
        file = next((file for file in files if key in file.text), files[0])
        raise file.error(f"`{key}` {effect}, {_consent()}", key)


def require_inside(path: Path, found: Path, by: ConfigFile | None) -> None:
    """Make sure, before it is read, that a configuration lies in the project of the one that was ``found``.

    ``by`` is the one that extends it, None for that which was found.

    Raises:
        WrongUsage: it does not, and the folder of the one that was found is not trusted.
    """
    places, name = _project(found)
    itself = os.path.join(os.path.realpath(found.parent), found.name)
    if is_below(os.path.realpath(path), (*places, itself)) or _is_trusted(found.parent):
        return
    effect = f"leads out of {name}, {_consent()}"
    raise (
        WrongUsage(f"{shown(path)}: a link that {effect}")
        if by is None
        else by.error(f"`extend` {effect}", "extend")
    )


def _consent() -> str:
    own = own_configuration()
    always = f", or name its folder under `{KEY}` in {own} to trust it always" if own else ""
    return (
        f"which needs your consent: pass --trust-config if you trust this configuration{always};"
        " --isolated uses no configuration"
    )


def own_configuration() -> Path | None:
    """Where a person's own configuration is; None where there is no home."""
    if sys.platform == "win32":
        folder = os.environ.get("APPDATA", "")
    else:
        folder = os.environ.get("XDG_CONFIG_HOME", "") or os.path.expanduser("~/.config")
    # A relative folder would be one that the files bring.
    return Path(folder, "sdfcheck", "config.toml") if os.path.isabs(folder) else None


def _reach(path: Path, settings: Mapping[str, Any]) -> Iterator[tuple[str, str]]:
    """The keys that do more than decide how the repository's files are linted, and what they do."""
    if settings["plugins"]:
        yield "plugins", "runs code"
    if any("=" in form for form in settings["output_format"]):
        yield "output-format", "writes a file"
    if settings["env"]:
        yield "env", "reads environment variables"
    own, name = _project(path)
    for key, places in (
        ("packages", [place for _, place in settings["packages"]]),
        ("package-paths", settings["package_paths"]),
        ("model-paths", settings["model_paths"]),
    ):
        if not all(is_below(os.path.realpath(place), own) for place in places):
            yield key, f"leads out of {name}"


def _project(file: Path) -> tuple[tuple[str, ...], str]:
    """The real places that belong to a file's project, and what to call them."""
    root = project_root(file)
    packages = Packages(root, environment={}, is_flat=is_shared(root))
    name = "the files beside it" if packages.is_flat else shown(Path(os.path.realpath(root)))
    return tuple(map(os.path.realpath, packages.places)), name


def _is_trusted(folder: Path) -> bool:
    """Whether a person's own configuration names a folder, or one above it."""
    own = own_configuration()
    if own is None or not os.path.isfile(own):
        return False
    real = os.path.realpath(folder)
    return is_below(real, map(os.path.realpath, _trusted_folders(own)))


def _trusted_folders(own: Path) -> Iterator[str]:
    try:
        table = parse_toml(own, read_regular(own).decode("utf-8-sig"))
    except (OSError, UnicodeDecodeError) as error:
        raise WrongUsage(f"cannot read {own}: {error}") from None
    folders = table.pop(KEY, [])
    if table:
        raise WrongUsage(f"{own}: unknown key `{next(iter(table))}`; it has `{KEY}` only")
    if not isinstance(folders, list) or not all(isinstance(folder, str) for folder in folders):
        raise WrongUsage(f"{own}: `{KEY}` should be a list of folders")
    for folder in map(os.path.expanduser, folders):
        if not os.path.isabs(folder):
            raise WrongUsage(f"{own}: `{KEY}` should name absolute folders, not `{folder}`")
        yield folder
