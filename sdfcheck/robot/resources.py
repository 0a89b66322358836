"""Other files that a description names by URIs."""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from sdfcheck.files.library import library_of
from sdfcheck.robot.part import Part
from sdfcheck.robot.values import lazy
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.text import pattern

if TYPE_CHECKING:
    from sdfcheck.files.library import Disk
    from sdfcheck.files.packages import Packages
    from sdfcheck.files.uris import Location
    from sdfcheck.robot.includes.included import Obstacle
    from sdfcheck.robot.includes.uri_spelling import Misspelling, OtherCase
    from sdfcheck.robot.part import Whole
    from sdfcheck.source.document import Document, Element, Value


# Files that a description names by URIs, and where those lead.
#
# No simulator refuses a description of SDFormat for a mesh, texture, script or sound that
# is absent: it is shown without, and collides with nothing. Nothing is fetched, and
# nothing is read.


Index = Mapping[str, Sequence["Element"]]

_MAPS = (
    "albedo_map", "ambient_occlusion_map", "emissive_map", "environment_map", "glossiness_map", "light_map",
    "metalness_map", "normal_map", "roughness_map", "specular_map",
)  # fmt: skip
_PBR = frozenset({"metal", "specular", "shader"})

_PLACES: dict[str, frozenset[str]] = {
    "uri": frozenset({"mesh", "heightmap", "image", "script", "audio_source"}),
    "filename": frozenset({"mesh", "skin", "animation"}),
    "texture": frozenset({"projector"}),
    "diffuse": frozenset({"texture"}),
    "normal": frozenset({"texture"}),
    "cubemap_uri": frozenset({"sky"}),
    "color_range_image": frozenset({"particle_emitter"}),
    **dict.fromkeys(_MAPS, _PBR),
}
"""Elements of SDFormat whose text names a file, and the parents below which it does."""

_NAMES = pattern(r"[\w.-]+")
_LOOKED_UP = ("get_package_share", "FindPackageShare", "$(find")
"""Words by which a launch file looks a file up in the place where packages are installed."""
_WHAT = {"script": "material script", "skin": "mesh", "audio_source": "sound", "texture": "texture"}
_TEXTURED = frozenset({"projector", "sky"})
_SHIPPED = pattern(r"file://media/.*/|__default__")
"""The folders that Gazebo Classic brings along, and the word for nothing."""
_SHIPPED_ACTORS = frozenset(
    f"{name}.dae" for name in "moonwalk run sit_down sitting stand stand_up talk_a talk_b walk".split()
)
"""The skins and animations that Gazebo Classic brings along."""
_EXPRESSIONS = ("$(", "${")
_PICTURES = frozenset({"texture", "heightmap", "projector"})
_TEXTURE_FOLDERS = ("materials/textures", "../materials/textures", "../textures")


class FileUse(Part):
    """Something that names a file by a URI: an include, or a resource."""

    __slots__ = ()

    @property
    def uri_value(self) -> Value | None:
        """The URI with its place; None where there is none."""
        raise NotImplementedError

    @property
    def uri(self) -> str:
        """The URI without spaces around it; empty where there is none."""
        return self.uri_value.text.strip() if self.uri_value is not None else ""

    @property
    def obstacle(self) -> Obstacle | None:
        """Why what it names cannot be read; None for what is not read at all."""
        return None

    @lazy
    def location(self) -> Location | None:
        """Where the URI leads; None without a URI, and for a text that is not looked at among other files."""
        if self.uri_value is None or self.document.library is None:
            return None
        from sdfcheck.files.uris import locate

        return locate(self.document, self.uri_value.text)

    @property
    def empty_folder(self) -> str:
        """The folder without content in which it is looked for first, as of a submodule that is not checked out."""
        from sdfcheck.files.uris import empty_folder

        first = "" if self.location is None else self.location.first
        return empty_folder(self.document, first) if first else ""

    @property
    def is_ignored(self) -> bool:
        """Does git ignore the file where it is looked for first: does a build make it, or a download bring it?"""
        from sdfcheck.files.git import ignores_in
        from sdfcheck.files.library import library_of

        library = library_of(self.document)
        if self.location is None or library is None or not self.location.folders:
            return False
        path = self.location.first
        ignores = library.disk.view(os.path.dirname(os.path.abspath(path)), ignores_in)
        return ignores is None or ignores.ignore(Path(path), folder=False)

    @property
    def leads_nowhere(self) -> bool:
        """Is nothing where the URI leads, although it is one, and one that can be looked up here?"""
        raise NotImplementedError

    @property
    def is_absolute(self) -> bool:
        """Is it a path that holds on this computer alone?"""
        from sdfcheck.robot.includes.uri_spelling import is_absolute

        return self.uri_value is not None and is_absolute(self.uri_value)

    @lazy
    def misspelling(self) -> Misspelling | None:
        """The fault of the URI as a text, also where that explains why it leads nowhere."""
        if self.uri_value is None or self._misspelling is not None:
            return self._misspelling
        from sdfcheck.robot.includes.uri_spelling import misplaced_blanks

        return misplaced_blanks(self.uri_value) if self.leads_nowhere else None

    @lazy
    def _misspelling(self) -> Misspelling | None:
        from sdfcheck.robot.includes.uri_spelling import misspelling

        return None if self.uri_value is None else misspelling(self.uri_value)

    @lazy
    def other_case(self) -> OtherCase | None:
        """The file that the URI would lead to if case did not matter, where it leads nowhere."""
        if self.uri_value is None or not self.leads_nowhere or self.misspelling is not None:
            return None
        from sdfcheck.robot.includes.uri_spelling import other_case

        return None if self.location is None else other_case(self.uri_value, self.location)

    @property
    def is_missing(self) -> bool:
        """Is nothing where the URI leads, and is that not the fault of its spelling?"""
        return self.leads_nowhere and self.misspelling is None and self.other_case is None


class Resource(FileUse):
    """A mesh, texture, script or sound that a file names.

    Its ``element`` is the one that names it: ``uri``, ``albedo_map`` …, in URDF ``mesh`` and ``texture``.
    """

    __slots__ = ("_value",)
    kind = "resource"

    def __init__(self, holder: Part, element: Element, value: Value) -> None:
        super().__init__(holder, element)
        self._value = value

    @property
    def uri_value(self) -> Value:
        """The URI with its place."""
        return self._value

    @property
    def what(self) -> str:
        """Its kind: ``mesh``, ``texture``, ``material script`` …"""
        if self.is_urdf:
            return self.element.name
        holder, name = self.holder.element.name if self.holder is not None else "", self.element.name
        if name in _MAPS or holder in _TEXTURED:
            return "texture"
        return _WHAT.get(holder, holder)

    @lazy
    def leads_nowhere(self) -> bool:
        """Is nothing where the URI leads, although it is one, and one that can be looked up here?"""
        if self._misspelling is not None or self.is_absolute or self.location is None:
            return False
        if "/" not in self.uri and _is_for_gazebo(self.element):
            return False  # Gazebo knows where its own pictures are
        location = self.location
        if location.path is not None or not location.is_local:
            return False
        return not self._is_among_textures and not self.is_in_mesh_folder

    @lazy
    def meant_uri(self) -> str | None:
        """The URI of the same file in a package of the project, where its own package is not there."""
        location, library = self.location, library_of(self.document)
        if location is None or library is None or location.scheme != "package" or location.owner is not None:
            return None
        name, inside = location.name, location.inside
        if not inside:
            return None
        from sdfcheck.files.packages import has_file

        if (own := _own_package(self.document)) is not None:
            for path in (inside, f"{name}/{inside}"):
                if has_file(own[0], path):
                    return f"package://{own[1]}/{path}"
        others = library.packages(self.document.path).with_file(f"{name}/{inside}")
        return f"package://{others[0]}/{name}/{inside}" if len(others) == 1 else None

    @property
    def uninstalled(self) -> tuple[str, str, str] | None:
        """Its package of ROS 2, the folder in it that is not installed, and the file that says what is."""
        library, location = library_of(self.document), self.location
        if library is None or location is None or location.scheme != "package" or location.path is None:
            return None
        found = library.disk.view(os.path.dirname(location.path), _uninstalled)
        return found if found is not None and found[0] == location.name else None

    @property
    def _is_among_textures(self) -> bool:
        """Gazebo also looks for the bare name of a picture in the folders that models keep theirs in."""
        if self.what not in _PICTURES or "/" in self.uri:
            return False
        folder = self.document.path.parent
        return any(os.path.exists(folder / place / self.uri) for place in _TEXTURE_FOLDERS)

    @property
    def is_in_mesh_folder(self) -> bool:
        """MuJoCo looks for the bare name of a mesh in the folder that a robot names for that."""
        root = self.document.root
        settings = root.find("mujoco") if root is not None and self.what == "mesh" else None
        compiler = settings.find("compiler") if settings is not None else None
        if compiler is None or "meshdir" not in compiler.attributes:
            return False
        folder = self.document.path.parent / compiler.attributes["meshdir"]
        return os.path.exists(folder / os.path.basename(self.uri))


def _uninstalled(folder: str, disk: Disk) -> tuple[str, str, str] | None:
    from sdfcheck.files.packages import uninstalled

    return uninstalled(folder)


class Unbuilt(NamedTuple):
    """A folder that the build of a package gets wrong: the package, the file that says what is installed, and words."""

    package: str
    build: str
    words: str


def unbuilt(document: Document) -> Iterator[Unbuilt]:
    """The faults in the build of a description's package: its own folder is left out, or others are not there."""
    library, own = library_of(document), _own_package(document)
    if library is None or own is None:
        return
    absent = library.disk.view(own[0], _absent)
    if absent is not None:
        package, build, folders = absent
        names, verb = " and ".join(f"`{name}`" for name in folders[:3]), "are" if len(folders) > 1 else "is"
        more = f" (and {len(folders) - 3} more)" if len(folders) > 3 else ""
        yield Unbuilt(package, build, f"installs {names}{more}, which {verb} not there")
    left_out = library.disk.view(os.path.dirname(os.path.abspath(document.path)), _uninstalled)
    if left_out is not None and not left_out[1].startswith("test"):
        package, folder, build = left_out
        launches, wanted = library.of_project(document.path, _Launches).words, {package, document.path.name}
        named = next((path for path, words in launches if words >= wanted), None)
        if named is not None:
            yield Unbuilt(
                package, build, f"does not install `{folder}`, from which `{named.name}` takes this file"
            )


class _Launches:
    """The words of the launch files of a project that look files up in packages."""

    def __init__(self, packages: Packages) -> None:
        from sdfcheck.xacro.static.launches import launch_texts

        self.words = [
            (path, frozenset(_NAMES.findall(text)))
            for path, text in launch_texts(packages)
            if any(word in text for word in _LOOKED_UP)
        ]


def _absent(folder: str, disk: Disk) -> tuple[str, str, tuple[str, ...]] | None:
    from sdfcheck.files.packages import absent_installs

    return absent_installs(folder)


def _own_package(document: Document) -> tuple[str, str] | None:
    """The folder and the name of the package that a document is in, where others are looked up."""
    library = library_of(document)
    return None if library is None else library.disk.view(os.path.dirname(document.path), _package_with)


def _package_with(folder: str, disk: Disk) -> tuple[str, str] | None:
    from sdfcheck.files.packages import package_around

    return package_around(os.path.join(folder, "file"))


def resources_of(root: Whole) -> tuple[Resource, ...]:
    """The resources that a file names, of the same elements one after the other."""
    index, found = root.elements, []
    for value in filter(_is_literal, _named_in_urdf(index) if root.is_urdf else _named_in_sdf(index)):
        parent = value.element.parent
        assert parent is not None, "the root names no file"
        found.append(Resource(root.part_of(parent), value.element, value))
    return tuple(found)


def _is_literal(value: Value) -> bool:
    text = value.text.strip()
    is_shipped = _SHIPPED.match(text) is not None or text in _SHIPPED_ACTORS
    return bool(text) and not is_shipped and not any(mark in text for mark in _EXPRESSIONS)


class Pieces(Part):
    """Elements of a robot that no expansion of xacro shows; whatever comes around them, they name the same files."""

    __slots__ = ("elements",)
    kind = "pieces"

    def __init__(self, holder: Part, elements: Iterable[Element]) -> None:
        super().__init__(holder, None)
        self.elements = tuple(elements)

    @lazy
    def resources(self) -> tuple[Resource, ...]:
        """The meshes and textures, if the files of the project decide whether they are there."""
        index: dict[str, list[Element]] = {}
        for element in self.elements:
            index.setdefault(element.name, []).append(element)
        named = (Resource(self, value.element, value) for value in filter(_is_literal, _named_in_urdf(index)))
        return tuple(each for each in named if _is_decided(each))


def _is_decided(resource: Resource) -> bool:
    """Do the project's files alone show where a URI leads? Meshes as a whole may be kept elsewhere."""
    location = resource.location
    if location is None or location.path is not None or resource.meant_uri is not None:
        return True
    return any(_is_filled(os.path.dirname(path)) for path in location.tried)


def _is_filled(folder: str) -> bool:
    try:
        with os.scandir(folder) as entries:
            return any(not entry.name.startswith(".") for entry in entries)
    except OSError:
        return False


def _named_in_sdf(index: Index) -> Iterator[Value]:
    for name, parents in _PLACES.items():
        if name in index and any(parent in index for parent in parents):
            yield from _named_by(index[name])


def _named_in_urdf(index: Index) -> Iterator[Value]:
    """Meshes and textures; and what is in ``<gazebo>``."""
    for kind in ("mesh", "texture"):
        for element in index.get(kind, ()):
            value = element.attribute("filename")
            if value is not None and not _is_for_gazebo(element):
                yield value
    for name in _PLACES:
        yield from (value for value in _named_by(index.get(name, ())) if _is_for_gazebo(value.element))


def _named_by(elements: Iterable[Element]) -> Iterator[Value]:
    return (element.own_value for element in elements if names_file(element))


def names_file(element: Element) -> bool:
    """Is it one of those elements of SDFormat whose text names a file?"""
    return element.parent is not None and element.parent.name in _PLACES.get(element.name, ())


def _is_for_gazebo(element: Element) -> bool:
    return any(ancestor.name == "gazebo" for ancestor in element.around)
