"""Derivatives of microscopes' stacks: sums of their own, differences, and what is refused."""

from __future__ import annotations

import numpy as np
import pytest

import lommel as lm
from lommel.optics import debye

WAVE, PIXEL = 520e-9, 6.5e-6
OIL = lm.Objective(
    NA=1.4,
    magnification=63,
    immersion=1.518,
    working_distance=0.19e-3,
    coverslip=lm.Layer(1.5255, 170e-6),
    sample=1.33,
)
Z, DEPTH, CENTER = np.array([1.0, 1.2, 3.0]) * 1e-6, np.array([0.05, 0.3, 2.0]) * 1e-6, (4.2, 3.7)


def pupil(dz=0.0, dd=0.0, emitter="isotropic"):
    return OIL.pupil(depth=DEPTH + dd, z=Z + dz, wavelength=WAVE, origin="coverslip", emitter=emitter)


def samples(name, of):
    """I of samples around CENTER and its derivative, over the power of each plane, by scipy's Bessel functions."""
    y, x = np.mgrid[0:9, 0:9]
    v = of.pupil_step * np.hypot(y - CENTER[0], x - CENTER[1]).ravel()
    p, model = of.pupil, of.pupil.light.model
    rule = debye.rule(p.layers, model, p.depth, p.focus, float(v.max()), 1e-13)
    turned = rule._replace(parts=tuple(part * 1j * rule.rates[{"depth": 1, "z": 2}[name]] for part in rule.parts))
    F, G = (debye.fields(each, model, p.depth, p.focus, v) for each in (rule, turned))
    shares = p.light.shares
    value = sum(share * np.abs(f) ** 2 for share, f in zip(shares, F, strict=True))
    slope = sum(2.0 * share * (g * f.conj()).real for share, f, g in zip(shares, F, G, strict=True))
    return (each.reshape(-1, 9, 9) for each in (value, slope))


class Asked:
    def __init__(self, emitter):
        self.pupil = pupil(emitter=emitter)
        self.pupil_step = lm.Grid(9, PIXEL).step(self.pupil)


def wrong(made, name, expected):
    off = np.abs(made.derivatives[name] - expected).max(axis=(1, 2))
    return float((off / made.values.max(axis=(1, 2))).max())


@pytest.mark.parametrize("tol", [1e-4, 1e-6, 1e-9])
@pytest.mark.parametrize("emitter", ["isotropic", "scalar"])
@pytest.mark.parametrize("normalize", ["strehl", "emitted"])
def test_derivatives_by_the_stage_and_the_depth_are_sums_over_the_same_angles(normalize, emitter, tol):
    of = Asked(emitter)
    made = lm.psf(
        of.pupil,
        9,
        PIXEL,
        tol=tol,
        center=CENTER,
        integrate=False,
        dtype=np.float64,
        normalize=normalize,
        derivatives=("z", "depth"),
    )
    power = of.pupil.power[:, None, None]
    scale = made.scale[:, None, None] / power
    value, slope = samples("z", of)
    assert made.values == pytest.approx(scale * value, abs=2 * tol * (scale * value).max())
    assert wrong(made, "z", scale * slope) <= made.derivative_bounds["z"] <= 30.0 * tol * 1e8
    value, slope = samples("depth", of)
    rate = debye.power(of.pupil.layers, of.pupil.depth, of.pupil.light.model, slope=True)[0] @ of.pupil.light.shares
    if normalize == "strehl":
        slope = slope - value * rate[:, None, None] / power
    assert wrong(made, "depth", scale * slope) <= made.derivative_bounds["depth"] <= 30.0 * tol * 1e8


@pytest.mark.parametrize("integrate", [False, True])
def test_derivatives_are_what_differences_come_to(integrate):
    options = {"integrate": integrate, "dtype": np.float64, "tol": 1e-9}
    names = ("row", "z", "column", "depth", "row")
    made = lm.psf(pupil(), 9, PIXEL, center=CENTER, derivatives=names, **options)
    assert list(made.derivatives) == ["row", "z", "column", "depth"]

    def difference(at, h):
        return (8.0 * (at(h) - at(-h)) - (at(2.0 * h) - at(-2.0 * h))) / (12.0 * h)

    def moved(dy=0.0, dx=0.0):
        return lm.psf(pupil(), 9, PIXEL, center=(CENTER[0] + dy, CENTER[1] + dx), **options).values

    found = {
        "row": difference(moved, 1e-2),
        "column": difference(lambda h: moved(dx=h), 1e-2),
        "z": difference(lambda h: lm.psf(pupil(dz=h), 9, PIXEL, center=CENTER, **options).values, 2e-9),
        "depth": difference(lambda h: lm.psf(pupil(dd=h), 9, PIXEL, center=CENTER, **options).values, 2e-9),
    }
    for name, expected in found.items():
        size = float((np.abs(expected).max(axis=(1, 2)) / made.values.max(axis=(1, 2))).max())
        assert wrong(made, name, expected) <= 3e-7 * size
        assert made.derivative_bounds[name] <= 3e-7 * size


def test_each_plane_moves_about_its_own_axis_and_single_precision_stores_what_it_says():
    rows, columns = np.array([3.1, 4.4, 5.0]), np.array([4.0, 3.3, 4.9])
    names = ("z", "row", "column")
    made = lm.psf(pupil(), 9, PIXEL, center=(rows, columns), derivatives=names)
    for k in range(3):
        one = lm.psf(
            pupil()[k], 9, PIXEL, center=(rows[k], columns[k]), derivatives=names, tol=1e-9, dtype=np.float64
        )
        for name in names:
            assert made.derivatives[name].dtype == np.float32
            off = np.abs(made.derivatives[name][k] - one.derivatives[name]).max() / one.values.max()
            assert off <= made.derivative_bounds[name] + one.derivative_bounds[name]


def test_light_that_depends_on_the_azimuth_has_derivatives_by_its_axis():
    dipole = pupil(emitter=lm.Dipole(0.6, 0.3))[:1]
    options = {"integrate": False, "dtype": np.float64, "tol": 1e-8, "normalize": "strehl"}
    made = lm.psf(dipole, 9, PIXEL, derivatives=("row",), **options)
    ahead, behind = (lm.psf(dipole, 9, PIXEL, center=(4.0 + h, 4.0), **options).values for h in (1e-3, -1e-3))
    assert wrong(made, "row", (ahead - behind) / 2e-3) <= 1e-5
    with pytest.raises(ValueError, match="radially symmetric"):
        lm.psf(dipole, 9, PIXEL, derivatives=("z",), **options)


def test_what_has_no_derivatives_says_so():
    with pytest.raises(ValueError, match="'z', 'depth', 'row' and 'column', got 'defocus'"):
        lm.psf(pupil(), 9, PIXEL, derivatives=("defocus",))
    with pytest.raises(ValueError, match="use Stratified"):
        lm.psf(pupil(), 9, PIXEL, method=lm.DebyeWolf(), derivatives=("z",))
    with pytest.raises(ValueError, match="'z' are of the pupils of an Objective"):
        lm.psf(lm.Pupil(), 9, 0.3, derivatives=("z",))
    with pytest.raises(ValueError, match="in windows up to"):
        lm.psf(pupil(), 3, PIXEL, center=(400.0, 2.0), derivatives=("depth",))
