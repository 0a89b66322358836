"""The least work of any linter in Python: load click and lxml, parse, look at each element once."""

import sys

import click
from lxml import etree


def _parse(path: str) -> etree._Element:
    try:
        return etree.parse(path).getroot()
    except etree.XMLSyntaxError:
        root = etree.parse(path, etree.XMLParser(recover=True)).getroot()
        return etree.Element("nothing") if root is None else root


def main(paths: list[str]) -> None:
    count = 0
    for path in paths:
        for element in _parse(path).iter(etree.Element):
            _ = element.tag, element.attrib, element.text
            count += 1
    click.echo(count)


if __name__ == "__main__":
    main(sys.argv[1:])
