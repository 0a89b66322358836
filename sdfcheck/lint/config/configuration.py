"""Configuration files: where they are, and what they settle for a file.

The closest of ``.sdfcheck.toml``, ``sdfcheck.toml`` and ``pyproject.toml`` (with a table
``[tool.sdfcheck]``) upward from a file's folder counts, alone. ``extend`` names another
one to build on.
"""

from __future__ import annotations

import os
from pathlib import Path
from typing import TYPE_CHECKING, Any

from sdfcheck.files.regular import MEGABYTE, read_named
from sdfcheck.lint.config.settings import UNSET, ConfigFile, Settings
from sdfcheck.source.errors import WrongUsage
from sdfcheck.source.text import shown

if TYPE_CHECKING:
    _Loaded = tuple[dict[str, Any], tuple[ConfigFile, ...]]

PYPROJECT = "pyproject.toml"
LARGEST = 16 * MEGABYTE
"""So many bytes a configuration may have."""
NAMES = (".sdfcheck.toml", "sdfcheck.toml", PYPROJECT)


class Configuration:
    """Finds and keeps the settings of each folder.

    ``file`` replaces all that could be found, ``isolated`` uses none. Those that are found
    may run code, write files and lead out of their repository only if they are ``trusted``.
    ``given`` is set by the caller, for all files.
    """

    __slots__ = ("_by_folder", "_fixed", "_trusted", "given")

    def __init__(
        self,
        file: Path | None = None,
        *,
        isolated: bool = False,
        trusted: bool = False,
        given: Settings = UNSET,
    ) -> None:
        self._by_folder: dict[str, Settings] = {}
        self._trusted = trusted
        self._fixed: Settings | None = None
        self.given = given
        if isolated:
            self._fixed = Settings().under(given)
        elif file is not None:
            self._fixed = load(file, root=Path.cwd()).under(given)

    def with_given(self, given: Settings) -> Configuration:
        """The same for a caller who sets something, of one for whom nothing was set."""
        other = Configuration(trusted=self._trusted, given=given)
        other._fixed = self._fixed and self._fixed.under(given)
        return other

    def settings_for(self, path: Path) -> Settings:
        """The settings of a file.

        Raises:
            WrongUsage: the configuration that counts is faulty, or would need to be trusted.
        """
        return self._fixed or self.settings_in(Path(os.path.abspath(path)).parent)

    def settings_in(self, folder: Path) -> Settings:
        """The settings of the files in an (absolute) folder."""
        if self._fixed is not None:
            return self._fixed
        missing: list[str] = []
        place, above = "", os.fspath(folder)
        settings: Settings | None = None
        while settings is None and place != above:
            place, above = above, os.path.dirname(above)
            settings = self._by_folder.get(place)
            if settings is None:
                missing.append(place)
                settings = self._found_in(place)
                settings = settings and settings.under(self.given)
        settings = settings or Settings().under(self.given)
        self._by_folder.update(dict.fromkeys(missing, settings))
        return settings

    def _found_in(self, folder: str) -> Settings | None:
        for name in NAMES:
            path = os.path.join(folder, name)
            if os.path.isfile(path) and (name != PYPROJECT or _configures_us(path)):
                settings = load(Path(path), trusted=self._trusted)
                if not self._trusted:
                    from sdfcheck.lint.config.trust import require_trust

                    require_trust(settings.files, settings._asdict())
                return settings
        return None


def load(path: Path, root: Path | None = None, *, trusted: bool = True) -> Settings:
    """The settings of a configuration file; relative paths start from ``root``, or its folder.

    One that is not ``trusted`` extends files of its project.

    Raises:
        WrongUsage: it is missing, unreadable, or says something that makes no sense.
    """
    values, files = _load(path, root, (), trusted)
    return Settings()._replace(**values, files=files)


def _configures_us(pyproject: str) -> bool:
    """Whether a ``pyproject.toml`` configures sdfcheck; most do not, and need no parsing to find out."""
    path = Path(pyproject)
    if b"sdfcheck" not in _bytes(path):
        return False
    from sdfcheck.lint.config.reading import parse_toml

    return "sdfcheck" in _tool(parse_toml(path, _text(path)))


def _load(path: Path, root: Path | None, below: tuple[ConfigFile, ...], trusted: bool) -> _Loaded:
    """The values that a file sets, its own over those that it extends, and all these files."""
    from sdfcheck.lint.config.reading import parse_toml, read_table

    path = Path(os.path.abspath(path))
    above = [file.path for file in below]
    if path in above:
        chain = " → ".join(shown(place) for place in (*above[above.index(path) :], path))
        raise WrongUsage(f"configuration files extend each other: {chain}")
    if not trusted:
        from sdfcheck.lint.config.trust import require_inside

        require_inside(path, above[0] if above else path, below[-1] if below else None)
    file = ConfigFile(path, _text(path), root or path.parent)
    table = parse_toml(path, file.text)
    if path.name == PYPROJECT:
        table = _tool(table).get("sdfcheck", {})
        if not isinstance(table, dict):
            raise file.error("`tool.sdfcheck` should be a table", "sdfcheck")
    values = read_table(file, table)
    extended = values.pop("extend", None)
    if extended is None:
        return values, (file,)
    if not os.path.exists(extended):
        raise file.error(f"no such file: {shown(extended)}", "extend")
    base, files = _load(extended, None, (*below, file), trusted)
    if "extend_select" in values:
        values["extend_select"] = (*base.get("extend_select", ()), *values["extend_select"])
    return base | values, (file, *files)


def _tool(table: dict[str, Any]) -> dict[str, Any]:
    tool = table.get("tool")
    return tool if isinstance(tool, dict) else {}


def _bytes(path: Path) -> bytes:
    try:
        return read_named(path, LARGEST)
    except OSError as error:
        raise WrongUsage(f"cannot read {shown(path)}: {error.strerror}") from None


def _text(path: Path) -> str:
    try:
        return _bytes(path).decode("utf-8-sig")
    except UnicodeDecodeError as error:
        line = error.object.count(b"\n", 0, error.start) + 1
        raise WrongUsage(f"{shown(path)}:{line}: not UTF-8") from None
