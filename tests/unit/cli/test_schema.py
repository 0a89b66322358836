"""``sdfcheck schema``."""

from __future__ import annotations

from pathlib import Path

import pytest
from lxml import etree

from sdfcheck.cli.main import main


@pytest.mark.parametrize("form", ["xsd", "rng"])
def test_to_stdout_and_to_a_file(form: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = tmp_path / "sdf"
    assert main(["schema", "--sdf-version", "1.5", "--format", form, "-o", str(file)]) == 0
    assert capsys.readouterr().out == ""
    assert main(["schema", "--sdf-version", "1.5", "--format", form]) == 0
    written = capsys.readouterr().out
    assert written == file.read_text(encoding="utf-8")
    root = etree.fromstring(written.encode())
    assert etree.QName(root).localname == {"xsd": "schema", "rng": "grammar"}[form]


def test_what_cannot_be_done(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["schema", "--sdf-version", "2.0"]) == 2
    assert main(["schema", "-o", str(tmp_path / "none" / "sdf.xsd")]) == 2
    assert "cannot write" in capsys.readouterr().err
