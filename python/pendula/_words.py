"""What the core's tables say of arguments and of results, in words. The docs, the signatures and the types are made from it."""

from __future__ import annotations

from typing import NamedTuple

from . import _core

INTERVALS = {
    _core.Rule.finite: "finite",
    _core.Rule.positive: "positive",
    _core.Rule.not_negative: "not negative",
    _core.Rule.fraction: "between 0 and 1",
}


class Argument(NamedTuple):
    """An argument by name, as it is documented."""

    name: str
    annotation: str
    default: object
    meaning: str

    @property
    def line(self) -> str:
        """The argument in a line of a docstring."""
        if self.default is None:
            return self.meaning
        default = f"{self.default:g}" if isinstance(self.default, float) else str(self.default)
        return f"{self.meaning}; {default} if left out"


def _with_unit(meaning: str, unit: str) -> str:
    return meaning if unit == "1" else f"{meaning} [{unit}]"


def _parameter(each: _core.Parameter) -> Argument:
    meaning = f"{each.symbol}, {_with_unit(each.meaning, each.unit)}, {INTERVALS[each.interval]}"
    return Argument(each.name, "npt.ArrayLike", None if each.is_initial else each.default, meaning)


def _setting(each: _core.Setting) -> Argument:
    is_whole = each.unit == "1" and each.default.is_integer()
    default = int(each.default) if is_whole else each.default
    return Argument(each.name, "int" if is_whole else "float", default, _with_unit(each.meaning, each.unit))


def _choice(name: str, annotation: str, names: tuple[str, ...], meaning: str) -> Argument:
    return Argument(name, annotation, names[0], f"{meaning}, {' or '.join(names)}")


THREADS = Argument("threads", "int | None", None, "at most so many, from 1 to 256; as many as there are processors if left out")
CARRY = Argument(
    "carry",
    "Carry | None",
    None,
    "along the last axis each starts from where its neighbour ended, up or down; both, along a new first axis",
)
INITIAL = tuple(_parameter(each) for each in _core.parameters if each.is_initial)
STIFFNESS = (
    *(_parameter(each) for each in _core.parameters if each.name == "alpha"),
    Argument("gravity", "npt.ArrayLike", None, "g, acceleration of gravity [m/s²], positive; with length, in place of alpha"),
    Argument("length", "npt.ArrayLike", None, "l, length of the pendulum [m], positive; alpha is gravity/length"),
)
PENDULUM = STIFFNESS + tuple(_parameter(each) for each in _core.parameters if not each.is_initial and each.name != "alpha")
MEASURES = {each.name: each for each in _core.measures}
COLUMNS = {each.name: each.columns for each in _core.measures} | {"jumps": _core.jump_columns}
CARRIES = (*_core.carry_names, "both")
DRIVEN = "A driven pendulum, of which either amplitude is not 0, needs a positive drive_frequency."


def settings_of(measure: str) -> tuple[Argument, ...]:
    """What a measure takes besides the parameters."""
    settings = [_setting(each) for each in MEASURES[measure].settings]
    settings.append(_choice("method", "StrobeMethod", _core.strobe_method_names, "of integration"))
    if measure == "section":
        settings.append(
            _choice(
                "plane",
                "Plane",
                _core.plane_names,
                "of the section, at `level`",
            )
        )
        settings.append(_choice("direction", "Direction", _core.direction_names, "of the crossings"))
    if measure != "orbit":
        settings.append(CARRY)
    return (*settings, THREADS)


JUMP_SETTINGS = tuple(each for each in settings_of("attractors") if each is not CARRY)


def attributes(function: str = "section") -> dict[str, dict[str, object]]:
    """The units and the names in words of all quantities, as xarray has them."""
    as_ascii = str.maketrans("⁻⁰¹²³", "-0123")
    rows = [("t", "s", "time"), ("dt", "s", "longest step"), ("energy", "s⁻²", "energy per m l²")]
    rows += [(each.name, each.unit, each.meaning) for each in _core.parameters]
    rows += [(each.name, each.unit, each.meaning) for each in COLUMNS[function]]
    found: dict[str, dict[str, object]] = {
        name: {"units": unit.translate(as_ascii), "long_name": meaning} for name, unit, meaning in rows
    }
    for each in COLUMNS[function]:
        if each.is_kind:
            found[each.name] |= {"flag_values": [int(k) for k in _core.Kind], "flag_meanings": " ".join(_core.Kind.__members__)}
    return found
