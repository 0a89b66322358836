"""MuJoCo: what its consumer of URDF does not take."""

SOURCES = ("https://mujoco.readthedocs.io/en/stable/modeling.html",)
