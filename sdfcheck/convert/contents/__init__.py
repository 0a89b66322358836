"""Other contents of a robot than bodies and moving joints: sensors, plugins, materials, custom data."""
