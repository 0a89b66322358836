"""The keys of a configuration file: one table for reading, for the JSON Schema, for ``--show-settings``."""

from __future__ import annotations

from enum import Enum

from sdfcheck.source.record import NamedTuple


class Shape(Enum):
    """The form of a key's value."""

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
    """One key; ``default`` is how an unset key reads in TOML."""

    key: str
    shape: Shape
    default: str
    summary: str

    @property
    def attribute(self) -> str:
        """The name of the key in ``Settings``."""
        return self.key.replace("-", "_")


FIELDS = (
    Field("extend", Shape.PATH, "", "A configuration file to build on; keys given here replace its keys."),
    Field("select", Shape.SELECTORS, "", "The rules to run; unset: all that are on by default."),
    Field("extend-select", Shape.SELECTORS, "[]", "Rules to run in addition to `select`."),
    Field("ignore", Shape.SELECTORS, "[]", "Rules not to run."),
    Field("preview", Shape.FLAG, "false", "Whether rules run that are not yet measured on public files."),
    Field("per-file-ignores", Shape.IGNORES, "{}", "File pattern → rules not to run on these files."),
    Field("severity", Shape.SEVERITIES, "{}", "Rule → severity, or `off`."),
    Field("target", Shape.TARGETS, "[]", "The consumers that the files are meant for; empty: all of them."),
    Field("exclude", Shape.PATTERNS, "[]", "Files and folders not to look at, as in a `.gitignore`."),
    Field("respect-gitignore", Shape.FLAG, "true", "Whether a walk leaves out what git ignores."),
    Field("plugins", Shape.STRINGS, "[]", "Rule packs to load: import names, or folders of `.py` files."),
    Field("fail-on", Shape.SEVERITY, '"warning"', "Exit with 1 if a finding is at least this severe."),
    Field(
        "output-format", Shape.STRINGS, '["full"]', "How to report: `concise`, to a file `sarif=out.sarif`."
    ),
    Field("model-paths", Shape.PATHS, "[]", "Folders in which `model://` is looked up."),
    Field("package-paths", Shape.PATHS, "[]", "Folders below which `package.xml` files are looked for."),
    Field("packages", Shape.PLACES, "{}", "Package name → its folder."),
    Field("env", Shape.STRINGS, "[]", "Environment variables that xacro may read."),
    Field("max-file-size", Shape.MEGABYTES, "256", "The size, in MB, from which on files are not read."),
    Field("xacro", Shape.ARGUMENTS, "{}", "File pattern → table of arguments, or a list of such tables."),
)
"""Every key, in the order in which it is documented."""
