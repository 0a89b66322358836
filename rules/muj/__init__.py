"""MuJoCo: what it does not take in URDF."""

SOURCES = ("https://mujoco.readthedocs.io/en/stable/modeling.html",)
