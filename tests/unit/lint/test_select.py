import pytest

from sdfcheck.lint.config.settings import UNSET, Settings
from sdfcheck.lint.diagnostic import Severity
from sdfcheck.lint.run import RuleFacts
from sdfcheck.lint.select import UnknownSelector, check_targets, covered, select, without
from sdfcheck.source.errors import WrongUsage


def rule(
    code: str, name: str, *, default: bool = True, preview: bool = False, affects: tuple[str, ...] = ()
) -> RuleFacts:
    family = code.rstrip("0123456789")
    effects = {consumer: {"sdf": "warn: complains"} for consumer in affects}
    return RuleFacts(
        code, name, family, Severity.ERROR, "", "", default, (), (), effects, "", preview=preview
    )


RULES = (
    rule("AAA001", "first-flaw"),
    rule("AAA002", "second-flaw", affects=("gazebo", "drake")),
    rule("AAA011", "third-flaw"),
    rule("AA001", "short-family"),
    rule("BBB001", "quiet-flaw", default=False),
    rule("BBB002", "classic-flaw", default=False, affects=("gazebo",)),
)
DEFAULT = {"AAA001", "AAA002", "AAA011", "AA001"}


@pytest.mark.parametrize(
    ("selector", "codes"),
    [
        ("AAA011", {"AAA011"}),
        ("third-flaw", {"AAA011"}),
        ("AAA", {"AAA001", "AAA002", "AAA011"}),
        ("AAA00", {"AAA001", "AAA002"}),
        ("AA", {"AA001"}),
        ("ALL", {facts.code for facts in RULES}),
    ],
)
def test_selectors_cover(selector: str, codes: set[str]) -> None:
    assert covered(selector, RULES)[1] == codes


@pytest.mark.parametrize("selector", ["A", "AAA9", "aaa", "AAA0011", "", "flaw"])
def test_unknown_selectors_are_refused(selector: str) -> None:
    with pytest.raises(UnknownSelector, match=f"unknown rule `{selector}`"):
        covered(selector, RULES)


@pytest.mark.parametrize(
    ("selector", "meant"),
    [("aaa011", "AAA011"), ("thrid-flaw", "third-flaw"), ("all", "ALL")],
)
def test_unknown_selectors_suggest_a_near_one(selector: str, meant: str) -> None:
    with pytest.raises(UnknownSelector, match=f"did you mean `{meant}`"):
        covered(selector, RULES)


def test_a_number_that_no_rule_has_is_no_misspelling_of_another() -> None:
    with pytest.raises(UnknownSelector, match=r"unknown rule `AAA111`; AAA has AAA001 to AAA011$"):
        covered("AAA111", RULES)


@pytest.mark.parametrize(
    ("configured", "given", "codes"),
    [
        (Settings(), UNSET, DEFAULT),
        (Settings(select=("AAA",)), UNSET, {"AAA001", "AAA002", "AAA011"}),
        (Settings(select=()), UNSET, set()),
        (Settings(extend_select=("BBB001",)), UNSET, DEFAULT | {"BBB001"}),
        (Settings(select=("ALL",), ignore=("AAA", "BBB")), UNSET, {"AA001"}),
        (Settings(select=("AAA011",), ignore=("AAA",)), UNSET, {"AAA011"}),
        (Settings(select=("AAA",), ignore=("third-flaw",)), UNSET, {"AAA001", "AAA002"}),
        (Settings(select=("AAA011",), ignore=("AAA011",)), UNSET, set()),
        (Settings(select=("AAA",)), Settings(select=("BBB001",)), {"BBB001"}),
        (Settings(select=("AAA011",)), Settings(ignore=("AAA",)), set()),
        (
            Settings(select=("AAA",)),
            Settings(extend_select=("BBB001",)),
            {"AAA001", "AAA002", "AAA011", "BBB001"},
        ),
        (Settings(ignore=("AAA011",)), Settings(select=("AAA",)), {"AAA001", "AAA002"}),
        (Settings(ignore=("AAA",)), Settings(select=("AAA011",)), {"AAA011"}),
        (Settings(ignore=("AAA011",)), Settings(extend_select=("AAA011",)), DEFAULT),
    ],
)
def test_longer_selectors_and_the_command_line_win(
    configured: Settings, given: Settings, codes: set[str]
) -> None:
    assert select(RULES, configured.under(given)).codes == codes


def test_severities_follow_the_longest_selector_and_may_turn_off() -> None:
    severity = ("AAA011", Severity.INFO), ("AAA", Severity.WARNING), ("second-flaw", None)
    active = select(RULES, Settings(severity=severity))
    assert active.severities["AAA011"] is Severity.INFO
    assert active.severities["AAA001"] is Severity.WARNING
    assert "AAA002" not in active.codes


def test_targets_keep_rules_about_them_or_about_nobody() -> None:
    assert select(RULES, Settings(), targets=["drake"]).codes == DEFAULT
    assert select(RULES, Settings(), targets=["mujoco"]).codes == DEFAULT - {"AAA002"}


def test_a_target_turns_on_the_rules_that_wait_for_it() -> None:
    assert select(RULES, Settings(), targets=["gazebo", "mujoco"]).codes == DEFAULT | {"BBB002"}
    assert select(RULES, Settings(ignore=("BBB002",)), targets=["gazebo"]).codes == DEFAULT


def test_unknown_targets_are_refused() -> None:
    check_targets(["gazebo", "drake", "urdfdom", "mujoco"])
    with pytest.raises(WrongUsage, match="unknown target `gazbo`; did you mean `gazebo`"):
        check_targets(["gazbo"])
    with pytest.raises(WrongUsage, match="choose from drake, gazebo"):
        check_targets(["zzz"])


def test_files_can_do_without_rules() -> None:
    active = without(select(RULES, Settings()), ["AAA00", "third-flaw"], RULES)
    assert active.codes == {"AA001"}
    assert [facts.code for facts in select(RULES, Settings()).facts] == sorted(DEFAULT)


@pytest.mark.parametrize(
    ("module", "has_page"),
    [
        ("sdfcheck_rules.jnt.zero_limit", True),
        ("sdfcheck.lint.suppress.rules", True),
        ("workshop_rules.xyz", False),
    ],
)
def test_only_built_in_rules_have_pages(module: str, has_page: bool) -> None:
    facts = RuleFacts("XYZ001", "odd-flaw", "XYZ", Severity.ERROR, "", "", True, (), (), {}, module)
    assert facts.is_built_in is has_page
    assert (facts.page is not None) is has_page
