"""Conditions for comparing a declaration of a prefix with others."""

from sdfcheck import PrefixDeclaration

XML_NAMESPACE = "http://www.w3.org/XML/1998/namespace"
XMLNS_NAMESPACE = "http://www.w3.org/2000/xmlns/"


def is_reserved(declaration: PrefixDeclaration) -> bool:
    """Does it give another meaning to the prefixes or names of XML itself?"""
    if declaration.prefix == "xml":
        return declaration.namespace != XML_NAMESPACE
    return declaration.prefix == "xmlns" or declaration.namespace in {XML_NAMESPACE, XMLNS_NAMESPACE}


def is_sound(declaration: PrefixDeclaration) -> bool:
    """Is nothing wrong with a declaration by itself?"""
    if not declaration.is_qualified or declaration.first is not None:
        return False
    return bool(declaration.namespace.strip()) and not is_reserved(declaration)
