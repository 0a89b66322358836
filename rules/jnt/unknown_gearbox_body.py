from collections.abc import Iterator

from sdfcheck import IN_MODEL, Bad, Diagnostic, Good, Joint, Rule, Severity

GEARBOX = (
    '<link name="a"/><link name="b"/><joint name="g" type="gearbox"><parent>a</parent><child>b</child>'
    "<gearbox_ratio>2</gearbox_ratio><gearbox_reference_body>{}</gearbox_reference_body>"
    "<axis><xyz>0 0 1</xyz></axis><axis2><xyz>0 0 1</xyz></axis2></joint>"
)


class UnknownGearboxBody(Rule):
    """The reference body of a gearbox names nothing in its model.

    The angles that a gearbox couples are measured against that body. Without it Gazebo
    reports an error when the simulation starts, and couples nothing.
    """

    code = "JNT018"
    name = "unknown-gearbox-body"
    severity = Severity.ERROR
    remedy = """Name a link of the same model as `gearbox_reference_body`.

    It is the body that carries both of the coupled joints: mostly the housing, the parent of both.
    """
    preview = True
    looks_at = (Joint,)
    scaffold = IN_MODEL

    bad = (
        Bad(
            GEARBOX.format("«bsae»"),
            fixed=GEARBOX.format("base"),
            unsafe=True,
            says="the reference body `bsae` of joint `g` does not exist; did you mean `base`?",
            also=("DRK008",),
        ),
    )
    good = (Good(GEARBOX.format("base")),)

    @staticmethod
    def applies(joint: Joint) -> bool:
        name = joint.get("gearbox_reference_body") if joint.type == "gearbox" else None
        return name is not None and name.strip() != "" and joint.scope.lacks(name.strip())

    def check(self, joint: Joint) -> Iterator[Diagnostic]:
        value = joint.value("gearbox_reference_body")
        assert value is not None
        name = value.text.strip()
        message = f"the reference body `{name}` of {joint.title} does not exist"
        yield self.diagnostic(value, message, meant=joint.scope.guess(name, but=(joint.name,)).meant)
