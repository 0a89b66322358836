"""Names and paths act on nothing, whatever command shows them: no terminal, no log of a CI system."""

from __future__ import annotations

import io
import os
import re
import subprocess
import sys
from pathlib import Path

import pytest

from sdfcheck.cli.main import main
from sdfcheck.cli.parts.terminal import emit, emit_lines, say
from sdfcheck.source.visible import cells, harmless, visible

ATTACKS = Path(__file__).parents[3].parent / "shared" / "found" / "attack" / "values_ctrl.sdf"
NAME = "a\u202eb\u2066\u009b31m\u2028c"
COMMAND = "::error::pwn"
LINK = f'<link name="x&#10;{COMMAND}"/>'
BROKEN = f'<sdf version="1.9"><model name="{NAME}">{LINK}{LINK}<modl/></model></sdf>'
SOUND = f"""<sdf version="1.9"><model name="{NAME}"><link name="{COMMAND}"/><link name="x&#10;{COMMAND}"/>
<link name="##vso[task.setvariable variable=PATH]x"/><link name="\u009d0;title&#9;&#13;"/>
<joint name="j\u2067" type="fixed"><parent>{COMMAND}</parent><child>x&#10;{COMMAND}</child></joint></model></sdf>"""
OTHER = SOUND.replace("<joint", '<link name="new&#10;::add-mask::x"/><joint')
FILE = "\u202e\x1b[8m\n::warning::m.sdf"
COMMANDS = (
    ("lint", "{}"),
    ("lint", "--output-format", "concise", "{}"),
    ("lint", "--output-format", "github", "{}"),
    ("lint", "--statistics", "{}"),
    ("lint", "--show-files", "."),
    ("lint", "--color", "always", "{}"),
    ("lint", "{}.gone.sdf"),
    ("lint", "--{}"),
    ("targets", "{}"),
    ("targets", "--output-format", "json", "{}"),
    ("inertia", "{}"),
    ("inertia", "--model", "::error::x\n::error::y", "{}"),
    ("inertia", "--output-format", "json", "{}"),
    ("graph", "joints", "{}"),
    ("graph", "frames", "--color", "always", "{}"),
    ("graph", "poses", "--output-format", "dot", "{}"),
    ("graph", "frames", "--output-format", "mermaid", "{}"),
    ("diff", "{}", "other.sdf"),
    ("diff", "--color", "always", "{}", "other.sdf"),
    ("diff", "--output-format", "json", "{}", "other.sdf"),
    ("print", "broken.sdf"),
    ("convert", "sdf-to-urdf", "{}", "-o", "out.urdf"),
    ("expand", "broken.xacro"),
    ("describe", "joint/\u202e\n::error::x"),
    ("rule", "::error::\x1b[8m"),
    ("\n::error::\u202e",),
)


@pytest.fixture(autouse=True)
def here(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.chdir(tmp_path)
    monkeypatch.delenv("FORCE_COLOR", raising=False)
    Path("broken.sdf").write_text(f"<sdf version='1.9'><model name='{NAME}'>\x07</modl></sdf>")
    Path("broken.xacro").write_text(
        f'<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro"><link name="${{{NAME}}}"/></robot>'
    )
    Path("other.sdf").write_text(OTHER)


def assert_harmless(text: str, *, color: bool, annotates: bool = False) -> None:
    if color:
        text = re.sub(r"\x1b\[[0-9;]*m", "", text)
    for line in text.split("\n"):
        assert all(character.isprintable() or character in "\u200c\u200d" for character in line), ascii(line)
        assert "##vso[" not in line or line.lstrip().startswith('"')
        if not (annotates and re.match(r"::(error|warning|notice)( file=|::\d+ more)", line)):
            assert not line.lstrip().startswith("::"), line


@pytest.mark.parametrize("text", [BROKEN, SOUND], ids=["broken", "sound"])
@pytest.mark.parametrize("command", COMMANDS, ids=lambda command: " ".join(command[:-1]))
def test_every_output_is_harmless(
    capfd: pytest.CaptureFixture[str], command: tuple[str, ...], text: str
) -> None:
    Path(FILE).write_text(text)
    main([argument.format(FILE) if "{}" in argument else argument for argument in command])
    out, err = capfd.readouterr()
    assert out or err
    color, annotates = "always" in command, "github" in command
    assert_harmless(out, color=color, annotates=annotates)
    assert_harmless(err, color=color)


def test_a_file_that_was_found_to_be_harmful(capfd: pytest.CaptureFixture[str]) -> None:
    if not ATTACKS.exists():
        pytest.skip("the file is not here")
    for command in (
        "lint",
        "targets",
        "inertia",
        "graph joints",
        "graph poses",
        "print",
        "lint --statistics",
    ):
        main([*command.split(), str(ATTACKS)])
        for text in capfd.readouterr():
            assert_harmless(text, color=False)


@pytest.mark.parametrize(
    ("line", "shown"),
    [
        ("link `a`", "link `a`"),
        ("::error::x", "<U+003A>:error::x"),
        ("  \t::error::x", "  ␉::error::x"),
        ("   ::error::x", "   <U+003A>:error::x"),
        ("model a::b", "model a::b"),
        ("a\n::error::x", "a␊::error::x"),
        ("a ##vso[x]y ##[group]z", "a #<U+0023>vso[x]y #<U+0023>[group]z"),
        ("## title", "## title"),
        ("\x1b[8mhidden\x9b8m\u202e\ud800", "␛[8mhidden<U+009B>8m<U+202E><U+D800>"),
    ],
)
def test_a_line_acts_on_nothing(line: str, shown: str) -> None:
    assert harmless(line) == shown


def test_colors_pass_where_they_are_our_own() -> None:
    assert harmless("\x1b[1mbold\x1b[0m \x1b]0;title\x07", color=True) == "\x1b[1mbold\x1b[0m ␛]0;title␇"
    assert harmless("\x1b[1mbold", color=False) == "␛[1mbold"
    assert harmless("::error::x", color=True) == "<U+003A>:error::x"


def test_cells_count_what_is_shown() -> None:
    for text in ("a ##vso[x]", "\t##[group]\u202e", "##", "é##[x"):
        shown, columns = cells(text)
        assert shown == visible(text.replace("\t", "    "))
        assert (len(columns), columns[-1]) == (len(text) + 1, len(shown))


def test_a_document_is_shown_harmless_and_piped_as_it_is(monkeypatch: pytest.MonkeyPatch) -> None:
    class Terminal(io.StringIO):
        encoding = "utf-8"

        def isatty(self) -> bool:
            return True

    text = "<a>\t\x9b8m\r\n  ::x\u202e</a>\n"
    terminal = Terminal()
    monkeypatch.setattr("sys.stdout", terminal)
    emit(text)
    assert terminal.getvalue() == "<a>\t<U+009B>8m\n  ::x<U+202E></a>\n"
    raw = io.BytesIO()
    monkeypatch.setattr("sys.stdout", io.TextIOWrapper(raw))
    emit(text)
    emit_lines(["a\nb"])
    assert raw.getvalue().decode() == text + "a␊b\n"


def test_a_notice_is_one_line(capsys: pytest.CaptureFixture[str]) -> None:
    say("note: a\n::error::b")
    assert capsys.readouterr().err == "note: a␊::error::b\n"


def test_a_name_that_is_no_text_is_shown() -> None:
    os.close(os.open(b"\xff::x.sdf", os.O_CREAT | os.O_WRONLY))
    command = [sys.executable, "-m", "sdfcheck", "lint", "--isolated", "--show-files", "."]
    done = subprocess.run(command, capture_output=True, check=False)
    assert b"<U+DCFF>::x.sdf" in done.stdout + done.stderr


def test_the_name_of_another_file_is_shown_as_it_is() -> None:
    assert harmless(" ::: parts/leg.sdf:4:1") == " ::: parts/leg.sdf:4:1"
    assert harmless("::error::x") != "::error::x"
