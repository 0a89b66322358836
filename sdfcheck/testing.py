"""Tests for packs of rules: each example of each rule is a test.

With pytest, one test for each example::

    @pytest.mark.parametrize("example", sdfcheck.testing.examples("my_rules"), ids=str)
    def test_example(example):
        example.check()

or all of them at once, with any test runner::

    def test_pack():
        sdfcheck.testing.check_pack("my_rules")

Packs are named as in ``plugins`` in the configuration: an entry point, an import name or a folder, which
is a :class:`~pathlib.Path` or has a slash in it.
"""

from __future__ import annotations

from pathlib import Path

from sdfcheck.lint.rulebook.pack import Fault, PackError
from sdfcheck.lint.rulebook.trial import Bench, Trial

__all__ = ["FaultyRule", "PackError", "Trial", "check_pack", "examples"]


class FaultyRule:
    """A rule that cannot be loaded, as a test that fails."""

    __slots__ = ("fault",)

    def __init__(self, fault: Fault) -> None:
        self.fault = fault

    def __repr__(self) -> str:
        return self.fault.place

    def check(self) -> None:
        """Fail.

        Raises:
            AssertionError: always; the text says what is wrong with the rule, and where.
        """
        raise AssertionError(str(self.fault))


def examples(pack: str | Path) -> tuple[Trial | FaultyRule, ...]:
    """The examples of a pack, each with a ``check``; rules that cannot be loaded come first.

    Raises:
        PackError: the pack cannot be loaded at all.
    """
    bench = Bench(pack)
    return (*map(FaultyRule, bench.faults), *bench.trials)


def check_pack(pack: str | Path) -> None:
    """Run all examples of a pack.

    Raises:
        AssertionError: some are not as they should be; the text has one line for each.
        PackError: the pack cannot be loaded at all.
    """
    bench = Bench(pack)
    failures = (trial.failure() for trial in bench.trials)
    lines = [*map(str, bench.faults), *filter(None, failures)]
    if lines:
        raise AssertionError("\n".join(lines))
