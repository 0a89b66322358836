"""XML: the text itself, in every dialect."""
