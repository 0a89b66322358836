"""Over stdio: the robot beside its text follows what is typed, and leads back to it."""

from __future__ import annotations

import asyncio
import json
import time
import urllib.request
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any
from urllib.error import HTTPError

import pytest
from lsprotocol import types

from tests.unit.lsp.texts import ROBOT
from tests.unit.lsp.wire import PATIENCE, Session, Text

pytestmark = [pytest.mark.asyncio(loop_scope="module"), pytest.mark.xdist_group(__name__)]

WORLD = """\
<sdf version="1.12">
  <world name="w">
    <include><uri>arm.sdf</uri><name>one</name></include>
    <model name="box"><link name="body"><visual name="c"><geometry><box><size>1 1 1</size></box></geometry></visual>
      <inertial><mass>-1</mass></inertial></link></model>
  </world>
</sdf>
"""
ARM = '<sdf version="1.12"><model name="arm">\n  <link name="tip"/>\n</model></sdf>'


class Looking:
    """A page that somebody looks at, as far as the server knows."""

    def __init__(self, address: str) -> None:
        self.address = address
        self._events = urllib.request.urlopen(f"{address}events", timeout=30)

    def close(self) -> None:
        self._events.close()

    async def news(self, kind: str, test: Callable[[Any], object] = bool) -> Any:
        """The next message of a kind that is as expected."""
        return await self._next(lambda message: message["kind"] == kind and test(message))

    async def noted(self, words: str) -> None:
        """Wait for a note with these words, which comes alone, or with the robot from before."""
        await self._next(lambda message: words in (message.get("note") or ""))

    async def _next(self, test: Callable[[Any], object]) -> Any:
        end = time.monotonic() + PATIENCE / 2
        seen = []
        while time.monotonic() < end:
            line = await asyncio.to_thread(self._events.readline)
            if line.startswith(b"data: "):
                message = json.loads(line[6:])
                if test(message):
                    return message
                seen.append(message)
        raise AssertionError(f"it did not come, but {seen}")

    async def say(self, **word: Any) -> None:
        data = json.dumps(word).encode()
        headers = {"Content-Type": "application/json"}
        request = urllib.request.Request(f"{self.address}say", data, headers)
        await asyncio.to_thread(lambda: urllib.request.urlopen(request, timeout=30).close())


@pytest.fixture
def looked() -> Iterator[list[Looking]]:
    found: list[Looking] = []
    yield found
    for each in found:
        each.close()


@pytest.fixture
def shown(session: Session) -> list[types.ShowDocumentParams]:
    """The places that the server lets the client show."""
    found: list[types.ShowDocumentParams] = []

    def show(params: types.ShowDocumentParams) -> types.ShowDocumentResult:
        found.append(params)
        return types.ShowDocumentResult(True)

    session.client.protocol.fm.features[types.WINDOW_SHOW_DOCUMENT] = show
    return found


async def built(page: Looking, *names: str) -> Any:
    """The message with the robot that has these links."""
    return await page.news("robot", lambda news: links(news) == list(names) and not news["note"])


async def look(text: Text, looked: list[Looking]) -> Looking:
    given = {"uri": text.uri, "open": False}
    params = types.ExecuteCommandParams("sdfcheck.showRobot", [given])
    page = Looking(str(await text.client.workspace_execute_command_async(params)))
    looked.append(page)
    return page


def links(news: Any) -> list[str]:
    return [link["name"] for model in news["page"]["scenes"][0]["models"] for link in model["links"]]


async def test_the_robot_follows_its_text(session: Session, folder: Path, looked: list[Looking]) -> None:
    text = session.open(folder / "r.xacro", ROBOT)
    page = await look(text, looked)
    first = await built(page, "left_ball", "base")
    assert first["page"]["arguments"] == [{"name": "side", "value": "left", "choices": []}]
    text.change('name="base"', 'name="basis"')
    await built(page, "left_ball", "basis")
    text.change('name="basis"/>', 'name="basis"')  # broken: the last one stays
    await page.noted("robot from before")
    text.change('name="basis"', 'name="foot"/>')
    await built(page, "left_ball", "foot")
    await page.say(kind="arguments", values={"side": "right"})
    await built(page, "right_ball", "foot")
    text.change("${size * 2}", "${sise * 2}")
    await page.noted("cannot be expanded")


async def test_arguments_without_values_are_asked_for(
    session: Session, folder: Path, looked: list[Looking]
) -> None:
    text = session.open(folder / "r.xacro", ROBOT.replace("$(arg side)", "$(arg it)"))
    page = await look(text, looked)
    first = await page.news("robot")
    assert "cannot be expanded" in first["note"]
    assert {"name": "it", "value": "", "choices": []} in first["page"]["arguments"]
    await page.say(kind="arguments", values={"it": "big"})
    await built(page, "big_ball", "base")


async def test_an_included_file_changes(session: Session, folder: Path, looked: list[Looking]) -> None:
    arm = session.open(folder / "arm.sdf", ARM)
    page = await look(session.open(folder / "w.sdf", WORLD), looked)
    await built(page, "tip", "body")
    arm.change("tip", "top")
    await built(page, "top", "body")


async def test_a_click_leads_to_the_text(
    session: Session, folder: Path, looked: list[Looking], shown: list[types.ShowDocumentParams]
) -> None:
    (folder / "arm.sdf").write_text(ARM)
    text = session.open(folder / "w.sdf", WORLD)
    page = await look(text, looked)
    news = await page.news("robot", lambda news: news["page"]["findings"])
    await page.say(kind="picked", model="box", part="body")
    if not session.can_show:
        return
    await session.waited(lambda: len(shown) == 1)
    assert shown[0].uri == text.uri
    assert shown[0].selection is not None
    assert text.cut(shown[0].selection) == "link"
    assert shown[0].selection.start.line == 3
    await page.say(kind="picked", model="one", part="tip")
    await session.waited(lambda: len(shown) == 2)
    assert shown[1].uri == (folder / "arm.sdf").as_uri()
    assert shown[1].selection is not None
    assert shown[1].selection.start.line == 1
    found = news["page"]["findings"]
    number = next(n for n, each in enumerate(found) if each["part"] == "body" and "mass" in each["message"])
    await page.say(kind="picked", model="box", part="body", finding=number)
    await session.waited(lambda: len(shown) == 3)
    assert shown[2].selection is not None
    assert text.cut(shown[2].selection) == "-1"


async def test_the_cursor_marks_parts(session: Session, folder: Path, looked: list[Looking]) -> None:
    call = '  <xacro:ball name="$(arg side)" size="${size * 2}"/>\n'
    text = session.open(folder / "r.xacro", ROBOT.replace(call, call + call.replace("$(arg side)", "other")))
    page = await look(text, looked)
    await page.news("robot")

    async def marked(mark: str, skip: int = 2) -> list[str]:
        position = text.position(mark, skip)
        place = {"line": position.line, "character": position.character}
        params = types.ExecuteCommandParams("sdfcheck.cursor", [{"uri": text.uri, "position": place}])
        await text.client.workspace_execute_command_async(params)
        return [place["part"] for place in (await page.news("cursor"))["places"]]

    assert await marked("sphere") == ["left_ball", "other_ball"]
    assert await marked("$(arg side)") == ["left_ball"]
    assert await marked('name="base"') == ["base"]
    assert await marked("<xacro:arg") == [None]


async def test_meshes_come_when_they_are_asked_for(
    session: Session, folder: Path, looked: list[Looking]
) -> None:
    (folder / "a.obj").write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
    mesh = "<mesh><uri>a.obj</uri></mesh>"
    shape = f"<visual name='v'><geometry>{mesh}</geometry></visual>"
    text = session.open(folder / "arm.sdf", ARM.replace('"tip"/>', f'"tip">{shape}</link>'))
    page = await look(text, looked)
    (entry,) = (await page.news("robot"))["page"]["meshes"]
    assert entry["format"] == "obj"
    assert "data" not in entry
    await page.say(kind="meshes", keys=[entry["key"], "x", 3])
    sent = await page.news("mesh")
    assert sent["key"] == entry["key"]
    assert sent["data"]
    text.change("tip", "top")
    assert (await built(page, "top"))["page"]["meshes"] == [entry]


async def test_odd_messages_change_nothing(session: Session, folder: Path, looked: list[Looking]) -> None:
    text = session.open(folder / "arm.sdf", ARM)
    page = await look(text, looked)
    await page.news("robot")
    words: tuple[dict[str, Any], ...] = (
        {"kind": "picked"},
        {"kind": "picked", "finding": 10**9},
        {"kind": "arguments"},
        {"kind": []},
        {},
    )
    for word in words:
        await page.say(**word)
    await page.say(kind="ready")
    await built(page, "tip")


async def test_a_client_shows_the_page_itself(session: Session, folder: Path) -> None:
    text = session.open(folder / "arm.sdf", ARM)
    news: list[Any] = []
    session.client.protocol.fm.features["sdfcheck/robot"] = news.append

    async def asked(command: str, **given: Any) -> Any:
        params = types.ExecuteCommandParams(command, [{"uri": text.uri, **given}])
        return await text.client.workspace_execute_command_async(params)

    page = await asked("sdfcheck.robotPage")
    html = page["html"] if isinstance(page, dict) else page.html
    assert "connect-src data: blob:;" in html
    await asked("sdfcheck.robotSay", message={"kind": "ready"})
    await session.waited(lambda: bool(news))
    place = await asked("sdfcheck.robotSay", message={"kind": "picked", "model": "arm", "part": "tip"})
    assert (place["uri"] if isinstance(place, dict) else place.uri) == text.uri
    count = len(news)
    text.change("tip", "top")
    await session.waited(lambda: len(news) > count)


async def test_a_closed_text_says_so(session: Session, folder: Path, looked: list[Looking]) -> None:
    text = session.open(folder / "arm.sdf", ARM)
    page = await look(text, looked)
    await page.news("robot")
    session.close(text)
    assert "closed" in (await page.news("note"))["note"]


async def test_other_texts_are_noted(session: Session, folder: Path, looked: list[Looking]) -> None:
    text = session.open(folder / "x.sdf", "<gui/>")
    page = await look(text, looked)
    assert "not like a robot" in (await page.news("robot"))["note"]
    with pytest.raises(HTTPError) as refused:
        urllib.request.urlopen(f"{page.address[:-2]}/", timeout=30)
    refused.value.close()
