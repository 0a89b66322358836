"""NS: namespaces and custom elements, after the custom-elements proposal of SDFormat 1.7."""

SOURCES = (
    "http://sdformat.org/tutorials?tut=custom_elements_attributes_proposal",
    "https://www.w3.org/TR/xml-names/",
)
