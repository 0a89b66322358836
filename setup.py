"""Lists the packages: the engine, and ``rules/`` under its import name ``sdfcheck_rules``."""

from setuptools import find_namespace_packages, find_packages, setup

_FAMILIES = find_namespace_packages("rules", exclude=["*__pycache__*"])

setup(
    packages=[
        *find_packages(include=["sdfcheck", "sdfcheck.*"]),
        "sdfcheck_rules",
        *(f"sdfcheck_rules.{family}" for family in _FAMILIES),
    ],
    package_dir={"sdfcheck_rules": "rules"},
)
