from setuptools import setup

NAME = "ament_sdfcheck"

setup(
    name=NAME,
    version="0.1.0",
    packages=[NAME],
    data_files=[
        (f"share/{NAME}", ["package.xml"]),
        ("share/ament_index/resource_index/packages", [f"resource/{NAME}"]),
    ],
    install_requires=["setuptools", "sdfcheck"],
    zip_safe=True,
    maintainer="The sdfcheck authors",
    maintainer_email="maintainers@sdfcheck.example",
    description="Checks SDFormat, URDF and xacro files with sdfcheck.",
    license="Apache-2.0",
    extras_require={"test": ["pytest"]},
    entry_points={
        "console_scripts": [f"ament_sdfcheck = {NAME}.main:run"],
        "pytest11": [f"ament_sdfcheck = {NAME}.pytest_marker"],
    },
)
