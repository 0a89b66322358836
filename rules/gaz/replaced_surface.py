from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Element, GazeboBlock, Good, Rule, Severity

PLACES = {
    "mu1": ("friction", "mu"),
    "mu2": ("friction", "mu2"),
    "fdir1": ("friction", "fdir1"),
    "kp": ("contact", "kp"),
    "kd": ("contact", "kd"),
    "maxVel": ("contact", "max_vel"),
    "minDepth": ("contact", "min_depth"),
}
"""Setting → the part of a `surface` that libsdformat writes it into, and its name in `ode` there."""
BOX = '<collision><geometry><box size="1 1 1"/></geometry></collision>'
ROBOT = f'<robot name="r"><link name="foot">{BOX}</link>{{}}</robot>'
BLOCK = '<gazebo reference="foot">{}</gazebo>'
BOUNCE = "<collision><surface><bounce><threshold>1</threshold></bounce></surface></collision>"
IMU = BLOCK.format('<sensor name="s" type="imu"/>')


class ReplacedSurface(Rule):
    """Settings of a link are lost, as a later `gazebo` block gives its collisions a whole `surface`.

    libsdformat makes one `surface` of the settings of all blocks about a link, and throws that away for one that is
    written out. In a block that is not the first, and in those after it, settings of friction are lost as well if the
    `surface` has no `friction`, and those of contact without `contact`: libsdformat writes them into memory that it has
    given back, so that they turn up in another element, or it crashes.
    """

    code = "GAZ042"
    name = "replaced-surface"
    severity = Severity.WARNING
    remedy = """Put the block with the `surface` in front of all others about the link, or all settings into it.

    `mu1` is `friction/ode/mu` there, `kp` is `contact/ode/kp`, `maxVel` is `contact/ode/max_vel` and `minDepth` is
    `contact/ode/min_depth`.
    """
    looks_at = (GazeboBlock,)
    needs = ("<surface",)
    scaffold = ROBOT
    sources = ("https://github.com/gazebosim/sdformat/issues/164",)

    bad = (
        Bad(
            BLOCK.format("<«mu1»>0.3</mu1><kp>1e6</kp>") + BLOCK.format(BOUNCE),
            says="`mu1` and 1 more of link `foot` are lost: the `surface` in a later block takes their place",
        ),
        Bad(
            IMU + BLOCK.format(f"<«kp»>1e6</kp>{BOUNCE}"),
            says="`kp` of link `foot` is lost: the `surface` beside it is not in the first block, and has no `contact`",
        ),
        Bad(IMU + BLOCK.format(BOUNCE) + BLOCK.format("<«mu2»>1</mu2>"), says="has no `friction`"),
    )
    good = (
        Good(BLOCK.format(f"<mu1>0.3</mu1><kp>1e6</kp>{BOUNCE}")),
        Good(BLOCK.format(BOUNCE) + IMU + BLOCK.format("<mu1>0.3</mu1>"), why="the first block has it"),
        Good(
            BLOCK.format("<mu1>0.3</mu1>")
            + BLOCK.format(
                "<collision><surface><friction><ode><mu>0.3</mu></ode></friction></surface></collision>"
            ),
            why="the `surface` has it as well",
        ),
    )

    @staticmethod
    def applies(block: GazeboBlock) -> bool:
        return next(lost(block), None) is not None

    def check(self, block: GazeboBlock) -> Iterator[Diagnostic]:
        for surface, (first, *more), why in lost(block):
            what = f"`{first.name}`{f' and {len(more)} more' if more else ''} of link `{block.reference}`"
            message = f"{what} {'are' if more else 'is'} lost: the `surface` {why}"
            yield self.diagnostic(first, message, labels={surface: "this one"})


def lost(block: GazeboBlock) -> Iterator[tuple[Element, list[Element], str]]:
    """Each `surface` by which settings of the link are lost, these settings, and the words for it.

    Those of all blocks about the link are reported at the first one.
    """
    blocks = block.model.blocks_by_reference.get(block.reference, ())
    if block.link is None or not block.link.collisions or len(blocks) < 2 or blocks[0] is not block:
        return
    given: list[Element] = []
    latest: Element | None = None
    parts = {"friction", "contact"}
    for other in blocks:
        surface = surface_of(other)
        if surface is not None and other is not block:
            kept = {name for name in PLACES if has(surface, name)}
            gone = [each for each in given if each.name not in kept]
            if gone:
                yield surface, gone, "in a later block takes their place"
            given, latest, parts = [], surface, {each.name for each in surface.children()}
        own = [each for each in other.children() if each.name in PLACES]
        misplaced = [each for each in own if PLACES[each.name][0] not in parts]
        if latest is not None and misplaced:
            where = "beside it" if latest is surface else "in a block before"
            yield (
                latest,
                misplaced,
                f"{where} is not in the first block, and has no `{PLACES[misplaced[0].name][0]}`",
            )
        given += [each for each in own if PLACES[each.name][0] in parts]


def surface_of(block: GazeboBlock) -> Element | None:
    """The `surface` that it gives to the collisions of its link."""
    collisions = (each for each in block.children() if each.name == "collision")
    return next((each.find("surface") for each in collisions if each.find("surface") is not None), None)


def has(surface: Element, setting: str) -> bool:
    """Does a `surface` say the same as a setting?"""
    part, name = PLACES[setting]
    there = surface.find(part)
    ode = there.find("ode") if there is not None else None
    return ode is not None and ode.find(name) is not None
