"""NAM: names and scoped names."""
