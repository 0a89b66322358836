"""RES: files, includes and plugins."""
