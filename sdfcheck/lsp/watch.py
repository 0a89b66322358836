"""Changes outside of the editor's texts: settings, configuration files, files on disk."""

from __future__ import annotations

import asyncio
import json
import os
import re
import time
from collections.abc import Iterable, Mapping
from contextlib import suppress
from pathlib import Path
from typing import Any

from lsprotocol import types

from sdfcheck.files.regular import read_regular
from sdfcheck.lint.config.configuration import NAMES
from sdfcheck.lint.config.reading import read_value
from sdfcheck.lint.config.settings import GIVEN, UNSET, Field, Shape
from sdfcheck.lsp.server import Server
from sdfcheck.lsp.speech import NAME, path_of, plain
from sdfcheck.lsp.workspace import Choices
from sdfcheck.source.errors import WrongUsage
from sdfcheck.source.record import NamedTuple

_DESCRIPTIONS = "**/*.{sdf,world,urdf,xacro,gazebo,srdf,config,yaml,yml,dae,stl,obj}"
_SURROUNDINGS = "**/{.sdfcheck.toml,sdfcheck.toml,pyproject.toml,package.xml,CMakeLists.txt,.gitignore}"
_LAUNCHES = "**/{*.launch,*launch.xml,*launch.py,launch/*.py}"
_LAYOUT = frozenset({*NAMES, "package.xml", "CMakeLists.txt"})
_OUTDATED = -1.0
"""When a file was changed that is not as it was read."""
_PAUSE = 1.0
"""Between two looks at the disk, in s, for clients that do not watch files."""
_SHARE = 20
"""The pause is so many times as long as a look at very many files, or at very long paths, takes."""


class Stamps(NamedTuple):
    """When files were changed last; 0 for those that are not there."""

    files: dict[str, float]
    configurations: dict[str, tuple[float, ...]]
    """Folder around an open text → those of the files in it that may configure us."""


class FileWatch:
    """Brings in what changes around the open texts."""

    def __init__(self, server: Server) -> None:
        self.server = server
        self._polling: asyncio.Task[None] | None = None
        self._stamps = Stamps({}, {})
        self._chains: dict[str, tuple[str, ...]] = {}
        """Folder with an open text → itself and the folders above it: their names may be long."""
        self._is_configured = False
        """Has the client sent settings after its first request?"""

    def began(self, params: types.InitializeParams) -> None:
        """Take the settings that come with the first request."""
        given = params.initialization_options
        if given is not None:
            self.server.robots.choose(choices_of(given, self._folder))

    async def start(self) -> None:
        """Ask the client for settings and for news of files; look at the disk if it has none."""
        speech = self.server.speech
        if speech.is_able("workspace", "configuration"):
            await self.configured(None)
        if speech.is_able("workspace", "did_change_watched_files", "dynamic_registration"):
            watchers = [types.FileSystemWatcher(glob) for glob in (_DESCRIPTIONS, _SURROUNDINGS, _LAUNCHES)]
            options = types.DidChangeWatchedFilesRegistrationOptions(watchers)
            method = types.WORKSPACE_DID_CHANGE_WATCHED_FILES
            registration = types.Registration(id=f"{NAME}.files", method=method, register_options=options)
            with suppress(Exception):  # a client may refuse what it offered
                await self.server.client_register_capability_async(types.RegistrationParams([registration]))
                return
        self._polling = asyncio.ensure_future(self._poll())

    def stop(self) -> None:
        if self._polling is not None:
            self._polling.cancel()

    async def saved(self, path: Path) -> None:
        """A text was written to its file: documents that include the file see it now."""
        if path.name in _LAYOUT:
            await self.server.refreshed(self.server.robots.refresh)

    async def noticed(self, changes: Iterable[types.FileEvent]) -> None:
        """Files were made, changed or deleted."""
        robots = self.server.robots
        paths = {path_of(change.uri): change.type for change in changes}
        news = {path: kind for path, kind in paths.items() if robots.key(path) not in robots.buffers}
        new = any(kind is not types.FileChangeType.Changed for kind in paths.values())
        if new or any(path.name in _LAYOUT for path in paths):
            await self.server.refreshed(robots.refresh)
        elif news:
            await self.server.refreshed(robots.forget)

    async def turned_to(self, added: Iterable[Path], removed: Iterable[Path]) -> None:
        """Folders were added to the workspace, or removed from it."""
        robots, gone = self.server.robots, set(removed)
        kept = [folder for folder in robots.folders if folder not in gone]

        folders = tuple(dict.fromkeys([*kept, *added]))
        await self.server.refreshed(lambda: robots.surround(folders))

    async def configured(self, settings: Any) -> None:
        """The settings of the client have changed, or are to be asked for."""
        if self.server.speech.is_able("workspace", "configuration"):
            item = types.ConfigurationItem(section=NAME)
            with suppress(Exception):  # a client may have no settings to give
                answer = await self.server.workspace_configuration_async(types.ConfigurationParams([item]))
                settings = answer[0] if answer else None
        own = plain(settings)
        own = own.get(NAME, own) if isinstance(own, Mapping) else None
        if own or (self._is_configured and isinstance(own, Mapping)):
            self._is_configured = True
            choices = choices_of(own, self._folder)
            if choices != self.server.robots.choices:
                await self.server.chosen(choices)

    @property
    def _folder(self) -> Path:
        folders = self.server.robots.folders
        return folders[0] if folders else Path.cwd()

    async def _poll(self) -> None:
        took = 0.0
        while True:
            await asyncio.sleep(max(_PAUSE, _SHARE * took))
            begin = time.monotonic()
            stamps = await self.server.work(self._look, Stamps({}, {}))
            took = time.monotonic() - begin
            (before, settings), self._stamps = self._stamps, stamps
            if not (before or settings) or stamps == (before, settings):
                continue
            now = stamps.files
            changed = {path for path in before.keys() | now.keys() if before.get(path) != now.get(path)}
            is_layout = any(os.path.basename(path) in _LAYOUT for path in changed) or any(
                settings.get(folder, there) != there for folder, there in stamps.configurations.items()
            )
            known = (before.keys() & now.keys()) | {path for path, stamp in now.items() if stamp < 0}
            if is_layout or any(
                path in known and 0.0 in (before.get(path), now.get(path)) for path in changed
            ):
                await self.server.refreshed(self.server.robots.refresh)
            elif changed & known:
                await self.server.refreshed(self.server.robots.forget)

    def _look(self) -> Stamps:
        """Look at the files that count."""
        robots = self.server.robots
        read = {
            str(document.path)
            for library in robots.caches.libraries
            for document in library.documents()
            if robots.key(document.path) not in robots.buffers
        }
        around = {str(folder / "package.xml") for folder in robots.folders if robots.buffers}
        open_in = {os.path.dirname(os.path.abspath(buffer.path)) for buffer in robots.buffers.values()}
        self._chains = {folder: self._chains.get(folder) or _chain(folder) for folder in open_in}
        outdated = {path for path in read if not self._is_as_read(path)}
        return Stamps(
            {path: _OUTDATED if path in outdated else _stamp(path) for path in sorted(read | around)},
            {
                folder: tuple(_stamp(os.path.join(folder, name)) for name in NAMES)
                for chain in self._chains.values()
                for folder in chain
            },
        )

    def _is_as_read(self, path: str) -> bool:
        """Does a file that was not looked at before hold what was read of it?"""
        if path in self._stamps.files:
            return True
        libraries = [each for each in self.server.robots.caches.libraries if each.holds(Path(path))]
        try:
            data = read_regular(Path(path)) if libraries else b""
        except OSError:
            return False
        return all(each.known(data, Path(path)) is not None for each in libraries)


def _chain(folder: str) -> tuple[str, ...]:
    """A folder and those above it."""
    found = [folder]
    while (above := os.path.dirname(found[-1])) != found[-1]:
        found.append(above)
    return tuple(found)


def _stamp(path: str) -> float:
    try:
        return os.stat(path).st_mtime
    except OSError:
        return 0.0


_FLAGS = {
    "trustConfig": "trust",
    "expandXacro": "expand",
    "codeLens": "lenses",
    "workspaceDiagnostics": "sweep",
}
"""Settings of the server itself → the names of their choices."""
SETTINGS = {re.sub(r"_(.)", lambda match: match[1].upper(), name): field for name, field in GIVEN.items()}
"""The settings of a run, as editors name them."""


def choices_of(given: Any, folder: Path) -> Choices:
    """The choices that a client's settings make; those of a wrong kind are left out, and named as faults."""
    own = plain(given)
    if isinstance(own, Mapping) and isinstance(inner := own.get(NAME), Mapping):
        own = inner
    if not isinstance(own, Mapping):
        return Choices()
    faults: list[str] = []
    flags = {name: _read(key, _FLAG, own.get(key), folder, faults) for key, name in _FLAGS.items()}
    read = {
        field.attribute: _read(key, field, own.get(key), folder, faults) for key, field in SETTINGS.items()
    }
    return Choices(
        _read("configuration", _FILE, own.get("configuration") or None, folder, faults),
        UNSET._replace(**{name: value for name, value in read.items() if value}),
        **{name: value for name, value in flags.items() if value is not None},
        faults=tuple(faults),
    )


_FILE, _FLAG = Field("", Shape.PATH, "", ""), Field("", Shape.FLAG, "", "")


def _read(name: str, field: Field, value: Any, folder: Path, faults: list[str]) -> Any:
    """The value of a setting, None where it is not given or of a wrong kind; lists may be words with commas."""
    if isinstance(value, str) and field.shape not in {Shape.PATH, Shape.FLAG}:
        value = value.split(",")
    if isinstance(value, list) and all(isinstance(each, str) for each in value):
        value = [word for each in value if (word := each.strip())]
    if value is None:
        return None
    is_target = field.shape == Shape.TARGETS  # each name that is unknown is a fault of its own
    try:
        return read_value(field._replace(shape=Shape.STRINGS) if is_target else field, value, folder)
    except WrongUsage:
        faults.append(f"setting `{name}` is {json.dumps(value)}; it must be {field.shape}")
        return None
