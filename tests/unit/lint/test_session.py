from pathlib import Path

import pytest

from sdfcheck.files import regular
from sdfcheck.files.discover import Found
from sdfcheck.lint import session
from sdfcheck.lint.config.configuration import Configuration
from sdfcheck.lint.config.settings import UNSET, Settings
from sdfcheck.lint.run import Run
from sdfcheck.lint.session import InternalError, Level, Notice, Options, run
from sdfcheck.source.errors import WrongUsage
from sdfcheck.source.sniff import HEAD, Kind
from tests.posix import IS_ROOT
from tests.unit.lint.fake_engine import Seen, install

SDF = '<sdf version="1.9">{}</sdf>'
CHEMISTRY = "ethanol\n\n\n  9  8  0  V2000\nM  END\n"


@pytest.fixture
def seen(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> list[Seen]:
    monkeypatch.chdir(tmp_path)
    return install(monkeypatch)


def plant(**files: str) -> list[Path]:
    """Files by name, with the dot of the suffix written as ``_``."""
    paths = [Path(name.replace("_", ".")) for name in files]
    for path, text in zip(paths, files.values(), strict=True):
        path.write_text(text)
    return paths


def lint(
    *paths: Path, notices: list[Notice] | None = None, given: Settings = UNSET, **options: object
) -> Run:
    made = Options(Configuration(trusted=True, given=given))._replace(**options)  # type: ignore[arg-type]
    return run(paths, made, notify=(notices if notices is not None else list[Notice]()).append)


def codes(done: Run) -> list[str]:
    return [diagnostic.code for diagnostic in done.diagnostics]


def test_a_run_is_sorted_and_complete(seen: list[Seen]) -> None:
    b, a, c = plant(b_sdf=SDF.format("? !"), a_urdf="<robot>!</robot>", c_sdf=SDF.format(""))
    done = lint(Path())
    assert [(d.code, d.span.source.path) for d in done.diagnostics] == [
        ("AAA001", a),
        ("BBB001", b),
        ("AAA001", b),
    ]
    assert done.files == (a, b, c)
    assert [facts.code for facts in done.rules] == ["AAA001", "BBB001", "INT001", "SUP001", "SUP002"]
    assert [(file.path, file.kind) for file in seen] == [(a, Kind.URDF), (b, Kind.SDF), (c, Kind.SDF)]


def test_broken_xml_is_left_to_the_parser(seen: list[Seen]) -> None:
    plant(a_sdf="?xml version='1.0'?><sdf/>")
    lint(Path())
    assert seen[0].kind is None


def test_large_files_are_read_whole(seen: list[Seen]) -> None:
    text = SDF.format(" " * (2 * HEAD) + "!")
    done = lint(*plant(a_sdf=text))
    assert seen[0].data == text.encode()
    assert codes(done) == ["AAA001"]


def test_choices_of_the_command_line_and_the_file_apply(seen: list[Seen]) -> None:
    plant(a_sdf=SDF.format("!?~"), b_sdf=SDF.format("!?~"))
    Path("sdfcheck.toml").write_text(
        'extend-select = ["CCC"]\n[per-file-ignores]\n"b.*" = ["AAA"]\n[severity]\nBBB = "error"'
    )
    done = lint(Path())
    assert codes(done) == ["AAA001", "BBB001", "CCC001", "BBB001", "CCC001"]
    assert {d.severity.value for d in done.diagnostics if d.code == "BBB001"} == {"error"}
    assert codes(lint(Path(), given=UNSET._replace(select=("AAA",)))) == ["AAA001"]
    assert codes(lint(Path("a.sdf"), given=UNSET._replace(target=("gazebo",)))) == ["AAA001", "CCC001"]


def test_each_folder_has_its_own_settings(seen: list[Seen]) -> None:
    Path("sub").mkdir()
    plant(a_sdf=SDF.format("!"))
    Path("sub/b.sdf").write_text(SDF.format("!"))
    Path("sub/sdfcheck.toml").write_text('ignore = ["AAA"]')
    assert [d.span.source.path for d in lint(Path()).diagnostics] == [Path("a.sdf")]


def test_excluded_files_are_left_out(seen: list[Seen]) -> None:
    plant(a_sdf=SDF, b_sdf=SDF)
    Path("sdfcheck.toml").write_text('exclude = ["b.sdf"]')
    done = lint(Path())
    assert done.files == (Path("a.sdf"),)
    assert done.skipped == ((Path("b.sdf"), "excluded by the configuration"),)
    assert lint(Path("b.sdf")).files == (Path("b.sdf"),)
    assert lint(Path("b.sdf"), force_exclude=True).files == ()


@pytest.mark.parametrize(
    ("text", "complaint"),
    [
        ('\nignore = ["loud-flow"]', "sdfcheck.toml:2: unknown rule `loud-flow`; did you mean `loud-flaw`?"),
        ('[per-file-ignores]\n"never" = ["XYZ"]', "sdfcheck.toml:2: unknown rule `XYZ`"),
        ('[severity]\nXYZ001 = "off"', "sdfcheck.toml:2: unknown rule `XYZ001`"),
        ('plugins = ["gone"]', "sdfcheck.toml:1: plugin gone: not there"),
    ],
)
def test_mistakes_in_the_configuration_stop_the_run(seen: list[Seen], text: str, complaint: str) -> None:
    plant(a_sdf=SDF)
    Path("sdfcheck.toml").write_text(text)
    with pytest.raises(WrongUsage) as caught:
        lint(Path())
    assert str(caught.value) == complaint


def test_mistakes_in_an_option_stop_the_run(seen: list[Seen]) -> None:
    with pytest.raises(WrongUsage, match=r"^unknown rule `XYZ`$"):
        lint(*plant(a_sdf=SDF), given=UNSET._replace(ignore=("XYZ",)))


def test_suppressions_are_applied_and_judged(seen: list[Seen]) -> None:
    text = "<sdf><!-- sdfcheck: ignore[AAA, BBB] -->!</sdf>"
    done = lint(*plant(a_sdf=text))
    assert codes(done) == ["SUP001"]
    assert done.suppressed == 1
    assert codes(lint(Path("a.sdf"), given=UNSET._replace(ignore=("SUP",)))) == []
    Path("sdfcheck.toml").write_text('severity = { SUP = "info" }')
    assert [d.severity.value for d in lint(Path("a.sdf")).diagnostics] == ["info"]


@pytest.mark.parametrize(
    ("text", "named", "walked"),
    [
        (CHEMISTRY, Level.NOTE, None),
        ("<html/>", Level.NOTE, None),
        ("version https://git-lfs.github.com/spec/v1\n", Level.WARNING, Level.WARNING),
        ("\0\1", Level.FAILURE, None),
    ],
)
def test_unrelated_files(seen: list[Seen], text: str, named: Level, walked: Level | None) -> None:
    (file,) = plant(a_sdf=text)
    notices: list[Notice] = []
    done = lint(file, notices=notices)
    assert [notice.level for notice in notices] == [named]
    assert done.files == ()
    assert done.skipped[0][0] == file
    assert done.skipped[0][1].startswith("looks like ")
    for unrelated, path in ((False, Path()), (True, file)):
        notices.clear()
        lint(path, notices=notices, skip_unrelated=unrelated)
        assert [notice.level for notice in notices] == ([walked] if walked else [])


def test_a_kind_that_is_given_overrules_the_looks_of_named_files(seen: list[Seen]) -> None:
    _, file = plant(a_urdf="<robot/>", b_txt="<html/>")
    lint(file, Path(), kind=Kind.SDF)
    assert [(entry.path.name, entry.kind) for entry in seen] == [("a.urdf", Kind.URDF), ("b.txt", Kind.SDF)]


def test_a_folder_without_files_is_a_warning(seen: list[Seen]) -> None:
    notices: list[Notice] = []
    assert lint(Path(), notices=notices).files == ()
    assert [notice.level for notice in notices] == [Level.WARNING]


@pytest.mark.skipif(IS_ROOT, reason="root reads everything")
def test_unreadable_files_do_not_stop_the_others(seen: list[Seen]) -> None:
    a, b = plant(a_sdf=SDF, b_sdf=SDF.format("!"))
    a.chmod(0)
    check_that_only_b_is_linted(a, b, "Permission denied")


def test_vanished_files_do_not_stop_the_others(seen: list[Seen], monkeypatch: pytest.MonkeyPatch) -> None:
    a, b = plant(a_sdf=SDF, b_sdf=SDF.format("!"))
    opened = regular.open_named

    def vanishing(path: Path, limit: int) -> object:
        if path == a:
            raise FileNotFoundError(2, "No such file or directory")
        return opened(path, limit)

    monkeypatch.setattr(session, "open_named", vanishing)
    check_that_only_b_is_linted(a, b, "No such file or directory")


def check_that_only_b_is_linted(a: Path, b: Path, reason: str) -> None:
    notices: list[Notice] = []
    done = lint(a, b, notices=notices)
    assert notices == [Notice(Level.FAILURE, f"a.sdf: cannot be read: {reason}")]
    assert done.files == (b,)
    assert codes(done) == ["AAA001"]


def test_stdin_goes_by_its_name(seen: list[Seen]) -> None:
    Path("sdfcheck.toml").write_text('[per-file-ignores]\n"sub/" = ["AAA"]\n')
    done = lint(stdin=SDF.format("!?").encode(), stdin_path=Path("sub/x.sdf"))
    assert codes(done) == ["BBB001"]
    assert done.files == (Path("sub/x.sdf"),)
    assert codes(lint(stdin=b"<robot>!</robot>")) == ["AAA001"]
    assert seen[-1] == Seen(b"<robot>!</robot>", Path("<stdin>"), Kind.URDF)


def test_progress_is_reported_before_each_file(seen: list[Seen]) -> None:
    plant(a_sdf=SDF, b_sdf=SDF)
    calls: list[tuple[int, int, Path]] = []
    run([Path()], Options(Configuration()), progress=lambda *where: calls.append(where))
    assert calls == [(0, 2, Path("a.sdf")), (1, 2, Path("b.sdf"))]


def test_a_bug_names_the_file(seen: list[Seen]) -> None:
    files = plant(a_sdf=SDF.format("crash"), b_sdf=SDF.format("?"))
    with pytest.raises(InternalError, match=r"a\.sdf: ValueError: no"):
        run(files, Options(Configuration()))


def test_a_bug_on_one_file_does_not_keep_the_others_from_being_linted(seen: list[Seen]) -> None:
    notices: list[Notice] = []
    done = lint(*plant(a_sdf=SDF.format("crash"), b_sdf=SDF.format("?")), notices=notices)
    assert [path.name for path in done.files] == ["b.sdf"]
    assert [(path.name, reason) for path, reason in done.skipped] == [("a.sdf", "met a bug")]
    (notice,) = notices
    assert notice.level is Level.FAILURE
    assert notice.text.startswith("a.sdf: internal error: ValueError: no")


def test_a_folder_that_cannot_be_read_is_skipped_with_the_reason(
    seen: list[Seen], monkeypatch: pytest.MonkeyPatch
) -> None:
    found = Found((), unreadable=((Path("dark"), "permission denied"),))
    monkeypatch.setattr(session, "discover", lambda *_, **__: found)
    assert lint(Path()).skipped == ((Path("dark"), "permission denied"),)
