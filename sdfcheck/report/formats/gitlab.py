"""GitLab's Code Quality report."""

from __future__ import annotations

import json
import os
from collections import Counter
from hashlib import sha256
from typing import Any

from sdfcheck.lint.diagnostic import Severity
from sdfcheck.lint.run import Run
from sdfcheck.report.paths import Paths
from sdfcheck.source.text import Position

_SEVERITIES = {Severity.ERROR: "major", Severity.WARNING: "minor", Severity.INFO: "info"}


def render(run: Run) -> str:
    paths = Paths("CI_PROJECT_DIR")
    seen: Counter[tuple[str, ...]] = Counter()
    issues: list[dict[str, Any]] = []
    for diagnostic in run.diagnostics:
        # GitLab refuses whole paths; nothing outside the project can be linked anyway.
        path = os.path.splitdrive(paths(diagnostic.span.source.path))[1].lstrip("/")
        # Without the line, so that a finding stays the same when it moves.
        key = (diagnostic.code, path, diagnostic.message)
        seen[key] += 1
        fingerprint = "\0".join((*key, str(seen[key]))).encode("utf-8", "surrogatepass")
        begin, end = diagnostic.span.begin, diagnostic.span.finish
        issues.append(
            {
                "description": f"{diagnostic.code}: {diagnostic.message}",
                "check_name": diagnostic.code,
                "fingerprint": sha256(fingerprint).hexdigest(),
                "severity": _SEVERITIES[run.gate.severity(diagnostic)],
                "location": {"path": path, "positions": {"begin": _position(begin), "end": _position(end)}},
            }
        )
    return json.dumps(issues, indent=2) + "\n"


def _position(position: Position) -> dict[str, int]:
    return {"line": position.line, "column": position.column}
