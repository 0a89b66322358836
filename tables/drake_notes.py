"""The prose of the facts about Drake, as keys of the table."""

from __future__ import annotations

_PRIMITIVES = "(geometry/sphere,geometry/cylinder,geometry/capsule,geometry/ellipsoid,geometry/:capsule,geometry/:ellipsoid)"
_SHAPES = "box,sphere,cylinder,capsule,ellipsoid,plane,mesh"

IGNORED_IN = (
    "axis",
    "axis/dynamics",
    "inertial",
    "pose",
    "frame",
    "mesh",
    "include",
    "surface/*",
    ":collision_filter_group",
    "@",
)
"""The parents in which Drake does not look for unknown tags; ``@`` means attributes."""

GONE = {
    "drake:elastic_modulus": (":hydroelastic_modulus", "sdf:error,urdf:ignored"),
    "drake:soft_hydroelastic": (":compliant_hydroelastic", "error"),
}
"""Tags that were: what to use instead, and what becomes of them."""

TAG_KEYS: dict[str, tuple[str, ...]] = {
    "ball_constraint_body_B": ("differs=:ball_constraint_body_A",),
    "ball_constraint_p_AP": ("point-in=:ball_constraint_body_A",),
    "ball_constraint_p_BQ": ("point-in=:ball_constraint_body_B",),
    "capsule": (f"loses-to={_SHAPES}", "deprecated=capsule", "deprecated-in=sdf"),
    "collision_filter_group": ("any=:member,:member_group", "skipped=@ignore"),
    "compliant_hydroelastic": (
        "needs=:hydroelastic_modulus",
        f"needs=:mesh_resolution_hint{_PRIMITIVES}",
        "excludes=geometry/plane",
    ),
    "curves": ("any=:line_segment,:circular_arc", "only=yes"),
    "distance_constraint_body_B": ("differs=:distance_constraint_body_A",),
    "distance_constraint_p_AP": ("point-in=:distance_constraint_body_A",),
    "distance_constraint_p_BQ": ("point-in=:distance_constraint_body_B",),
    "ellipsoid": (f"loses-to={_SHAPES}", "deprecated=ellipsoid", "deprecated-in=sdf"),
    "hydroelastic_modulus": (
        "range-with=:compliant_hydroelastic",
        "idle-with=:rigid_hydroelastic",
    ),
    "joint": ("forbids=pose",),
    "linear_spring_damper_p_AP": ("point-in=:linear_spring_damper_body_A",),
    "linear_spring_damper_p_BQ": ("point-in=:linear_spring_damper_body_B",),
    "mesh_resolution_hint": (
        f"range-with=:compliant_hydroelastic{_PRIMITIVES},:rigid_hydroelastic{_PRIMITIVES}",
    ),
    "mu_dynamic": ("at-most=:mu_static",),
    "rigid_hydroelastic": (
        "excludes=:compliant_hydroelastic",
        f"needs=:mesh_resolution_hint{_PRIMITIVES}",
    ),
    "surface_velocity_axis": ("direction-in=link",),
    "tendon_constraint_lower_limit": ("at-most=:tendon_constraint_upper_limit:abort",),
    "tendon_constraint": ("missing=:tendon_constraint_joint:abort",),
    "visual": ("mirror=visual", "any=:geometry", "missing=:geometry:abort"),
}
"""Tag → how it gets on with others; see docs/vendor-tables.md for the keys."""

_ONE_AXIS = "[type=continuous,prismatic,revolute]"

PLACES: dict[tuple[str, str], tuple[tuple[str, ...], ...]] = {
    ("acceleration", "sdf"): ((f"model/joint{_ONE_AXIS}/axis/limit", "text", "0", "else=ignored"),),
    ("acceleration", "urdf"): ((f"robot/joint{_ONE_AXIS}/limit", "attribute", "0", "else=ignored"),),
    ("damping", "sdf"): (
        ("model/:joint[type=planar]", "text", "1", "type=vector3"),
        ("model/:joint[type=curvilinear]", "text", "0", "wrong=error"),
    ),
}
"""(Tag, dialect) → its places, where they depend on the type of the joint."""

PLACE_KEYS: dict[tuple[str, str], tuple[str, ...]] = {
    ("angle", "urdf"): ("use=:circular_arc/@angle",),
    ("child", "urdf"): ("use=child/@link",),
    ("collision_filter_group", "@name"): ("plain=error", "unique=urdf:error"),
    ("damping", "urdf"): ("use=dynamics/@damping",),
    ("diffuse_map", "urdf"): ("use=material/texture/@filename", "within=material"),
    ("is_periodic", "sdf"): ("bad=error",),
    ("is_periodic", "urdf"): ("bad=false", "lacking=false"),
    ("initial_tangent", "urdf"): ("lacking=1 0 0",),
    ("length", "urdf"): ("use=:line_segment/@length",),
    ("mimic", "urdf"): ("use=joint/mimic",),
    ("parent", "urdf"): ("use=parent/@link",),
    ("plane_normal", "urdf"): ("lacking=0 0 1",),
    ("radius", "urdf"): ("use=:circular_arc/@radius",),
    ("screw_thread_pitch", "sdf"): ("use=joint/screw_thread_pitch",),
    ("tendon_constraint_joint", "@name"): ("unique=error",),
}
"""(Tag, dialect or attribute) → keys of the line."""

REFERENCES = {"frame": "frame,link", "tendon_constraint_joint": "joint,:joint"}
"""Kind in the facts, or tag, → the kinds of thing that a name may be of."""

UNITS = {"damping": "N s/m", "gear_ratio": "|1/m"}
"""Tag → unit, where the facts give it in a sentence."""
