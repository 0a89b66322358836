"""What Drake does about links without mass."""

from sdfcheck import Consumer, Link, Reaction, warns


def in_drake(link: Link) -> dict[Consumer, Reaction]:
    """It takes a sphere where there are moments without a mass."""
    inertial = link.inertial
    if inertial.mass.is_given and inertial.mass.number == 0 and any(inertial.tensor):
        return {Consumer.DRAKE: warns("takes a solid sphere of 1 kg in its place")}
    return {}
