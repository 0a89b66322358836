"""Rules, and what runs them; the package can be called: ``sdfcheck.lint("robot.sdf")``."""

from sdfcheck.source.record import make_callable

make_callable(__name__)
