from collections.abc import Iterator

from sdfcheck import IN_MODEL, IN_ROBOT, Bad, Consumer, Diagnostic, Good, Plugin, Rule, Severity, warns

NAMELESS_SINCE = "1.10"
OLDER = dict.fromkeys((Consumer.GAZEBO, Consumer.DRAKE), warns("older releases refuse the file"))


class MissingPluginAttribute(Rule):
    """A plugin has no `filename`, or in old versions no `name`.

    Without the name of the library there is nothing to load, and libsdformat stops
    reading the document. A `name` is required up to version 1.9; later consumers do
    without, and only older ones refuse the file.
    """

    code = "RES008"
    name = "missing-plugin-attribute"
    severity = Severity.ERROR
    remedy = """Name the plugin's library in `filename`, such as `gz-sim-diff-drive-system`, and its class in `name`.

    `sdfcheck describe plugin` shows what the format asks for. The library is found without `lib` and `.so`
    by new Gazebo; Classic wants the whole `libgazebo_ros_….so`.
    """
    looks_at = (Plugin,)
    scaffold = IN_MODEL

    bad = (
        Bad('<«plugin» name="p"/>', says="plugin `p` has no `filename`"),
        Bad('<plugin name="p" «filename»=""/>', says="`filename` of plugin `p` is empty"),
        Bad('<gazebo><«plugin» name="p"/></gazebo>', scaffold=IN_ROBOT, says="plugin `p` has no `filename`"),
        Bad(
            '<«plugin» filename="libp.so"/>',
            scaffold=IN_MODEL.replace("1.12", "1.9"),
            says="up to version 1.9",
        ),
    )
    good = (
        Good('<plugin filename="libp.so"/>', why="a plugin needs no name since 1.10"),
        Good(
            '<plugin filename="libp.so" name="p"><plugin/></plugin>', why="the content of a plugin is its own"
        ),
    )

    @staticmethod
    def applies(plugin: Plugin) -> bool:
        return lacks_file(plugin) or lacks_name(plugin)

    def check(self, plugin: Plugin) -> Iterator[Diagnostic]:
        title = plugin.title
        if lacks_file(plugin):
            value = plugin.filename_value
            if value is None:
                cause = plugin.misnamed("filename")
                yield self.diagnostic(plugin, f"{title} has no `filename`", cause=cause)
            else:
                yield self.diagnostic(value.name_span, f"`filename` of {title} is empty")
        if lacks_name(plugin):
            message = f"{title} has no `name`, required up to version 1.9"
            cause = plugin.misnamed("name")
            yield self.diagnostic(plugin, message, severity=Severity.WARNING, affects=OLDER, cause=cause)


def lacks_file(plugin: Plugin) -> bool:
    return not plugin.filename


def lacks_name(plugin: Plugin) -> bool:
    if plugin.name_value is not None or plugin.root.is_urdf:
        return False
    return plugin.root.is_older_than(NAMELESS_SINCE)
