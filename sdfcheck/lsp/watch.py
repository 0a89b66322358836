"""Changes outside of the editor's texts: settings, configuration files, files on disk."""

from __future__ import annotations

import asyncio
import os
from collections.abc import Iterable, Mapping
from contextlib import suppress
from pathlib import Path
from typing import Any

from lsprotocol import types

from sdfcheck.files.regular import read_regular
from sdfcheck.lint.config.configuration import NAMES
from sdfcheck.lsp.server import Server
from sdfcheck.lsp.speech import NAME, path_of
from sdfcheck.lsp.workspace import Choices

_DESCRIPTIONS = "**/*.{sdf,world,urdf,xacro,srdf,config,yaml,dae,stl,obj}"
_SURROUNDINGS = "**/{.sdfcheck.toml,sdfcheck.toml,pyproject.toml,package.xml,CMakeLists.txt,.gitignore}"
_LAYOUT = frozenset({*NAMES, "package.xml", "CMakeLists.txt"})
_OUTDATED = -1.0
"""When a file was changed that is not as it was read."""
_PAUSE = 1.0
"""Between two looks at the disk, in s, for clients that do not watch files."""


class Watch:
    """Brings in what changes around the open texts."""

    def __init__(self, server: Server) -> None:
        self.server = server
        self._polling: asyncio.Task[None] | None = None
        self._stamps: dict[str, float] = {}

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
            watchers = [types.FileSystemWatcher(glob) for glob in (_DESCRIPTIONS, _SURROUNDINGS)]
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

    async def configured(self, settings: Any) -> None:
        """The settings of the client have changed, or are to be asked for."""
        if self.server.speech.is_able("workspace", "configuration"):
            item = types.ConfigurationItem(section=NAME)
            with suppress(Exception):  # a client may have no settings to give
                answer = await self.server.workspace_configuration_async(types.ConfigurationParams([item]))
                settings = answer[0] if answer else None
        own = _plain(settings)
        own = own.get(NAME, own) if isinstance(own, Mapping) else None
        if own:
            choices = choices_of(own, self._folder)
            if choices != self.server.robots.choices:
                await self.server.chosen(choices)

    @property
    def _folder(self) -> Path:
        folders = self.server.robots.folders
        return folders[0] if folders else Path.cwd()

    async def _poll(self) -> None:
        while True:
            await asyncio.sleep(_PAUSE)
            nothing: dict[str, float] = {}
            stamps = await self.server.work(self._look, nothing)
            before, self._stamps = self._stamps, stamps
            if not before or stamps == before:
                continue
            changed = {path for path in before.keys() | stamps.keys() if before.get(path) != stamps.get(path)}
            is_layout = any(os.path.basename(path) in _LAYOUT for path in changed)
            known = (before.keys() & stamps.keys()) | {path for path, stamp in stamps.items() if stamp < 0}
            if is_layout or any(
                path in known and 0.0 in (before.get(path), stamps.get(path)) for path in changed
            ):
                await self.server.refreshed(self.server.robots.refresh)
            elif changed & known:
                await self.server.refreshed(self.server.robots.forget)

    def _look(self) -> dict[str, float]:
        """When the files that count were changed last; 0 for those that are not there."""
        robots = self.server.robots
        paths = {
            str(document.path)
            for library in robots.caches.libraries
            for document in library.documents()
            if robots.key(document.path) not in robots.buffers
        }
        for buffer in robots.buffers.values():
            folder = Path(os.path.abspath(buffer.path)).parent
            paths |= {str(above / name) for above in (folder, *folder.parents) for name in NAMES}
            for around in robots.folders:
                paths.add(str(around / "package.xml"))
        return {path: _stamp(path) if self._is_as_read(path) else _OUTDATED for path in sorted(paths)}

    def _is_as_read(self, path: str) -> bool:
        """Does a file that was not looked at before hold what was read of it?"""
        if path in self._stamps:
            return True
        libraries = [each for each in self.server.robots.caches.libraries if each.holds(Path(path))]
        try:
            data = read_regular(Path(path)) if libraries else b""
        except OSError:
            return False
        return all(each.known(data, Path(path)) is not None for each in libraries)


def _stamp(path: str) -> float:
    try:
        return os.stat(path).st_mtime
    except OSError:
        return 0.0


def _plain(value: Any) -> Any:
    """A mapping from an object that the protocol library made of it."""
    if hasattr(value, "_asdict"):
        value = value._asdict()
    if isinstance(value, Mapping):
        return {str(key): _plain(each) for key, each in value.items()}
    if isinstance(value, list | tuple):
        return [_plain(each) for each in value]
    return value


def choices_of(given: Any, folder: Path) -> Choices:
    """The choices that a client's settings make; what is not of the right kind is left out."""
    plain = _plain(given)
    own: Mapping[str, Any] = plain if isinstance(plain, Mapping) else {}
    if isinstance(inner := own.get(NAME), Mapping):
        own = inner

    def words(key: str) -> tuple[str, ...] | None:
        value = own.get(key)
        if isinstance(value, str):
            value = value.split(",")
        return (
            tuple(str(each).strip() for each in value if str(each).strip())
            if isinstance(value, list)
            else None
        )

    path = own.get("configuration")
    return Choices(
        configuration=folder / os.path.expanduser(path) if isinstance(path, str) and path else None,
        select=words("select") or None,
        extend_select=words("extendSelect") or (),
        ignore=words("ignore") or (),
        preview=True if own.get("preview") is True else None,
        target=words("target") or None,
        trust=own.get("trustConfig") is True,
        expand=own.get("expandXacro") is not False,
    )
