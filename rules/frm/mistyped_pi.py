from collections.abc import Iterator

from sdfcheck import (
    IN_LINK,
    IN_URDF_JOINT,
    IN_WORLD,
    Bad,
    Diagnostic,
    Element,
    Good,
    Rule,
    Severity,
    TextEdit,
    Value,
    make_fix,
)

RIGHT = {
    **dict.fromkeys(("3.1159", "3.11459", "3.1459", "3.14519", "3.4159", "3.41159"), "3.14159"),
    **dict.fromkeys(("3.1146", "3.1461", "3.4116"), "3.1416"),
    **dict.fromkeys(("1.5078", "1.5780", "1.7508"), "1.5708"),
    **dict.fromkeys(("1.5079", "1.50779", "1.57709", "1.5779", "1.7079", "1.75079"), "1.57079"),
    **dict.fromkeys(("1.507796", "1.50796", "1.577096", "1.57796", "1.70796", "1.750796"), "1.570796"),
}
"""Digits of pi or its half, one left out or two exchanged: what is meant."""
_LIMITS = ("lower", "upper")


class MistypedPi(Rule):
    """An angle has the digits of pi, but for one that is missing or two that are exchanged.

    A scan up to 3.1459 looks at a part of the circle twice, and a link that is turned by 1.5078 is 3.6° off.
    """

    code = "FRM011"
    name = "mistyped-pi"
    severity = Severity.WARNING
    remedy = """Write 3.14159 or 1.570796.

    In xacro write `${pi}` and `${pi/2}`.
    """
    looks_at = (Element,)
    selects = (
        *("sdf:pose", "sdf:min_angle", "sdf:max_angle", "sdf:horizontal_fov", "sdf:lower", "sdf:upper"),
        *("urdf:origin", "urdf:limit"),
    )
    needs = tuple(dict.fromkeys(wrong[:5] for wrong in RIGHT))
    scaffold = IN_LINK

    bad = (
        Bad(
            '<sensor name="s" type="gpu_lidar"><lidar><scan><horizontal><samples>9</samples>'
            "<min_angle>«-3.1459»</min_angle><max_angle>3.14159</max_angle></horizontal></scan>"
            "<range><min>1</min><max>9</max></range></lidar></sensor>",
            fixed='<sensor name="s" type="gpu_lidar"><lidar><scan><horizontal><samples>9</samples>'
            "<min_angle>-3.14159</min_angle><max_angle>3.14159</max_angle></horizontal></scan>"
            "<range><min>1</min><max>9</max></range></lidar></sensor>",
            unsafe=True,
            says="-3.1459 is nearly -3.14159",
        ),
        Bad("<pose>0 0 1 0 «1.5780» 0</pose>", fixed="<pose>0 0 1 0 1.5708 0</pose>", unsafe=True),
        Bad(
            '<origin rpy="0 0 «1.57709»"/><limit lower="0" upper="1" effort="5" velocity="2"/>',
            fixed='<origin rpy="0 0 1.57079"/><limit lower="0" upper="1" effort="5" velocity="2"/>',
            unsafe=True,
            scaffold=IN_URDF_JOINT,
        ),
    )
    good = (
        Good("<pose>3.1459 0 1 0 0 3.1416</pose>", why="the first three are meters"),
        Good("<pose>0 0 1 0 0 1.5</pose>"),
        Good(
            '<state world_name="w"><model name="m"><pose>0 0 1 0 0 1.5780</pose></model></state>',
            scaffold=IN_WORLD,
            why="a simulator wrote the state",
        ),
    )

    @staticmethod
    def applies(element: Element) -> bool:
        if not any(word.lstrip("+-") in RIGHT for _, _, word in angles(element)):
            return False
        return all(each.name != "state" for each in element.around)

    def check(self, element: Element) -> Iterator[Diagnostic]:
        for value, number, word in angles(element):
            meant = RIGHT.get(word.lstrip("+-"))
            if meant is not None:
                meant, span = word[: len(word) - len(word.lstrip("+-"))] + meant, value.part(number)
                fix = make_fix(f"write {meant}", (TextEdit(span, meant),), unsafe=True)
                yield self.diagnostic(span, f"{word} is nearly {meant}", fix=fix)


def angles(element: Element) -> Iterator[tuple[Value, int, str]]:
    """The angles that an element writes: the text, and which word of it each is."""
    if element.name == "limit":
        values = [value for name in _LIMITS if (value := element.attribute(name)) is not None]
    else:
        own = element.attribute("rpy") if element.name == "origin" else element.own_value
        values = [] if own is None else [own]
    first = 3 if element.name == "pose" else 0
    for value in values:
        for number, word in enumerate(value.text.split()):
            if number >= first:
                yield value, number, word
