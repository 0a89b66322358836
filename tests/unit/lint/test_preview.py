from __future__ import annotations

from pathlib import Path
from typing import Any

import sdfcheck
from tests.unit.preview import preview_example


def test_rules_in_preview_run_where_they_are_asked_for(tmp_path: Path) -> None:
    code, text = preview_example()

    def codes(**options: Any) -> set[str]:
        return {found.code for found in sdfcheck.lint(text, **options).diagnostics}

    configuration = tmp_path / "sdfcheck.toml"
    configuration.write_text("preview = true\n")
    assert code not in codes(isolated=True) | codes(isolated=True, select=["ALL"])
    assert code in codes(isolated=True, preview=True) & codes(isolated=True, select=[code])
    assert code in codes(config=configuration)
    assert code not in codes(config=configuration, preview=False)
