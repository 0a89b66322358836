from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Rule, Severity, World

WHEEL = (
    '<link name="{0}"><pose>0 {1} 0.1 0 0 0</pose></link><joint name="{0}_joint" type="revolute"><parent>l</parent>'
    "<child>{0}</child><axis><xyz>0 1 0</xyz></axis></joint>"
)
DRIVE = (
    '<plugin filename="gz-sim-diff-drive-system" name="gz::sim::systems::DiffDrive"><left_joint>left_joint</left_joint>'
    "<right_joint>right_joint</right_joint></plugin>"
)


def car(pose: str, *, more: str = DRIVE) -> str:
    """A world with a car of two wheels."""
    wheels = WHEEL.format("left", "0.2") + WHEEL.format("right", "-0.2")
    model = f'<model name="car"><pose>{pose}</pose><link name="l"/>{wheels}{more}</model>'
    return f'<sdf version="1.9"><world name="w">{model}</world></sdf>'


class LyingVehicle(Rule):
    """A vehicle lies on its side at the start, with the axes of its wheels upright.

    The last three numbers of a pose are roll, pitch and yaw: a quarter turn to the left is the last of them. A roll of
    1.57 lays the vehicle on its right side, where its wheels turn in the air.
    """

    code = "GEO027"
    name = "lying-vehicle"
    severity = Severity.WARNING
    remedy = """Write the turn as yaw, the last number of the pose: `<pose>2 3 0 0 0 1.57</pose>`.

    In the specification, roll turns about x, pitch about y, and yaw about z, which points up.
    """
    looks_at = (World,)
    scaffold = "{}"

    bad = (
        Bad(
            car("«2 3 0.5 1.57 0 0»"),
            says="model `car` starts on its side: the axes of its wheels point up",
        ),
    )
    good = (
        Good(car("2 3 0.5 0 0 1.57")),
        Good(car("2 3 0.5 0.3 0 1.57"), why="a ramp"),
        Good(car("2 3 0.5 1.57 0 0", more=""), why="nothing drives the wheels"),
    )

    @staticmethod
    def applies(world: World) -> bool:
        return next(world.lying, None) is not None

    def check(self, world: World) -> Iterator[Diagnostic]:
        for model in world.lying:
            pose = model.pose_element
            message = f"{model.title} starts on its side: the axes of its wheels point up"
            yield self.diagnostic(pose.own_value if pose is not None else model, message)
