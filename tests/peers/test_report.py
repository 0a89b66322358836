"""The HTML report in headless Chromium: no errors, filters, keyboard, accessibility, and a large run."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest

from sdfcheck.cli.main import main
from tests.peers import chromium

pytestmark = [
    pytest.mark.peers,
    pytest.mark.skipif(chromium.missing() is not None, reason=chromium.missing() or ""),
]

ROBOTS = Path(__file__).parents[2] / "fixtures" / "robots"
LARGEST = 15_000_000
"""Bytes of the report of a large run."""
VIEWS = ("#view=summary", "#view=findings", "#view=rules", "#view=files", "#view=robots", "#fix=safe")


@pytest.fixture(scope="module")
def tab() -> Iterator[chromium.Tab]:
    with chromium.tab() as opened:
        yield opened


@pytest.fixture(scope="module")
def report(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return made(ROBOTS, tmp_path_factory.mktemp("report"))


def made(folder: Path, place: Path) -> Path:
    out = place / "report.html"
    arguments = ["lint", str(folder), "--isolated", "--exit-zero", "--output-format", f"html={out}", "-q"]
    assert main(arguments) == 0
    return out


def shown(tab: chromium.Tab) -> int:
    """The findings that are listed."""
    return int(tab.run("document.querySelectorAll('details.finding').length"))


def arrive(tab: chromium.Tab, view: str) -> None:
    """Waits until a link has led to a view."""
    tab.page.wait_for_selector(f"main > .current[data-view={view}]")


def heading(tab: chromium.Tab) -> str:
    """Of the section that is shown."""
    return str(tab.run("document.querySelector('main > .current').getAttribute('aria-label')"))


@pytest.mark.parametrize("view", VIEWS)
def test_every_view_opens_without_an_error(view: str, tab: chromium.Tab, report: Path) -> None:
    tab.open(report, view)
    assert tab.errors == []
    assert tab.run("document.querySelector('main > .current').textContent.length") > 100


@pytest.mark.skipif(chromium.missing_axe() is not None, reason=chromium.missing_axe() or "")
@pytest.mark.parametrize("scheme", ["light", "dark"])
@pytest.mark.parametrize("view", VIEWS)
def test_accessible(view: str, scheme: str, tab: chromium.Tab, report: Path) -> None:
    tab.page.emulate_media(color_scheme=scheme)
    tab.open(report, view)
    assert tab.faults() == []


def test_the_address_holds_search_and_filters(tab: chromium.Tab, report: Path) -> None:
    tab.open(report, "#view=findings")
    everything = shown(tab)
    tab.page.select_option("select[name=severity]", "error")
    errors = shown(tab)
    assert 0 < errors < everything
    tab.page.fill("input[name=q]", "crane mass")
    assert shown(tab) == 1
    address = tab.run("location.hash")
    assert address == "#q=crane+mass&severity=error"
    tab.open(report, address)
    assert tab.page.input_value("input[name=q]") == "crane mass"
    assert shown(tab) == 1
    assert tab.page.text_content("[role=status]").startswith("1 of ")
    tab.page.click("text=Clear filters")
    assert shown(tab) == everything


def test_counts_lead_to_what_they_count(tab: chromium.Tab, report: Path) -> None:
    tab.open(report)
    rows = tab.run("[...document.querySelectorAll('tbody tr')].map(row => row.cells[0].textContent)")
    assert len(rows) > 10
    for number in (0, 8):
        tab.open(report)
        tab.page.click(f"tbody tr >> nth={number} >> a")
        arrive(tab, "findings")
        assert shown(tab) == int(rows[number])
    tab.page.go_back()
    arrive(tab, "summary")


def test_the_keyboard_is_enough(tab: chromium.Tab, report: Path) -> None:
    tab.open(report)
    press = tab.page.keyboard.press
    press("/")
    tab.page.keyboard.type("jnt005")
    assert heading(tab) == "Findings"
    assert shown(tab) == 2
    press("Escape")
    is_open = "document.activeElement.closest('details').open"
    for key, number in (("j", 0), ("j", 1), ("k", 0)):
        press(key)
        # A function to wait for would be evaluated, which the page forbids.
        tab.page.wait_for_selector(f":nth-match(details.finding, {number + 1}) > summary:focus")
    before = tab.run(is_open)
    press("Enter")
    assert tab.run(is_open) is not before
    assert tab.errors == []


def test_an_opened_finding_has_code_and_the_fix(tab: chromium.Tab, report: Path) -> None:
    tab.open(report, "#rule=JNT005&q=crane")
    assert "^" in tab.page.text_content("pre.frame")
    assert tab.page.text_content("pre.fix del") == "1.57"
    assert tab.page.text_content("pre.fix ins") == "-1.57"


def test_a_print_holds_everything(report: Path, tab: chromium.Tab) -> None:
    tab.open(report)
    tab.page.emulate_media(media="print")
    tab.run("dispatchEvent(new Event('beforeprint'))")
    visible = "[...document.querySelectorAll('main > section')].filter(section => section.offsetHeight)"
    sections = tab.run(f"{visible}.map(section => section.dataset.view)")
    tab.page.emulate_media(media="screen")
    assert sections == ["summary", "findings", "rules", "files"]
    assert tab.run("document.querySelectorAll('details.finding:not([open])').length") == 0
    assert shown(tab) > 50


def test_names_bring_no_script(tab: chromium.Tab, tmp_path: Path) -> None:
    name = "&lt;/script>&lt;img src=x onerror=alert(1)>&lt;script>alert(2)&lt;/script>"
    file = tmp_path / "<img src=x onerror=alert(3)>.sdf"
    links = f'<link name="{name}"/><link name="{name}"/>'
    file.write_text(f'<sdf version="1.12"><model name="{name}">{links}</model></sdf>')
    out = made(tmp_path, tmp_path)
    for view in (*VIEWS, "#q=link", "#file=<img src=x onerror=alert(4)>"):
        tab.open(out, view)
        assert tab.dialogs == []
        assert tab.errors == []
        assert tab.run("document.querySelectorAll('img').length") == 0
    tab.open(out, "#view=findings")
    tab.page.click("text=Open all")
    assert "onerror=alert(1)" in tab.page.text_content("#findings")


def test_many_findings_are_listed_on_demand(tab: chromium.Tab, tmp_path: Path) -> None:
    links = "".join(f'<link name="a{number}"/>' * 2 for number in range(1000))
    (tmp_path / "many.sdf").write_text(f'<sdf version="1.12"><model name="m">{links}</model></sdf>')
    out = made(tmp_path, tmp_path)
    assert out.stat().st_size < LARGEST
    tab.open(out, "#rule=NAM001")
    assert shown(tab) == 300
    tab.page.click("text=Show 300 more")
    assert shown(tab) == 600
    assert tab.errors == []


def test_robots_are_shown_one_at_a_time(tab: chromium.Tab, report: Path) -> None:
    tab.open(report, "#view=findings")
    tab.page.click("nav >> text=Robots")
    arrive(tab, "robots")
    files = tab.run("[...document.querySelectorAll('.robots li')].map(item => item.textContent)")
    assert len(files) >= 5
    for file in files[:2]:
        tab.page.click(f".robots >> text={file}")
        robot = tab.page.frame_locator(f"iframe[title='The robot of {file}']")
        robot.locator("#panel details").first.wait_for(timeout=60_000)
        assert robot.locator("h1").text_content() == file
        assert robot.locator("canvas").count() == 1
        assert tab.run("document.querySelectorAll('iframe').length") == 1
        assert tab.run("new URLSearchParams(location.hash.slice(1)).get('file')") == file
    assert tab.errors == []


def test_names_bring_no_script_into_the_frame(tab: chromium.Tab, tmp_path: Path) -> None:
    name = "&lt;/script>&lt;img src=x onerror=alert(1)>&lt;script>alert(2)&lt;/script>"
    file = tmp_path / "<img src=x onerror=alert(3)>.urdf"
    file.write_text(f'<robot name="{name}"><link name="{name}"/></robot>')
    tab.open(made(tmp_path, tmp_path), "#view=robots")
    robot = tab.page.frame_locator("iframe")
    robot.locator("#panel details").first.wait_for(timeout=60_000)
    assert "onerror=alert(3)" in robot.locator("h1").text_content()
    assert robot.locator("img").count() == 0
    assert tab.dialogs == []
    assert tab.errors == []
