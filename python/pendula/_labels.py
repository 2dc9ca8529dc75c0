"""Arguments with labels: DataArrays of xarray and Series of pandas, and the same labels on results."""

from __future__ import annotations

import sys
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from ._words import COLUMNS, attributes

if TYPE_CHECKING:
    from collections.abc import Mapping
    from typing import Any

    import pandas


@dataclass(frozen=True)
class Labels:
    """The labels of the axes of pendulums."""

    dims: tuple[str, ...]
    coords: Mapping[str, Any]
    index: pandas.Index | None
    """Of Series."""

    def put(self, result: Any, function: str, carry: object) -> Any:
        """Results with these labels: DataArrays, or Series, and DataFrames where there are rows or a carried axis."""
        if hasattr(result, "with_labels"):
            return result.with_labels(self)
        fields: Mapping[str, Any] = attributes(function) if function in COLUMNS else attributes()
        is_both = carry == "both"
        if not isinstance(result, tuple):
            return self._one(result, "", fields, is_both)
        names = getattr(result, "_fields", [""] * len(result))
        values = [self._one(value, name, fields, is_both) for name, value in zip(names, result, strict=True)]
        make: Any = getattr(result, "_make", tuple)
        return make(values)

    def _one(self, value: Any, name: str, fields: Mapping[str, Any], is_both: bool) -> Any:
        values = np.asarray(value)
        has_rows = values.ndim - is_both > len(self.dims)
        if self.index is None:
            import xarray

            dims = ("carry",) * is_both + self.dims + ("row",) * has_rows
            coords = {**self.coords, "carry": ["up", "down"]} if is_both else self.coords
            return xarray.DataArray(values, coords, dims, name or None, fields.get(name, {}))
        import pandas

        if not is_both and not has_rows:
            return pandas.Series(values, self.index, name=name or None)
        columns: Any = pandas.RangeIndex(values.shape[-1], name="row")
        if is_both and has_rows:
            columns = pandas.MultiIndex.from_product([["up", "down"], columns], names=["carry", "row"])
        elif is_both:
            columns = pandas.Index(["up", "down"], name="carry")
        flat = np.moveaxis(values, 0, 1) if is_both else values
        return pandas.DataFrame(flat.reshape(len(self.index), -1), self.index, columns)


def labels_of(given: Mapping[str, Any], apart: tuple[str, ...]) -> tuple[Labels | None, dict[str, Any]]:
    """The labels of arguments, and their values as they broadcast; None where there are none."""
    running = {name: value for name, value in given.items() if name not in apart}
    arrays = _instances(running, "xarray", "DataArray")
    series = _instances(running, "pandas", "Series")
    if arrays and series:
        raise TypeError(f"{next(iter(arrays))} is a DataArray and {next(iter(series))} a Series: give all as one of them")
    if not arrays and not series:
        return None, {**given}
    labels, values = _of_arrays(arrays, running) if arrays else _of_series(series, running)
    return labels, {**given, **values}


def _instances(given: Mapping[str, Any], module: str, name: str) -> dict[str, Any]:
    """What is of a class, where its module has been imported."""
    kind = getattr(sys.modules.get(module), name, None)
    return {} if kind is None else {name: value for name, value in given.items() if isinstance(value, kind)}


def _of_arrays(arrays: dict[str, Any], given: dict[str, Any]) -> tuple[Labels, dict[str, Any]]:
    import xarray

    first = next(iter(arrays))
    aligned = xarray.align(*arrays.values(), join="exact", copy=False)
    dims = tuple(dict.fromkeys(str(dim) for array in aligned for dim in array.dims))
    coords: dict[str, Any] = {}
    for array in aligned:
        for name, coord in array.coords.items():
            if name not in coords or coords[str(name)].ndim < coord.ndim:
                coords[str(name)] = coord
    for name, array in zip(arrays, aligned, strict=True):
        ordered = array.transpose(*(dim for dim in dims if dim in array.dims)).values
        given[name] = ordered[tuple(slice(None) if dim in array.dims else np.newaxis for dim in dims)]
    for name, value in given.items():
        if name not in arrays and isinstance(value, (np.ndarray, list, tuple)) and np.ndim(value) > 0:
            raise ValueError(f"the axes of {name} have no names: give it as a DataArray, as {first} is")
    return Labels(dims, coords, None), given


def _of_series(series: dict[str, Any], given: dict[str, Any]) -> tuple[Labels, dict[str, Any]]:
    first = next(iter(series))
    index = series[first].index
    for name, each in series.items():
        if not each.index.equals(index):
            raise ValueError(f"{name} and {first} have different indices")
        given[name] = each.to_numpy()
    for name, value in given.items():
        if isinstance(value, (np.ndarray, list, tuple)) and np.shape(value) not in ((), (1,), index.shape):
            raise ValueError(f"{name} must be one number, or one for each of the {len(index)} of {first}")
    dim = str(index.name or "index")
    return Labels((dim,), {dim: index}, index), given
