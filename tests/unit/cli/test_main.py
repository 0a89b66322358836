import subprocess
import sys
from pathlib import Path

import pytest

from sdfcheck import __version__
from sdfcheck.cli.main import COMMANDS, main

HEAVY = {
    "argparse",
    "dataclasses",
    "difflib",
    "json",
    "logging",
    "lxml",
    "numpy",
    "pathspec",
    "rich",
    "subprocess",
    "tomllib",
    "xacro",
}


def python(code: str) -> set[str]:
    """The words that a fresh interpreter prints."""
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    return set(done.stdout.split())


def test_the_version_is_reported(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["--version"]) == 0
    assert capsys.readouterr().out == f"sdfcheck {__version__}\n"


@pytest.mark.parametrize("arguments", [["--version", "--verbose"], ["--verbose", "-V"]])
def test_the_walls_around_xacro_are_shown(arguments: list[str], capsys: pytest.CaptureFixture[str]) -> None:
    assert main(arguments) == 0
    first, *others = capsys.readouterr().out.splitlines()
    assert first == f"sdfcheck {__version__}"
    shown = dict(line.strip().split(": ") for line in others if line.startswith("  "))
    assert shown["interpreter of expressions"] == "active"
    assert {"Landlock", "seccomp filter"} < set(shown)
    assert set(shown.values()) <= {"active", "not available"}


def test_verbose_goes_with_version(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["--verbose", "rules"]) == 2
    assert "goes with `--version`" in capsys.readouterr().err


def test_every_command_is_listed_and_can_be_loaded(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["--help"]) == 0
    listed = capsys.readouterr().out
    for name, lazy in COMMANDS.items():
        assert lazy.load().name == name
        assert f"  {name}" in listed
        assert lazy.summary in listed


def test_help_imports_no_command() -> None:
    loaded = python(
        "import sys, click\n"
        "from sdfcheck.cli.main import main\n"
        "assert main(['--help']) == 0\n"
        "print(*sys.modules)"
    )
    assert not {lazy.place.partition(":")[0] for lazy in COMMANDS.values()} & loaded
    assert "sdfcheck.lint.session" not in loaded


def test_linting_a_clean_file_imports_nothing_heavy(tmp_path: Path) -> None:
    file = tmp_path / "a.sdf"
    file.write_text('<sdf version="1.9"><model name="m"><link name="l"/></model></sdf>')
    command = f"['lint', '--isolated', '--select', 'INT', '--output-format', 'concise', {str(file)!r}]"
    ground = "import sys, click, json; before = set(sys.modules)\n"
    loaded = python(
        f"{ground}from sdfcheck.cli.main import main\nassert main({command}) == 0\n"
        "print(*(set(sys.modules) - before))"
    )
    assert "sdfcheck.lint.session" in loaded
    assert not HEAVY & loaded


def test_a_closed_pipe_is_not_an_error(tmp_path: Path) -> None:
    python = sys.executable
    done = subprocess.run(
        f"{python} -m sdfcheck rules --isolated | {python} -c 'pass'; exit ${{PIPESTATUS[0]}}",
        shell=True,
        executable="/bin/bash",
        capture_output=True,
        text=True,
        check=False,
    )
    assert (done.returncode, done.stderr) == (0, "")


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="there is no device that is always full")
@pytest.mark.parametrize(("target", "says"), [(">/dev/full", "No space left"), (">&-", "stdout is closed")])
def test_an_output_that_takes_nothing_is_reported(target: str, says: str, tmp_path: Path) -> None:
    file = tmp_path / "a.sdf"
    file.write_text("<sdf/>")
    command = f'exec "{sys.executable}" -m sdfcheck lint --isolated "{file}" {target}'
    done = subprocess.run(["sh", "-c", command], stderr=subprocess.PIPE, text=True, check=False)
    assert done.returncode == 2
    assert done.stderr.startswith("error: cannot write the output: ")
    assert says in done.stderr


@pytest.mark.parametrize("words", [[], ["convert"]], ids=["sdfcheck", "convert"])
def test_the_bare_command_shows_its_help_once(words: list[str], capsys: pytest.CaptureFixture[str]) -> None:
    assert main(words) == 2
    captured = capsys.readouterr()
    assert captured.out.count("Usage:") == 1
    assert captured.out.count("Commands:") == 1
    assert captured.err == ""


def test_choices_are_listed_in_a_line(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["graph"]) == 2
    err = capsys.readouterr().err
    assert err.endswith("Choose from: frames, poses, joints\n")
    assert "␊" not in err
    assert "␉" not in err


_INTERRUPTED = """
import runpy, sys
wanted, sys.argv = sys.argv[1], ["sdfcheck", "lint", "nothing.sdf"]
class Interrupting:
    def find_spec(self, name, path, target=None):
        if name == wanted:
            raise KeyboardInterrupt
sys.meta_path.insert(0, Interrupting())
runpy.run_module("sdfcheck", run_name="__main__")
"""


@pytest.mark.parametrize(
    "module", ["sdfcheck.cli.main", "click", "sdfcheck.cli.lint", "sdfcheck.lint.session"]
)
def test_an_interrupt_while_modules_are_loaded(module: str) -> None:
    command = [sys.executable, "-c", _INTERRUPTED, module]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode == 130
    assert "Traceback" not in done.stderr
