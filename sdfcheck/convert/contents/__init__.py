"""What a robot has beyond bodies and joints that move: sensors, plugins, materials, surfaces, custom data."""
