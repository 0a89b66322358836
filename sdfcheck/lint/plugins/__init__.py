"""Packs of rules from elsewhere: found, loaded, judged, and run with care."""
