"""Vendors' own elements, as the other dialect writes them."""
