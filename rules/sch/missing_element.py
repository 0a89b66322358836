from collections.abc import Iterator, Mapping

from sdfcheck import (
    IN_COLLISION,
    IN_LINK,
    IN_MODEL,
    IN_VISUAL,
    IN_WORLD,
    Bad,
    Consumer,
    Diagnostic,
    Element,
    Fix,
    Good,
    Reaction,
    Rule,
    Severity,
    Span,
    lacking,
    problems,
    refuses,
    replace,
    rewrite,
    warns,
)


class MissingElement(Rule):
    """A required element is missing.

    Without its parent or child a joint is refused, and so are an include without uri and
    a material script without uri and name. For all else libsdformat takes a default and
    says nothing. Where that makes another robot or scene there is a warning: a box without a size is a
    cube of one meter, an axis without direction points along z, a spot light without angles lights
    nothing, a visible plane is 1 m wide, a battery has no voltage.

    Nothing is reported where the default is what everybody expects who leaves the element out: all of
    physics, its solvers and constraints; scene, gravity, magnetic field, atmosphere and the model of
    the Earth's surface; products of inertia (0); limits of joints (none), springs (none) and the terms of a mimic;
    the whole image of a camera, its field of view, clip distances, lens and noise of cameras and other sensors; topics;
    the normal of a plane (up), and its size as a collision, which has no end; states.

    A robot without name and content, which holds the place of a part, is a warning.
    """

    code = "SCH004"
    name = "missing-element"
    severity = Severity.ERROR
    remedy = """Write the element, with the value that is meant, also where that is the default.

    `sdfcheck describe box` and the like say what is required and what the default is, with its unit.
    """
    explains = (problems.MissingElement,)
    scaffold = IN_COLLISION

    bad = (
        Bad("<geometry><«box»/></geometry>", says="`box` has no `size`, so the default 1 1 1 applies"),
        Bad(
            '<«joint» name="j" type="fixed"><parent>base</parent></joint>',
            scaffold=IN_MODEL,
            says="joint `j` has no `child`",
        ),
        Bad(
            "<«inertial»><inertia><ixx>1</ixx><iyy>1</iyy><izz>1</izz></inertia></inertial>",
            scaffold=IN_LINK,
            says="`inertial` has no `mass`, so the default 1 applies",
        ),
        Bad(
            "<geometry><sphere>«0.5»</sphere></geometry>",
            fixed="<geometry><sphere><radius>0.5</radius></sphere></geometry>",
            unsafe=True,
            says="`sphere` has no `radius`, only text, so the default 1 applies",
        ),
        Bad(
            '<geometry><sphere «radius»="0.5"/></geometry>',
            fixed="<geometry><sphere><radius>0.5</radius></sphere></geometry>",
            unsafe=True,
            says="`sphere` has no `radius`, which is an element there, not an attribute, so the default 1 applies",
        ),
        Bad(
            '<geometry><cylinder «radius»="0.5" length="2"/></geometry>',
            fixed="<geometry><cylinder><radius>0.5</radius><length>2</length></cylinder></geometry>",
            unsafe=True,
            says="`radius` and 1 more of `cylinder` are elements, not attributes, so the defaults apply",
        ),
        Bad(
            '<geometry><mesh «filename»="model://arm/arm.obj" scale="2 2 2"/></geometry>',
            fixed="<geometry><mesh><uri>model://arm/arm.obj</uri><scale>2 2 2</scale></mesh></geometry>",
            unsafe=True,
            says="`mesh` has no `uri`, an element that is `filename` in URDF",
        ),
        Bad(
            "<geometry><box><size>1 1 1</size></box></geometry>"
            "<material><script>«Gazebo/Red»</script></material>",
            scaffold=IN_VISUAL,
            says="`script` has no `uri` and no `name`, only text",
        ),
        Bad(
            "<geometry><mesh><uri>model://arm/arm.dae</uri><«submesh»/></mesh></geometry>",
            says="`submesh` has no `name`",
        ),
        Bad(
            "<geometry><box><size>1 1 1</size></box></geometry>"
            '<material><«shader» type="normal_map_object_space"/></material>',
            scaffold=IN_VISUAL,
            says="`shader` has no `normal_map`",
        ),
        Bad(
            '<«light» name="l" type="directional"/>', scaffold=IN_WORLD, says="so the default 0 0 -1 applies"
        ),
        Bad(
            "<geometry><«plane»/></geometry>",
            scaffold=IN_LINK.replace("{}", '<visual name="v">{}</visual>'),
            says="`plane` has no `size`, so the default 1 1 applies",
        ),
    )
    good = (
        Good("<geometry><plane/></geometry>", why="a horizontal plane without end"),
        Good('<light name="l" type="point"/>', scaffold=IN_WORLD, why="shines everywhere"),
        Good("<geometry><box><size>2 1 1</size></box></geometry>"),
        Good(
            '<world name="w"><physics type="ode"/></world>',
            why="the defaults of a world are harmless",
            scaffold='<sdf version="1.12">{}</sdf>',
        ),
        Good(
            '<joint name="j" type="fixed"><parent>world</parent><child>base</child></joint>',
            scaffold=IN_MODEL,
        ),
    )

    def check(self, problem: problems.MissingElement) -> Iterator[Diagnostic]:
        place, message, fix = described(problem)
        cause = problem.cause
        if problem.refused:
            affects, labels = refusals(problem), other_end(problem)
            severity = Severity.WARNING if is_placeholder(problem.element) else None
            yield self.diagnostic(
                place, message, severity=severity, fix=fix, affects=affects, labels=labels, cause=cause
            )
            return
        if problem.default is not None:
            is_one = len(problem.attributes) < 2 and not problem.others
            message += f", so the default {problem.default} applies" if is_one else ", so the defaults apply"
        affects = dict.fromkeys(Consumer, warns("takes a default"))
        if problem.attributes:
            affects[Consumer.DRAKE] = refuses("refuses unknown attributes")
        if problem.element.name == "inertia":  # moments that the default makes impossible are an error there
            cause = cause or place
        yield self.diagnostic(
            place, message, severity=Severity.WARNING, affects=affects, fix=fix, cause=cause
        )


def described(problem: problems.MissingElement) -> tuple[Span, str, Fix | None]:
    """Where it is missing, which element has no such child, and the fix that makes one of what is there."""
    element, child, attributes = problem.element, problem.child, problem.attributes
    lacks = " and no ".join(f"`{name}`" for name in (child, *problem.others))
    message = f"{element.title} has no {lacks}"
    if (place := problem.text) is not None:
        text = f"<{child}>{place.text}</{child}>"
        fix = replace(place, text, f"write `{text}`", unsafe=True) if problem.fits else None
        return place, f"{message}, only text", fix
    attribute = element.attribute(attributes[0]) if attributes else None
    if attribute is None:
        return element.span, message, None
    first, *others = attributes
    message += ", which is an element there, not an attribute"
    if first != child:
        message = f"{element.title} has no `{child}`, an element that is `{first}` in URDF"
    elif others:
        message = f"`{first}` and {len(others)} more of {element.title} are elements, not attributes"
    fix = as_elements(element, {first: child, **{name: name for name in others}})
    return attribute.name_span, message, fix


def refusals(problem: problems.MissingElement) -> dict[Consumer, Reaction]:
    """The consumers that refuse the file for it; Drake needs no link, but the name that a placeholder lacks, too."""
    affects: dict[Consumer, Reaction] = {}
    for child in (*problem.others, problem.child):
        affects |= lacking(problem.element, child)
    if is_placeholder(problem.element):
        affects[Consumer.DRAKE] = refuses("wants a name")
    return affects


def is_placeholder(element: Element) -> bool:
    """Is it a robot with nothing in it, and without a name?"""
    return element.name == "robot" and "name" not in element.attributes and not any(element.children())


def other_end(problem: problems.MissingElement) -> dict[Element, str]:
    """Where a joint that lacks one of its ends names the other one, beside which the missing one belongs."""
    other = {"child": "parent", "parent": "child"}.get(problem.child, "")
    end = problem.element.find(other) if other else None
    return {} if end is None else {end: f"its {other}"}


def as_elements(element: Element, names: Mapping[str, str]) -> Fix | None:
    """The fix that writes the attributes of an empty element, if they are these, as elements of these names."""
    given = element.attributes
    if element.nodes or given.keys() != names.keys():
        return None
    inner = "".join(f"<{names[name]}>{value}</{names[name]}>" for name, value in given.items())
    text = f"<{element.name}>{inner}</{element.name}>"
    return rewrite(f"write `{text}`", {element: text})
