"""Lists the packages: the engine with its folders of data, and ``rules/`` under its import name ``sdfcheck_rules``."""

from setuptools import find_namespace_packages, setup

_FAMILIES = find_namespace_packages("rules", exclude=["*__pycache__*"])

setup(
    packages=[
        *find_namespace_packages(include=["sdfcheck", "sdfcheck.*"], exclude=["*__pycache__*"]),
        "sdfcheck_rules",
        *(f"sdfcheck_rules.{family}" for family in _FAMILIES),
    ],
    package_dir={"sdfcheck_rules": "rules"},
)
