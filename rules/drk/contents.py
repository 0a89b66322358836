"""Which files Drake reads: those of one model or one world."""

from sdfcheck import Element, Root


def unread(root: Root) -> tuple[Element, str] | None:
    """The part that keeps Drake from reading an SDF file; None without one.

    That several models are too many is a matter of the format. A file that is included may hold a light.
    """
    if root.is_urdf or root.document.included_by:
        return None
    models, worlds = list(root.children("model")), list(root.children("world"))
    if not models and not worlds:
        return root.element, "a file with neither model nor world"
    if worlds and len(models) + len(worlds) > 1:
        return (models[0], "a model beside a world") if models else (worlds[1], "a second world")
    return None
