from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Severity, VendorRule, VendorTag
from sdfcheck_rules.drk.scaffolds import BOX, COLLISION, MODEL, SPHERE

RIGID = "<drake:rigid_hydroelastic/>"


class ConflictingCompliance(VendorRule):
    """Drake's elements beside each other do not go together.

    A geometry is rigid or compliant in hydroelastic contact, not both. A compliant one
    needs its modulus; whatever Drake meshes itself (sphere, cylinder, capsule, ellipsoid) needs a
    resolution hint; a half space cannot be compliant.
    """

    code = "DRK005"
    name = "conflicting-compliance"
    severity = Severity.ERROR
    remedy = """Choose rigid or compliant; compliant needs a modulus, and a round shape a resolution hint.

    A compliant one needs `drake:hydroelastic_modulus` in Pa (1e5 is soft rubber, 1e8 hard plastic);
    spheres, cylinders, capsules and ellipsoids need a `drake:mesh_resolution_hint` in meters, about a
    quarter of their radius. A half space is rigid.
    """
    prefix = "drake"
    looks_at = (VendorTag,)
    scaffold = BOX

    bad = (
        Bad(
            "<«drake:rigid_hydroelastic»/><drake:compliant_hydroelastic/>",
            says="`drake:rigid_hydroelastic` and `drake:compliant_hydroelastic` exclude each other",
        ),
        Bad(
            "<«drake:compliant_hydroelastic»/>",
            says="`drake:compliant_hydroelastic` needs `drake:hydroelastic_modulus`: Drake refuses the file",
        ),
        Bad(
            "<«drake:rigid_hydroelastic»/>",
            says="`drake:rigid_hydroelastic` on a `sphere` needs `drake:mesh_resolution_hint`",
            scaffold=SPHERE,
        ),
        Bad(
            RIGID + "<«drake:hydroelastic_modulus»>1e7</drake:hydroelastic_modulus>",
            says="has no effect beside `drake:rigid_hydroelastic`: Drake ignores it",
        ),
        Bad(
            "<geometry><plane><normal>0 0 1</normal><size>1 1</size></plane></geometry>"
            "<drake:proximity_properties>"
            "<«drake:compliant_hydroelastic»/><drake:hydroelastic_modulus>1e7</drake:hydroelastic_modulus>"
            "</drake:proximity_properties>",
            says="`drake:compliant_hydroelastic` and `plane` exclude each other",
            scaffold=COLLISION,
        ),
        Bad(
            '<drake:joint name="j" type="planar"><drake:parent>a</drake:parent><drake:child>b</drake:child>'
            "<drake:damping>0 0 0</drake:damping><«pose»>0 0 1 0 0 0</pose></drake:joint>",
            says="`pose` and `drake:joint` exclude each other",
            scaffold=MODEL,
        ),
    )
    good = (
        Good(RIGID, why="a box needs no hint"),
        Good(RIGID + "<drake:mesh_resolution_hint>0.1</drake:mesh_resolution_hint>", scaffold=SPHERE),
        Good("<drake:compliant_hydroelastic/><drake:hydroelastic_modulus>1e7</drake:hydroelastic_modulus>"),
        Good(
            "<drake:hydroelastic_modulus>1e7</drake:hydroelastic_modulus>", why="kept for later, and harmless"
        ),
    )

    @staticmethod
    def applies(tag: VendorTag) -> bool:
        if tag.prefix != "drake":
            return False
        if tag.excluded is not None or tag.idle_beside is not None:
            return True
        return bool(tag.forbidden or tag.needs)

    def check(self, tag: VendorTag) -> Iterator[Diagnostic]:
        yield from self.conflicting(tag)
