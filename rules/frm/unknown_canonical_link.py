from collections.abc import Iterator

from sdfcheck import SDF, Bad, Diagnostic, Good, Model, Rule, Severity


class UnknownCanonicalLink(Rule):
    """The canonical link of a model is not one of its links.

    The model's own frame moves with this link, so it must be a link of the model or, as
    `A::b`, of a model nested in it (SDFormat 1.7). libsdformat refuses the file, also
    where the name is that of a frame or a joint.
    """

    code = "FRM003"
    name = "unknown-canonical-link"
    severity = Severity.ERROR
    remedy = """Name a link of the model, or leave `canonical_link` out: then the first link is taken.

    The canonical link is the one that the frame of the model moves with, so the heaviest one, such as the
    base, is the usual choice. For a frame name the link that it is attached to; a link of a nested model is
    `arm::base`.
    """
    looks_at = (Model,)
    scaffold = SDF

    bad = (
        Bad(
            '<model name="m" canonical_link="«bsae»"><link name="base"/></model>',
            fixed='<model name="m" canonical_link="base"><link name="base"/></model>',
            unsafe=True,
            says="`bsae` is not a link of model `m`; did you mean `base`?",
        ),
        Bad(
            '<model name="m" canonical_link="«tool»"><link name="base"/><frame name="tool"/></model>',
            says="`tool` is a frame, not a link",
        ),
    )
    good = (
        Good('<model name="m" canonical_link="b"><link name="a"/><link name="b"/></model>'),
        Good('<model name="m" canonical_link="n::a"><model name="n"><link name="a"/></model></model>'),
        Good('<model name="m" canonical_link=""><link name="a"/></model>', why="empty is the default"),
    )

    @staticmethod
    def applies(model: Model) -> bool:
        if model.canonical_link_value is None or model.is_urdf:
            return False
        name = model.canonical_link_name
        node = model.resolve(name)
        return model.lacks(name) if node is None else node.kind != "link"

    def check(self, model: Model) -> Iterator[Diagnostic]:
        value, name = model.canonical_link_value, model.canonical_link_name
        if value is None:
            return
        node = model.resolve(name)
        if node is not None:
            yield self.diagnostic(value, f"`{name}` is a {node.kind}, not a link")
            return
        message = f"`{name}` is not a link of {model.title}"
        meant = model.guess(name, kind="link").meant
        yield self.diagnostic(value, message, meant=meant, cause=model.fault_of(name))
