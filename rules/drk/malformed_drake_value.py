from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Severity, VendorRule, VendorTag, VendorValue
from sdfcheck_rules.drk.scaffolds import BOX, JOINT, LINK, MODEL, ROBOT


class MalformedDrakeValue(VendorRule):
    """The value of one of Drake's elements is not of its type, or not where Drake reads it.

    In SDF files the value is mostly the text of the element, and Drake takes what number
    is at its front: `1,5` is 1, a word or nothing is 0, and the simulation runs with it. In
    URDF files the value is an attribute, and anything but the right number of numbers
    makes Drake refuse the file; only letters after a number are cut off.
    """

    code = "DRK003"
    name = "malformed-drake-value"
    severity = Severity.ERROR
    remedy = """Write the value where Drake reads it, and as the type that it asks for.

    In SDF it is mostly the text of the element, `<drake:mu_dynamic>0.5</drake:mu_dynamic>`, in URDF an
    attribute, `<drake:mu_dynamic value="0.5"/>`. `sdfcheck describe drake:NAME` shows type and unit.
    """
    prefix = "drake"
    looks_at = (VendorTag, VendorValue)
    scaffold = BOX

    bad = (
        Bad(
            "<drake:mu_dynamic>«0,5»</drake:mu_dynamic>",
            says="should be a number, not `0,5`: Drake reads `0`",
        ),
        Bad("<drake:mu_dynamic>«low»</drake:mu_dynamic>", says="Drake reads `0`"),
        Bad("<«drake:mu_dynamic»/>", says="`drake:mu_dynamic` is empty: Drake reads `0`"),
        Bad(
            '<drake:mu_dynamic «value»="0.5"/>',
            says="is read from its text, not from its attribute `value`: Drake reads `0`",
        ),
        Bad(
            '<drake:controller_gains p="«high»" d="1"/>',
            says="`p` of `drake:controller_gains`",
            scaffold=JOINT,
        ),
        Bad(
            '<visual name="v"><geometry><box><size>1 1 1</size></box></geometry>'
            '<drake:perception_properties enabled="«off»"/></visual>',
            says="should be true or false, not `off`: Drake refuses the file",
            scaffold=LINK,
        ),
        Bad(
            '<transmission><type>SimpleTransmission</type><joint name="j"/><actuator name="m">'
            "<drake:gear_ratio>«3»</drake:gear_ratio></actuator></transmission>",
            says="is read from its attribute `value`, not from its text: Drake refuses the file",
            scaffold=ROBOT,
        ),
        Bad(
            '<link name="s"><drake:deformable_properties>'
            "<drake:material_model>«rubber»</drake:material_model>"
            "</drake:deformable_properties></link>",
            says="cannot be `rubber`: Drake refuses the file; it is one of `linear_corotated`",
            scaffold=MODEL,
        ),
    )
    good = (
        Good("<drake:mu_dynamic> 5e-1 </drake:mu_dynamic>"),
        Good("<drake:rigid_hydroelastic>false</drake:rigid_hydroelastic>", why="its presence alone counts"),
    )

    @staticmethod
    def applies(given: VendorTag | VendorValue) -> bool:
        if given.prefix != "drake":
            return False
        if isinstance(given, VendorTag):
            return given.is_empty and (given.stray is not None or given.lacks_text)
        is_type_of_joint = given.tag.name == "drake:joint"
        return given.misreading is not None or (given.is_unknown_choice and not is_type_of_joint)

    def check(self, given: VendorTag | VendorValue) -> Iterator[Diagnostic]:
        yield self.malformed(given)
