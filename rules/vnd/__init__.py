"""Vendors' own elements, by the tables that packs bring."""

SOURCES = ("http://sdformat.org/tutorials?tut=custom_elements_attributes_proposal",)
