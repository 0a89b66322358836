from __future__ import annotations

from pathlib import Path

from sdfcheck.lint.subjects import Subjects
from sdfcheck.source.document import read


def test_a_document_without_the_needed_texts_is_not_looked_at() -> None:
    subjects = Subjects(("Geometry",), (), ("<mesh", "<plane", "<box "))
    shapes = (("<plane/>", 1), ("<mesh/>", 1), ("<sphere/>", 0), ('<box a=""/>', 1), ("<box/>", 0))
    for shape, number in shapes:
        text = (
            '<sdf version="1.12"><model name="m"><link name="l"><visual name="v"><geometry>'
            f"{shape}</geometry></visual></link></model></sdf>"
        )
        assert len(subjects.of(read(text.encode(), Path("m.sdf")))) == number, shape
