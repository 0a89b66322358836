"""The example of ``docs/large-corpora.md``, on a cluster of this machine."""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

import pytest

import sdfcheck

DOCS = Path(__file__).parents[3] / "docs"


PACK = """
import os
from sdfcheck import Rule, Severity

class Deadly(Rule):
    \"\"\"A name that ends the process.\"\"\"

    code = "ZZZ001"
    name = "deadly"
    severity = Severity.ERROR
    selects = ("sdf:model",)
    bad = good = ()

    def check(self, model):
        if model.get("name") == "r7":
            os._exit(1)
        return iter(())
"""
SCRIPT = """
import sys
import dask, distributed, sdfcheck
if __name__ == "__main__":
    dask.config.set({"distributed.scheduler.allowed-failures": 0})
    with distributed.Client(n_workers=2, threads_per_worker=1) as client:
        run = sdfcheck.lint(sys.argv[1], trust_config=True, executor=client.get_executor())
    print(len(run.files), *run.skipped)
"""


def test_a_worker_that_dies_loses_its_portion(tmp_path: Path) -> None:
    pytest.importorskip("distributed", reason="distributed is not installed")
    (tmp_path / "pack").mkdir()
    (tmp_path / "pack" / "deadly.py").write_text(PACK)
    corpus = tmp_path / "corpus"
    corpus.mkdir()
    (corpus / "sdfcheck.toml").write_text('plugins = ["../pack"]\n')
    for number in range(10):
        (corpus / f"{number}.sdf").write_text(f'<sdf version="1.12"><model name="r{number}"/></sdf>')
    (tmp_path / "script.py").write_text(SCRIPT)
    command = [sys.executable, str(tmp_path / "script.py"), str(corpus)]
    done = subprocess.run(command, capture_output=True, text=True, check=True)
    count, _, skipped = done.stdout.partition(" ")
    # Another file that the worker was given may be lost, too.
    assert 5 <= int(count) <= 9
    assert str(corpus / "7.sdf") in skipped
    assert "KilledWorker: " in skipped


def test_the_example_of_the_manual_runs(tmp_path: Path) -> None:
    pytest.importorskip("distributed", reason="distributed is not installed")
    corpus = tmp_path / "corpus"
    for number in range(120):
        folder = corpus / f"robot_{number:03}"
        folder.mkdir(parents=True)
        mass = number % 3 - 1
        (folder / "model.sdf").write_text(
            f'<sdf version="1.12"><model name="r{number}"><link name="l"><inertial><mass>{mass}</mass>'
            "</inertial></link></model></sdf>"
        )
    manual = (DOCS / "large-corpora.md").read_text(encoding="utf-8")
    (example,) = re.findall(r"^```python\n(# lint_corpus.*?)^```$", manual, re.MULTILINE | re.DOTALL)
    script = tmp_path / "lint_corpus.py"
    script.write_text(example)
    done = subprocess.run(
        [sys.executable, str(script), str(corpus)], capture_output=True, text=True, check=True, cwd=tmp_path
    )
    one = sdfcheck.lint(corpus)
    lines = done.stdout.splitlines()
    assert lines[0] == f"120 files, {len(one.diagnostics)} diagnostics, 0 not linted"
    assert lines[1:] == [
        f"{d.span.source.path}:{d.span.begin.line}: {d.code} {d.message}" for d in one.diagnostics
    ]
