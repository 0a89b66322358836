"""The settings of a run, each declared in one place.

A declaration has the name, the type and the default, the form and the words for configuration files
and, for what a caller may set as well, the option. Keys of configuration files and their JSON Schema,
options of commands, keywords of functions and settings of the language server follow from it.
"""

from __future__ import annotations

import os
import re
from pathlib import Path
from typing import TYPE_CHECKING, Any

from sdfcheck.files.library import SearchPaths
from sdfcheck.files.regular import MEGABYTE, SIZE_LIMIT, Configured
from sdfcheck.lint.diagnostic import Severity
from sdfcheck.source.errors import WrongUsage
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.text import relative_path, shown

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence
    from typing import TypedDict

    class Given(TypedDict, total=False):
        """The settings that a caller may set, for those who check types."""

        select: Sequence[str] | None
        extend_select: Sequence[str]
        ignore: Sequence[str]
        preview: bool | None
        target: Sequence[str] | None
        model_paths: Sequence[str | os.PathLike[str]]
        package_paths: Sequence[str | os.PathLike[str]]
        packages: Mapping[str, str | os.PathLike[str]]
        env: Sequence[str]


ArgumentSet = tuple[tuple[str, str], ...]
"""Names and values of xacro arguments."""


class Pattern:
    """A pattern as in a ``.gitignore`` that lies in ``root``; ValueError if it is not valid."""

    __slots__ = ("_spec", "glob", "root")

    def __init__(self, root: Path, glob: str) -> None:
        from pathspec import GitIgnoreSpec

        self.root = root
        self.glob = glob
        self._spec = GitIgnoreSpec.from_lines([glob])

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Pattern) and (self.root, self.glob) == (other.root, other.glob)

    def __hash__(self) -> int:
        return hash((self.root, self.glob))

    def __repr__(self) -> str:
        return f"Pattern({str(self.root)!r}, {self.glob!r})"

    def matches(self, path: Path) -> bool:
        """Whether the pattern holds for a file, or for a folder above it."""
        return bool(self.verdict(path))

    def verdict(self, path: Path) -> bool | None:
        """The same, but False if a pattern with ``!`` holds, and None if none does."""
        relative = relative_path(path, self.root).replace(os.sep, "/")
        return None if relative.startswith("../") else self._spec.check_file(relative).include


class ConfigFile(NamedTuple):
    """A configuration file's text, and the folder that its relative paths start from."""

    path: Path
    text: str
    root: Path

    def error(self, message: str, *keys: str) -> WrongUsage:
        """The complaint, placed where the last of ``keys`` is after the others."""
        return WrongUsage(f"{shown(self.path)}:{line_of(self.text, keys)}: {message}")


def line_of(text: str, keys: tuple[str, ...]) -> int:
    """The line of the last of ``keys``, each looked for after the one before."""
    bare = re.sub(r"(?m)^[ \t]*#.*", lambda match: " " * len(match[0]), text)
    header = re.search(r"(?m)^[ \t]*\[\s*tool\.sdfcheck\b", bare)
    place = header.start() if header else 0
    for key in keys:
        found = re.compile(rf"(?<![\w-]){re.escape(key)}(?![\w-])").search(bare, place)
        if found:
            place = found.start()
    return bare.count("\n", 0, place) + 1


class Shape:
    """The form of a setting's value, in words."""

    SELECTORS = "a list of rule codes, names or families"
    PATTERNS = "a list of patterns"
    TARGETS = "a list of targets"
    STRINGS = "a list of strings"
    PATHS = "a list of paths"
    PATH = "a path"
    FLAG = "true or false"
    MEGABYTES = "a number of megabytes"
    SEVERITY = "a severity"
    SEVERITIES = "a table of severities"
    IGNORES = "a table of lists of rule codes, names or families"
    PLACES = "a table of paths"
    ARGUMENTS = "a table of argument tables"


class Field(NamedTuple):
    """The declaration of a setting; ``default`` is how an unset key reads in TOML, ``value`` the same in Python.

    ``option`` is the flag of commands, with what follows it; a caller cannot set one without.
    """

    key: str
    shape: str
    default: str
    summary: str
    option: str = ""
    value: Any = None

    @property
    def attribute(self) -> str:
        """The name in ``Settings``."""
        return self.key.replace("-", "_")


def _field(value: object, shape: str, default: str, summary: str, option: str = "") -> Any:
    return Field("", shape, default, summary, option, value)


class Settings(NamedTuple):
    """The settings for a file; the defaults apply where nothing is set.

    ``files`` are the configuration file and those that it extends, none if there is none. ``given``
    is set by the caller, above the configuration; None in it leaves a setting to that.
    """

    select: tuple[str, ...] | None = _field(
        None,
        Shape.SELECTORS,
        "",
        "The rules to run (codes, names, families, ALL), by default those that are on.",
        "--select RULE,…",
    )
    extend_select: tuple[str, ...] = _field(
        (),
        Shape.SELECTORS,
        "[]",
        "Rules to run, too, beside those that are selected.",
        "--extend-select RULE,…",
    )
    ignore: tuple[str, ...] = _field((), Shape.SELECTORS, "[]", "Rules not to run.", "--ignore RULE,…")
    preview: bool | None = _field(
        False, Shape.FLAG, "false", "Also run rules that are not yet measured on public files.", "--preview"
    )
    per_file_ignores: tuple[tuple[Pattern, tuple[str, ...]], ...] = _field(
        (), Shape.IGNORES, "{}", "File pattern → rules not to run on these files."
    )
    severity: tuple[tuple[str, Severity | None], ...] = _field(
        (), Shape.SEVERITIES, "{}", "Rule → severity, or `off`."
    )
    target: tuple[str, ...] | None = _field(
        (), Shape.TARGETS, "[]", "Keep the rules that matter to these consumers.", "--target CONSUMERS"
    )
    exclude: tuple[Pattern, ...] = _field(
        (), Shape.PATTERNS, "[]", "Files and folders not to look at, as in a `.gitignore`."
    )
    respect_gitignore: bool = _field(True, Shape.FLAG, "true", "Whether a walk leaves out what git ignores.")
    plugins: tuple[str, ...] = _field(
        (), Shape.STRINGS, "[]", "Rule packs to load: import names, or folders of `.py` files."
    )
    fail_on: Severity = _field(
        Severity.WARNING, Shape.SEVERITY, '"warning"', "Exit with 1 if a finding is at least this severe."
    )
    output_format: tuple[str, ...] = _field(
        ("full",), Shape.STRINGS, '["full"]', "How to report: `concise`, to a file `sarif=out.sarif`."
    )
    model_paths: tuple[Path, ...] = _field(
        (), Shape.PATHS, "[]", "Folders in which to look for models.", "--model-path FOLDER"
    )
    package_paths: tuple[Path, ...] = _field(
        (), Shape.PATHS, "[]", "Folders below which to look for ROS packages.", "--package-path FOLDER"
    )
    packages: tuple[tuple[str, Path], ...] = _field(
        (), Shape.PLACES, "{}", "Where ROS packages are: name and folder.", "--package NAME=PATH"
    )
    env: tuple[str, ...] = _field(
        (), Shape.STRINGS, "[]", "Environment variables that xacro may read.", "--env NAME"
    )
    max_file_size: float = _field(
        SIZE_LIMIT / MEGABYTE, Shape.MEGABYTES, "256", "The size, in MB, from which on files are not read."
    )
    xacro: tuple[tuple[Pattern, tuple[ArgumentSet, ...]], ...] = _field(
        (), Shape.ARGUMENTS, "{}", "File pattern → table of arguments, or a list of such tables."
    )
    files: tuple[ConfigFile, ...] = ()
    given: Settings | None = None

    @property
    def size_limit(self) -> Configured:
        """The size up to which files are read, in bytes."""
        return Configured(self.max_file_size * MEGABYTE)

    @property
    def search(self) -> SearchPaths:
        """Where models and packages are looked for, and tables of vendors."""
        return SearchPaths(self.model_paths, self.package_paths, self.packages, tables=self.tables)

    @property
    def tables(self) -> tuple[Path, ...]:
        """The tables of vendors' own elements that the plugins bring."""
        if not self.plugins:
            return ()
        from sdfcheck.lint.rulebook.plugins import tables_of

        return tables_of(self.plugins)

    def under(self, given: Settings) -> Settings:
        """The settings with those of the caller above them: places and variables are added to the configured ones."""
        if given is UNSET:
            return self
        return self._replace(
            given=given,
            model_paths=(*given.model_paths, *self.model_paths),
            package_paths=(*given.package_paths, *self.package_paths),
            packages=(*self.packages, *given.packages),
            env=(*self.env, *given.env),
        )

    def excludes(self, path: Path) -> bool:
        """Whether ``exclude`` names a file; the last pattern with an opinion decides."""
        verdicts = (pattern.verdict(path) for pattern in reversed(self.exclude))
        return next((verdict for verdict in verdicts if verdict is not None), False)

    def ignored_for(self, path: Path) -> tuple[str, ...]:
        """The selectors that ``per-file-ignores`` has for a file."""
        return tuple(s for pattern, given in self.per_file_ignores if pattern.matches(path) for s in given)

    def arguments_for(self, path: Path) -> tuple[ArgumentSet, ...]:
        """The sets of xacro arguments for a file; the last pattern that matches decides."""
        sets = [given for pattern, given in self.xacro if pattern.matches(path)]
        return sets[-1] if sets else ()

    def misplaced(self, selector: str, message: str) -> WrongUsage:
        """The complaint about a selector, placed in the file that uses it."""
        file = next((file for file in self.files if selector in file.text), None)
        return file.error(message, selector) if file else WrongUsage(message)


FIELDS: tuple[Field, ...] = (
    Field("extend", Shape.PATH, "", "A configuration file to build on; keys given here replace its keys."),
    *(
        field._replace(key=name.replace("_", "-"))
        for name, field in Settings._field_defaults.items()
        if isinstance(field, Field)
    ),
)
"""Every setting, in the order in which it is documented."""
Settings._field_defaults.update({field.attribute: field.value for field in FIELDS[1:]})
GIVEN = {field.attribute: field for field in FIELDS if field.option}
"""The settings that a caller may set, too, by their names."""
UNSET = Settings()._replace(preview=None, target=None)
"""The settings of a caller who sets none."""
