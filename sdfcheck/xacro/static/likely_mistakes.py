"""Likely mistakes that xacro accepts, as far as reading a file shows them."""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from itertools import islice

from sdfcheck.files.library import library_of
from sdfcheck.formats import history
from sdfcheck.formats.near_names import nearest
from sdfcheck.formats.urdf import schema as table
from sdfcheck.source.document import Document, Element, Value
from sdfcheck.source.sniff import Kind
from sdfcheck.source.text import Span
from sdfcheck.xacro.language import (
    DEPRECATED,
    KEYWORDS,
    LEADING,
    PREFIX,
    SYMBOLS,
    Parameter,
    is_literal,
    matches,
    substitutions,
)
from sdfcheck.xacro.problems import (
    ArgumentForParameter,
    CounterpartProperty,
    DeprecatedFunction,
    DoubledPrefix,
    EmptiedBlock,
    EmptyRobot,
    ForgottenPrefix,
    MissingXacroPrefix,
    NameByDefault,
    NeverEqualText,
    OddParameter,
    Oversight,
    OverwrittenParameter,
    OverwrittenProperty,
    ParameterFlaw,
    PrefixedMacroName,
    ReboundPrefix,
    RedefinedMacro,
    RedefinedSymbol,
    ReplacedProperty,
    TruthComparedWithText,
    UnknownPropertyScope,
    UnusedArgument,
    UnusedMacro,
    UnusualXacroNamespace,
)
from sdfcheck.xacro.static.definitions import (
    Definitions,
    Expression,
    Macro,
    Property,
    Reading,
    has_content,
    is_conditional,
    is_free,
    is_in_include,
    is_name,
    is_outside,
    knows_all,
    lacks_prefix,
    own_words,
    place,
    reading,
    visible_definitions,
)
from sdfcheck.xacro.static.launches import is_launched
from sdfcheck.xacro.static.project import (
    has_namesake,
    includers,
    is_included,
    is_read_in_project,
    name_endings,
    passed,
)

# Elements of xacro and calls of macros that lack the prefix ``xacro:``.

_KNOWN: dict[str, Callable[[str], Sequence[str]]] = {
    "robot": table.known_parents,
    "sdf": history.known_parents,
}
"""Name of the root → the elements that may hold one of a name."""


def missing_prefixes(document: Document) -> list[MissingXacroPrefix]:
    """One problem for each name of the elements that lack the prefix."""
    return document.view(_missing)


def _missing(document: Document) -> list[MissingXacroPrefix]:
    problems: list[MissingXacroPrefix] = []
    visible = visible_definitions(document)
    found: dict[str, list[Element]] = {}
    for element in document.elements[1:]:
        if (lacks_prefix(element) or is_plain_call(element, visible)) and not is_in_include(element):
            found.setdefault(element.name, []).append(element)
    for name, alike in found.items():
        first, *others = (element.span for element in alike)
        ends = (document.spans.end_name(element) for element in alike)
        places = (first, *others, *(end for end in ends if end is not None))
        problems.append(MissingXacroPrefix(first, name, tuple(others), places))
    return problems


def is_plain_call(element: Element, visible: Definitions) -> bool:
    """Is an element that its format does not know the call of a macro but for the prefix?

    A file that includes its own may bring the macro.
    """
    name = element.name
    if ":" in name or is_free(element):
        return False
    root = element.document.root
    knows = _KNOWN.get(root.name) if root is not None else None
    if knows is None or knows(name):
        return False
    given = element.attributes.keys()
    for macro in visible.macros.get(name) or element.document.view(_macros_of_includers).get(name, []):
        taken = [each for each in macro.parameters if not each.is_block]
        needed = {each.name for each in taken if each.default is None and not each.forwards}
        if needed <= given <= {each.name for each in taken}:
            return True
    return False


def _macros_of_includers(document: Document) -> dict[str, list[Macro]]:
    """The macros of the files that include one, and of all that they include."""
    found: dict[str, list[Macro]] = {}
    for read in with_includers(document, visible_definitions(document)):
        for macro in read.macros:
            found.setdefault(macro.name, []).append(macro)
    return found


_NEARLY = 1e-6
_SIGN = re.compile(r"\s*(:?=)(\s*)")
_SCOPES = ("global", "local", "parent")
_NAMESPACE = "http://www.ros.org/wiki/xacro"
_CUSTOMARY = re.compile(r"https?://(www\.|wiki\.)?ros\.org/(wiki/)?xacro/?#?$")
_DEPRECATED = re.compile(rf"(?<![\w.])({'|'.join(sorted(DEPRECATED))})\s*\(")
_COMPARED = re.compile(
    r"(['\"])\$\(arg\s+(?P<arg>\w+)\)\1\s*[!=]=\s*(['\"])(?P<text>[^'\"]*)\3"
    r"|(['\"])(?P<first>[^'\"]*)\5\s*[!=]=\s*(['\"])\$\(arg\s+(?P<last>\w+)\)\7"
)
_TRUTH = r"(?P<{}>true|false|True|False)"
_COMPARED_TRUTH = re.compile(
    rf"(?<![\w.'\"])(?P<name>[^\W\d]\w*)\s*[!=]=\s*(?P<q>['\"]){_TRUTH.format('text')}(?P=q)"
    rf"|(?P<r>['\"]){_TRUTH.format('first')}(?P=r)\s*[!=]=\s*(?P<last>[^\W\d]\w*)(?![\w.(\[])"
)
_AMONG_TRUTHS = re.compile(
    r"(?<![\w.'\"])(?P<name>[^\W\d]\w*)\s+(?:not\s+)?in\s*(?:\[(?P<list>[^][]*)\]|\((?P<tuple>[^()]*)\))"
)
_QUOTED_TRUTH = re.compile(rf"(?P<q>['\"]){_TRUTH.format('text')}(?P=q)")
_TRUTHS = frozenset(("true", "false", "True", "False"))
_ARGUMENT = re.compile(r"arg\s+([^\s${}]+)\s*$")
_PREFIXED = re.compile(r"\$\{\s*(?P<parameter>[^\W\d]\w*)\s*\}(?P<slash>/?)(?P<rest>\w+)")
_LED = re.compile(rf"{LEADING}(?P<rest>.+)")
_DOUBLED = re.compile(r"\$\{\s*(?P<parameter>[^\W\d]\w*)\s*\}[/_]?\$\{\s*(?P=parameter)\s*\}")
_ASKED = re.compile(r"\s*\$\(arg\s+(\w+)\s*\)\s*")
_SLASH = re.compile(r"[})]/")
_LINK = re.compile(r"^(?:parent|child)$|_link$|^link_")
"""Parameters of macros that are called so name links."""
_LONGEST_PREFIX = 100
"""The characters of a longer one are not looked through."""
_MOST_INCLUDERS = 8
"""So many files that include one are read for the names that it may use."""
_OF_GAZEBO = frozenset(("bodyname", "jointname", "linkname"))
"""Parameters of plugins that Gazebo resolves itself; frames of ROS may get a prefix."""
_ENDS = frozenset((("parent", "link"), ("child", "link"), ("mimic", "joint"), ("gazebo", "reference")))
"""Elements and attributes that name a link or joint."""
_WORD = re.compile(r"(?<![\w.])\w+")
_NAMING = ("name", "link", "joint", "reference")
"""Attributes with the name of something."""


def oversights(document: Document, visible: Definitions) -> Iterator[Oversight]:
    """The oversights in a document."""
    read = reading(document)
    yield from _symbols(read)
    yield from _macros(read)
    yield from _functions(read)
    yield from _overwritten(read)
    yield from _replaced(read, visible)
    yield from _scopes(read)
    yield from _comparisons(read, visible)
    yield from _compared_truths(read, visible)
    yield from _arguments_for_parameters(read)
    yield from _counterparts(document, read, visible)
    yield from _forgotten_prefixes(read, visible)
    yield from _names_by_default(read, visible)
    yield from _doubled_prefixes(document, read)
    yield from _blocks(read, visible)
    yield from _namespace(document)
    yield from _rebound_prefixes(document, visible)
    if knows_all(document):
        yield from _unused(document, read, visible)
    yield from _empty_robot(document, visible)


_NUMBER = re.compile(r"\d+")
_EXPRESSION = re.compile(r"\$[({][^(){}]*[)}]")
_SIDES = (("left", "right"), ("front", "rear"), ("front", "back"))
_PAIRED = re.compile(r"\d|left|right|front|rear|back")
_DEEPEST_SETTING = 10
_MOST_NUMBERS, _MOST_COUNTERPARTS = 5, 20
"""So many numbers of a name, and so many unread properties of a file, are looked at."""


def _own_names(word: str, name: str) -> Iterator[str]:
    """The names of properties that an element may mean which reads that of another number or side than its own."""
    own = set(_NUMBER.findall(name)[:_MOST_NUMBERS])
    for match in islice(_NUMBER.finditer(word), _MOST_NUMBERS):
        if match[0] not in own:
            yield from (word[: match.start()] + number + word[match.end() :] for number in sorted(own))
    for one, other in (pair for sides in _SIDES for pair in (sides, sides[::-1])):
        if one in word and other in name and one not in name:
            yield word.replace(one, other)


def _counterparts(document: Document, read: Reading, visible: Definitions) -> Iterator[Oversight]:
    """The properties of one joint or link that another one reads, whose own nothing reads."""
    unread = set() if visible.is_open else visible.given.keys() - visible.words
    found: dict[Element, list[tuple[str, str, Expression]]] = {}
    known: dict[str, bool] = {}
    for word, places in (_paired_words(read, visible) if unread else {}).items():
        names = {holder: _own_text(holder) for holder, _ in places}
        if not any(_is_of(word, name) for name in names.values()):
            continue
        for holder, expression in places:
            own = next((each for each in _own_names(word, names[holder]) if each in unread), None)
            if own is not None and own not in known and len(known) < _MOST_COUNTERPARTS:
                known[own] = is_read_in_project(document, own)
            if own is not None and not known.get(own, True):
                found.setdefault(holder, []).append((word, own, expression))
    for holder, cases in found.items():
        yield _counterpart(holder, cases, visible)


def _paired_words(read: Reading, visible: Definitions) -> dict[str, list[tuple[Element, Expression]]]:
    """The properties with numbers or sides in their names, with the joints and links that read them."""
    uses: dict[str, list[tuple[Element, Expression]]] = {}
    for expression in read.expressions:
        words = {word for word in _WORD.findall(expression.code) if _PAIRED.search(word)}
        words &= visible.given.keys()
        holder = _holder(expression.element) if words else None
        if holder is not None:
            for word in sorted(words):
                uses.setdefault(word, []).append((holder, expression))
    return uses


def _counterpart(
    holder: Element, cases: Sequence[tuple[str, str, Expression]], visible: Definitions
) -> CounterpartProperty:
    word, own, _ = cases[0]
    spans = [place(each.element, each.attribute, each.code, word) for word, _, each in cases]
    title = f"{holder.name} `{holder.attributes['name']}`"
    return CounterpartProperty(
        spans[0], word, _named(visible.given[own][0].element), own, title, tuple(spans[1:])
    )


def _holder(element: Element) -> Element | None:
    """The joint or link that an element is in, or is."""
    at: Element | None = element
    for _ in range(_DEEPEST_SETTING):
        if at is None or (at.name in {"joint", "link"} and "name" in at.attributes):
            return at
        at = at.parent
    return None


def _own_text(holder: Element) -> str:
    """A name without its expressions."""
    return _EXPRESSION.sub("", holder.attributes["name"]).lower()


def _is_of(word: str, name: str) -> bool:
    """Has a property the numbers and sides of a name?"""
    numbers = set(_NUMBER.findall(word))
    sides = {side for pair in _SIDES for side in pair if side in word}
    return (
        bool(numbers or sides)
        and numbers <= set(_NUMBER.findall(name))
        and all(side in name for side in sides)
    )


def _symbols(read: Reading) -> Iterator[Oversight]:
    for found in read.properties:
        if found.name in SYMBOLS and "remove" not in found.element.attributes:
            same = found.name if _is_that_number(found) else None
            yield RedefinedSymbol(_named(found.element), found.name, near=same)
    for macro in read.macros:
        for parameter in macro.parameters:
            if parameter.name in SYMBOLS:
                yield RedefinedSymbol(parameter_place(macro, parameter), parameter.name)


def _is_that_number(found: Property) -> bool:
    """Has a property the value that expressions know by its name?"""
    known = getattr(math, found.name, None)
    try:
        return isinstance(known, float) and abs(float(found.value or "") - known) < _NEARLY
    except ValueError:
        return False


def _macros(read: Reading) -> Iterator[Oversight]:
    first: dict[str, Macro] = {}
    for macro in read.macros:
        if macro.element.attributes.get("name", "").startswith(PREFIX):
            yield PrefixedMacroName(_named(macro.element), macro.name)
        if macro.name and is_literal(macro.name) and is_outside(macro.element):
            earlier = first.setdefault(macro.name, macro)
            if earlier is not macro:
                yield RedefinedMacro(_named(macro.element), macro.name, _named(earlier.element))
        yield from _parameters(macro)


def _parameters(macro: Macro) -> Iterator[Oversight]:
    value = macro.element.attribute("params")
    seen: dict[str, Parameter] = {}
    has_comma = is_unclear = False
    if value is None:
        return
    for parameter in macro.written:
        name = parameter.name.strip(",")
        if "," in parameter.name or (parameter.default or "").endswith(","):
            if not has_comma:
                yield OddParameter(parameter_place(macro, parameter), name, flaw=ParameterFlaw.COMMA)
            has_comma = True
        elif not is_name(parameter):
            if not is_unclear and ("$" not in name or any(name in each[0] for each in matches(value.text))):
                yield OddParameter(parameter_place(macro, parameter), name, flaw=ParameterFlaw.NO_NAME)
            is_unclear = True
        elif parameter.name in seen:
            place, other = (parameter_place(macro, each) for each in (parameter, seen[parameter.name]))
            yield OddParameter(place, name, other, flaw=ParameterFlaw.DOUBLED)
        elif parameter.is_optional and (flaw := _flaw_of_default(parameter, value.text)):
            yield OddParameter(parameter_place(macro, parameter), name, flaw=flaw)
        seen.setdefault(parameter.name, parameter)


def _flaw_of_default(parameter: Parameter, text: str) -> ParameterFlaw | None:
    """The oddity of the sign between a parameter of a ``params`` and its default."""
    sign = _SIGN.match(text, parameter.end)
    if sign and ":=" in (parameter.default or ""):
        return ParameterFlaw.NO_DEFAULT
    if sign and sign[2] and parameter.default is not None:
        return ParameterFlaw.BLANK
    return ParameterFlaw.NO_COLON if sign and sign[1] == "=" else None


def _functions(read: Reading) -> Iterator[Oversight]:
    seen: set[str] = set()
    own = {found.name for found in read.properties}
    for found in read.expressions:
        for match in _DEPRECATED.finditer(found.code):
            name = match[1]
            if name not in own and name not in seen:
                seen.add(name)
                span = place(found.element, found.attribute, found.code, name)
                yield DeprecatedFunction(span, name, near=DEPRECATED[name])


def _overwritten(read: Reading) -> Iterator[Oversight]:
    """Properties that get two values in a row, and parameters that a property replaces."""
    waiting: dict[str, dict[Element | None, Property]] = {}
    properties = {found.element: found for found in read.properties}
    inside: dict[Element | None, _Inside] = {macro.element: _Inside(macro) for macro in read.macros}
    for element, around in read.elements:
        found, macro, words = properties.get(element), inside.get(around), own_words(element)
        if found is None or not _is_plain(found):
            found = None
            if element.name.startswith(PREFIX) and element.name[len(PREFIX) :] not in _READING_LITTLE:
                waiting.clear()
        for word in words:
            waiting.pop(word, None)
        if found is not None:
            if macro is not None and found.name not in words:
                yield from macro.replaced_by(found)
            earlier = waiting.get(found.name, {}).get(around)
            if earlier is not None and found.name not in words:
                yield OverwrittenProperty(_named(earlier.element), found.name, _named(element))
            waiting.setdefault(found.name, {})[around] = found
        if macro is not None and element is not around:
            macro.words |= words


def _replaced(read: Reading, visible: Definitions) -> Iterator[Oversight]:
    """The includes that replace a property of an earlier one whose macros read it when they are called later."""
    files = {each.document.path: each for each in visible.readings} if len(read.includes) > 1 else {}
    own = {found.name for found in read.properties}
    called = {call.name: call.element.span.start for call in read.calls} if files else {}
    earlier: dict[str, tuple[Reading, Property]] = {}
    for include in read.includes if files else ():
        path, value = visible.target(include.element), include.element.attribute("filename")
        target = files.get(path) if path is not None else None
        if target is None or value is None or include.conditional or include.namespace:
            continue
        given = {found.name: found for found in target.properties if found.macro is None and _is_plain(found)}
        used = frozenset[str]().union(*(macro.words for macro in target.macros))
        for name in sorted((given.keys() & earlier.keys() & used) - own):
            other, first = earlier[name]
            reads = (each.name for each in other.macros if _reads(each, name))
            macro = next((each for each in reads if called.get(each, -1) > value.span.start), None)
            if macro is not None and first.value != given[name].value:
                yield ReplacedProperty(value.span, name, _named(first.element), macro)
        earlier.update((name, (target, found)) for name, found in given.items())


def _reads(macro: Macro, name: str) -> bool:
    """Does a macro read the property of a name as it is where it is called?"""
    return name in macro.words and all(name != parameter.name for parameter in macro.parameters)


class _Inside:
    """A macro that is read from its beginning: its parameters by name, and the words that were read in it."""

    def __init__(self, macro: Macro) -> None:
        self.macro = macro
        self.words: set[str] = set()
        self.parameters: dict[str, list[Parameter]] = {}
        for parameter in macro.parameters:
            self.parameters.setdefault(parameter.name, []).append(parameter)

    def replaced_by(self, found: Property) -> Iterator[Oversight]:
        """The parameters that nobody has read before a property replaces them."""
        for parameter in self.parameters.get(found.name, ()) if found.name not in self.words else ():
            place = parameter_place(self.macro, parameter)
            yield OverwrittenParameter(_named(found.element), found.name, place)


_READING_LITTLE = KEYWORDS - {"include", "call", "if", "unless"}
"""Any other element of xacro, a callee, an include or a block, may read any property."""


def _is_plain(found: Property) -> bool:
    """Does a property get a value of its own, whatever came before?"""
    given = found.element.attributes
    is_plain = "value" in given and "scope" not in given and is_literal(found.name)
    return is_plain and not is_conditional(found.element)


def _scopes(read: Reading) -> Iterator[Oversight]:
    for found in read.properties:
        value = found.element.attribute("scope")
        if value is not None and is_literal(value.text) and value.text not in _SCOPES:
            yield UnknownPropertyScope(value.span, value.text, near=nearest(value.text, _SCOPES))


def _comparisons(read: Reading, visible: Definitions) -> Iterator[Oversight]:
    for found in read.expressions:
        for match in _COMPARED.finditer(found.code):
            name, text = match["arg"] or match["last"], match["text"] or match["first"] or ""
            homes = [each for each in visible.readings if name in each.arguments]
            default = homes[0].arguments[name] if homes else ""
            if len(homes) == 1 and default != text and default.casefold() == text.casefold():
                span = place(found.element, found.attribute, match[0])
                given = homes[0].argument_elements[name]
                other = given.document.spans.attribute_value(given, "default")
                yield NeverEqualText(span, text, other, default)


def _compared_truths(read: Reading, visible: Definitions) -> Iterator[Oversight]:
    """Comparisons of a name with a text of which xacro makes a truth value, so that it never equals it."""
    for found in read.expressions:
        for name, text, code in _truths_as_texts(found.code):
            is_parameter = found.macro is not None and name in visible.parameters
            if not is_parameter and _may_be_truth(name, visible):
                yield TruthComparedWithText(place(found.element, found.attribute, code), name, near=text)


def _truths_as_texts(code: str) -> Iterator[tuple[str, str, str]]:
    """The names that an expression compares with ``true`` or ``false`` in quotes: name, text, place.

    A list that has the truth value itself as well is complete.
    """
    for match in _COMPARED_TRUTH.finditer(code):
        yield match["name"] or match["last"], match["text"] or match["first"], match[0]
    for match in _AMONG_TRUTHS.finditer(code):
        items = match["list"] or match["tuple"] or ""
        bare = {item.strip() for item in items.split(",")}
        for quoted in _QUOTED_TRUTH.finditer(items):
            if quoted["text"].title() not in bare:
                yield match["name"], quoted["text"], quoted[0]
                break


def _may_be_truth(name: str, visible: Definitions) -> bool:
    """Is a property ``true`` or ``false``, or an argument that may be, and never in quotes or worked out?"""
    values = [(found.value or "").strip() for found in visible.given.get(name, ())]
    is_open = [value in _TRUTHS or bool(_ASKED.fullmatch(value)) for value in values]
    return any(is_open) and all(
        each or value.isidentifier() for each, value in zip(is_open, values, strict=True)
    )


def _arguments_for_parameters(read: Reading) -> Iterator[Oversight]:
    """The uses of ``$(arg name)`` in a macro that reads its parameter of that name, too, or may get another value."""
    macros = {macro.element: macro for macro in read.macros}
    around = dict(read.elements)
    words: dict[Element | None, set[str]] = {}
    for expression in read.expressions if macros else ():
        words.setdefault(expression.macro, set()).update(_WORD.findall(expression.code))
    for command in read.commands if macros else ():
        match, element = _ARGUMENT.match(command.text), command.element
        holder = around.get(element)
        macro = macros.get(holder) if holder is not None else None
        if match is None or macro is None or element is macro.element:
            continue
        for parameter in macro.parameters:
            if parameter.name == match[1] and (
                match[1] in words.get(macro.element, ())
                or passed(read.document, macro.name, match[1]) != {f"$(arg {match[1]})"}
            ):
                span = place(element, command.attribute, f"$({command.text})")
                yield ArgumentForParameter(span, match[1], parameter_place(macro, parameter))


def _forgotten_prefixes(read: Reading, visible: Definitions) -> Iterator[Oversight]:
    """The names in a macro that only become those of its links and joints by the prefix of these.

    Where a call gives a prefix, the expansion shows that the name reaches nothing.
    """
    macros = {macro.element: macro for macro in read.macros}
    defined: dict[tuple[Element, str], tuple[str, Element]] = {}
    for element, macro in read.elements:
        match = _PREFIXED.fullmatch(element.attributes.get("name", ""))
        if element.name not in {"link", "joint"} or macro not in macros or match is None:
            continue
        if any(match["parameter"] == parameter.name for parameter in macros[macro].parameters):
            defined.setdefault((macro, match["rest"]), (match["parameter"], element))
    if not defined:
        return
    plain = {
        e.attributes.get("name")
        for each in visible.readings
        for e, _ in each.elements
        if e.name in {"link", "joint"}
    }
    given = {
        (call.name, parameter)
        for each in visible.readings
        for call in each.calls
        for parameter, text in call.element.attributes.items()
        if _is_surely_text(text, visible)
    }
    for element, macro in read.elements:
        for value in _references(element):
            found = defined.get((macro, value.text.strip())) if macro is not None else None
            if macro is None or found is None or value.text.strip() in plain:
                continue
            parameter, home = found
            name = home.attributes["name"]
            is_frame = _is_frame(element, value) and _SLASH.search(name)
            if (macros[macro].name, parameter) not in given and not is_frame:
                yield ForgottenPrefix(value.span, value.text.strip(), _named(home), name)


def _names_by_default(read: Reading, visible: Definitions) -> Iterator[Oversight]:
    """The names that are those of links and joints only while an argument has its default, or not at all."""
    uses = list(_possible_uses(read))
    around = with_includers(read.document, visible) if uses else []
    named = {
        element: (element.attributes.get("name", ""), macro)
        for each in around
        for element, macro in each.elements
        if element.name in {"link", "joint"}
    }
    defined: dict[_Key, Element] = {}
    for key, element in _defined_by_default(named, around):
        defined.setdefault(key, element)
    plain = {_key(*each) for each in named.values()}
    for value, element, macro in uses:
        name = value.text.strip()
        home = defined.get(_key(name, macro))
        if home is None or _key(name, macro) in plain:
            continue
        near = home.attributes["name"]
        conditions = " ".join(each.attributes.get("value", "") for each in element.around)
        depends = not set(_WORD.findall(near)).isdisjoint({*_WORD.findall(conditions)} - {"arg"})
        if not depends and not (_is_frame(element, value) and near.endswith(f"/{name}")):
            yield NameByDefault(value.span, name, _named(home), near)


_Key = tuple[str, Element | None]
"""A name, and the macro in which it has a meaning, if that is not everywhere the same."""


def _key(name: str, macro: Element | None) -> _Key:
    return name, None if is_literal(name) else macro


def _defined_by_default(
    named: Mapping[Element, tuple[str, Element | None]], around: Sequence[Reading]
) -> Iterator[tuple[_Key, Element]]:
    """The names of links and joints that ask for an argument, with its default, or else without it."""
    arguments = {name: text for each in around for name, text in each.arguments.items()}
    taken = {each.element: {one.name for one in each.parameters} for read in around for each in read.macros}
    asking = {
        found.name: match[1]
        for each in around
        for found in each.properties
        if (match := _ASKED.fullmatch(found.element.attributes.get("value", ""))) is not None
    }
    for element, (name, macro) in named.items():
        match = _LED.fullmatch(name)
        if match is None or (macro is not None and match["property"] in taken[macro]):
            continue
        asked = match["arg"] or asking.get(match["property"], "")
        if is_literal(text := arguments.get(asked, "$(arg")):
            is_known = is_literal(match["rest"])
            yield _key((text + match["slash"]) * is_known + match["rest"], macro), element


def _possible_uses(read: Reading) -> Iterator[tuple[Value, Element, Element | None]]:
    """The names of links and joints that may be those of others that begin with an expression."""
    endings = name_endings(read.document)
    for element, macro in read.elements if endings else ():
        for value in _uses(element):
            name = value.text.strip()
            starts = range(min(len(name), _LONGEST_PREFIX)) if is_literal(name) else (0,)
            if any(name[start:] in endings for start in starts):
                yield value, element, macro


def _uses(element: Element) -> Iterator[Value]:
    """The names of links and joints that an element writes, or the call of a macro gives."""
    yield from _references(element)
    if element.name in {"parent", "child"} and element.content:
        yield element.own_value
    if element.name.startswith(PREFIX) and element.name[len(PREFIX) :] not in KEYWORDS:
        for name in element.attributes:
            if _LINK.search(name) and (value := element.attribute(name)) is not None:
                yield value


def with_includers(document: Document, visible: Definitions) -> list[Reading]:
    """A file and those that it includes, and the same of those that include it, directly or not."""
    seen = {each.document.path: each for each in visible.readings}
    library, waiting, done = library_of(document), [document], {document.path}
    while library is not None and waiting and len(done) <= _MOST_INCLUDERS:
        for path in includers(waiting.pop(0)):
            found = library.document(path, Kind.XACRO, document) if path not in done else None
            done.add(path)
            if found is not None and found.root is not None:
                waiting.append(found)
                for each in visible_definitions(found).readings:
                    seen.setdefault(each.document.path, each)
    return list(seen.values())


def _is_frame(element: Element, value: Value) -> bool:
    """Is a name of a plugin perhaps that of a frame of ROS, to which programs add a prefix?"""
    return element.name.replace("_", "").lower() not in _OF_GAZEBO and value.attribute is None


def _doubled_prefixes(document: Document, read: Reading) -> Iterator[Oversight]:
    """The names with the same prefix twice: right as long as it is empty."""
    for element, _ in read.elements if _DOUBLED.search(document.source.text) else ():
        for attribute in _NAMING:
            match = _DOUBLED.search(element.attributes.get(attribute, ""))
            if match is not None:
                span = place(element, attribute, match[0])
                yield DoubledPrefix(span, match["parameter"])


def _is_surely_text(text: str, visible: Definitions) -> bool:
    """Is a value that a call gives not empty, by itself or by the defaults of the arguments in it?"""
    asked = {match[1] for _, command in substitutions(text) if (match := _ARGUMENT.match(command))}
    if asked:
        return any(read.arguments.get(name) for read in visible.readings for name in asked)
    return bool(text) and is_literal(text)


def _references(element: Element) -> Iterator[Value]:
    """The names of links and joints that an element writes."""
    parent = element.parent
    for name, attribute in _ENDS:
        if element.name == name and (value := element.attribute(attribute)) is not None:
            yield value
    if element.name == "joint" and parent is not None and parent.name in {"ros2_control", "transmission"}:
        if (value := element.attribute("name")) is not None:
            yield value
    elif parent is not None and parent.name == "plugin" and not element.nodes:
        yield element.own_value


def _blocks(read: Reading, visible: Definitions) -> Iterator[Oversight]:
    for call in read.calls:
        macros = visible.macros.get(call.name, [])
        children = list(call.element.children())
        if len(macros) != 1 or any(child.name.startswith(PREFIX) for child in children):
            continue
        blocks = [parameter for parameter in macros[0].parameters if parameter.is_block]
        for parameter, child in zip(blocks, children, strict=False):
            if parameter.name.startswith("**") and child.attributes and not child.nodes and not child.content:
                other = parameter_place(macros[0], parameter)
                yield EmptiedBlock(child.span, child.name, other, parameter.name)


def _namespace(document: Document) -> Iterator[Oversight]:
    span = _bindings(document).get("xmlns:xacro")
    if span is not None and not _CUSTOMARY.match(span.text) and nearest(span.text, (_NAMESPACE,)):
        yield UnusualXacroNamespace(span, span.text, near=_NAMESPACE)


def _rebound_prefixes(document: Document, visible: Definitions) -> Iterator[Oversight]:
    """The prefixes of the root that an included file binds to another name: xacro keeps the first, with a warning."""
    own = _bindings(document)
    own.pop("xmlns:xacro", None)
    for each in visible.readings if own else ():
        for name, other in _bindings(each.document).items() if each.document is not document else ():
            if name in own and other.text != own[name].text:
                yield ReboundPrefix(own.pop(name), name.partition(":")[2], other)


def _bindings(document: Document) -> dict[str, Span]:
    """The declarations of prefixes on the root, each with the place of its value."""
    assert document.root is not None
    tag = document.spans.start_tag(document.root)
    return {
        attribute.name: document.source.span(attribute.value_start, attribute.value_end)
        for attribute in tag.attributes
        if attribute.name.startswith("xmlns:")
    }


def _unused(document: Document, read: Reading, visible: Definitions) -> Iterator[Oversight]:
    called = {call.name.rpartition(".")[2] for each in visible.readings for call in each.calls}
    called.update(each.name for each in missing_prefixes(document))
    for macro in read.macros:
        if macro.name and macro.name not in called and macro.name not in visible.words:
            yield UnusedMacro(_named(macro.element), macro.name)
    for name, element in read.argument_elements.items():
        if name and "default" in element.attributes and is_literal(name) and name not in visible.words:
            yield UnusedArgument(_named(element), name)


def parameter_place(macro: Macro, parameter: Parameter) -> Span:
    """Where a parameter is written."""
    span = macro.element.document.spans.attribute_value(macro.element, "params")
    start = span.start + parameter.start
    is_there = span.source.text.startswith(parameter.name, start)
    return span.source.span(start, start + len(parameter.name)) if is_there else span


def _named(element: Element) -> Span:
    """The name that an element gives."""
    spans = element.document.spans
    return spans.attribute_value(element, "name") if "name" in element.attributes else element.span


def _empty_robot(document: Document, visible: Definitions) -> Iterator[Oversight]:
    """The macro to be called in a robot of macros alone that a launch file expands, and that no other file includes."""
    root = document.root
    if root is None or root.name != "robot" or "name" not in root.attributes or has_namesake(document):
        return  # launch files are known to name the file, but not its folder
    if visible.is_open or any(has_content(each.document) for each in visible.readings):
        return
    called = {call.name.rpartition(".")[2] for each in visible.readings for call in each.calls}
    uncalled = [
        macro for each in visible.readings for macro in each.macros if macro.name not in {"", *called}
    ]
    if uncalled and is_launched(document) and not is_included(document):
        macro = next((each for each in uncalled if each.element.has("link")), uncalled[0])
        is_own = macro.element.document is document
        yield EmptyRobot(_named(macro.element if is_own else root), macro.name)
