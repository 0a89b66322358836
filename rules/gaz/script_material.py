from collections.abc import Iterator

from sdfcheck import IN_VISUAL, Bad, Consumer, Diagnostic, Good, Rule, Severity, problems, used, warns

BOX = '<geometry><box size="1 1 1"/></geometry>'
SHAPE = "<geometry><box><size>1 1 1</size></box></geometry>"
LINK = f'<robot name="r"><link name="base"><visual>{BOX}</visual></link>{{}}</robot>'
RED = '<material name="red"><color rgba="1 0 0 1"/></material>'


class ScriptMaterial(Rule):
    """A visual gets its looks from a material script, which new Gazebo does not load.

    Scripts belong to the renderer of Gazebo Classic; its successor shows the default colour. Only the
    colours of the `Gazebo/…` palette are known to recent releases by their names, so these are for information.
    Colours beside the script (`ambient`, `diffuse`, `pbr`) are seen everywhere.
    """

    code = "GAZ006"
    name = "script-material"
    severity = Severity.WARNING
    affects = {
        Consumer.GAZEBO: warns("shows the default colour"),
        Consumer.DRAKE: {"sdf": warns("shows the default colour")},
    }
    explains = (problems.ScriptMaterial,)
    scaffold = IN_VISUAL

    bad = (
        Bad(
            f"{SHAPE}<material><script><uri>model://m/materials/scripts</uri>"
            "<name>«Bark»</name></script></material>",
            says="new Gazebo does not read material script `Bark`, and no colour stands beside it",
        ),
        Bad(
            '<gazebo reference="base"><material>«Gazebo/Red»</material></gazebo>'
            '<gazebo reference="base"><material>Gazebo/Red</material></gazebo>',
            scaffold=LINK,
            says="`Gazebo/Red` (used 2 times)",
        ),
    )
    good = (
        Good(
            f"{SHAPE}<material><script><uri>file://media/materials/scripts/gazebo.material</uri>"
            "<name>Gazebo/Red</name></script><diffuse>1 0 0 1</diffuse></material>",
            why="the colour is there for those who read no scripts",
        ),
        Good(
            '<gazebo reference="base"><material>Gazebo/Red</material></gazebo>',
            why="the colour of the visual is seen",
            scaffold=LINK.replace("</visual>", f"{RED}</visual>"),
        ),
    )

    def check(self, problem: problems.ScriptMaterial) -> Iterator[Diagnostic]:
        script = f"material script `{problem.script}`" if problem.script else "a material script"
        severity = Severity.INFO if problem.script.startswith("Gazebo/") else None
        yield self.diagnostic(
            problem.target,
            f"new Gazebo does not read {script}{used(problem.count)}, and no colour stands beside it",
            help="give the material `ambient` and `diffuse`",
            severity=severity,
        )
