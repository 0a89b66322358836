"""Which release this is, and where its home is."""

__version__ = "0.1.0"
FIRST_RELEASE = "0.1.0"

HOME = "https://sdfcheck.example"
"""Where the documentation is published. A placeholder until the project is: every link of reports, packages and
pages starts here or at ``REPOSITORY``, so these two lines are all that changes."""

REPOSITORY = "https://github.example/sdfcheck/sdfcheck"
"""Where the source is published: the same placeholder."""


def rule_page(name: str) -> str:
    """The address of the page about a rule or a kind of loss."""
    return f"{HOME}/latest/rules/{name}/"
