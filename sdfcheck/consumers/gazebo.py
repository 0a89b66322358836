"""What Gazebo brings along."""

from __future__ import annotations

STANDARD_MODELS = frozenset({"ground_plane", "sun"})
"""Models without a robot in them that most worlds include, and most computers have."""
