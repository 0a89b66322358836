import io

import pytest

from sdfcheck.cli.parts.terminal import emit, wants_color, wants_links
from sdfcheck.source.visible import harmless


class Terminal(io.StringIO):
    def isatty(self) -> bool:
        return True


def test_terminals_are_coloured_unless_they_cannot_be() -> None:
    assert wants_color("auto", Terminal(), {})
    assert not wants_color("auto", Terminal(), {"TERM": "dumb"})
    assert not wants_color("auto", Terminal(), {"NO_COLOR": "1"})
    assert wants_color("auto", Terminal(), {"NO_COLOR": ""})
    assert not wants_color("auto", io.StringIO(), {})


@pytest.mark.parametrize(
    ("environment", "links"),
    [
        ({"TERM": "xterm-kitty"}, True),
        ({"TERM": "xterm-256color", "VTE_VERSION": "7200"}, True),
        ({"TERM": "xterm-256color", "TERM_PROGRAM": "vscode"}, True),
        ({"TERM": "xterm-256color"}, False),
        ({"TERM": "dumb", "VTE_VERSION": "7200"}, False),
        ({"TERM": "xterm-kitty", "NO_COLOR": "1"}, False),
        ({"TERM": "tmux-256color", "VTE_VERSION": "7200"}, False),
        ({"TERM": "xterm-kitty", "CI": "true"}, False),
    ],
)
def test_links_are_for_terminals_that_know_them(environment: dict[str, str], links: bool) -> None:
    assert wants_links("auto", Terminal(), environment) is links
    assert not wants_links("never", Terminal(), environment)
    assert not wants_links("always", io.StringIO(), environment)


def test_pipes_get_utf8_whatever_the_locale(monkeypatch: pytest.MonkeyPatch) -> None:
    raw = io.BytesIO()
    monkeypatch.setattr("sys.stdout", io.TextIOWrapper(raw, encoding="ascii"))
    emit("ä \udcff\n")
    assert raw.getvalue() == "ä \\udcff\n".encode()


def test_terminals_get_what_they_can_show(monkeypatch: pytest.MonkeyPatch) -> None:
    class Ascii(Terminal):
        encoding = "ascii"

    stream = Ascii()
    monkeypatch.setattr("sys.stdout", stream)
    emit("ä\n")
    assert stream.getvalue() == "\\xe4\n"


def test_links_of_our_own_pass_and_no_others() -> None:
    link = "\x1b]8;;https://sdfcheck.example/rules/x/\x1b\\NS003\x1b]8;;\x1b\\"
    assert harmless(link, color=True) == link
    assert "\x1b" not in harmless(link)
    for other in ("\x1b]8;;file:///etc/passwd\x1b\\a", "\x1b]0;title\x07", "\x1b]8;;https://a b\x1b\\"):
        assert "\x1b" not in harmless(other, color=True)
