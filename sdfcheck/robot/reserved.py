"""The names that the format itself gives, and the kinds of part that have a frame."""

from __future__ import annotations

MODEL_FRAME = "__model__"
WORLD_FRAME = "world"
NODES = frozenset({"link", "joint", "frame", "model"})
