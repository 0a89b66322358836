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
    ConfigFault.BAD_VERSION: "`{}` is not a version of SDFormat",
    ConfigFault.TOO_NEW: "version {} is newer than any consumer knows",
    ConfigFault.MISSING_FILE: "there is no file `{}` beside this one",
    ConfigFault.UNMADE_FILE: "`{}` has yet to be made from `{}`",
}
SEVERITIES = {ConfigFault.NO_NAME: Severity.WARNING, ConfigFault.UNMADE_FILE: Severity.INFO}


class InvalidModelConfig(Rule):
    """A `model.config` does not say which file is the model.

    A model folder is included through it: libsdformat takes the `sdf` element of the
    highest version that it knows. A missing file or version, or a version from the
    future, fails the including document; with neither `name` nor `sdf` libsdformat
    crashes. A missing name alone is a warning. A file that a build is to make from a
    template beside it is only pointed out.
    """

    code = "RES007"
    name = "invalid-model-config"
    severity = Severity.ERROR
    affects = {Consumer.GAZEBO: refuses("refuses the model"), Consumer.DRAKE: refuses("refuses the model")}
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
            says="`arm.sdf` has yet to be made from `arm.sdf.jinja`",
        ),
        Bad("<«sdf»>arm.sdf</sdf>", file=CONFIG, files={"arm.sdf": ARM}, says="no `version`"),
        Bad('<sdf version="«1.99»">arm.sdf</sdf>', file=CONFIG, files={"arm.sdf": ARM}, says="newer"),
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
            '<sdf version="1.5">arm.sdf</sdf><sdf version="1.12">arm.sdf</sdf>',
            file=CONFIG,
            files={"arm.sdf": ARM},
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
            yield self.diagnostic(subject.uri_value, message)

    def misconfigured(self, config: ModelConfig) -> Iterator[Diagnostic]:
        for place, fault, near in config.faults:
            named = place.text.strip() if isinstance(place, Value) else place.name
            message = MESSAGES[fault].format(named, near)
            if near is not None and fault is not ConfigFault.UNMADE_FILE:
                message += f", did you mean `{near}`?"
            affects = dict.fromkeys(self.affects, warns("reads the model, and warns"))
            yield self.diagnostic(
                place,
                message,
                fix=write_instead(near, place) if fault is ConfigFault.MISSING_FILE else None,
                severity=SEVERITIES.get(fault, Severity.ERROR),
                affects=affects if fault is ConfigFault.NO_NAME else {},
            )
