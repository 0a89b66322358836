"""Fixes do no harm: whichever are applied to examples, random texts and public files, they break nothing."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from random import Random

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from sdfcheck.lint.config.configuration import Configuration
from sdfcheck.lint.diagnostic import Diagnostic
from sdfcheck.lint.example import fill, unmark
from sdfcheck.lint.fix.fixer import FixedFile, fix_file
from sdfcheck.lint.one_file import Caches, Selected, lint_file
from sdfcheck.lint.rulebook.rulebook import RuleBook
from sdfcheck.lint.rulebook.trial import Trial, file_name
from tests.fuzz.documents import Text, changed, fixtures
from tests.harm_of_fixes import harm
from tests.test_rules import TRIALS, selected

CORPUS = Path(__file__).parents[2] / "shared" / "corpus"
pytestmark = pytest.mark.usefixtures("elsewhere")
BOOK = RuleBook()


def some_fixed(data: bytes, path: Path, chance: Random, share: float, *, unsafe: bool) -> FixedFile:
    """The file after some of its fixes, drawn again in each round."""
    configuration = Configuration(None, isolated=True)
    with Caches() as caches:

        def lint(file: Selected) -> tuple[Sequence[Diagnostic], int]:
            found, silenced = lint_file(file, BOOK, configuration.settings_for(path), caches)
            return [each if chance.random() < share else each._replace(fix=None) for each in found], silenced

        return fix_file(selected(data, path), lint, unsafe=unsafe)


@pytest.mark.parametrize(
    "trial", [trial for trial in TRIALS if getattr(trial.example, "fixed", None) is not None], ids=repr
)
def test_fixes_of_examples_do_no_harm(trial: Trial) -> None:
    data = unmark(fill(trial.rule.scaffold, trial.example))[0].encode()
    path = Path(file_name(data.decode(), trial.example))
    result = some_fixed(data, path, Random(1), 1.0, unsafe=True)
    assert harm(data, result.after, path) == ""


DIRECTIVES = ("ignore[NAM]", "disable[SCH]", "enable", "ignore-file[URD010]", "ignore[INR] -- why: so")


@settings(max_examples=40, deadline=None, suppress_health_check=list(HealthCheck))
@given(changed(st.sampled_from(fixtures())), st.randoms(use_true_random=False), st.booleans(), st.data())
def test_random_combinations_do_no_harm(
    text: Text, chance: Random, unsafe: bool, data: st.DataObject
) -> None:
    words = data.draw(st.sampled_from(DIRECTIVES))
    place = data.draw(st.sampled_from((">", "</", "<link", "<joint")))
    before = text.data.replace(place.encode(), f"<!-- sdfcheck: {words} -->{place}".encode(), 3)
    path = Path(f"file{text.suffix}")
    result = some_fixed(before, path, chance, data.draw(st.sampled_from((0.3, 1.0))), unsafe=unsafe)
    assert harm(before, result.after, path) == ""


@pytest.mark.skipif(not CORPUS.is_dir(), reason="public files are not there")
def test_public_files_take_no_harm() -> None:
    files = sorted(path for path in CORPUS.rglob("*") if path.suffix in {".sdf", ".urdf", ".xacro", ".world"})
    for path in Random(1).sample(files, 25):
        before = path.read_bytes()
        for unsafe in (False, True):
            result = some_fixed(before, path, Random(1), 1.0, unsafe=unsafe)
            assert harm(before, result.after, path) == "", path
            again = some_fixed(result.after, path, Random(1), 1.0, unsafe=unsafe)
            assert again.after == result.after, path
