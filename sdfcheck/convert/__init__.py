"""Between formats; the package can be called: ``sdfcheck.convert("robot.urdf", "sdf")``."""

from sdfcheck.source.callable_package import make_callable

make_callable(__name__)
