"""Lints examples of rules, each among the other files that it names."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path
from tempfile import TemporaryDirectory

from sdfcheck.files.library import Library
from sdfcheck.lint.diagnostic import Diagnostic
from sdfcheck.lint.engine import Dispatch, Xacro
from sdfcheck.lint.example import Bad, Good
from sdfcheck.lint.rulebook.packs import RuleIndex
from sdfcheck.lint.run import RuleFacts
from sdfcheck.lint.select import ActiveRules
from sdfcheck.lint.source_file import lint_source
from sdfcheck.source.sniff import Kind
from sdfcheck.xacro.expansion import Expander

_KINDS = {".xacro": Kind.XACRO, ".config": Kind.MODEL_CONFIG, ".srdf": Kind.SRDF}


class ExampleRunner:
    """Lints with some of the rules of an index, for the consumers in ``targets``."""

    def __init__(
        self,
        index: RuleIndex,
        rules: Iterable[RuleFacts],
        targets: Iterable[str] = (),
        *,
        expander: Expander | None = None,
    ) -> None:
        self._dispatch = Dispatch(index, ActiveRules(tuple(rules), {}, frozenset(targets)))
        self._xacro = Xacro(expander or Expander())

    def lint(self, text: str, example: Bad | Good, folder: Path | None = None) -> list[Diagnostic]:
        """Lint a text as the example's file, among the example's other files, which are written to ``folder``."""
        kind, path = _KINDS.get(Path(example.file).suffix), Path(file_name(text, example))
        if example.files is None:
            return lint_source(text.encode(), path, kind, self._dispatch, None, self._xacro).diagnostics
        if folder is None:
            with TemporaryDirectory() as made:
                return self.lint(text, example, Path(made))
        for name, content in example.files.items():
            file = folder / name
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_text(content, encoding="utf-8")
        return lint_source(
            text.encode(), folder / path, kind, self._dispatch, Library(), self._xacro
        ).diagnostics


def file_name(text: str, example: Bad | Good) -> str:
    """The name of the file that an example is in."""
    return example.file or ("robot.urdf" if "<robot" in text else "robot.sdf")
