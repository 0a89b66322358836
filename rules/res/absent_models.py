"""Models that includes lack for a reason outside of the file."""

from __future__ import annotations

from typing import NamedTuple

from sdfcheck import Include, MissingKind
from sdfcheck_rules.res.places import looked_for, near_model, place


class Absence(NamedTuple):
    """A model that is missing, and the advice; ``meant`` is the one that its name is a misspelling of."""

    kind: MissingKind
    name: str
    message: str
    advice: str
    meant: str | None = None


def elsewhere(include: Include) -> Absence:
    """A model that another computer may have, or the network."""
    location = include.location
    assert location is not None
    kind, name = location.scheme or "model", location.name or include.uri
    if location.is_remote:
        message = f"`{include.uri}` is not fetched, so what it brings is not known"
        advice = "download it, and name the folder of its models in `model-paths` of the configuration"
        return Absence(MissingKind.REMOTE, include.uri, message, advice)
    advice = f"{looked_for(include)}; set `{kind}-paths` in the configuration if it is elsewhere"
    message = f"{kind} `{name}` is not on the search path"
    return Absence(MissingKind(kind), name, message, advice, near_model(include))


def of_submodule(include: Include, folder: str) -> Absence:
    """The models of a folder without content."""
    name = place(include.document, folder)
    message = f"folder `{name}` is empty: it may be a submodule that is not checked out"
    advice = f"{looked_for(include)}; fetch it with `git submodule update --init`"
    return Absence(MissingKind.SUBMODULE, name, message, advice)


def unfetched(include: Include) -> str:
    """The folder without content that an include leads into, as that of a submodule that is not checked out."""
    location = include.location
    if location is None or location.is_remote or not (include.is_missing or include.needs_config):
        return ""
    is_name = location.is_searched_for and location.owner is None
    return "" if is_name else include.empty_folder
