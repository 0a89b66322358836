"""Linter and converter for SDFormat, URDF and xacro robot descriptions."""

__version__ = "0.1.0"
