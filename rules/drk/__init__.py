"""Drake: its own elements, and what it does not support."""
