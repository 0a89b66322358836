from collections.abc import Iterator
from typing import Any

from sdfcheck import REFUSES, Bad, Consumer, Diagnostic, Good, Severity, VendorRule, problems
from sdfcheck_rules.drk.scaffolds import BOX, COLLISION

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
    affects = {Consumer.DRAKE: REFUSES}
    prefix = "drake"
    explains = (problems.UnorderedTags, problems.FrictionOrder)
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

    def check(self, problem: Any) -> Iterator[Diagnostic]:
        if isinstance(problem, problems.UnorderedTags):
            yield from super().check(problem)
            return
        static, dynamic = problem.static, problem.dynamic
        name, text = static.element.name, static.text.strip()
        if dynamic is None:
            other = "mu2" if name == "mu" else "mu"
            message = f"`{name}` is {text}, and `{other}` is 1 where it is not given: Drake refuses the file"
            yield self.diagnostic(static, message)
            return
        message = f"`mu2` is {dynamic.text.strip()} and above `mu`, {text}: Drake refuses the file"
        yield self.diagnostic(dynamic, message, labels={static: "the static friction"})

    def is_about(self, problem: Any) -> bool:
        """Frictions only."""
        return "mu_" in problem.name
