from collections.abc import Iterator

from sdfcheck import (
    IN_WORLD,
    Bad,
    ConfigFault,
    Consumer,
    Diagnostic,
    Good,
    Include,
    ModelConfig,
    Rule,
    Severity,
    Value,
    accepts,
    refuses,
    warns,
    write_instead,
)

CONFIG = "model.config"
ARM = '<sdf version="1.12"><model name="arm"><link name="l"/></model></sdf>'
MESSAGES = {
    ConfigFault.NO_MODEL: "the root element of a model.config is `model`, not `{}`",
    ConfigFault.NO_NAME: "the model has no `name`",
    ConfigFault.NO_NAME_NO_FILE: "neither `name` nor `sdf` says what the model is",
    ConfigFault.NO_FILE: "no `sdf` says which file is the model",
    ConfigFault.EMPTY_FILE: "`sdf` names no file",
    ConfigFault.NO_VERSION: "`sdf` has no `version`",
    ConfigFault.EMPTY_VERSION: "the `version` of `sdf` is empty",
    ConfigFault.BAD_VERSION: "`{}` is not a version of SDFormat",
    ConfigFault.TOO_NEW: "version {} is newer than any consumer knows",
    ConfigFault.MISSING_FILE: "there is no file `{}` beside this one",
    ConfigFault.UNMADE_FILE: "`{}` has yet to be made (see `{}`)",
    ConfigFault.OTHER_VERSION: "version {} is not that of the file, which declares {}",
}
ADVICE = {
    ConfigFault.NO_MODEL: "write `<model>` as the root element",
    ConfigFault.NO_NAME: "give the model its `<name>`",
    ConfigFault.NO_VERSION: 'write the version that the file declares: `<sdf version="1.9">`',
    ConfigFault.EMPTY_VERSION: 'write the version that the file declares: `<sdf version="1.9">`',
    ConfigFault.BAD_VERSION: 'write the version that the file declares: `<sdf version="1.9">`',
    ConfigFault.TOO_NEW: 'write the version that the file declares: `<sdf version="1.9">`',
    ConfigFault.MISSING_FILE: "name a file of this folder",
    ConfigFault.UNMADE_FILE: "run the build that makes it",
}
"""The help where the rule's own would not fit."""
SEVERITIES = {
    ConfigFault.NO_NAME: Severity.WARNING,
    ConfigFault.EMPTY_VERSION: Severity.WARNING,
    ConfigFault.OTHER_VERSION: Severity.WARNING,
    ConfigFault.UNMADE_FILE: Severity.INFO,
}
READ = {consumer: accepts("reads the model") for consumer in (Consumer.GAZEBO, Consumer.DRAKE)}
NEWLY_REFUSED = {
    Consumer.GAZEBO: refuses("refuses the model; version 12 warns"),
    Consumer.DRAKE: warns("reads the model, and warns"),
}
REACTIONS = {
    ConfigFault.NO_NAME: READ,
    ConfigFault.EMPTY_VERSION: READ,
    ConfigFault.OTHER_VERSION: READ,
    ConfigFault.NO_VERSION: NEWLY_REFUSED,
    ConfigFault.TOO_NEW: NEWLY_REFUSED,
    ConfigFault.BAD_VERSION: {**READ, Consumer.GAZEBO: refuses("crashes")},
}
NAMING_MODEL = {ConfigFault.NO_VERSION, ConfigFault.TOO_NEW, ConfigFault.EMPTY_FILE}
"""Where libsdformat writes a message with the model's name in it."""


class InvalidModelConfig(Rule):
    """A `model.config` does not say which file is the model.

    A model folder is included through it: libsdformat takes the `sdf` element of the
    highest version that it knows, else the first one. A missing file or version, or a
    version from the future, fails the including document (libsdformat 12 only warns of
    versions). It crashes at a version that is not a number, and where it has something to
    say of a model without a name; a missing name alone is a warning. So is a version that
    is not that of the file: by it a consumer may take a file that is too new for it, and a
    missing file for an old version beside a newer one. A file that a build is to make, from a
    template beside it or in a folder without any description, is only pointed out.
    """

    code = "RES007"
    name = "invalid-model-config"
    severity = Severity.ERROR
    remedy = """Name the model's file in `<sdf version="…">`, with the version of SDFormat that it is written in.

    A whole `model.config` is

    ```xml
    <model>
      <name>arm</name>
      <sdf version="1.9">model.sdf</sdf>
    </model>
    ```

    Several `<sdf>` lines offer several versions; the highest that the consumer knows is taken. For a file
    that a build makes, run the build first.
    """
    looks_at = (ModelConfig, Include)
    scaffold = "<model><name>arm</name>{}</model>"

    bad = (
        Bad('<sdf version="1.12">«gone.sdf»</sdf>', file=CONFIG, files={}, says="no file `gone.sdf`"),
        Bad(
            '<sdf version="1.12">«amr.sdf»</sdf>',
            fixed='<sdf version="1.12">arm.sdf</sdf>',
            unsafe=True,
            file=CONFIG,
            files={"arm.sdf": ARM},
            says="no file `amr.sdf` beside this one, did you mean `arm.sdf`?",
        ),
        Bad(
            '<sdf version="1.12">«arm.sdf»</sdf>',
            file=CONFIG,
            files={"arm.sdf.jinja": "{{ arm }}"},
            says="`arm.sdf` has yet to be made (see `arm.sdf.jinja`)",
        ),
        Bad(
            '<sdf version="1.12">«stairs.urdf»</sdf>',
            file=CONFIG,
            files={"CMakeLists.txt": "", "make_stairs.py": ""},
            says="`stairs.urdf` has yet to be made (see `CMakeLists.txt`)",
        ),
        Bad(
            '<sdf version="«1.6»">arm.sdf</sdf>',
            fixed='<sdf version="1.12">arm.sdf</sdf>',
            unsafe=True,
            file=CONFIG,
            files={"arm.sdf": ARM},
            says="version 1.6 is not that of the file, which declares 1.12",
        ),
        Bad(
            '<sdf version="«1»">arm.sdf</sdf>',
            fixed='<sdf version="1.12">arm.sdf</sdf>',
            unsafe=True,
            file=CONFIG,
            files={"arm.sdf": ARM},
            says="version 1 is not that of the file",
        ),
        Bad("<«sdf»>arm.sdf</sdf>", file=CONFIG, files={"arm.sdf": ARM}, says="no `version`"),
        Bad('<sdf version="«1.99»">arm.sdf</sdf>', file=CONFIG, files={"arm.sdf": ARM}, says="newer"),
        Bad(
            '<sdf version="1.5">«old.sdf»</sdf><sdf version="1.12">arm.sdf</sdf>',
            file=CONFIG,
            files={"arm.sdf": ARM, "hand.sdf": ARM},
            says="no file `old.sdf`",
        ),
        Bad(
            '<sdf version="«new»">arm.sdf</sdf>',
            file=CONFIG,
            files={"arm.sdf": ARM},
            says="not a version of SDF",
        ),
        Bad('<«sdf» version="1.12"/>', file=CONFIG, says="names no file"),
        Bad("<«model»><name>arm</name></model>", file=CONFIG, scaffold="{}", says="no `sdf`"),
        Bad("<«model»/>", file=CONFIG, scaffold="{}", says="neither"),
        Bad('<«model»><sdf version="1.12">a.sdf</sdf></model>', file=CONFIG, scaffold="{}", says="no `name`"),
        Bad(
            "<include><uri>«arm»</uri></include>",
            scaffold=IN_WORLD,
            files={
                "arm/manifest.xml": '<model><name>arm</name><sdf version="1.12">arm.sdf</sdf></model>',
                "arm/arm.sdf": ARM,
            },
            says="manifest.xml",
        ),
    )
    good = (
        Good(
            '<sdf version="@VERSION@">@NAME@.sdf</sdf>',
            file=CONFIG,
            files={},
            why="a template that a build fills in",
        ),
        Good(
            "<model><name>town</name></model>",
            file=CONFIG,
            scaffold="{}",
            files={"town.world": "<sdf version='1.12'/>"},
            why="the folder of a world",
        ),
        Good(
            "<model><name>parts</name></model>",
            file=CONFIG,
            scaffold="{}",
            files={"meshes/tire.stl": ""},
            why="a folder of meshes for other models",
        ),
        Good(
            '<sdf version="1.5">old.sdf</sdf><sdf version="1.12">arm.sdf</sdf>',
            file=CONFIG,
            files={"arm.sdf": ARM, "old.sdf": ARM.replace("1.12", "1.5")},
        ),
    )

    @staticmethod
    def applies(subject: ModelConfig | Include) -> bool:
        return subject.is_misconfigured

    def check(self, subject: ModelConfig | Include) -> Iterator[Diagnostic]:
        if isinstance(subject, ModelConfig):
            yield from self.misconfigured(subject)
        elif subject.uri_value is not None:
            message = f"`{subject.uri}` has only a manifest.xml, and consumers look for a model.config"
            advice = "rename manifest.xml to model.config, or write one"
            yield self.diagnostic(subject.uri_value, message, help=advice)

    def misconfigured(self, config: ModelConfig) -> Iterator[Diagnostic]:
        crashes = not config.element.has("name") and not NAMING_MODEL.isdisjoint(
            each.fault for each in config.faults
        )
        for place, fault, near in config.faults:
            named = place.text.strip() if isinstance(place, Value) else place.name
            message = MESSAGES[fault].format(named, near)
            if near is not None and fault not in (ConfigFault.UNMADE_FILE, ConfigFault.OTHER_VERSION):
                message += f", did you mean `{near}`?"
            is_fatal = fault is ConfigFault.NO_NAME and crashes
            is_for_others = (
                fault is ConfigFault.MISSING_FILE and getattr(place, "element", None) is not config.chosen
            )
            severity = Severity.WARNING if is_for_others else SEVERITIES.get(fault, Severity.ERROR)
            affects = READ if is_for_others else REACTIONS.get(fault, {})
            is_replaced = fault in (ConfigFault.MISSING_FILE, ConfigFault.OTHER_VERSION)
            fix = write_instead(near, place) if is_replaced else None
            yield self.diagnostic(
                place,
                message,
                fix=fix,
                help=ADVICE.get(fault) if fix is None else None,
                severity=Severity.ERROR if is_fatal else severity,
                affects=dict.fromkeys(READ, refuses("crashes")) if is_fatal else affects,
            )
