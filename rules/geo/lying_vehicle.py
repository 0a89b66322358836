from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Model, Rule, Severity, World

MOST = 200
"""Includes of a world: of more than that most are rows of one."""
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
    looks_at = (Model, World)
    selects = ("sdf:model", "sdf:world")
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
    def applies(part: Model | World) -> bool:
        return any(True for _ in lying(part))

    def check(self, part: Model | World) -> Iterator[Diagnostic]:
        for model in lying(part):
            pose = model.pose_element
            message = f"{model.title} starts on its side: the axes of its wheels point up"
            yield self.diagnostic(pose.own_value if pose is not None else model, message)


def lying(part: Model | World) -> Iterator[Model]:
    """The model, or those that a world includes, that start on their side."""
    if isinstance(part, Model):
        yield from (part,) if part.is_on_its_side else ()
        return
    included = [model for model in part.models if model.include is not None]
    yield from (model for model in included[:MOST] if model.is_on_its_side)
