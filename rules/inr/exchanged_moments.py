from collections.abc import Iterator, Sequence
from math import log

from sdfcheck import (
    IN_LINK,
    IN_URDF_LINK,
    Bad,
    Diagnostic,
    Good,
    Inertial,
    Rule,
    Severity,
    Shape,
    TextEdit,
    listed,
    make_fix,
)
from sdfcheck_rules.inr.moments import is_doubtful, is_weighed

FITS, DIFFERS = 1.5, 2.2
"""Moments within the first factor of those of a box are those of the body; beyond the second one they are not."""
NEAR, EXACT, ROUNDED = 0.05, 0.125, 0.002
"""Nearer than the first to the moments of the link's only solid, they are those of it; their quotient is off by less
than the second of what it is off as they are; the third may come from rounding."""
ACROSS = 0.1
"""Of the cosine: a cylinder with a smaller one is across an axis."""
PAIRS, RINGS = ((0, 2, 1), (1, 0, 2), (2, 1, 0)), ((1, 2, 0), (2, 0, 1))
"""The axis whose moment belongs to each axis, where two or all three are exchanged."""
CLEARLY = 0.2
"""So much better, in the sum of the logarithms, must all three fit than two."""
NAMES = ("ixx", "iyy", "izz")
WHEEL = (
    '<collision name="c"><pose>0 0 0 1.5708 0 0</pose><geometry><cylinder><radius>0.18</radius>'
    "<length>0.05</length></cylinder></geometry></collision>"
)
INERTIAL = "<inertial>{}<mass>2.6</mass><inertia><ixx>{}</ixx><iyy>{}</iyy><izz>{}</izz></inertia></inertial>"
BEAM = (
    '<inertial><mass value="1.37"/><inertia ixx="{}" ixy="0" ixz="0" iyy="0.0303" iyz="0" izz="{}"/></inertial>'
    '<collision><geometry><box size="0.508 0.09 0.09"/></geometry></collision>'
)
BLOCK = (
    "<inertial><mass>12</mass><inertia><ixx>{}</ixx><iyy>{}</iyy><izz>{}</izz></inertia></inertial>"
    '<collision name="c"><geometry><box><size>0.01 2 1</size></box></geometry></collision>'
)
CRATE = (
    "<inertial><mass>15</mass><inertia><ixx>{}</ixx><iyy>{}</iyy><izz>{}</izz></inertia></inertial>"
    '<collision name="c"><geometry><box><size>0.42 0.31 0.18</size></box></geometry></collision>'
)
BOARD = (
    "<inertial><mass>1.2</mass><inertia><ixx>0.00090</ixx><iyy>{}</iyy><izz>{}</izz></inertia></inertial>"
    '<collision name="c"><geometry><box><size>1.04 0.03 0.09</size></box></geometry></collision>'
)


class ExchangedMoments(Rule):
    """Two moments of inertia of a link are exchanged, or all three.

    In another order they fit the box around the link's shapes; as they are, they belong to a body that lies
    across. Often the shape is turned by its own pose (a wheel), and the inertia is that of the unturned one.
    Seven such mistakes were corrected by the maintainers of public robots.
    """

    code = "INR015"
    name = "exchanged-moments"
    severity = Severity.WARNING
    remedy = """Exchange the moments, or turn the inertial as the shape is turned.

    The moment about an axis is large where the body extends across that axis: a rod along x has the small
    moment `ixx`, a wheel that turns about y the large one `iyy`. Where the shape has a rotation of its own,
    give the `<pose>` or `<origin>` of the inertial the same rotation, and keep the moments of the unturned
    shape.
    """
    looks_at = (Inertial,)
    scaffold = IN_LINK

    bad = (
        Bad(
            INERTIAL.format("", "0.024", "«0.024»", "0.044") + WHEEL,
            fixed=INERTIAL.format("", "0.024", "0.044", "0.024") + WHEEL,
            unsafe=True,
            says="iyy 0.024 and izz 0.044 look exchanged: the shapes of link `base` fill 0.36 × 0.05 × 0.36 m",
        ),
        Bad(
            BEAM.format("«0.0303»", "0.0018"),
            fixed=BEAM.format("0.0018", "0.0303"),
            unsafe=True,
            scaffold=IN_URDF_LINK,
        ),
        Bad(
            BOARD.format("«0.10825»", "0.10897"),
            fixed=BOARD.format("0.10897", "0.10825"),
            unsafe=True,
            says="iyy 0.10825 and izz 0.10897 look exchanged",
        ),
        Bad(
            BLOCK.format("«1»", "4", "5"),
            fixed=BLOCK.format("5", "1", "4"),
            unsafe=True,
            says="ixx 1, iyy 4 and izz 5 look exchanged: the shapes of link `base` fill",
        ),
        Bad(
            CRATE.format("«0.261»", "0.3406", "0.1606"),
            fixed=CRATE.format("0.1606", "0.261", "0.3406"),
            unsafe=True,
            says="ixx 0.261, iyy 0.3406 and izz 0.1606 look exchanged",
        ),
    )
    good = (
        Good(INERTIAL.format("", "0.024", "0.044", "0.024") + WHEEL),
        Good(
            INERTIAL.format("<pose>0 0 0 1.5708 0 0</pose>", "0.024", "0.024", "0.044") + WHEEL,
            why="the inertia is turned with the shape",
        ),
    )

    @staticmethod
    def applies(inertial: Inertial) -> bool:
        return bool(exchanged(inertial))

    def check(self, inertial: Inertial) -> Iterator[Diagnostic]:
        box = inertial.link.box
        assert box is not None, "it was compared"
        order = exchanged(inertial)
        values = [inertial.moments[name] for name in NAMES]
        axes = [axis for axis, source in enumerate(order) if axis != source]
        lengths = " × ".join(f"{length:.3g}" for length in box.size)
        edits = tuple(TextEdit(values[axis].span, values[order[axis]].text) for axis in axes)
        first, *others = (values[axis] for axis in axes)
        yield self.diagnostic(
            first,
            f"{listed(f'{NAMES[axis]} {values[axis].text}' for axis in axes)} look exchanged:"
            f" the shapes of {inertial.link.title} fill {lengths} m",
            labels={
                **dict.fromkeys(others, "the other one"),
                inertial.link.shapes[0]: "the first of its shapes",
            },
            fix=make_fix(f"exchange {listed(NAMES[axis] for axis in axes)}", edits, unsafe=True),
        )


def exchanged(inertial: Inertial) -> tuple[int, ...]:
    """The axis whose moment belongs to each axis by the link's shapes; none where they fit as they are."""
    if not is_doubtful(inertial) or len(set(inertial.tensor[:3])) == 1:
        return ()
    if not is_weighed(inertial) or is_turned(inertial) or is_about_axis(inertial):
        return ()
    moments, mass = inertial.tensor, inertial.mass.number
    if not mass > 0 or not min(moments[:3]) > 0 or max(map(abs, moments[3:])) > min(moments[:3]) / 10:
        return ()
    if not all(inertial.moments[name].is_given for name in NAMES):
        return ()
    found = of_another_body(inertial) or of_other_axes(inertial)
    return found if found and inertial.link.extent is not None else ()


def is_about_axis(inertial: Inertial) -> bool:
    """Is the largest moment of a wheel about its axis, and its cylinder across that? Then the cylinder is wrong."""
    link = inertial.link
    joint = next(iter(link.parent_joints), None)
    shapes = link.collisions or link.visuals
    if (
        joint is None
        or joint.type != "continuous"
        or len(shapes) != 1
        or shapes[0].geometry.shape != "cylinder"
    ):
        return False
    axis, moments = list(map(abs, joint.axis.xyz)), inertial.tensor[:3]
    along = shapes[0].along
    if (
        not joint.is_urdf
        or len(axis) != 3
        or along is None
        or float(shapes[0].geometry.length) > 2 * float(shapes[0].geometry.radius)
    ):
        return False
    largest = axis.index(max(axis))
    return moments.index(max(moments)) == largest and abs(along[largest]) < ACROSS


def of_another_body(inertial: Inertial) -> tuple[int, ...]:
    """The order in which they fit the box around the shapes, as they do not now."""
    moments = inertial.tensor[:3]
    box = inertial.link.box if max(moments) >= DIFFERS / FITS * min(moments) else None
    if box is None:
        return ()
    squares = [length * length for length in box.size]
    solid = [inertial.mass.number / 12 * (sum(squares) - square) for square in squares]
    if not min(solid) > 0 or off(moments, solid) <= DIFFERS:
        return ()
    turned = {order: [moments[axis] for axis in order] for order in (*PAIRS, *RINGS)}
    fitting = {
        order: total(each, solid) + CLEARLY * (order in RINGS)
        for order, each in turned.items()
        if off(each, solid) <= FITS
    }
    return min(fitting, key=fitting.__getitem__, default=())


def of_other_axes(inertial: Inertial) -> tuple[int, ...]:
    """The order in which they are those of the only solid: about other axes all three, or two that differ little."""
    moments, solids = inertial.tensor[:3], inertial.link.solids
    only = solids[0].geometry.solid if len(solids) == 1 and not is_turned(solids[0]) else None
    if only is None or not min(only.moments[:3]) > 0:
        return ()
    solid = [inertial.mass.number * moment for moment in only.moments[:3]]
    for order in (*PAIRS, *RINGS):
        turned = [moments[axis] for axis in order]
        if off(turned, solid) >= 1 + NEAR:
            continue
        if order in RINGS:
            as_written, exchanged_back = off(moments, solid) - 1, off(turned, solid) - 1
        else:
            first, second = (axis for axis, source in enumerate(order) if axis != source)
            as_written = abs(moments[first] * solid[second] / moments[second] / solid[first] - 1)
            exchanged_back = abs(turned[first] * solid[second] / turned[second] / solid[first] - 1)
        if as_written > ROUNDED and exchanged_back < EXACT * as_written:
            return order
    return ()


def off(moments: Sequence[float], others: Sequence[float]) -> float:
    """The greatest factor between moments about one axis."""
    return max(max(one / other, other / one) for one, other in zip(moments, others, strict=True))


def total(moments: Sequence[float], others: Sequence[float]) -> float:
    """How far moments are from others, all three together."""
    return sum(abs(log(one / other)) for one, other in zip(moments, others, strict=True))


def is_turned(part: Inertial | Shape) -> bool:
    """Does its own pose turn its axes?"""
    place = part.find("origin" if part.is_urdf else "pose")
    if place is None:
        return False
    words = (place.text_of("rpy") or "") if part.is_urdf else " ".join(place.content.split()[3:])
    return any(word.strip("+-0.") for word in words.split()) or place.text_of("quat_xyzw") is not None
