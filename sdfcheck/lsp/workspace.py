"""The texts that are open in the editor and the files on disk, as one set of documents."""

from __future__ import annotations

import os
from collections.abc import Iterator, Mapping
from pathlib import Path

from sdfcheck.files.library import Library, SearchPaths
from sdfcheck.files.regular import read_regular
from sdfcheck.lint.config.configuration import Configuration, Settings
from sdfcheck.lint.one_file import Caches
from sdfcheck.lint.rulebook.rulebook import RuleBook
from sdfcheck.lint.run import RuleFacts
from sdfcheck.lint.select import Choice
from sdfcheck.lsp.completion.context import Checkpoints
from sdfcheck.source.document import Document
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.sniff import HEAD, Kind, Treatment, sniff, treatment
from sdfcheck.source.text import Source
from sdfcheck.source.wrong_usage import WrongUsage
from sdfcheck.xacro.expansion import Surroundings


class Choices(NamedTuple):
    """The client's settings, over the configuration files."""

    configuration: Path | None = None
    select: tuple[str, ...] | None = None
    extend_select: tuple[str, ...] = ()
    ignore: tuple[str, ...] = ()
    preview: bool | None = None
    target: tuple[str, ...] | None = None
    trust: bool = False
    expand: bool = True


class Buffer:
    """A text that is open in the editor; its document is made when it is asked for."""

    __slots__ = ("_document", "_stale", "checkpoints", "path", "source", "uri", "version")

    def __init__(self, uri: str, path: Path, text: str, version: int | None) -> None:
        self.uri = uri
        self.path = path
        self.source = Source(path, text)
        self.version = version
        self.checkpoints = Checkpoints()
        self._document: Document | None = None
        self._stale: list[Document] = []

    def write(self, source: Source, version: int | None, kept: int = 0) -> None:
        """Take a new text, which begins with ``kept`` characters of the old one."""
        self.forget()
        self.source, self.version = source, version
        self.checkpoints.cut(kept)

    def forget(self) -> None:
        """Make the document anew when it is asked for next."""
        if self._document is not None:
            self._stale.append(self._document)
        self._document = None

    def tidy(self, kept: int = 0) -> None:
        """Drop old documents, which takes a while; so many are kept for later."""
        while len(self._stale) > kept:
            self._stale.pop(0).release()

    @property
    def data(self) -> bytes:
        return self.source.text.encode("utf-8", "surrogatepass")

    @property
    def kind(self) -> Kind:
        """The kind of a text."""
        head = self.source.text[:HEAD].encode("utf-8", "surrogatepass")
        return sniff(head, self.path)

    @property
    def document(self) -> Document:
        """The text as it is read; not to be looked at by two threads."""
        if self._document is None:
            self.tidy(kept=1)
            kind = self.kind
            self._document = Document(self.source, None if kind is Kind.BROKEN_XML else kind, [])
        return self._document

    @property
    def is_linted(self) -> bool:
        """Is it something that has diagnostics?"""
        return treatment(self.kind, self.path, named=True) is Treatment.LINT


def _kind(path: Path) -> Kind | None:
    """The content of a file of ROS: robots, their semantics and macros have the same root."""
    if path.suffix not in {".urdf", ".xacro", ".srdf"}:
        return None
    try:
        kind = sniff(read_regular(path)[:HEAD], path)
    except OSError:
        return None
    return kind if kind in {Kind.URDF, Kind.XACRO, Kind.SRDF} else None


Buffers = dict[str, Buffer]
"""Real path → what is open."""


class LiveLibrary(Library):
    """A library in which open texts take the place of files."""

    __slots__ = ("_buffers",)

    def __init__(self, buffers: Buffers, search: SearchPaths, limit: int) -> None:
        super().__init__(search, limit)
        self._buffers = buffers

    def known(self, data: bytes, path: Path) -> Document | None:
        buffer = self._buffers.get(self.disk.real(path))
        if buffer is None:
            return super().known(data, path)
        return buffer.document if buffer.data == data else None

    def _read(self, path: Path, key: str, kind: Kind | None, of: Document | None) -> Document | None:
        buffer = self._buffers.get(key)
        if buffer is None:
            return super()._read(path, key, kind, of)
        document = buffer.document
        if kind is not None and document.kind is not kind:
            document = Document(buffer.source, kind, [])
        self._hashes[key] = hash(buffer.data)
        document.library = self
        return document


class LiveCaches(Caches):
    """Libraries and expanders that know the open texts."""

    __slots__ = ("_buffers",)

    def __init__(self, buffers: Buffers, *, expand: bool) -> None:
        super().__init__(expand=expand)
        self._buffers = buffers

    def library(self, settings: Settings) -> LiveLibrary:
        search = settings.search
        if search not in self._libraries:
            self._libraries[search] = LiveLibrary(self._buffers, search, settings.size_limit)
        found = self._libraries[search]
        assert isinstance(found, LiveLibrary)
        return found

    @property
    def libraries(self) -> tuple[Library, ...]:
        """Those that were asked for."""
        return tuple(self._libraries.values())

    def _surroundings(self, settings: Settings) -> Surroundings:
        return super()._surroundings(settings)._replace(texts=_Texts(self._buffers))


class _Texts(Mapping[str, str]):
    """Absolute path → text, of what is open now and xacro may read."""

    def __init__(self, buffers: Buffers) -> None:
        self._buffers = buffers

    def _open(self) -> dict[str, str]:
        return {
            os.path.abspath(buffer.path): buffer.source.text
            for buffer in self._buffers.values()
            if buffer.kind in {Kind.XACRO, Kind.URDF}
        }

    def __getitem__(self, path: str) -> str:
        return self._open()[path]

    def __iter__(self) -> Iterator[str]:
        return iter(self._open())

    def __len__(self) -> int:
        return len(self._open())


class Workspace:
    """The open texts with their settings, rules and libraries; everything here belongs to one thread."""

    def __init__(self) -> None:
        self.folders: tuple[Path, ...] = ()
        self.buffers: Buffers = {}
        self.generation = 0
        """How often documents were forgotten: what was worked out before has no worth after."""
        self.fault = ""
        """The fault of the configuration, as a sentence for people."""
        self.choose(Choices())

    def choose(self, choices: Choices) -> None:
        """Take other settings of the client; whatever was known is worked out anew."""
        self.choices = choices
        self.configuration = self._configuration()
        choice = Choice(choices.select, choices.extend_select, choices.ignore, choices.preview)
        self.book = RuleBook(choice, choices.target or None)
        self.caches = LiveCaches(self.buffers, expand=choices.expand)
        self.forget()

    def refresh(self) -> None:
        """Find configuration files, packages and documents again."""
        self.caches.close()
        self.choose(self.choices)

    def forget(self) -> None:
        """Read all documents again when they are asked for."""
        self.generation += 1
        for library in self.caches.libraries:
            library.forget()
        for buffer in self.buffers.values():
            buffer.forget()

    def close(self) -> None:
        """End what expands xacro."""
        self.caches.close()

    # Texts

    def key(self, path: Path) -> str:
        """By what a file is known, whatever links lead to it."""
        return os.path.realpath(path)

    def open(self, uri: str, path: Path, text: str, version: int | None) -> Buffer:
        """Take a text that the editor shows."""
        self._turn(path)
        buffer = self.buffers[self.key(path)] = Buffer(uri, path, text, version)
        return buffer

    def write(self, buffer: Buffer, source: Source, version: int | None, kept: int = 0) -> None:
        """Take a new text of what is open, which begins with ``kept`` characters of the old one."""
        self._turn(buffer.path)
        buffer.write(source, version, kept)

    def drop(self, path: Path) -> None:
        """A text that the editor closes is again the content of its file."""
        if self.buffers.pop(self.key(path), None) is not None:
            self._turn(path)

    def is_referred_to(self, path: Path) -> bool:
        """Did another document ask for this one?"""
        return any(library.holds(path) for library in self.caches.libraries)

    def _turn(self, path: Path) -> None:
        """Documents that depend on a file must be read again."""
        if self.is_referred_to(path):
            self.forget()

    # Documents

    def settings_for(self, path: Path) -> Settings:
        """The settings of a file; the defaults where the configuration is faulty."""
        try:
            return self.configuration.settings_for(path)
        except WrongUsage as error:
            self.fault = str(error)
            return Settings()

    def library(self, path: Path) -> LiveLibrary:
        """The library that the file at a path looks others up in."""
        return self.caches.library(self.settings_for(path))

    def facts(self, path: Path) -> dict[str, RuleFacts]:
        """The available rules for a file, by their codes."""
        try:
            return {facts.code: facts for facts in self.book.rules(self.settings_for(path))}
        except WrongUsage as error:
            self.fault = str(error)
            return {}

    def document(self, path: Path) -> Document | None:
        """The text that is open at a path, or the content of the file; None where it cannot be read."""
        library = self.library(path)
        buffer = self.buffers.get(self.key(path))
        if buffer is None:
            return library.document(path, _kind(path))
        document = buffer.document
        document.library = library
        return document

    def _configuration(self) -> Configuration:
        self.fault = ""
        try:
            return Configuration(self.choices.configuration, trusted=self.choices.trust)
        except WrongUsage as error:
            self.fault = str(error)
            return Configuration(isolated=True)
