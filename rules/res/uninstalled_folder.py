from collections.abc import Iterator

from sdfcheck import IN_URDF_LINK, Bad, Diagnostic, Good, Resource, Root, Rule, Severity, used

MESH = '<visual><geometry><mesh filename="{}"/></geometry></visual>'
MANIFEST = "<package><name>arm</name><buildtool_depend>{}</buildtool_depend></package>"
LISTS = """project(arm)
install(DIRECTORY {} DESTINATION share/${{PROJECT_NAME}})
ament_package()
"""
OBJ = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"
PACKAGE = {
    "package.xml": MANIFEST.format("ament_cmake"),
    "CMakeLists.txt": LISTS.format("urdf"),
    "meshes/a.obj": OBJ,
}


class UninstalledFolder(Rule):
    """A robot names files of a folder that its package of ROS 2 does not install.

    After `colcon build`, `package://arm/meshes/a.obj` is looked for in the `share` folder of the package, where
    nothing is but what the build copies or links, also with `--symlink-install`: RViz and Gazebo show the robot without
    its meshes. A build that gathers its folders by a pattern or a loop is not judged.
    """

    code = "RES029"
    name = "uninstalled-folder"
    severity = Severity.WARNING
    remedy = """Name the folder in the file that the message names.

    In `CMakeLists.txt`: `install(DIRECTORY meshes urdf DESTINATION share/${PROJECT_NAME})`. In the `data_files` of
    `setup.py`: `("share/arm/meshes", glob("meshes/*"))`.
    """
    looks_at = (Root,)
    needs = ("package://",)
    scaffold = IN_URDF_LINK

    bad = (
        Bad(
            MESH.format("«package://arm/meshes/a.obj»") + MESH.format("package://arm/meshes/a.obj"),
            files=PACKAGE,
            says="`CMakeLists.txt` of package `arm` does not install `meshes` (used 2 times)",
        ),
        Bad(
            MESH.format("«package://arm/meshes/a.obj»"),
            files={
                "package.xml": MANIFEST.format("ament_python"),
                "setup.py": 'setup(data_files=[("share/arm/urdf", ["urdf/arm.urdf"])])',
                "meshes/a.obj": OBJ,
            },
            says="`setup.py` of package `arm` does not install `meshes`",
        ),
    )
    good = (
        Good(
            MESH.format("package://arm/meshes/a.obj"),
            files=PACKAGE | {"CMakeLists.txt": LISTS.format("urdf meshes")},
        ),
        Good(
            MESH.format("package://arm/meshes/a.obj"),
            files=PACKAGE | {"CMakeLists.txt": LISTS.format("${FOLDERS}")},
            why="a variable may hold the folder",
        ),
        Good(
            MESH.format("package://arm/meshes/a.obj"),
            files=PACKAGE | {"package.xml": MANIFEST.format("catkin")},
            why="catkin finds it where it is",
        ),
    )

    @staticmethod
    def applies(root: Root) -> bool:
        return any(resource.uninstalled for resource in root.resources)

    def check(self, root: Root) -> Iterator[Diagnostic]:
        uses: dict[tuple[str, str, str], list[Resource]] = {}
        for resource in root.resources:
            if (found := resource.uninstalled) is not None:
                uses.setdefault(found, []).append(resource)
        for (package, folder, build), resources in uses.items():
            message = f"`{build}` of package `{package}` does not install `{folder}`{used(len(resources))}"
            yield self.diagnostic(resources[0].uri_value, message)
