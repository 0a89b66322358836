from collections.abc import Iterator

from sdfcheck import (
    Bad,
    Consumer,
    Diagnostic,
    Element,
    Good,
    Rule,
    Severity,
    Span,
    Value,
    problems,
    rename,
    warns,
    write_instead,
)
from sdfcheck.problems import ParameterFault

ARM = {
    "arm.sdf": '<sdf version="1.12"><model name="arm"><link name="base"><visual name="skin"><geometry>'
    "<box><size>1 1 1</size></box></geometry></visual></link></model></sdf>"
}
ADVICE = {
    ParameterFault.UNKNOWN_ACTION: "write `add`, `modify`, `remove` or `replace`",
    ParameterFault.NO_NAME: "give the new element a `name`",
    ParameterFault.EMPTY_NAME: "give the new element a `name`",
    ParameterFault.TAKEN: "choose another name, or the action `modify` or `replace`",
    ParameterFault.UNKNOWN_ENTRY: "name the link, joint, frame or other named element that it is in",
    ParameterFault.NO_CHILD_ACTION: "write an `action` here, or in the element around it",
    ParameterFault.ABSENT_CHILD: "add it instead, with the action `add`",
    ParameterFault.UNKNOWN_CHILD: "remove it, or move it to an element that may hold it",
    ParameterFault.UNKNOWN_ATTRIBUTE: "remove the attribute",
    ParameterFault.NAME_ASSUMED: "write the `name` of the one that is meant",
    ParameterFault.NO_CHANGE: "write what is to change, or remove it",
}
"""The help where the rule's own would not fit."""
DOUBTS = {ParameterFault.NAME_ASSUMED, ParameterFault.NO_CHANGE}


class InvalidIncludeParameter(Rule):
    """A parameter of an include cannot be carried out.

    Each entry of `<experimental:params>` names an element of the included model by `element_id`
    and says in `action` whether to add, modify, remove or replace it; without an action its
    children say so. libsdformat skips an entry that it cannot carry out and refuses the
    document; where a name is missing it takes the first one. Added and replaced elements have
    to fit the format, too.
    """

    code = "RES010"
    name = "invalid-include-parameter"
    severity = Severity.ERROR
    remedy = """Let `element_id` lead to an element of the included model, and name an action for it.

    Actions are add, modify, remove and replace. `<visual element_id="base::skin" action="modify">` is an
    example: the names of the link and of its visual, with `::` between them. For `add` a `name` is needed
    as well, that of the new element. `sdfcheck print --expand-includes FILE` shows the result.
    """
    explains = (problems.InvalidParameter,)
    scaffold = (
        '<sdf version="1.12" xmlns:experimental="http://sdformat.org/schemas/experimental"><world name="w">'
        "<include><uri>arm.sdf</uri><experimental:params>{}</experimental:params></include></world></sdf>"
    )

    bad = (
        Bad('<«link» action="remove"/>', files=ARM, says="has no `element_id`"),
        Bad('<link element_id="«base::»" action="remove"/>', files=ARM, says="ends in `::`"),
        Bad('<link element_id="base" action="«delete»"/>', files=ARM, says="no action `delete`"),
        Bad('<«link» element_id="" action="add"/>', files=ARM, says="has no `name`"),
        Bad('<link element_id="" «name»="" action="add"/>', files=ARM, says="has an empty name"),
        Bad('<link element_id="" name="«base»" action="add"/>', files=ARM, says="already"),
        Bad(
            '<visual element_id="«base::skim»" action="remove"/>',
            fixed='<visual element_id="base::skin" action="remove"/>',
            unsafe=True,
            files=ARM,
            says="did you mean `base::skin`?",
        ),
        Bad('<link element_id="«base::skin»" action="remove"/>', files=ARM, says="is a visual, not a link"),
        Bad('<frame element_id="«top»" name="f" action="add"/>', files=ARM, says="no `top`"),
        Bad('<«glow» element_id="base" action="modify"/>', files=ARM, says="`glow` is not an element"),
        Bad('<link element_id="base"><«gravity»>0</gravity></link>', files=ARM, says="has an `action`"),
        Bad(
            '<link element_id="base"><«gravity» action="modify">0</gravity></link>',
            files=ARM,
            says="has no `gravity`",
        ),
        Bad('<link element_id="base"><«wheel» action="add"/></link>', files=ARM, says="may not hold `wheel`"),
        Bad('<link element_id="base" action="modify" «color»="red"/>', files=ARM, says="attribute `color`"),
        Bad('<link element_id="base"><«visual» action="remove"/></link>', files=ARM, says="`skin` is taken"),
        Bad('<«link» element_id="base"/>', files=ARM, says="changes nothing"),
    )
    good = (
        Good('<visual element_id="base::skin" action="remove"/>', files=ARM),
        Good(
            '<frame element_id="" name="top" action="add"/>', files=ARM, why="an empty id is the model itself"
        ),
        Good('<link element_id="base"><gravity action="add">0</gravity></link>', files=ARM),
        Good('<link element_id="elsewhere" action="remove"/>', files={}, why="the model is not known here"),
    )

    def check(self, problem: problems.InvalidParameter) -> Iterator[Diagnostic]:
        message = self.message(problem)
        if problem.suggestion is not None:
            message += f", did you mean `{problem.suggestion}`?"
        severity = Severity.WARNING if problem.fault in DOUBTS else Severity.ERROR
        place: Element | Value | Span = problem.place
        if problem.fault is ParameterFault.UNKNOWN_ATTRIBUTE and isinstance(place, Value):
            place = place.name_span
        doubtful = dict.fromkeys((Consumer.GAZEBO, Consumer.DRAKE), warns("changes nothing"))
        affects = doubtful if problem.fault is ParameterFault.NO_CHANGE else {}
        if problem.fault is ParameterFault.NAME_ASSUMED:
            affects = {Consumer.GAZEBO: warns("takes the first one")}
        write = rename if isinstance(place, Element) else write_instead
        fix = write(problem.suggestion, place)  # type: ignore[arg-type]
        yield self.diagnostic(
            place,
            message,
            severity=severity,
            affects=affects,
            fix=fix,
            help=ADVICE.get(problem.fault) if fix is None else None,
        )

    def message(self, problem: problems.InvalidParameter) -> str:
        place, entry, other = problem.place, problem.entry, problem.other
        name = place.name if isinstance(place, Element) else ""
        text, attribute = (place.text, place.attribute) if isinstance(place, Value) else ("", "")
        return {
            ParameterFault.NO_ID: f"this `{entry.name}` has no `element_id`",
            ParameterFault.OPEN_END: f"`{text}` ends in `::`",
            ParameterFault.UNKNOWN_ACTION: f"no action `{text}`, only add, modify, remove and replace",
            ParameterFault.NO_NAME: f"the {entry.name} to add has no `name`",
            ParameterFault.EMPTY_NAME: f"the {entry.name} to add has an empty name",
            ParameterFault.TAKEN: f"the included model already has a {entry.name} `{text}` there",
            ParameterFault.NOTHING: f"the included model has no {entry.name} `{text}`",
            ParameterFault.OTHER_KIND: f"`{text}` is a {other}, not a {entry.name}",
            ParameterFault.NO_PARENT: f"the included model has no `{text}` to add something to",
            ParameterFault.UNKNOWN_ENTRY: f"`{name}` is not an element that can be named here",
            ParameterFault.NO_CHILD_ACTION: f"neither this `{name}` nor its parent has an `action`",
            ParameterFault.ABSENT_CHILD: f"{other} has no `{text or name}` in the included file",
            ParameterFault.UNKNOWN_CHILD: f"`{other}` may not hold `{name}`",
            ParameterFault.UNKNOWN_ATTRIBUTE: f"`{other}` has no attribute `{attribute}`",
            ParameterFault.NAME_ASSUMED: f"no `name` says which {name} is meant, so `{other}` is taken",
            ParameterFault.NO_CHANGE: f"this `{name}` changes nothing",
        }[problem.fault]
