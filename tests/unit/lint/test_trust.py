"""A configuration that comes with the files does nothing but decide how they are linted, until a person trusts it."""

import os
from pathlib import Path

import pytest

import sdfcheck
from sdfcheck.cli.main import main
from sdfcheck.lint.config import trust
from sdfcheck.lint.config.configuration import Configuration
from sdfcheck.source.errors import WrongUsage

MODEL = '<sdf version="1.9"><model name="m"><link name="l"/></model></sdf>'
CODE = "import pathlib\npathlib.Path(__file__).with_name('it_ran').touch()\n"


@pytest.fixture(autouse=True)
def repository(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> Path:
    """A clone with a pack of rules, in a home without a configuration."""
    folder = tmp_path / "clone"
    (folder / ".git").mkdir(parents=True)
    (folder / "models").mkdir()
    (folder / "models" / "model.sdf").write_text(MODEL)
    (folder / "pack").mkdir()
    (folder / "pack" / "rules.py").write_text(CODE)
    monkeypatch.setenv("XDG_CONFIG_HOME", str(tmp_path / "home"))
    monkeypatch.setenv("APPDATA", str(tmp_path / "home"))
    monkeypatch.chdir(folder)
    return folder


def trusted(tmp_path: Path, text: str) -> Path:
    own = tmp_path / "home" / "sdfcheck" / "config.toml"
    own.parent.mkdir(parents=True, exist_ok=True)
    own.write_text(text)
    return own


def refusal(text: str, name: str = "sdfcheck.toml") -> str:
    Path(name).write_text(text)
    with pytest.raises(WrongUsage) as caught:
        Configuration().settings_for(Path("models/model.sdf"))
    return str(caught.value)


@pytest.mark.parametrize(
    "command",
    [
        "lint",
        "lint models",
        "lint models/model.sdf",
        "lint --fix",
        "lint --show-files",
        "targets models/model.sdf",
        "convert sdf-to-urdf models/model.sdf",
        "rules",
        "rule NS003",
    ],
)
def test_code_of_a_repository_does_not_run(
    repository: Path, capsys: pytest.CaptureFixture[str], command: str
) -> None:
    Path("sdfcheck.toml").write_text('ignore = []\nplugins = ["pack/"]\n')
    assert main(command.split()) == 2
    assert capsys.readouterr().err.startswith(
        "error: sdfcheck.toml:2: `plugins` runs code, which needs your consent: pass --trust-config if"
    )
    assert not Path("pack/it_ran").exists()


def test_a_configuration_below_the_linted_folder_is_not_trusted_either(repository: Path) -> None:
    (repository / "models" / "sdfcheck.toml").write_text('plugins = ["../pack/"]\n')
    with pytest.raises(WrongUsage, match=r"^models/sdfcheck\.toml:1: `plugins` runs code"):
        sdfcheck.lint(repository)
    assert not Path("pack/it_ran").exists()


def test_consent_is_given_for_one_run(capsys: pytest.CaptureFixture[str]) -> None:
    Path("sdfcheck.toml").write_text('plugins = ["pack/"]\n')
    main(["lint", "--trust-config"])
    assert "needs your consent" not in capsys.readouterr().err
    assert Path("pack/it_ran").exists()
    assert main(["lint", "--trust-config", "--isolated"]) == 2


def test_a_configuration_that_is_named_is_trusted(repository: Path) -> None:
    file = repository.parent / "own.toml"
    file.write_text(f'plugins = ["{repository.as_posix()}/pack"]\n')
    assert Configuration(file).settings_for(Path("models/model.sdf")).plugins


def test_consent_is_given_for_good_in_a_persons_own_configuration(repository: Path, tmp_path: Path) -> None:
    refusal('plugins = ["pack/"]')
    trusted(tmp_path, f'trusted = ["{repository.parent.as_posix()}/other"]\n')
    refusal('plugins = ["pack/"]')
    trusted(tmp_path, f'trusted = ["{repository.as_posix()}"]\n')
    assert Configuration().settings_for(Path("models/model.sdf")).plugins


def test_a_link_does_not_lead_into_a_trusted_folder(
    repository: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    refusal('plugins = ["pack/"]')
    mine = tmp_path / "mine"
    mine.mkdir()
    (mine / "theirs").symlink_to(repository)
    trusted(tmp_path, f'trusted = ["{mine.as_posix()}"]\n')
    monkeypatch.chdir(mine)
    with pytest.raises(WrongUsage, match="runs code"):
        Configuration().settings_for(Path("theirs/models/model.sdf"))


@pytest.mark.parametrize(
    "text",
    [
        '[packages]\narm = "../arm"',
        'package-paths = [".", "/usr/share"]',
        'package-paths = ["elsewhere"]',
        'model-paths = ["~/models"]',
    ],
)
def test_the_search_stays_in_the_repository(text: str) -> None:
    Path("elsewhere").symlink_to("..")
    key = text.strip("[").partition("\n")[0].partition(" ")[0].strip("]")
    assert f"`{key}` leads out of" in refusal(text)


@pytest.mark.parametrize(
    ("text", "effect"),
    [
        ('package-paths = ["secret"]', "`package-paths` leads out of the files beside it"),
        ('extend = "secret/shared.toml"', "`extend` leads out of the files beside it"),
        ('extend = "shared.toml"', ""),
    ],
)
def test_a_shared_folder_is_not_a_project(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, text: str, effect: str
) -> None:
    home = tmp_path / "everyone"
    (home / "secret").mkdir(parents=True)
    monkeypatch.setenv("HOME", str(home))
    monkeypatch.setenv("USERPROFILE", str(home))
    for shared in (home, home / "secret"):
        (shared / "shared.toml").write_text("ignore = []")
    (home / "a.sdf").write_text(MODEL)
    (home / "sdfcheck.toml").write_text(text)
    if not effect:
        assert Configuration().settings_for(home / "a.sdf")
        return
    with pytest.raises(WrongUsage, match=effect):
        Configuration().settings_for(home / "a.sdf")


def test_a_path_in_the_repository_needs_no_consent(repository: Path) -> None:
    text = (
        'model-paths = ["models"]\npackage-paths = ["."]\noutput-format = ["concise"]\n[packages]\na = "a"\n'
    )
    (repository / "models" / "sdfcheck.toml").write_text(text.replace('"models"', '".."'))
    assert Configuration().settings_for(Path("models/model.sdf")).package_paths


def test_no_report_is_written_to_a_file_of_the_configurations_choice(repository: Path) -> None:
    Path("pyproject.toml").write_text('[tool.sdfcheck]\noutput-format = ["full", "concise=.git/hooks/x"]\n')
    assert main(["lint"]) == 2
    assert not (repository / ".git" / "hooks").exists()
    assert refusal('extend = "pyproject.toml"').startswith("pyproject.toml:2: `output-format` writes a file")


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        ('trusted = "x"', "`trusted` should be a list of folders"),
        ('trusted = ["x"]', "`trusted` should name absolute folders, not `x`"),
        ("plugins = []", "unknown key `plugins`; it has `trusted` only"),
    ],
)
def test_a_faulty_configuration_of_ones_own(tmp_path: Path, text: str, reason: str) -> None:
    trusted(tmp_path, text)
    assert reason in refusal('plugins = ["pack/"]')


def test_a_configuration_of_ones_own_that_is_not_text(tmp_path: Path) -> None:
    trusted(tmp_path, "").write_bytes(b"\xff")
    assert "cannot read" in refusal('plugins = ["pack/"]')


def test_a_relative_place_for_ones_own_configuration_does_not_count(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("XDG_CONFIG_HOME", "models")
    monkeypatch.setenv("APPDATA", "models")
    assert trust.own_configuration() is None
    Path("models/sdfcheck").mkdir()
    Path("models/sdfcheck/config.toml").write_text(f'trusted = ["{os.getcwd()}"]')
    assert "to trust it always" not in refusal('plugins = ["pack/"]')
