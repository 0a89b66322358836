"""``sdfcheck schema``."""

from __future__ import annotations

from pathlib import Path

import pytest
from lxml import etree

from sdfcheck.cli.main import main


@pytest.mark.parametrize("form", ["xsd", "rng"])
def test_to_stdout_and_to_a_file(form: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = tmp_path / "sdf"
    assert main(["schema", "--sdf-version", "1.5", "--output-format", form, "-o", str(file)]) == 0
    assert capsys.readouterr().out == ""
    assert main(["schema", "--sdf-version", "1.5", "--output-format", form]) == 0
    written = capsys.readouterr().out
    assert written == file.read_text(encoding="utf-8")
    root = etree.fromstring(written.encode())
    assert etree.QName(root).localname == {"xsd": "schema", "rng": "grammar"}[form]


def test_impossible_requests(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["schema", "--sdf-version", "2.0"]) == 2
    assert main(["schema", "-o", str(tmp_path / "none" / "sdf.xsd")]) == 2
    assert "cannot write" in capsys.readouterr().err


def test_the_schema_that_fits_a_file(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = tmp_path / "m.sdf"
    file.write_text('<sdf version="1.6"><model name="m"><link name="l"/></model></sdf>')
    assert main(["schema", "--for", str(file), "--output-format", "rng"]) == 0
    fitting = capsys.readouterr().out
    main(["schema", "--sdf-version", "1.6", "--output-format", "rng"])
    assert capsys.readouterr().out == fitting
    schema = etree.RelaxNG(etree.fromstring(fitting.encode()))
    assert schema.validate(etree.parse(str(file)))

    file.write_text('<sdf version="9.9"><model name="m"/></sdf>')
    assert main(["schema", "--for", str(file)]) == 0
    assert "declares no known version of SDFormat" in capsys.readouterr().err
    assert main(["schema", "--for", str(file), "--sdf-version", "1.6"]) == 2
    assert "exclude each other" in capsys.readouterr().err

    settings = tmp_path / "sdfcheck.toml"
    settings.touch()
    assert main(["schema", "--for", str(settings)]) == 0
    assert '"select"' in capsys.readouterr().out
    urdf = tmp_path / "r.urdf"
    urdf.write_text('<robot name="r"/>')
    assert main(["schema", "--for", str(urdf)]) == 2
    assert "looks like URDF" in capsys.readouterr().err
