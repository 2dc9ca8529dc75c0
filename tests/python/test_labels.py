"""Labels of xarray and pandas: results have those of the arguments, and the numbers of arrays without."""

# mypy: disable-error-code="attr-defined"
# Type checkers take the results for arrays.

import re

import numpy as np
import pandas
import pendula
import pytest
import xarray
from doubles import same_bits
from pendula import measure

THETA = xarray.DataArray([0.5, 1.0, 2.0], dims="start", coords={"start": ["a", "b", "c"]})
BETA = xarray.DataArray([0.1, 0.3], dims="friction", coords={"friction": [1, 3]})
STEPS = {"transient": 5, "periods": 4}


def test_arrays_broadcast_by_the_names_of_their_axes():
    found = measure.section(THETA, 0.0, beta=BETA, **STEPS)
    assert type(found) is measure.Section
    assert found.theta.dims == ("start", "friction", "row")
    assert found.theta.attrs == {"units": "rad", "long_name": "angle in [-π, π)"}
    one = measure.section(1.0, 0.0, beta=0.3, **STEPS)
    for labelled, plain in zip(found, one, strict=True):
        assert same_bits(labelled.sel(start="b", friction=3), plain)


def test_the_order_of_axes_in_memory_does_not_matter():
    both = THETA + BETA
    assert both.dims == ("start", "friction")
    found = pendula.analyze(THETA, 0.0, alpha=both.transpose())
    assert found.tau.dims == ("start", "friction")
    assert same_bits(found.tau, pendula.analyze(THETA.values[:, None], 0.0, alpha=both.values).tau)
    assert found.regime.dtype == np.int8


def test_a_carried_sweep_has_its_order_as_an_axis():
    torque = xarray.DataArray([0.1, 0.5, 1.2], dims="torque", coords={"torque": [0.1, 0.5, 1.2]})
    found = measure.mean_velocity(0.0, 0.0, beta=0.2, torque=torque, carry="both")
    assert found.mean_velocity.dims == ("carry", "torque")
    down = measure.mean_velocity(0.0, 0.0, beta=0.2, torque=torque.values, carry="down")
    assert same_bits(found.mean_velocity.sel(carry="down"), down.mean_velocity)
    meanings = found.kind.attrs["flag_meanings"].split()
    assert meanings[int(found.kind.sel(carry="up", torque=0.1))] == "fixed_point"
    jumps = measure.jumps(0.0, 0.0, beta=0.2, torque=torque, jump_tolerance=1e-3)
    assert jumps.value.dims == ("torque",)


def test_every_public_function_takes_labels():
    t = xarray.DataArray([0.0, 1.0], dims="t")
    theta, omega = pendula.exact(THETA, 0.0, t)
    assert theta.dims == omega.dims == ("start", "t")
    assert pendula.to_radians(THETA).dims == ("start",)
    data = pendula.solve(THETA, 0.0, beta=BETA, t=t).to_xarray()
    assert data.theta.dims == ("start", "friction", "t")
    assert data.sel(start="b", friction=3).theta.equals(data.theta[1, 1])
    assert same_bits(data.beta, BETA)
    crossings = pendula.crossings(THETA, 0.0, until=5.0)
    assert crossings.t.dims == ("start", "row")
    assert pendula.measured_period(THETA, 0.0, until=50.0).dims == ("start",)
    assert pendula.amplitude(7 + THETA).dims == ("start",)
    alpha = pendula.analyze(0.5, 0.0, gravity=THETA, length=2.0)
    assert same_bits(alpha.tau, pendula.analyze(0.5, 0.0, alpha=THETA.values / 2).tau)


def test_series_give_series_and_tables():
    theta0 = pandas.Series([0.5, 1.0], index=["p", "q"], name="theta0")
    found = measure.mean_velocity(theta0, 0.0, beta=np.array([0.1, 0.2]), **STEPS)
    plain = measure.mean_velocity(theta0.values, 0.0, beta=np.array([0.1, 0.2]), **STEPS)
    assert list(found.error.index) == ["p", "q"]
    assert found.error.name == "error"
    assert same_bits(found.theta, plain.theta)
    section = measure.section(theta0, 0.0, carry="both", **STEPS).theta
    assert section.shape == (2, 8)
    assert same_bits(section.loc["q", "down"], measure.section(theta0.values, 0.0, carry="down", **STEPS).theta[1])
    assert list(measure.mean_velocity(theta0, 0.0, beta=0.1, carry="both", **STEPS).error) == ["up", "down"]
    assert pendula.analyze(theta0, 0.0).tau.index.equals(theta0.index)
    assert pendula.solve(theta0, 0.0, t=[0.0, 1.0]).to_xarray().theta.dims == ("index", "t")


SERIES = pandas.Series([1.0, 2.0])
REFUSED = {
    "an array among DataArrays": (
        (THETA, [1.0, 2.0, 3.0]),
        ValueError,
        "the axes of omega0 have no names: give it as a DataArray, as theta0 is",
    ),
    "other coordinates": ((THETA, THETA[::2]), ValueError, "cannot align objects with join='exact'"),
    "both kinds": ((THETA, SERIES), TypeError, "theta0 is a DataArray and omega0 a Series: give all as one of them"),
    "another index": ((SERIES, SERIES[::-1]), ValueError, "omega0 and theta0 have different indices"),
    "another length": ((SERIES, [1.0, 2.0, 3.0]), ValueError, "omega0 must be one number, or one for each of the 2 of theta0"),
    "text": ((xarray.DataArray(["x"]), 0.0), TypeError, "theta0 must be real numbers, got <U1 ['x']"),
}


@pytest.mark.parametrize(("start", "kind", "message"), REFUSED.values(), ids=REFUSED.keys())
def test_labels_that_do_not_fit_are_refused(start, kind, message):
    for call in (pendula.analyze, measure.section, pendula.solve):
        with pytest.raises(kind, match=f"^{re.escape(message)}"):
            call(*start)
