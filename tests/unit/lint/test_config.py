import json
import sys
from pathlib import Path

import pytest

from sdfcheck.lint.config import show as config_show
from sdfcheck.lint.config.configuration import Configuration, load
from sdfcheck.lint.config.schema import render, schema
from sdfcheck.lint.config.settings import FIELDS, Pattern, Settings, line_of
from sdfcheck.lint.diagnostic import Severity
from sdfcheck.source.errors import WrongUsage

EVERYTHING = """\
select = ["AAA", "first-flaw"]
extend-select = ["BBB001"]
ignore = ["AAA002"]
target = ["gazebo"]
exclude = ["third_party/", "*.gen.sdf"]
respect-gitignore = false
plugins = ["my_rules", "./packs"]
fail-on = "error"
output-format = ["concise", "sarif=out.sarif"]
model-paths = ["models"]
package-paths = ["../ws/src"]

[per-file-ignores]
"worlds/*.sdf" = ["AAA"]

[severity]
AAA001 = "info"
BBB = "off"

[packages]
my_robot = "src/my_robot"

[xacro]
"arm.xacro" = { side = "left", sim = true, size = 2 }
"hand.xacro" = [{ side = "left" }, { side = "right" }]
"""


def write(path: Path, text: str) -> Path:
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text)
    return path


def settings_for(path: Path) -> Settings:
    return Configuration().settings_for(path)


def test_every_key_is_read(tmp_path: Path) -> None:
    (tmp_path / "packs").mkdir()
    file = write(tmp_path / "sdfcheck.toml", EVERYTHING)
    settings = load(file)
    (source,) = settings.files
    assert source.path == file
    assert settings._replace(files=()) == Settings(
        select=("AAA", "first-flaw"),
        extend_select=("BBB001",),
        ignore=("AAA002",),
        per_file_ignores=((Pattern(tmp_path, "worlds/*.sdf"), ("AAA",)),),
        severity=(("AAA001", Severity.INFO), ("BBB", None)),
        target=("gazebo",),
        exclude=(Pattern(tmp_path, "third_party/"), Pattern(tmp_path, "*.gen.sdf")),
        respect_gitignore=False,
        plugins=("my_rules", str(tmp_path / "packs")),
        fail_on=Severity.ERROR,
        output_format=("concise", "sarif=out.sarif"),
        model_paths=(tmp_path / "models",),
        package_paths=(tmp_path.parent / "ws/src",),
        packages=(("my_robot", tmp_path / "src/my_robot"),),
        xacro=(
            (Pattern(tmp_path, "arm.xacro"), ((("side", "left"), ("sim", "true"), ("size", "2")),)),
            (Pattern(tmp_path, "hand.xacro"), ((("side", "left"),), (("side", "right"),))),
        ),
    )


def test_settings_and_the_table_of_keys_agree() -> None:
    keys = {field.attribute for field in FIELDS}
    assert keys == {*Settings._fields, "extend"} - {"files", "given"}


def test_the_closest_file_counts_alone(tmp_path: Path) -> None:
    write(tmp_path / "sdfcheck.toml", 'ignore = ["AAA"]\nfail-on = "info"')
    write(tmp_path / "a/b/.sdfcheck.toml", 'select = ["BBB"]')
    assert settings_for(tmp_path / "a/x.sdf").ignore == ("AAA",)
    inner = settings_for(tmp_path / "a/b/c/x.sdf")
    assert (inner.select, inner.ignore, inner.fail_on) == (("BBB",), (), Severity.WARNING)


def test_in_one_folder_the_hidden_file_counts(tmp_path: Path) -> None:
    write(tmp_path / "pyproject.toml", '[tool.sdfcheck]\nselect = ["C"]')
    assert settings_for(tmp_path / "x.sdf").select == ("C",)
    write(tmp_path / "sdfcheck.toml", 'select = ["B"]')
    assert settings_for(tmp_path / "x.sdf").select == ("B",)
    write(tmp_path / ".sdfcheck.toml", 'select = ["A"]')
    assert settings_for(tmp_path / "x.sdf").select == ("A",)


def test_a_pyproject_that_says_nothing_is_passed_over(tmp_path: Path) -> None:
    write(tmp_path / "sdfcheck.toml", 'select = ["A"]')
    write(tmp_path / "sub/pyproject.toml", '[project]\ndependencies = ["sdfcheck"]')
    assert settings_for(tmp_path / "sub/x.sdf").select == ("A",)


def test_a_broken_pyproject_of_somebody_else_is_not_our_concern(tmp_path: Path) -> None:
    write(tmp_path / "pyproject.toml", "[project")
    assert settings_for(tmp_path / "x.sdf") == Settings()


def test_without_a_file_nothing_is_parsed(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "tomllib", None)
    write(tmp_path / "pyproject.toml", "[project]")
    assert settings_for(tmp_path / "x.sdf") == Settings()


def test_isolated_and_a_given_file_stop_the_search(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    write(tmp_path / "sdfcheck.toml", 'select = ["A"]')
    other = write(tmp_path / "conf/strict.toml", 'select = ["B"]\nmodel-paths = ["models"]')
    monkeypatch.chdir(tmp_path)
    assert Configuration(isolated=True).settings_for(tmp_path / "x.sdf") == Settings()
    given = Configuration(other).settings_for(tmp_path / "x.sdf")
    assert given.select == ("B",)
    assert given.model_paths == (tmp_path / "models",)


def test_extending(tmp_path: Path) -> None:
    write(
        tmp_path / "base/base.toml",
        'select = ["A"]\nignore = ["B"]\nextend-select = ["C"]\nmodel-paths = ["m"]',
    )
    file = write(tmp_path / "sdfcheck.toml", 'extend = "base/base.toml"\nignore = []\nextend-select = ["D"]')
    settings = load(file)
    assert (settings.select, settings.ignore, settings.extend_select) == (("A",), (), ("C", "D"))
    assert settings.model_paths == (tmp_path / "base/m",)
    assert [source.path.name for source in settings.files] == ["sdfcheck.toml", "base.toml"]


def test_extending_in_a_circle_is_refused(tmp_path: Path) -> None:
    write(tmp_path / "a.toml", 'extend = "b.toml"')
    write(tmp_path / "b.toml", 'extend = "a.toml"')
    with pytest.raises(WrongUsage, match=r"extend each other: .*a\.toml → .*b\.toml → .*a\.toml"):
        load(tmp_path / "a.toml")


@pytest.mark.parametrize(
    ("text", "complaint"),
    [
        ('\nignroe = ["A"]', ":2: unknown key `ignroe`; did you mean `ignore`?"),
        ("# select\nselect = 3", ":2: `select` should be a list of rule codes, names or families"),
        ("ignore = [3]", ":1: `ignore` should be a list"),
        ('target = "gazebo"', ':1: `target` should be a list of targets: write `["gazebo"]`'),
        ('respect-gitignore = "yes"', ":1: `respect-gitignore` should be true or false"),
        ('fail-on = "warn"', ":1: `fail-on` should be `error`, `warning` or `info`"),
        ("severity = 3", ":1: `severity` should be a table of severities"),
        (
            '[severity]\nA = "info"\nB = "fatal"',
            ":3: `B` of `severity` should be `error`, `warning`, `info` or `off`",
        ),
        ('[per-file-ignores]\n"*.sdf" = "A"', ":2: `*.sdf` of `per-file-ignores` should be a list of rule"),
        ("[packages]\nx = 3", ":2: `x` of `packages` should be a path"),
        ('[xacro]\n"a.xacro" = 3', ":2: `a.xacro` of `xacro` should be a table of texts"),
        ('target = ["gazbo"]', ":1: unknown target `gazbo`; did you mean `gazebo`?"),
        ('exclude = [\n  "a",\n  "!",\n]', ":3: `!` is not a pattern"),
        ("extend = 3", ":1: `extend` should be a path"),
        ("max-file-size = 0", ":1: `max-file-size` should be a number of megabytes"),
        ("max-file-size = true", ":1: `max-file-size` should be a number of megabytes"),
        ('max-file-size = "1"', ":1: `max-file-size` should be a number of megabytes"),
        ('\n\nextend = "gone.toml"', ":3: no such file: "),
        ("a = 1\nb =\n", ":2: invalid value"),
        ("a = 1\na = 2", ":2: cannot overwrite a value"),
    ],
)
def test_mistakes_are_placed(tmp_path: Path, text: str, complaint: str) -> None:
    file = write(tmp_path / "sdfcheck.toml", text)
    with pytest.raises(WrongUsage) as caught:
        load(file)
    assert f"sdfcheck.toml{complaint}" in str(caught.value)
    assert "\n" not in str(caught.value)


def test_mistakes_in_a_pyproject_are_looked_for_in_our_table() -> None:
    text = "[tool.other]\nselect = 1\n# ignore\n[tool.sdfcheck]\nextend-select = 2\nselect = 3\n"
    assert line_of(text, ("select",)) == 6


def test_missing_and_undecodable_files(tmp_path: Path) -> None:
    with pytest.raises(WrongUsage, match=r"cannot read .*gone\.toml: No such file"):
        load(tmp_path / "gone.toml")
    (tmp_path / "bad.toml").write_bytes(b'ignore = []\n# \xff"')
    with pytest.raises(WrongUsage, match=r"bad\.toml:2: not UTF-8"):
        load(tmp_path / "bad.toml")


def test_unknown_rules_are_placed_where_they_are_named(tmp_path: Path) -> None:
    write(tmp_path / "base.toml", 'select = ["A"]\nignore = [\n  "nonsense",\n]')
    settings = load(write(tmp_path / "sdfcheck.toml", 'extend = "base.toml"'))
    assert str(settings.misplaced("nonsense", "unknown")).endswith("base.toml:3: unknown")
    assert str(settings.misplaced("elsewhere", "unknown")) == "unknown"


@pytest.mark.parametrize(
    ("glob", "path", "matches"),
    [
        ("*.sdf", "a/b.sdf", True),
        ("/*.sdf", "a/b.sdf", False),
        ("a/", "a/b/c.sdf", True),
        ("a/**/c.sdf", "a/b/c.sdf", True),
        ("b.sdf", "a/b.sdf", True),
        ("x/b.sdf", "a/b.sdf", False),
        ("*.sdf", "../b.sdf", False),
    ],
)
def test_patterns_read_as_in_a_gitignore(tmp_path: Path, glob: str, path: str, matches: bool) -> None:
    assert Pattern(tmp_path, glob).matches(tmp_path / path) is matches


def test_settings_of_a_file(tmp_path: Path) -> None:
    settings = load(write(tmp_path / "sdfcheck.toml", EVERYTHING))
    assert settings.excludes(tmp_path / "third_party/x.sdf")
    assert not settings.excludes(tmp_path / "x.sdf")
    assert settings.ignored_for(tmp_path / "worlds/x.sdf") == ("AAA",)
    assert settings.ignored_for(tmp_path / "x.sdf") == ()
    assert settings.arguments_for(tmp_path / "hand.xacro") == ((("side", "left"),), (("side", "right"),))
    assert settings.arguments_for(tmp_path / "foot.xacro") == ()


def test_an_exclusion_can_be_taken_back(tmp_path: Path) -> None:
    settings = load(write(tmp_path / "sdfcheck.toml", 'exclude = ["a/", "!a/b.sdf"]'))
    assert settings.excludes(tmp_path / "a/c.sdf")
    assert not settings.excludes(tmp_path / "a/b.sdf")


def test_the_schema_knows_every_key() -> None:
    properties = schema()["properties"]
    assert list(properties) == [field.key for field in FIELDS]
    assert all("description" in entry and len(entry) > 1 for entry in properties.values())
    assert json.loads(render()) == schema()


def test_the_written_schema_is_up_to_date() -> None:
    written = Path(__file__).parents[3] / "docs" / "sdfcheck.schema.json"
    assert written.read_text(encoding="utf-8") == render()


def test_shown_settings_read_back_the_same(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    settings = load(write(tmp_path / "sdfcheck.toml", EVERYTHING))
    again = load(write(tmp_path / "again.toml", config_show.render(settings)))
    assert again._replace(files=()) == settings._replace(files=())
    defaults = load(write(tmp_path / "defaults.toml", config_show.render(Settings())))
    assert defaults._replace(files=()) == Settings()


def test_the_documented_defaults_are_the_defaults(tmp_path: Path) -> None:
    lines = [f"{field.key} = {field.default}" for field in FIELDS if field.default]
    defaults = load(write(tmp_path / "sdfcheck.toml", "\n".join(lines)))
    assert defaults._replace(files=()) == Settings()
