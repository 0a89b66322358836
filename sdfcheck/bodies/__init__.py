"""Meshes: what their files hold, and what consumers can read of them."""
