"""The JSON Schema of a configuration file, for editors; made from the table of keys."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from sdfcheck.lint.config.settings import FIELDS, Field, Shape

_STRING = {"type": "string"}
_STRINGS = {"type": "array", "items": _STRING}
_SELECTOR = {"type": "string", "pattern": "^(ALL|[A-Z][A-Z0-9]*[A-Z][0-9]{0,3}|[a-z][a-z0-9-]*)$"}
_SELECTORS = {"type": "array", "items": _SELECTOR}
_LEVELS = ["error", "warning", "info"]
_ARGUMENTS = {"type": "object", "additionalProperties": {"type": ["string", "number", "boolean"]}}


def schema() -> dict[str, Any]:
    """The schema as JSON values."""
    return {
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "title": "sdfcheck configuration",
        "description": "sdfcheck.toml, .sdfcheck.toml, or the table tool.sdfcheck of pyproject.toml",
        "type": "object",
        "additionalProperties": False,
        "properties": {field.key: _property(field) for field in FIELDS},
    }


def render() -> str:
    """The text of ``docs/sdfcheck.schema.json``."""
    import json

    return json.dumps(schema(), indent=2, ensure_ascii=False) + "\n"


def _property(field: Field) -> dict[str, Any]:
    return {"description": field.summary, **_shapes()[field.shape]}


def _shapes() -> Mapping[str, dict[str, Any]]:
    from sdfcheck.consumers.reaction import Consumer

    targets = sorted(consumer.value for consumer in Consumer)
    return {
        Shape.SELECTORS: _SELECTORS,
        Shape.PATTERNS: _STRINGS,
        Shape.TARGETS: {"type": "array", "items": {"enum": targets}},
        Shape.STRINGS: _STRINGS,
        Shape.PATHS: _STRINGS,
        Shape.PATH: _STRING,
        Shape.FLAG: {"type": "boolean"},
        Shape.MEGABYTES: {"type": "number", "exclusiveMinimum": 0},
        Shape.SEVERITY: {"enum": _LEVELS},
        Shape.SEVERITIES: {
            "type": "object",
            "propertyNames": _SELECTOR,
            "additionalProperties": {"enum": [*_LEVELS, "off"]},
        },
        Shape.IGNORES: {"type": "object", "additionalProperties": _SELECTORS},
        Shape.PLACES: {"type": "object", "additionalProperties": _STRING},
        Shape.ARGUMENTS: {
            "type": "object",
            "additionalProperties": {"anyOf": [_ARGUMENTS, {"type": "array", "items": _ARGUMENTS}]},
        },
    }
