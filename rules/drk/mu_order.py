from collections.abc import Iterator

from sdfcheck import REFUSES, Bad, Collision, Diagnostic, Good, Severity, VendorRule, VendorTag
from sdfcheck_rules.drk.effect import above, does
from sdfcheck_rules.drk.frictions import friction, own_friction
from sdfcheck_rules.drk.scaffolds import BOX, COLLISION

DEFAULT_MU = 1.0

ODE = (
    "<geometry><box><size>1 1 1</size></box></geometry><surface><friction><ode>{}</ode></friction></surface>"
)


class MuOrder(VendorRule):
    """The dynamic friction is greater than the static one.

    Drake refuses such a pair. Beside `drake:mu_dynamic` and `drake:mu_static` it reads `mu` of the
    ODE settings as the static and `mu2` as the dynamic friction, each of them 1 if it is not given: a lone
    `mu` below 1 is refused. ODE's settings are judged with `--target drake` only.
    """

    code = "DRK014"
    name = "mu-order"
    severity = Severity.ERROR
    remedy = """Write a dynamic friction that is at most the static one.

    `mu2` is taken for the dynamic one, so write it beside `mu`, with the same value. Or give
    `drake:mu_dynamic` and `drake:mu_static`, which win over the settings of ODE.
    """
    prefix = "drake"
    looks_at = (Collision, VendorTag)
    selects = ("sdf:collision",)
    scaffold = BOX

    bad = (
        Bad(
            "<drake:mu_static>0.3</drake:mu_static><drake:mu_dynamic>«0.5»</drake:mu_dynamic>",
            says="`drake:mu_dynamic` is 0.5 and above `drake:mu_static`, 0.3: Drake refuses the file",
        ),
        Bad(
            ODE.format("<mu>«0.5»</mu>"),
            says="`mu` is 0.5, and `mu2` is 1 where it is not given: Drake refuses the file",
            scaffold=COLLISION,
        ),
        Bad(
            ODE.format("<mu>0.5</mu><mu2>«0.6»</mu2>"),
            says="`mu2` is 0.6 and above `mu`, 0.5",
            scaffold=COLLISION,
        ),
    )
    good = (
        Good("<drake:mu_dynamic>2</drake:mu_dynamic>", why="alone it holds for both"),
        Good(ODE.format("<mu>0.5</mu><mu2>0.5</mu2>"), scaffold=COLLISION),
    )

    def check(self, subject: Collision | VendorTag) -> Iterator[Diagnostic]:
        if isinstance(subject, Collision):
            yield from self._of_ode(subject)
        elif subject.prefix == "drake" and "mu_" in subject.name and (excess := subject.excess) is not None:
            message = above(subject.name, excess.low, excess.high)
            labels = {excess.high: "the value that it must not exceed"}
            yield self.report(subject, message, excess.effect, at=excess.low, labels=labels)

    def _of_ode(self, collision: Collision) -> Iterator[Diagnostic]:
        """`mu` is the static friction, `mu2` the dynamic one."""
        standard = friction(collision)
        ode = standard.find("ode") if standard is not None and own_friction(collision) is None else None
        static, dynamic = (ode.value("mu"), ode.value("mu2")) if ode is not None else (None, None)
        low = static.number if static is not None else DEFAULT_MU
        high = dynamic.number if dynamic is not None else DEFAULT_MU
        if not high > low >= 0:
            return
        if static is not None and dynamic is not None:
            message = (
                f"`mu2` is {dynamic.text.strip()} and above `mu`, {static.text.strip()}: {does(REFUSES)}"
            )
            yield self.diagnostic(dynamic, message, labels={static: "the static friction"})
        elif (lone := static or dynamic) is not None:
            name, other = ("mu", "mu2") if lone is static else ("mu2", "mu")
            message = f"`{name}` is {lone.text.strip()}, and `{other}` is 1 where it is not given"
            yield self.diagnostic(lone, f"{message}: {does(REFUSES)}")
