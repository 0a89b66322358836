"""ROS packages without ROS: where the folder of a package is. Everything here only reads."""

from __future__ import annotations

import os
import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from itertools import islice
from pathlib import Path

from sdfcheck.files.regular import MEGABYTE, is_below, is_made_up, names_in, read_regular
from sdfcheck.source.text import pattern

FOLDER_LIMIT = 20_000
"""So many folders are looked into below one root, no more."""

_NAMES_LIMIT = 300_000
"""So many names of files of one project are kept."""

LAUNCHES, YAML = ("launch", "launch.xml", ".py"), (".yaml", ".yml")
"""The ends of the names of launch files and programs, and of files of parameters."""

TEMPLATE = ".in"
"""The suffix of a file of which CMake makes the one without it."""

_NAME = pattern(r"<name>\s*([^<\s]+)\s*</name>")
_COMMENT = pattern(r"<!--.*?(?:-->|\Z)", re.DOTALL)
_FOREIGN = frozenset({"build", "install", "log", "devel", "node_modules", "site-packages", "__pycache__"})
_BUILT = ("install", "devel", "build")
_INSTALL = pattern(r"\binstall\s*\(\s*(DIRECTORY|FILES|PROGRAMS)\b([^()]*)\)", re.IGNORECASE)
_PROJECT = pattern(r"\bproject\s*\(\s*([\w.+-]+)", re.IGNORECASE)
_REMARK = pattern(r"#[^\n]*")
_PARTS = frozenset(
    {"config", "launch", "materials", "mesh", "meshes", "models", "robots", "stl", "urdf", "worlds", "xacro"}
)
"""Names of folders that packages have, and that no package has itself."""
_GATHERED = pattern(
    r"foreach|GLOB|\$\{CMAKE_CURRENT_SOURCE_DIR\}/?[\s\")]|DIRECTORY\s+\"?[.$]|INSTALL_TO_SHARE\s+\.|\bwalk\b|\*\*|listdir|"
    r"iterdir|rglob|find_packages?_data|package_files|generate_data_files",
    re.IGNORECASE,
)
"""Words of a build that gathers folders without their names."""
_GLOBBED = pattern(
    r"\*\*|\b(?:walk|listdir|scandir|iterdir|rglob|iglob|find_packages?_data|package_files|generate_data_files)\b|"
    r"(?<!\bglob)\.glob\(|\bglob\((?!\s*(?:(?:os\.)?(?:path\.)?join\(\s*)?[rb]?[\"'][\w.])"
)
"""The same in ``setup.py``, where a pattern is taken for the folder that it begins with."""
_GUARDED = pattern(
    r"\b(?:if|foreach|while|add_custom_command|add_custom_target|configure_file|file|execute_process|include|macro|function)\s*\(",
    re.IGNORECASE,
)
"""Words of a build that may install a folder under a condition, or make it."""
_MOST_INSTALLED = 100
"""So many commands of a build that install, and folders in one, are looked at."""
_TESTED = pattern(
    r"\bif\s*\(\s*BUILD_TESTING\s*\)(?:(?!\b(?:end)?if\s*\()[\s\S]){0,5000}\bendif\s*\([^)]*\)", re.IGNORECASE
)
_MADE = pattern(r"[$*<>\\]|^/|(?:^|/)\.\.(?:/|$)|^(?:PATTERN|FILES_MATCHING|USE_SOURCE_PERMISSIONS)$")
PYTHON = ("pyproject.toml", "setup.py", "requirements.txt")
"""One of them is in a project of Python."""
_STOP = frozenset(
    {"PATTERN", "FILES_MATCHING", "USE_SOURCE_PERMISSIONS", "PERMISSIONS", "RENAME", "OPTIONAL"}
)


def project_root(path: Path) -> Path:
    """The folder that a file's project fills: its workspace, else its repository, else what can be guessed.

    Without either it is the current folder if the file lies below it, else the folder
    above the outermost ``package.xml``, else the one above the file's own. The home
    folder, the one of temporary files and what is above them never count, but for a file
    that lies in one of them (see :func:`is_shared`).
    """
    own = list(_folders_around(os.path.abspath(path)))
    for folder in own:
        above, name = os.path.split(folder)
        if name == "src" and any(os.path.isdir(os.path.join(above, built)) for built in _BUILT):
            return Path(folder)
    for folder in own:
        if os.path.exists(os.path.join(folder, ".git")):
            return Path(folder)
    here = os.getcwd()
    if here in own:
        return Path(here)
    described = [folder for folder in own if os.path.isfile(os.path.join(folder, "package.xml"))]
    if described:
        above = os.path.dirname(described[-1])
        return Path(above if above in own else described[-1])
    return Path(own[1]) if len(own) > 1 else Path(os.path.abspath(path)).parent


def _folders_around(file: str) -> Iterator[str]:
    """The folders that a file is in, the innermost first, but for those that everyone's files share."""
    shared = _shared()
    folder, above = os.path.dirname(file), ""
    while folder != above:
        if not _holds_any(folder, shared):
            yield folder
        folder, above = os.path.dirname(folder), folder


def is_shared(folder: Path) -> bool:
    """Do everyone's files share a folder: is it home, one of temporary files, or above such a one?"""
    return _holds_any(os.path.abspath(folder), _shared())


def _shared() -> list[str]:
    return [os.path.join(folder, "") for folder in (os.path.expanduser("~"), *_temporary())]


def _holds_any(folder: str, folders: Sequence[str]) -> bool:
    own = os.path.join(folder, "")
    return any(one.startswith(own) for one in folders)


def _temporary() -> Iterator[str]:
    """The folders of temporary files, without the module that makes such files: it takes long to load."""
    for name in ("TMPDIR", "TEMP", "TMP"):
        if folder := os.environ.get(name):
            yield os.path.abspath(folder)
    if os.name == "posix":
        yield from ("/tmp", "/var/tmp")


class Packages:
    """Finds packages by name: those that were named, then those around, then those of a ROS installation.

    ``given`` maps names to folders; ``paths`` are folders below which to look for
    ``package.xml``; ``root`` is the project, of which the files in that folder alone count
    where it ``is_flat``; ``environment`` may hold
    ROS_PACKAGE_PATH and AMENT_PREFIX_PATH. The folder ``install`` of the workspace counts
    also where nothing is sourced.
    """

    __slots__ = (
        "_below",
        "_builds",
        "_called",
        "_folders",
        "_found",
        "_has_ros_files",
        "_installed",
        "_listed",
        "_own_prefixes",
        "environment",
        "given",
        "is_flat",
        "paths",
        "root",
    )

    def __init__(
        self,
        root: Path,
        given: Mapping[str, Path] | None = None,
        paths: Sequence[Path] = (),
        environment: Mapping[str, str] | None = None,
        *,
        is_flat: bool = False,
    ) -> None:
        self.root = root
        self.given = {name: Path(os.path.abspath(folder)) for name, folder in (given or {}).items()}
        self.paths = tuple(Path(os.path.abspath(folder)) for folder in paths)
        self.environment = dict(os.environ if environment is None else environment)
        self._below: dict[Path, dict[str, list[Path]]] = {}
        self._folders: dict[Path, tuple[str, ...]] = {}
        self._called: dict[Path, dict[str, list[str]]] = {}
        self._listed: list[tuple[str, list[str]]] | None = None
        self._found: dict[str, Path | None] = {}
        self._installed: dict[Path, list[tuple[str, str]]] = {}
        self._builds: dict[Path, Path | None] = {}
        self._has_ros_files: bool | None = None
        self._own_prefixes: list[Path] | None = None
        self.is_flat = is_flat

    def find(self, name: str, near: str | os.PathLike[str] = "") -> Path | None:
        """The folder of a package, of copies in the project the one nearest to a file; None if there is none."""
        if name not in self._found:
            self._found[name] = next(self._candidates(name), None)
        found, copies = self._found[name], self._below.get(self.root, {}).get(name, ())
        if len(copies) < 2 or found not in copies:
            return found
        return min(copies, key=lambda copy: _distance(copy, os.path.abspath(near)) if near else 0)

    def forget(self) -> None:
        """Look at the files in folders anew when they are asked for next."""
        self._listed = self._has_ros_files = None
        self._builds.clear()

    @property
    def searched(self) -> tuple[Path, ...]:
        """Where packages are looked for, in that order."""
        places = [*self.paths, self.root, *self._of_environment("ROS_PACKAGE_PATH")]
        places += [prefix / "share" for prefix in self._prefixes()]
        return tuple(dict.fromkeys(places))

    def survey(self) -> None:
        """Look everything up now that :meth:`find` may need."""
        for folder in self.searched:
            self._package_files(folder)

    @property
    def names(self) -> list[str]:
        """The packages that are there, sorted."""
        known = set(self.given)
        for folder in self.searched:
            known.update(self._package_files(folder))
        return sorted(known)

    def with_file(self, path: str) -> list[str]:
        """The packages of the project that have a file at a path."""
        found = self._package_files(self.root)
        return [name for name, copies in found.items() if any(has_file(copy, path) for copy in copies)]

    def trusted(self) -> tuple[Path, ...]:
        """The folders that a person or the ROS environment pointed out."""
        return (*self.given.values(), *self.paths, *self.sourced)

    @property
    def sourced(self) -> tuple[Path, ...]:
        """The folders that the ROS environment points out."""
        return (*self._of_environment("ROS_PACKAGE_PATH"), *self._of_environment("AMENT_PREFIX_PATH"))

    @property
    def own(self) -> tuple[Path, ...]:
        """The folders whose files belong to the project, or single ones: its own, and those of packages."""
        return (*self.places, *self.installed(), *self.trusted())

    @property
    def places(self) -> tuple[Path, ...]:
        """The project's folder, or the visible files in it that are no links."""
        return tuple(self._files_beside()) if self.is_flat else (self.root,)

    def locate(self, path: Path) -> Path:
        """The file that a path into a package leads to, which may hold only once the package is installed.

        ``<package>/urdf/arm.xacro`` is ``<package>/description/urdf/arm.xacro`` if
        CMakeLists.txt installs it so, and ``arm.xacro.in`` if a build makes it of that, or ``arm.urdf.xacro``
        where CMakeLists.txt has it expanded. A path that leads nowhere is returned as it is.
        """
        if os.path.exists(path):
            return path
        if (lists := self._lists_above(path.parent)) is not None:
            folder = lists.parent
            rest = path.relative_to(folder).as_posix()
            for installed, source in self._layout(folder, lists):
                if rest == installed or rest.startswith(f"{installed}/") or not installed:
                    found = folder / source / rest[len(installed) :].lstrip("/")
                    if os.path.exists(found):
                        return found
            expanded = path.with_name(f"{path.name}.xacro")
            if (
                path.suffix == ".urdf"
                and os.path.isfile(expanded)
                and "xacro_add_" in _REMARK.sub("", _read(lists))
            ):
                return expanded
        template = path.with_name(path.name + TEMPLATE)
        return template if os.path.isfile(template) else path

    @property
    def has_ros_files(self) -> bool:
        """Has the project files that may be launch files or parameters of nodes?"""
        if self._has_ros_files is None:
            ends = (*LAUNCHES, *YAML)
            self._has_ros_files = any(name.endswith(ends) for _, names in self._listings() for name in names)
        return self._has_ros_files

    def files(
        self, suffix: str, limit: int, is_meant: Callable[[str, str], bool] | None = None
    ) -> Iterator[Path]:
        """The project's files of one suffix, at most ``limit``; ``is_meant`` chooses by the folder and the name."""
        count = 0
        roots = tuple(os.path.realpath(folder) for folder in self.own)
        for folder, names in self._listings():
            for name in names:
                if not name.endswith(suffix) or (is_meant is not None and not is_meant(folder, name)):
                    continue
                path = os.path.join(folder, name)
                if os.path.islink(path) and not is_below(os.path.realpath(path), roots):
                    continue
                count += 1
                if count > limit:
                    return
                yield Path(path)

    def models(self, name: str, near: str) -> list[str]:
        """The project's folders of a model, the nearest to a folder first."""
        found = (
            folder for folder in self._folders_called(name, self.root) if "model.config" in names_in(folder)
        )
        here = os.path.abspath(near)
        return sorted(found, key=lambda each: (_distance(each, here), each))

    def _files_beside(self) -> Iterator[Path]:
        for name in names_in(self.root)[:FOLDER_LIMIT]:
            path = self.root / name
            if name[0] != "." and os.path.isfile(path) and not os.path.islink(path):
                yield path

    def _candidates(self, name: str) -> Iterator[Path]:
        if name in self.given:
            yield self.given[name]
        for folder in (*self.paths, self.root, *self._of_environment("ROS_PACKAGE_PATH")):
            yield from self._package_files(folder).get(name, ())
        for prefix in self._prefixes():
            if os.path.isdir(share := prefix / "share" / name):
                yield share
        for folder in (*self.paths, self.root):
            same = self._folders_called(name, folder)
            # A submodule that is not checked out is empty.
            if len(same) == 1 and names_in(same[0]) and not is_part(same[0]):
                yield Path(same[0])

    def _package_files(self, root: Path) -> dict[str, list[Path]]:
        """Package name → folders, of every ``package.xml`` below a folder."""
        known = self._below.get(root)
        if known is None:
            known = {}
            for folder in self._folders_below(root):
                name = _package_name(os.path.join(folder, "package.xml"))
                if name:
                    known.setdefault(name, []).append(Path(folder))
            self._below[root] = known
        return known

    def _folders_below(self, root: Path) -> tuple[str, ...]:
        if root not in self._folders:
            is_alone = self.is_flat and root == self.root and root not in self.paths
            self._folders[root] = (os.fspath(root),) if is_alone else tuple(_folders(root))
        return self._folders[root]

    def _folders_called(self, name: str, root: Path) -> list[str]:
        called = self._called.get(root)
        if called is None:
            called = self._called[root] = {}
            for folder in self._folders_below(root):
                called.setdefault(os.path.basename(folder), []).append(folder)
        return called.get(name, [])

    def _listings(self) -> Iterator[tuple[str, list[str]]]:
        """The project's folders with the names in them, kept for the next question unless they are many."""
        if self._listed is not None:
            yield from self._listed
            return
        listed, count = [], 0
        for folder in self._folders_below(self.root):
            names = names_in(folder)
            count += len(names)
            if count <= _NAMES_LIMIT:
                listed.append((folder, names))
            yield folder, names
        if count <= _NAMES_LIMIT:
            self._listed = listed

    def _of_environment(self, variable: str) -> list[Path]:
        entries = self.environment.get(variable, "").split(os.pathsep)
        return [Path(os.path.abspath(entry)) for entry in entries if entry]

    def installed(self) -> tuple[Path, ...]:
        """The folders that the workspace installs packages in; what links in them lead to is not among it."""
        sourced = self._of_environment("AMENT_PREFIX_PATH")
        return tuple(prefix for prefix in self._prefixes() if prefix not in sourced)

    def _prefixes(self) -> list[Path]:
        """The folders that packages are installed in: those of the environment, then those of the workspace."""
        if self.is_flat:
            self._own_prefixes = []
        if self._own_prefixes is None:
            workspace = self.root.parent if self.root.name == "src" else self.root
            own = workspace / "install"
            below = [own / name for name in names_in(own)]
            real = os.path.join(os.path.realpath(workspace), "")
            self._own_prefixes = [
                folder
                for folder in (own, *below)
                if os.path.isdir(folder / "share") and os.path.realpath(folder).startswith(real)
            ]
        return [*self._of_environment("AMENT_PREFIX_PATH"), *self._own_prefixes]

    def _lists_above(self, folder: Path) -> Path | None:
        """The nearest CMakeLists.txt in a folder or above it."""
        if folder not in self._builds:
            every = (each / "CMakeLists.txt" for each in (folder, *folder.parents))
            self._builds[folder] = next(filter(os.path.isfile, every), None)
        return self._builds[folder]

    def _layout(self, folder: Path, lists: Path) -> list[tuple[str, str]]:
        if folder not in self._installed:
            self._installed[folder] = list(islice(_install_rules(_read(lists)), _MOST_INSTALLED))
        return self._installed[folder]


def _distance(folder: str | Path, here: str) -> int:
    """The distance of a folder to a path: the more of their ways they share, the less."""
    try:
        return -len(os.path.commonpath((os.path.abspath(folder), here)))
    except ValueError:  # another drive
        return 0


def _folders(root: Path) -> Iterator[str]:
    """The folder and those below it, without hidden ones and what build tools write."""
    # By hand: before Python 3.12 `os.walk` calls itself, and folders may be deep.
    waiting, count = [os.fspath(root)], 0
    while waiting and count < FOLDER_LIMIT:
        folder = waiting.pop()
        if is_made_up(folder):  # below the root of the system
            continue
        try:
            with os.scandir(folder) as entries:
                below = [entry.name for entry in entries if entry.is_dir(follow_symlinks=False)]
        except OSError:
            continue
        count += 1
        waiting += sorted(
            (os.path.join(folder, name) for name in below if name[0] != "." and name not in _FOREIGN),
            reverse=True,
        )
        yield folder


def package_around(path: str | os.PathLike[str]) -> tuple[str, str] | None:
    """The folder and the name of the package that a file is in, by the nearest ``package.xml`` above it."""
    for folder in _folders_around(os.path.abspath(path)):
        if name := _package_name(os.path.join(folder, "package.xml")):
            return folder, name
    return None


def has_file(folder: str | os.PathLike[str], path: str) -> bool:
    """Has a folder a file at a path, and does that not lead out of it?"""
    real = os.path.realpath(os.path.join(folder, path))
    return is_below(real, (os.path.realpath(folder),)) and os.path.isfile(real)


def is_part(folder: str) -> bool:
    """Is a folder one in a package, which no program takes for a package of its name?

    One of meshes or the like, or one directly in the package that is not a model.
    """
    around, path = package_around(os.path.join(folder, "file")), os.path.abspath(folder)
    if around is None or around[0] == path:
        return False
    is_inner = os.path.dirname(path) == around[0] and not os.path.isfile(os.path.join(path, "model.config"))
    return is_inner or os.path.basename(path) in _PARTS


def is_of_ros_1(path: str | os.PathLike[str]) -> bool:
    """Is the package that a file is in built by catkin alone?"""
    manifest = _manifest_around(path)
    return "<buildtool_depend>catkin<" in manifest and "ament_" not in manifest


def is_of_ros_2(path: str | os.PathLike[str]) -> bool:
    """Is the package that a file is in built by ament alone?"""
    manifest = _manifest_around(path)
    return "ament_" in manifest and ">catkin<" not in manifest


def uninstalled(folder: str) -> tuple[str, str, str] | None:
    """A package of ROS 2, the folder in it that its build does not install, and the file that says what is installed.

    ``folder`` is the one itself, or one in it. None where it is installed, or where that is not certain.
    """
    around = package_around(os.path.join(folder, "file"))
    if around is None or not is_of_ros_2(os.path.join(folder, "file")):
        return None
    top = os.path.relpath(folder, around[0]).partition(os.sep)[0]
    build = next(
        (name for name in ("CMakeLists.txt", "setup.py") if os.path.isfile(os.path.join(around[0], name))), ""
    )
    text = _REMARK.sub("", _read(Path(around[0], build))) if build else ""
    is_named = re.search(rf"(?<![\w-]){re.escape(top)}(?![\w-])", text)
    gathered = _GLOBBED if build == "setup.py" else _GATHERED
    if top == os.curdir or not text or is_named or gathered.search(text):
        return None
    return around[1], top, build


def absent_installs(folder: str) -> tuple[str, str, tuple[str, ...]] | None:
    """A package of ROS 2 by its folder, its ``CMakeLists.txt``, and the absent folders of robots that this installs.

    None where there are none, or where a build may make them.
    """
    lists = os.path.join(folder, "CMakeLists.txt")
    text = _TESTED.sub("", _REMARK.sub("", _read(Path(lists)))) if os.path.isfile(lists) else ""
    if not text or _GUARDED.search(text) or not is_of_ros_2(lists):
        return None
    found = []
    for match in islice(_INSTALL.finditer(text), _MOST_INSTALLED):
        words = [word.strip('"') for word in match[2].split()]
        if match[1].upper() != "DIRECTORY" or "DESTINATION" not in words or "OPTIONAL" in words:
            continue
        named = words[: words.index("DESTINATION")]
        plain = [
            name.rstrip("/")
            for name in named[:_MOST_INSTALLED]
            if name.rstrip("/") and not _MADE.search(name)
        ]
        own = (name for name in plain if os.path.basename(name) in _PARTS)
        found += [name for name in own if not os.path.exists(os.path.join(folder, name))]
    name = _package_name(os.path.join(folder, "package.xml"))
    return (name, os.path.basename(lists), tuple(dict.fromkeys(found))) if found else None


def is_of_python(path: str | os.PathLike[str]) -> bool:
    """Is it in a project of Python, and in no package of ROS?"""
    for folder in _folders_around(os.path.abspath(path)):
        if os.path.isfile(os.path.join(folder, "package.xml")):
            return False
        if any(os.path.isfile(os.path.join(folder, name)) for name in PYTHON):
            return True
    return False


def _manifest_around(path: str | os.PathLike[str]) -> str:
    around = package_around(path)
    return "" if around is None else _COMMENT.sub("", _read(Path(around[0], "package.xml")))


def _package_name(path: str) -> str:
    match = _NAME.search(_COMMENT.sub("", _read(Path(path)))) if os.path.isfile(path) else None
    return match[1] if match else ""


def _read(path: Path) -> str:
    try:
        return read_regular(path, MEGABYTE).decode("utf-8", "replace")
    except OSError:
        return ""


def _install_rules(text: str) -> Iterator[tuple[str, str]]:
    """(place below the share folder, place in the source) of the folders and files that are installed."""
    text = _REMARK.sub("", text)
    project = _PROJECT.search(text)
    name = project[1] if project else ""
    for variable in ("${PROJECT_NAME}", "${CMAKE_PROJECT_NAME}"):
        text = text.replace(variable, name)
    for match in _INSTALL.finditer(text):
        words = [word.strip('"') for word in match[2].split()]
        if "DESTINATION" not in words:
            continue
        at = words.index("DESTINATION")
        destination = words[at + 1] if at + 1 < len(words) else ""
        for prefix in (f"share/{name}", "${CATKIN_PACKAGE_SHARE_DESTINATION}"):
            if destination == prefix or destination.startswith(f"{prefix}/"):
                below = destination[len(prefix) :].strip("/")
                yield from _installed(match[1].upper(), words[:at], below)


def _installed(kind: str, sources: list[str], below: str) -> Iterator[tuple[str, str]]:
    for source in sources:
        if source in _STOP:
            return
        plain = source.rstrip("/")
        own = "" if kind == "DIRECTORY" and source.endswith("/") else plain.rpartition("/")[2]
        if "$" not in source and plain:
            yield "/".join(part for part in (below, own) if part), plain
