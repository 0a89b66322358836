"""Every description of some folders, converted and judged: ``python -m tests.peers.conversions FOLDER…``.

URDF becomes SDFormat, and each model of SDFormat becomes URDF, by the command that users run. Found are
references that led somewhere in the source and lead nowhere in the result, results that a consumer refuses or
complains of though it had no complaint of the source, and files that are refused though their own consumer
reads them.
"""

from __future__ import annotations

import io
import json
import re
import sys
import tempfile
from collections import Counter
from collections.abc import Iterator, Sequence
from contextlib import redirect_stderr, redirect_stdout
from pathlib import Path
from typing import NamedTuple

from lxml import etree

from sdfcheck.cli.main import main as sdfcheck
from sdfcheck.consumers.engines import Answer, Engine, Question, ask_all, is_installed
from sdfcheck.source.sniff import Kind, sniff

ENGINES = {Kind.URDF: (Engine.URDFDOM, Engine.LIBSDFORMAT), Kind.SDF: (Engine.LIBSDFORMAT,)}
"""The consumers of a format; the verdict of the first one on a source decides whether it has to be converted."""
NAMED = {Engine.URDFDOM: "urdfdom", Engine.LIBSDFORMAT: "libsdformat"}
"""The words for them in the summary line."""
CANNOT = frozenset({"CNV001", "CNV005"})
"""Why nothing is written where the target has no words for the source, or the source is ambiguous."""
COMPLAINT = re.compile(r"^(Error|Warning)")
FOLLOWS = re.compile(r"^Error:\s+Could not parse \w+ element")
"""A complaint of urdfdom that follows from one about the content of the element."""


class Job(NamedTuple):
    """A robot to convert: a file, or one of the models in it."""

    source: Path
    kind: Kind
    model: str
    target: Path

    @property
    def name(self) -> str:
        return f"{self.source}#{self.model}" if self.model else str(self.source)


class Done(NamedTuple):
    """The end of a conversion: what it said, and what it reported (code, severity, message)."""

    job: Job
    said: str
    reported: tuple[tuple[str, str, str], ...]

    @property
    def is_written(self) -> bool:
        return self.job.target.exists()

    @property
    def why(self) -> tuple[str, str]:
        """Code and message of what stopped it."""
        errors = [(code, message) for code, severity, message in self.reported if severity == "error"]
        stopping = [error for error in errors if error[0].startswith("CNV")]
        return next(iter(stopping[::-1] or errors), ("", self.said.strip()))


class Finding(NamedTuple):
    """Something that is wrong with a conversion."""

    kind: str
    where: str
    text: str

    def __str__(self) -> str:
        return f"{self.kind}: {self.where}: {self.text}"


def _tree(file: Path) -> etree._Element:
    return etree.parse(file, etree.XMLParser(recover=True, remove_comments=True)).getroot()


def jobs(folders: Sequence[Path], results: Path) -> list[Job]:
    """The robots in some folders."""
    found: list[Job] = []
    files = (file for folder in folders for file in sorted((folder, *folder.rglob("*"))))
    for file in files:
        if file.suffix not in {".urdf", ".sdf", ".world"} or not file.is_file():
            continue
        kind = sniff(file.read_bytes(), file)
        if kind is Kind.URDF:
            found.append(Job(file, kind, "", results / f"{len(found)}.sdf"))
        elif kind is Kind.SDF:
            root = _tree(file)
            tops = [*root.findall("model"), *root.findall("world/model")]
            names = [one.get("name", "") for one in tops]
            for name in names if len(names) > 1 else names and [""]:
                found.append(Job(file, kind, name, results / f"{len(found)}.urdf"))
    return found


def convert(job: Job, *options: str) -> Done:
    """Convert it as a user does."""
    report, said = job.target.with_suffix(".json"), io.StringIO()
    command = "urdf-to-sdf" if job.kind is Kind.URDF else "sdf-to-urdf"
    chosen = ["--model", job.model] if job.model else []
    arguments = [command, str(job.source), "-o", str(job.target), "--isolated", *chosen, *options]
    with redirect_stderr(said), redirect_stdout(io.StringIO()):
        sdfcheck(["convert", *arguments, "--output-format", f"json={report}"])
    found = json.loads(report.read_text())["diagnostics"] if report.exists() else []
    return Done(job, said.getvalue(), tuple((one["code"], one["severity"], one["message"]) for one in found))


# References, found without the robot model that the conversions use.

_HOLDERS = frozenset({"plugin", "sensor", "transmission", "ros2_control"})
_PARTS = frozenset({"link", "joint", "frame", "collision", "model"})
_NAMING = re.compile(r"link|joint|frame|body|model|collision", re.IGNORECASE)
"""Parameters that are called so hold names, where there is something of that name."""


class Reference(NamedTuple):
    """A text that names a part: in which plugin or sensor, by which parameter, and which one of those."""

    holder: str
    name: str
    parameter: str
    number: int


def references(file: Path, model: str = "") -> tuple[dict[Reference, str], set[str]]:
    """The texts that may name a part, and the names that parts have; of one model, if one is named."""
    root = _tree(file)
    tops = (*root.findall("model"), *root.findall("world/model"))
    root = next((one for one in tops if model and one.get("name") == model), root)
    names = {one.get("name", "") for one in root.iter(etree.Element) if _local(one) in _PARTS}
    if root.tag == "robot":
        # Shapes without a name get one from libsdformat, which users write in their sensors.
        names |= {one.get("name", "") for one in root.iter("link") for _ in one.iter("collision")}
    found: dict[Reference, str] = {}
    count: Counter[tuple[str, str, str]] = Counter()
    for holder in root.iter(etree.Element):
        if _local(holder) not in _HOLDERS or any(_local(one) in _HOLDERS for one in holder.iterancestors()):
            continue
        for parameter, text in _texts(holder):
            key = _local(holder), holder.get("name", ""), parameter
            found[Reference(*key, count[key])] = text
            count[key] += 1
    return found, names | {"world", "__model__"}


def _local(element: etree._Element) -> str:
    return element.tag.rpartition("}")[2].rpartition(":")[2]


def _texts(holder: etree._Element) -> Iterator[tuple[str, str]]:
    for element in holder.iter(etree.Element):
        if element is not holder and not len(element) and (text := (element.text or "").strip()):
            yield _local(element), text
        if element is not holder and _local(element) in _PARTS and element.get("name"):
            yield _local(element), element.get("name", "")


def _leads(text: str, names: set[str]) -> bool:
    return all(part in names for part in text.split("::"))


def broken(done: Done) -> Iterator[Finding]:
    """The references that resolve in the source, and neither do so in the result nor are reported."""
    before, names = references(done.job.source, done.job.model)
    after, new_names = references(done.job.target)
    messages = [message for _, _, message in done.reported]
    for reference, text in before.items():
        if not _NAMING.search(reference.parameter) or not _leads(text, names):
            continue
        now = after.get(reference)
        if now is not None and _leads(now, new_names):
            continue
        said = (text, *text.split("::"), reference.name)
        if not any(f"`{word}`" in message for word in said for message in messages):
            what = f"`{text}` in <{reference.parameter}> of {reference.holder} `{reference.name}`"
            yield Finding(
                "reference", done.job.name, f"{what} is now {'gone' if now is None else f'`{now}`'}"
            )


# The verdicts of consumers.


def _ask(engine: Engine, files: Sequence[Path], models: Sequence[Path]) -> dict[Path, Answer]:
    places = tuple(map(str, models))
    questions = [Question(file, model_paths=places) for file in files]
    return dict(zip(files, ask_all(engine, questions), strict=True))


def _complaints(answer: Answer) -> Counter[str]:
    """Its complaints, without places and names, which differ between formats."""
    lines = (re.sub(r"\x1b\[[0-9;]*m", "", line) for line in answer.messages)
    return Counter(re.sub(r"\[.*?\]|line \d+|/\S+", "", line) for line in lines if COMPLAINT.match(line))


def judged(done: Sequence[Done], models: Sequence[Path]) -> Iterator[Finding]:
    """The findings of consumers about results, and robots that they read and that were refused."""
    engines = [engine for engine in NAMED if is_installed(engine)]
    sources = {kind: sorted({one.job.source for one in done if one.job.kind is kind}) for kind in ENGINES}
    written = {
        Kind.SDF: [one.job.target for one in done if one.is_written and one.job.kind is Kind.URDF],
        Kind.URDF: [one.job.target for one in done if one.is_written and one.job.kind is Kind.SDF],
    }
    answers = {}
    for engine in engines:
        read = [kind for kind, own in ENGINES.items() if engine in own]
        files = [file for kind in read for file in (*sources[kind], *written[kind])]
        answers[engine] = _ask(engine, files, models)
    for one in done:
        yield from _judged(one, answers)


def _judged(done: Done, answers: dict[Engine, dict[Path, Answer]]) -> Iterator[Finding]:
    job = done.job
    own = next((engine for engine in ENGINES[job.kind] if engine in answers), None)
    is_read = own is not None and answers[own][job.source].is_accepted
    if not done.is_written:
        code, message = done.why
        if is_read and code not in CANNOT and "choose one with --model" not in message:
            yield Finding("false refusal", job.name, f"{code} {message}")
        return
    readers = [engine for engine in ENGINES[job.kind] if engine in answers]
    of_source = [answers[engine][job.source] for engine in readers]
    known = sum((_complaints(answer) for answer in of_source), Counter[str]())
    for engine in ENGINES[Kind.SDF if job.kind is Kind.URDF else Kind.URDF]:
        if engine not in answers or not is_read:
            continue
        answer = answers[engine][job.target]
        if not answer.is_accepted and f"{NAMED[engine]} refuses it" not in done.said:
            yield Finding("refused result", job.name, f"{engine.value}: {answer.error}")
        for complaint in _complaints(answer) - known if answer.is_accepted else ():
            if not FOLLOWS.match(complaint) and not _is_reported(complaint, done):
                yield Finding("complaint", job.name, f"{engine.value}: {complaint}")


def _is_reported(complaint: str, done: Done) -> bool:
    """Does an error or warning of the conversion name what a consumer complains of?"""
    messages = [message for _, severity, message in done.reported if severity != "info"]
    named = re.findall("'([^']+)'", complaint)
    return any(f"`{name}`" in message for name in named for message in messages)


def examine(folders: Sequence[Path], results: Path, version: str = "") -> tuple[list[Done], list[Finding]]:
    """Convert and judge all that is in some folders; results go to a folder, and SDFormat is of some version."""
    models = sorted({place for folder in folders for place in folder.rglob("models") if place.is_dir()})
    chosen = [option for place in models for option in ("--model-path", str(place))]
    newest = ("--sdf-version", version) if version else ()
    done = [
        convert(job, *chosen, *(newest if job.kind is Kind.URDF else ())) for job in jobs(folders, results)
    ]
    found = [finding for one in done if one.is_written for finding in broken(one)]
    return done, [*found, *judged(done, models)]


def main(arguments: Sequence[str]) -> int:
    """Print what is wrong. ``--keep=FOLDER``: results stay there; ``--sdf-version=VERSION``: what to write."""
    options = dict(one.split("=", 1) for one in arguments if one.startswith("--"))
    folders = [Path(one) for one in arguments if not one.startswith("--")]
    with tempfile.TemporaryDirectory() as scratch:
        results = Path(options.get("--keep", scratch))
        results.mkdir(parents=True, exist_ok=True)
        done, found = examine(folders, results, options.get("--sdf-version", ""))
        written = sum(one.is_written for one in done)
    for finding in found:
        print(finding)
    counts = Counter(finding.kind for finding in found)
    print(f"{len(done)} robots, {written} converted: {dict(counts)}")
    return int(bool(found))


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
