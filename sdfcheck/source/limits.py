"""The limits of what is read of a text."""

from __future__ import annotations

DEPTH_LIMIT = 256
"""How deep elements may be nested. libxml2 stops there; tinyxml2, which libsdformat uses, ends at 500."""

ATTRIBUTE_LIMIT = 1000
"""The most attributes of an element that are read."""

LENGTH_LIMIT = 10_000_000
"""The longest text or value, in characters: libxml2's bound, which consumers in Python have."""
