"""Records and tuples behave like dataclasses and ``typing.NamedTuple``."""

from __future__ import annotations

import pickle

import pytest

from sdfcheck.source.record import NamedTuple, Record


class Size(Record):
    """Two fields, one with a default."""

    width: int
    height: int = 1


class Place(NamedTuple):
    """A tuple with a default, a method and a property."""

    line: int
    column: int = 1

    @property
    def next(self) -> Place:
        return self._replace(line=self.line + 1)


class Named(Place):
    """A subclass may hold more."""

    name = "n"


def test_a_record_is_frozen_and_equal_by_value() -> None:
    assert Size(2) == Size(width=2, height=1)
    assert Size(2) != Size(3)
    assert len({Size(2), Size(2), Size(3)}) == 2
    with pytest.raises(AttributeError, match="Size is frozen"):
        Size(2).width = 3  # type: ignore[misc]
    with pytest.raises(TypeError, match="Size takes width, height"):
        Size(1, 2, 3)  # type: ignore[call-arg]
    with pytest.raises(TypeError, match="Size takes width, height"):
        Size(1, width=2)  # type: ignore[misc]


@pytest.mark.parametrize(
    "made", [Place(3, 1), Place(3), Place(line=3), Place(3, column=1), Place(column=1, line=3)]
)
def test_a_tuple_takes_its_fields_in_order_by_name_or_by_default(made: Place) -> None:
    assert made == (3, 1)
    assert (made.line, made.column) == tuple(made)
    assert repr(made) == "Place(line=3, column=1)"
    assert made._asdict() == {"line": 3, "column": 1}
    assert made.next == Place(4, 1)


def test_a_tuple_keeps_its_type() -> None:
    made = Named(2, 3)
    assert type(made._replace(line=1)) is Named
    assert type(pickle.loads(pickle.dumps(made))) is Named
    assert Place._make([1, 2]) == (1, 2)
    match made:
        case Place(line, column):
            assert (line, column) == (2, 3)


@pytest.mark.parametrize(
    ("values", "named", "says"),
    [
        ((), {}, "takes line, column"),
        ((1, 2, 3), {}, "takes line, column"),
        ((1,), {"line": 1}, "takes line, column"),
        ((1,), {"row": 1}, "takes line, column"),
    ],
)
def test_a_tuple_complains_of_other_fields(values: tuple[int, ...], named: dict[str, int], says: str) -> None:
    with pytest.raises(TypeError, match=says):
        Place(*values, **named)
    with pytest.raises(TypeError, match="has no row"):
        Place(1)._replace(row=2)  # type: ignore[call-arg]
