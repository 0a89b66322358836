"""Pages in headless Chromium, drawn without a graphics card."""

from __future__ import annotations

import importlib.util
import json
import shutil
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

PROGRAM = shutil.which("chromium") or shutil.which("chromium-browser") or shutil.which("google-chrome")
AXE = Path(__file__).parents[2] / "viewer" / "node_modules" / "axe-core" / "axe.min.js"

_WITHOUT_GRAPHICS_CARD = ("--use-angle=swiftshader", "--enable-unsafe-swiftshader")


def missing() -> str | None:
    """Why no page can be opened, as a reason to skip; None if one can."""
    if PROGRAM is None:
        return "chromium is not installed"
    if importlib.util.find_spec("playwright") is None:
        return "playwright is not installed (pip install 'sdfcheck[browser]')"
    return None


def missing_axe() -> str | None:
    """Why accessibility cannot be checked; None if it can."""
    return missing() or (None if AXE.is_file() else "axe-core is not installed (npm ci in viewer/)")


@dataclass
class Tab:
    """An open page: ``page`` as Playwright has it, and what went wrong in it so far."""

    page: Any
    errors: list[str] = field(default_factory=list)
    """Errors and warnings of the console, exceptions, and requests for anything but the page."""
    dialogs: list[str] = field(default_factory=list)
    server: str = "file:"
    """The address of a page that may ask its own server."""

    def open(self, file: Path, fragment: str = "") -> None:
        """Loads a file; returns when its script has run."""
        self.errors.clear()
        self.dialogs.clear()
        self.page.goto("about:blank")
        self.page.goto(file.resolve().as_uri() + fragment)

    def run(self, script: str, argument: Any = None) -> Any:
        """The value of a JavaScript expression or function, as JSON; promises are waited for."""
        return self.page.evaluate(script, argument)

    def faults(self) -> list[str]:
        """Serious and critical faults of accessibility that axe-core finds, each with its elements."""
        self.page.evaluate(AXE.read_text(encoding="utf-8"))
        found = self.page.evaluate("axe.run(document, {resultTypes: ['violations']})")
        return [
            f"{fault['impact']} {fault['id']}: {json.dumps([node['target'] for node in fault['nodes']])}"
            for fault in found["violations"]
            if fault["impact"] in {"serious", "critical"}
        ]


@contextmanager
def tab(*, width: int = 1280, height: int = 800) -> Iterator[Tab]:
    """A tab of a new browser; tests share one in a fixture of their module."""
    from playwright.sync_api import sync_playwright

    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=PROGRAM, args=[*_WITHOUT_GRAPHICS_CARD])
        page: Any = browser.new_page(viewport={"width": width, "height": height})
        opened = Tab(page)
        page.on("console", lambda said: _note(opened, said))
        page.on("pageerror", lambda error: opened.errors.append(f"exception: {error}"))
        page.on("request", lambda request: _requested(opened, request.url))
        page.on("dialog", lambda dialog: _dismiss(opened, dialog))
        try:
            yield opened
        finally:
            browser.close()


def _note(opened: Tab, said: Any) -> None:
    if said.type in {"error", "warning"} and "GPU stall due to ReadPixels" not in said.text:
        opened.errors.append(f"{said.type}: {said.text}")


def _requested(opened: Tab, url: str) -> None:
    if not url.startswith(("file:", "about:", "data:", "blob:", opened.server)):
        opened.errors.append(f"request: {url}")


def _dismiss(opened: Tab, dialog: Any) -> None:
    opened.dialogs.append(dialog.message)
    dialog.dismiss()
