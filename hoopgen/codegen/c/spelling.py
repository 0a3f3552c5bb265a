"""C's spelling of operations on lanes, and of expressions that consist of them."""

from __future__ import annotations

from hoopgen.derive.ir.kernel import Kind

from ..formatter import ONE_SHOT, Spelling
from ..statements import (
    Apply,
    Column,
    Execute,
    Expression,
    Infix,
    Item,
    Name,
    Number,
    Operate,
    Statement,
)

LANES = Spelling(
    operations={
        "add": "lanes_add({0}, {1})",
        "sub": "lanes_sub({0}, {1})",
        "mul": "lanes_mul({0}, {1})",
        "div": "lanes_div({0}, {1})",
        "neg": "lanes_neg({0})",
        "sqrt": "lanes_sqrt({0})",
        "abs": "lanes_abs({0})",
        "max": "lanes_max({0}, {1})",
        "min": "lanes_min({0}, {1})",
        "less": "lanes_less({0}, {1})",
        "at_most": "lanes_at_most({0}, {1})",
        "equal": "lanes_equal({0}, {1})",
        "both": "lanes_both({0}, {1})",
        "either": "lanes_either({0}, {1})",
        "not": "lanes_not({0})",
        "nowhere": "mask_none()",
        "select": "lanes_select({0}, {1}, {2})",
    },
    constant="K({0})",
    infinity="K(INFINITY)",
    number="V",
    truth="M",
)

SINGLES = Spelling(
    operations={k: text.replace("lanes_", "singles_") for k, text in LANES.operations.items()}
    | {"nowhere": "singles_mask_none()"},
    constant="KS({0})",
    infinity="KS(INFINITY)",
    number="S",
    truth="Q",
    truth_output="singles_truth",
)

SCALARS = Spelling(
    operations=ONE_SHOT | {"sqrt": "sqrt({0})", "abs": "fabs({0})", "nowhere": "0"},
    infinity="(INFINITY)",
    number="double",
    truth="_Bool",
)
"""C's spelling of operations on one number of each argument."""

TYPES: dict[Kind, str] = {"double": "V", "single": "S", "truth": "M"}
"""The type of a variable in C."""

ZERO, ONE = Number(0.0), Number(1.0)


def both(one: Expression, other: Expression) -> Operate:
    """Return the lanes that two masks have in common.

    Parameters
    ----------
    one, other
        Masks.
    """
    return Operate("both", (one, other))


def complement(mask: Expression) -> Operate:
    """Return the lanes that a mask has not."""
    return Operate("not", (mask,))


def less(one: Expression, other: Expression) -> Operate:
    """Return the lanes in which one value is less than another.

    Parameters
    ----------
    one, other
        Lanes of doubles; a NaN is in no lane less.
    """
    return Operate("less", (one, other))


def select(mask: Expression, then: Expression, other: Expression) -> Operate:
    """Return one value in the lanes of a mask, and another elsewhere.

    Parameters
    ----------
    mask
        The lanes that take the first value.
    then, other
        Lanes of doubles.
    """
    return Operate("select", (mask, then, other))


def any_lane(mask: Expression) -> Apply:
    """Return whether a mask has any lane."""
    return Apply("lanes_any", (mask,))


def usual_lane(mask: Expression) -> Apply:
    """Return whether a mask has any lane, or true without a test if it mostly has one."""
    return Apply("LANES_USUAL", (mask,))


def seldom(asked: str) -> Apply:
    """Return whether something holds that mostly does not."""
    return Apply("LANES_SELDOM", (Name(asked),))


def offset(array: Expression, index: Expression) -> Infix:
    """Return an array from an index on.

    Parameters
    ----------
    array
        A pointer to doubles or singles.
    index
        The number of elements to skip.
    """
    return Infix("+", array, index)


def is_parameter(name: str) -> bool:
    """Return whether a variable is a parameter of the scene, not one of derive/."""
    return name.startswith("p_")


def column_of(prefix: str, name: str) -> str:
    """Return the name of the column of a variable in the list of a prefix.

    Parameters
    ----------
    prefix
        The text before the fields of the list, such as ``worklist->``.
    name
        The name of the variable, or of a parameter.

    Returns
    -------
    str
        An expression of C, which is an array.
    """
    return f"{prefix}parameters.{name}" if is_parameter(name) else f"{prefix}{name}"


def numbered_column(prefix: str, number: Expression) -> Expression:
    """Return the column of a parameter in the list of a prefix, by the parameter's number.

    Parameters
    ----------
    prefix
        As for `column_of`.
    number
        The number of the parameter in calling order.
    """
    return Item(Column(f"{prefix}parameters.columns"), number)


def at(column: str, index: str) -> Infix:
    """Return a column from an index on.

    Parameters
    ----------
    column
        The expression of the column, as `column_of` gives it.
    index
        The name of the variable that holds the index.
    """
    return offset(Column(column), Name(index))


def function(name: str) -> str:
    """Return the name that a function has for this width."""
    return f"LANES({name})"


_PREFIX: dict[Kind, str] = {"double": "lanes", "single": "singles", "truth": "lanes"}


def _stored(kind: Kind, value: Expression) -> Expression:
    """Return a value as columns hold it: a truth is a number that is not zero."""
    return select(value, ONE, ZERO) if kind == "truth" else value


def _loaded(kind: Kind, value: Expression) -> Expression:
    return less(ZERO, value) if kind == "truth" else value


def load(kind: Kind, place: Expression) -> Expression:
    """Return the lanes of a column from a place on.

    Parameters
    ----------
    kind
        The kind of the variable: "double", "single" or "truth", which is stored as a double.
    place
        The address of the first lane.
    """
    return _loaded(kind, Apply(f"{_PREFIX[kind]}_load", (place,)))


def expand(kind: Kind, place: Expression, mask: Expression, old: Expression) -> Expression:
    """Return old values, the lanes of a mask from a place of a column on.

    Parameters
    ----------
    kind
        As for `load`.
    place
        The address of the first element; the elements are taken without gaps.
    mask
        The lanes that take one.
    old
        The value of the other lanes.
    """
    given = (place, mask, _stored(kind, old))
    return _loaded(kind, Apply(f"{_PREFIX[kind]}_expand", given))


def store(kind: Kind, place: Expression, value: Expression) -> Statement:
    """Store lanes in a column from a place on.

    Parameters
    ----------
    kind
        As for `load`.
    place
        The address of the first lane.
    value
        The lanes.
    """
    return Execute(Apply(f"{_PREFIX[kind]}_store", (place, _stored(kind, value))))


def pack(kind: Kind, place: Expression, mask: Expression, value: Expression) -> Statement:
    """Store the lanes of a mask one behind the other, from a place of a column on.

    Parameters
    ----------
    kind
        As for `load`.
    place
        The address of the first element; a whole vector from there on may be written.
    mask
        The lanes that are stored.
    value
        The lanes.
    """
    return Execute(Apply(f"{_PREFIX[kind]}_pack", (place, mask, _stored(kind, value))))


def zeros(kind: Kind, place: Expression) -> Statement:
    """Store zeros in a column from a place on.

    Parameters
    ----------
    kind
        As for `load`.
    place
        The address of the first lane.
    """
    single = kind == "single"
    return Execute(Apply(f"{_PREFIX[kind]}_store", (place, Number(0.0, single))))


def nothing(kind: Kind) -> Expression:
    """Return a value that no lane needs."""
    return Operate("nowhere") if kind == "truth" else Number(0.0, kind == "single")


def choose(kind: Kind, mask: Expression, then: Expression, other: Expression) -> Expression:
    """Return the value of a variable that takes a new value in some lanes.

    Parameters
    ----------
    kind
        As for `load`.
    mask
        The lanes that take the new value.
    then, other
        The new value and the old one, of that kind.
    """
    if kind == "truth":
        return Apply("lanes_choose", (mask, then, other))
    own = Apply("singles_of", (mask,)) if kind == "single" else mask
    return Operate("select", (own, then, other), kind == "single")


def parameter_of_row(number: Expression) -> Expression:
    """Return the lanes of a parameter in the row at hand, by its number in the array `p`."""
    return load("double", offset(Item(Name("p"), number), Name("row")))
