"""Runs sdfcheck as one of the linters of ament."""
