from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Element, GazeboBlock, Good, Rule, Severity

BOX = '<collision><geometry><box size="1 1 1"/></geometry></collision>'
ROBOT = f'<robot name="r"><link name="base">{BOX}</link>{{}}</robot>'


class RepeatedSetting(Rule):
    """A setting of a link or joint is given twice in `gazebo` blocks, with two values.

    libsdformat overwrites the first with the last, which may be in a file that another one includes.
    """

    code = "GAZ013"
    name = "repeated-setting"
    severity = Severity.WARNING
    remedy = """Remove one of the two, and keep the value that is meant.

    Blocks of all files that are included add up, so look in the macros of the parts, too. The last one is
    in effect now.
    """
    looks_at = (GazeboBlock,)
    scaffold = ROBOT

    bad = (
        Bad(
            '<gazebo reference="base"><mu1>9</mu1><«mu1»>1.5</mu1></gazebo>',
            says="`mu1` of `base` is `1.5` here and `9` before; libsdformat takes the last",
        ),
        Bad(
            '<gazebo reference="base"><mu1>9</mu1></gazebo><gazebo reference="base"><«mu1» value="1.5"/></gazebo>'
        ),
    )
    good = (
        Good('<gazebo reference="base"><mu1>9</mu1><mu2>1.5</mu2></gazebo>'),
        Good('<gazebo reference="base"><mu1>9</mu1><mu1> 9.0 </mu1></gazebo>', why="the same twice"),
    )

    @staticmethod
    def applies(block: GazeboBlock) -> bool:
        return bool(repeated(block))

    def check(self, block: GazeboBlock) -> Iterator[Diagnostic]:
        for first, again in repeated(block):
            name, about = again.name, f"of `{block.reference}`" if block.reference else "of the robot"
            message = f"`{name}` {about} is `{text(again)}` here and `{text(first)}` before; libsdformat takes the last"
            yield self.diagnostic(again, message, labels={first: "lost"})


def repeated(block: GazeboBlock) -> list[tuple[Element, Element]]:
    """The settings in the blocks about one link, joint or robot that one before gives with another value.

    Those of all blocks are reported at the first one.
    """
    blocks = block.model.blocks_by_reference.get(block.reference, ())
    if not blocks or blocks[0] is not block:
        return []
    before: dict[str, Element] = {}
    found = []
    for other in blocks:
        for child in other.overridable:
            first = before.get(child.name)
            if first is not None and not is_same(text(first), text(child)):
                found.append((first, child))
            before[child.name] = child
    return found


def text(setting: Element) -> str:
    """The value of a setting: its attribute `value`, else its text."""
    return str(setting.get("value") or setting.content).strip()


def is_same(one: str, other: str) -> bool:
    """Are two values one, as numbers or truth values?"""
    try:
        return float(one) == float(other)
    except ValueError:
        truths = {"1": "true", "0": "false", "yes": "true"}
        return truths.get(one.lower(), one.lower()) == truths.get(other.lower(), other.lower())
