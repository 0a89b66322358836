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
    "urdf/a.urdf": "",
}


LAUNCH = 'os.path.join(get_package_share_directory("arm"), "model", "arm.urdf")\n'
WHOLE = '<robot name="r"><link name="a"/></robot>'


class UninstalledFolder(Rule):
    """A package of ROS 2 does not install a folder that the robot needs, or installs one that is not there.

    After `colcon build`, `package://arm/meshes/a.obj` is looked for in the `share` folder of the package, where
    nothing is but what the build copies or links, also with `--symlink-install`: RViz and Gazebo show the robot without
    its meshes. So it is with a description that a launch file takes from `share`. Where `CMakeLists.txt` installs a
    folder that is not there, the build ends with an error. A build that gathers its folders by a pattern or a loop is
    not judged, nor one with conditions.
    """

    code = "RES029"
    name = "uninstalled-folder"
    severity = Severity.WARNING
    remedy = """Name the folder in the file that the message names.

    In `CMakeLists.txt`: `install(DIRECTORY meshes urdf DESTINATION share/${PROJECT_NAME})`. In the `data_files` of
    `setup.py`: `("share/arm/meshes", glob("meshes/*"))`. Leave out a folder that is not there.
    """
    looks_at = (Root,)
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
        Bad(
            WHOLE.replace("robot", "«robot»", 1),
            scaffold="{}",
            files={
                "package.xml": MANIFEST.format("ament_cmake"),
                "CMakeLists.txt": LISTS.format("launch urdf"),
                "urdf/a.urdf": "",
            },
            says="`CMakeLists.txt` of package `arm` installs `launch`, which is not there",
        ),
        Bad(
            WHOLE.replace("robot", "«robot»", 1),
            scaffold="{}",
            file="model/arm.urdf",
            files=PACKAGE | {"launch/arm.launch.py": LAUNCH},
            says="does not install `model`, from which `arm.launch.py` takes this file",
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
        return bool(root.unbuilt) or any(resource.uninstalled for resource in root.resources)

    def check(self, root: Root) -> Iterator[Diagnostic]:
        uses: dict[tuple[str, str, str], list[Resource]] = {}
        for resource in root.resources:
            if (found := resource.uninstalled) is not None:
                uses.setdefault(found, []).append(resource)
        for (package, folder, build), resources in uses.items():
            message = f"`{build}` of package `{package}` does not install `{folder}`{used(len(resources))}"
            yield self.diagnostic(resources[0].uri_value, message)
        for each in root.unbuilt:
            yield self.diagnostic(root.element, f"`{each.build}` of package `{each.package}` {each.words}")
