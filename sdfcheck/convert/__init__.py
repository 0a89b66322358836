"""Between formats; the package can be called: ``sdfcheck.convert("robot.urdf", "sdf")``."""

from sdfcheck.source.record import make_callable

make_callable(__name__)
