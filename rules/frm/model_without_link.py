from collections.abc import Iterator

from sdfcheck import SDF, Bad, Diagnostic, Good, Model, Rule, Severity


class ModelWithoutLink(Rule):
    """A model that is not static has no link.

    Nothing of it can move or be seen. libsdformat refuses the file unless the model is
    static or holds another model; that the model around it is static does not help.
    """

    code = "FRM005"
    name = "model-without-link"
    severity = Severity.ERROR
    remedy = """Give the model a link, or declare `<static>true</static>`.

    A model that only groups other models needs at least one of them inside. A model that is a mere place in
    the world is better written as a `<frame>` of the world. If the links were lost, look for a misspelled
    or wrapped `link`.
    """
    looks_at = (Model,)
    scaffold = SDF

    bad = (
        Bad('<«model» name="m"/>', says="model `m` has no link"),
        Bad('<«model» name="m"><frame name="f"/></model>', says="model `m` has no link"),
        Bad('<model name="m"><static>true</static><«model» name="n"/></model>', says="model `n` has no link"),
    )
    good = (
        Good('<model name="m"><static>true</static></model>', why="a static model needs none"),
        Good(
            '<model name="m"><model name="n"><link name="l"/></model></model>', why="the nested model has one"
        ),
        Good(
            '<model name="m"><include><uri>model://not_here</uri></include></model>',
            why="an include that could not be read may bring one",
        ),
    )

    @staticmethod
    def applies(model: Model) -> bool:
        if model.has("link") or model.has("model") or model.is_urdf:
            return False
        return not (
            model.links
            or model.models
            or not model.is_complete
            or model.stands_still
            or model.is_included_as_static
        )

    def check(self, model: Model) -> Iterator[Diagnostic]:
        cause = model.misnamed("link") or model.misnamed("model")
        yield self.diagnostic(model, f"{model.title} has no link, and is not static", cause=cause)
