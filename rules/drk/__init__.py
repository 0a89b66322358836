"""Drake: its own elements, and what it does not support."""

SOURCES = ("https://drake.mit.edu/doxygen_cxx/group__multibody__parsing.html",)
