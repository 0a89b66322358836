from collections.abc import Iterator, Mapping

from sdfcheck import (
    Bad,
    Consumer,
    Diagnostic,
    Good,
    Missing,
    MissingKind,
    Origin,
    Rule,
    Severity,
    problems,
    warns,
)
from sdfcheck_rules.xac.scaffold import FILE, IN_XACRO
from sdfcheck_rules.xac.unreached import unless_reached

_HELP: Mapping[str, str] = {
    "argument": "give it a value: `{detail}:=…` after the file, or under `xacro` in the configuration",
    "variable": "set it, and pass it on with `--env {detail}` or `env` in the configuration",
    "withheld": "pass it on with `--env {detail}` or `env` in the configuration",
    "file": 'correct the path, or write `optional="true"` if the file need not be there',
    "above": "write the path as it is from the file itself",
    "ignored": "run the build that makes it, or correct the path",
    "built": "run the build",
    "submodule": "fetch it with `git submodule update --init`, or correct the path",
    "syntax": "correct the file that is included",
    "text": "save the file as UTF-8",
    "number": "write the number alone, with a point for the decimals: lengths are in meters, angles in radians",
    "pattern": "correct the pattern, or remove the include: xacro includes nothing here, and warns",
    "recursion": "put the call into an `xacro:if` or `xacro:unless` that ends it",
    "refused": "an expansion may compute, and read files below the project and the package paths",
}
_MESSAGES: Mapping[str, str] = {
    "argument": "argument `{detail}` has no value, so what depends on it is not checked",
    "variable": "environment variable `{detail}` is not set for the expansion",
    "withheld": "environment variable `{detail}` is set, but not passed on to the expansion",
    "number": "`{detail}` is not a number",
    "pattern": "no file matches `{detail}`, so nothing is included",
    "text": "xacro cannot read the file here: {detail}",
    "syntax": "the included file is not well-formed: {detail}",
    "recursion": "macro `{detail}` calls itself without end",
    "file": "cannot read {detail}",
    "above": "this leads to a file from `{detail}` only, and xacro looks beside the file",
    "ignored": "git ignores {detail}, which is not there: a build may make it",
    "built": "the build of the package makes {detail}, which is not there yet",
    "submodule": "folder `{detail}` is empty: it may be a submodule that is not checked out",
}

_WORDS = {
    "circular variable definition: ": (
        "a property is defined by itself: {}",
        "give it a value that does not read it",
    ),
    "Property names must not start with double underscore:": (
        "`{}` begins with two underscores, which xacro keeps for itself",
        "rename the property, here and where it is read",
    ),
}
"""How xacro begins to say what is wrong → our words for it, and what to do."""
_MISSING = {"submodule": MissingKind.SUBMODULE, "ignored": MissingKind.IGNORED, "built": MissingKind.BUILT}
_ELSEWHERE = {"above", "argument", "pattern", "variable", "withheld", *_MISSING}
"""The kinds of what another computer, or another call, may have."""


_STOP = "xacro.fatal("


class ExpansionError(Rule):
    """xacro cannot expand the file.

    An expression fails, an included file is missing or malformed, a macro calls itself
    without end, or the expansion exceeds a limit (time, memory, files). The diagnostic is at
    the expression as it is written, and shows the macro calls and includes that lead
    there. The rest of the robot is expanded and checked, as far as it does not depend on
    that. A substitution argument without a value is a warning: the file may be sound. So is
    an environment variable that is not set here, a file that is not there for the default of an argument, that git
    ignores or `CMakeLists.txt` makes, or whose path holds on one computer or from another folder only, what the file
    stops at on purpose (`xacro.fatal`), and what xacro does not stop for: a pattern that matches no file, and a mistake
    in a branch or macro that is not reached.

    Expansion runs in a process of its own, without network, with few environment
    variables, and reads nothing outside the project: a xacro file is a program.
    """

    code = "XAC001"
    name = "expansion-error"
    severity = Severity.ERROR
    remedy = """Correct the expression, or the values that reach it.

    Notes show where the values come from. Expressions are those of Python without imports: texts need
    quotes, and properties are named without another `${…}`. An argument gets a value by `NAME:=VALUE` after
    the file, or a default in `<xacro:arg name="…" default="…"/>`. A condition is `true`, `false` or a
    number. For macros that call themselves, `xacro:if` has to end them.
    """
    explains = (problems.ExpansionFailure,)
    scaffold = IN_XACRO

    bad = (
        Bad('<link name="a«${1 / 0}»"/>', file=FILE, says="division by zero"),
        Bad(
            '<xacro:property name="half" value="«${1 +}»"/><link name="a${half}"/>',
            file=FILE,
            says="`${1 +}` cannot be evaluated",
        ),
        Bad(
            "<xacro:if value='1'>«${xacro.fatal('which arm?')}»</xacro:if>",
            file=FILE,
            says="the file stops here on purpose: which arm?",
        ),
        Bad(
            '<xacro:if value="«yes»"><link name="a"/></xacro:if>',
            file=FILE,
            says="`yes` is neither true nor false",
        ),
        Bad(
            '<link name="«$(var prefix)»a"/>',
            file=FILE,
            says="`var` is a word of launch files: xacro has `arg`",
        ),
        Bad(
            '<xacro:property name="r" value="«0,05»"/><link name="a"><visual><origin xyz="0 0 ${r * 2.0}"/>'
            '<geometry><sphere radius="${r}"/></geometry></visual></link>',
            file=FILE,
            says="`0,05` is not a number; `${r * 2.0}` computes with it",
        ),
        Bad('<xacro:include filename="«missing.xacro»"/>', file=FILE, says="no such file"),
        Bad(
            '<xacro:arg name="kind" default="kind_7"/><xacro:include filename="«$(arg kind)/a.xacro»"/>',
            file=FILE,
            says="no such file or directory; the default of argument `kind` is `kind_7`",
        ),
        Bad('<link name="«$(arg prefix)»a"/>', file=FILE, says="argument `prefix` has no value"),
        Bad(
            '<«xacro:property» name="__n" value="1"/><link name="a${__n}"/>',
            file=FILE,
            says="`__n` begins with two underscores, which xacro keeps for itself",
        ),
        Bad(
            '<xacro:property name="n" value="«${n}»"/><link name="a${n}"/>',
            file=FILE,
            says="a property is defined by itself: n -> n",
        ),
        Bad(
            '<xacro:macro name="m" params="n"><«xacro:m» n="${n + 1}"/></xacro:macro><xacro:m n="0"/>',
            file=FILE,
            says="without end",
        ),
    )
    good = (
        Good('<xacro:arg name="prefix" default="x"/><link name="$(arg prefix)a"/>', file=FILE),
        Good(
            '<xacro:if value="${1 > 2}"><link name="${1 / 0}"/></xacro:if>', why="never evaluated", file=FILE
        ),
    )

    def check(self, problem: problems.ExpansionFailure) -> Iterator[Diagnostic]:
        kind = problem.kind.value
        reason = problem.reason
        advice = _HELP.get(kind, "").format(detail=problem.detail) or (None if reason is None else "")
        if reason is not None and reason.argument:
            advice = _HELP["argument"].format(detail=reason.argument)
        is_dormant = problem.is_dormant and kind != "pattern"
        own = dict(unless_reached(is_dormant=is_dormant, help=advice))
        labels = {reason.place: reason.label} if reason and reason.place else {}
        if problem.cause not in {None, problem.span}:
            labels[problem.cause] = "here"
        if kind == "argument" and reason is not None:
            own["help"] = (
                f"give it a value (`{problem.detail}:=…` after the file), or define it before its first use"
            )
        elif is_meant(problem):
            own |= {"severity": Severity.WARNING, "help": "give it the arguments that it asks for"}
        elif kind in _ELSEWHERE or (reason is not None and reason.argument) or is_absolute(problem):
            own["severity"] = Severity.WARNING
        for beginning, (_, help_) in _WORDS.items():
            if problem.detail.startswith(beginning):
                own["help"] = help_
        if kind in _MISSING:
            own["missing"] = Missing(_MISSING[kind], problem.detail)
        if kind == "pattern":
            own["affects"] = dict.fromkeys(Consumer, warns("gets a robot description without it"))
        origins = tuple(Origin(*step) for step in problem.origins)
        yield self.diagnostic(
            problem.span, _message(problem), labels=labels, origins=origins, cause=problem.cause, **own
        )


def is_meant(problem: problems.ExpansionFailure) -> bool:
    """Does the file stop itself, as it lacks an argument?"""
    return _STOP in problem.expression


def is_absolute(problem: problems.ExpansionFailure) -> bool:
    """Is a file missing whose path holds on one computer only?"""
    return problem.kind.value == "file" and problem.span.text.startswith("/")


def _message(problem: problems.ExpansionFailure) -> str:
    detail, kind, reason = problem.detail, problem.kind.value, problem.reason
    if kind == "argument" and reason is not None:
        return f"argument `{detail}` has no value here: {reason.words}"
    because = f"; {reason.words}" if reason is not None else ""
    if is_meant(problem):
        return f"the file stops here on purpose: {detail}"
    if kind == "expression" and problem.expression:
        return f"`{problem.expression}` cannot be evaluated: {detail}{because}"
    for beginning, (words, _) in _WORDS.items():
        if detail.startswith(beginning):
            return words.format(detail.removeprefix(beginning).split(" Consider")[0].strip())
    return _MESSAGES.get(kind, "expansion fails: {detail}").replace("{detail}", detail) + because
