"""Windows that follow a lens: what their numbers of samples, chords and layers rest on, a second time."""

from __future__ import annotations

import math
from types import SimpleNamespace

import numpy as np
import pytest

from lommel.imaging import traced_windows
from lommel.special.chebyshev import chebyshev, chebyshev_nodes

TOL = 1e-3


@pytest.mark.parametrize(("parts", "chosen"), [([9.0] * 6, None), ([1.01, 0.99, 0, 0, 0, 0], 1), ([0.99] * 6, 0)])
def test_windows_take_the_fewest_nodes_that_are_off_by_a_tenth_of_the_tolerance_of_each_peak(
    parts, chosen, monkeypatch
):
    asked, stretch = {}, 550e-9 / 440e-9

    def averaging(width, samples):
        asked.setdefault("samples", []).append((width, samples))
        return 0.1 * TOL / (2.0 * phases + 1.0) * (1.01 if samples < 5 else 0.99)

    def counts(*given):
        asked["chords"] = given
        return 100, 80, None, {}

    exact = np.full((2, 1, 3, 3), 0.5)
    exact[1], exact[:, :, 0], exact[..., 0] = 0.1, 0.01, 0.01  # small windows, and rows and columns within them

    class Windows(traced_windows.AberratedWindows):
        def __call__(self, ns, tables, c, coefficients, scale):
            made, share = exact.copy(), [math.ceil(s * 80) for s in (*traced_windows._SHARES, 1.0)].index(self.nodes)
            assert (c.tolist(), coefficients.tolist()) == ([-3.0, 5.0], [2.0, -0.4])
            off = [*(0.1 * TOL * part for part in parts), 0.0][share]
            made[:, 0, 0, 0] -= off * np.array([0.5, 0.1])
            return made

    monkeypatch.setattr(traced_windows, "averaging_error", averaging)
    monkeypatch.setattr(traced_windows, "counts_by_largest", counts)
    monkeypatch.setattr(traced_windows, "AberratedWindows", Windows)
    fixed, size = SimpleNamespace(terms=((2, 0), (3, 1)), edge=np.array([0.2, -0.7])), {(2, 0): 0.2, (3, 1): 0.7}
    lens = SimpleNamespace(
        wavelength=550e-9, aberrations=fixed, obscuration=0.0, illumination=SimpleNamespace(at=abs)
    )
    spectra = (((440e-9, 0.5), (600e-9, 0.5)),)
    phases = 2.0 + 0.4 + 5.0 + sum(size.values())
    rule, _ = traced_windows.build_windows(lens, {(2, 2): 2.0, (2, 0): 0.4}, (-3.0, 5.0), spectra, (1, 0.3), TOL)
    share = 1.0 if chosen is None else traced_windows._SHARES[chosen]
    assert (rule.samples, rule.chords, rule.nodes) == tuple(math.ceil(share * n) for n in (5, 100, 80))
    assert asked["samples"] == [(pytest.approx(0.3 * stretch), n) for n in (2, 3, 4, 5)]
    names, bounds, most, _, extents, error = asked["chords"]
    expected = {(2, 2): 2.0, (2, 0): 5.4} | {t: s + {(2, 0): 5.4}.get(t, 0.0) for t, s in size.items()}
    assert dict(zip(names, bounds[0], strict=True)) == pytest.approx(expected)
    assert (most, error) == pytest.approx((stretch, TOL / (2.0 * phases + 1.0)))
    assert extents == pytest.approx((math.sqrt(2.0) * 0.3 * stretch * 1.5, 0.3 * stretch * 1.5))


def series(amounts, count=20):
    """Return windows of peak 1, whose other cells are Chebyshev polynomials with these amounts."""
    x, _ = chebyshev_nodes(count)
    basis = chebyshev(x, count)
    return x, np.stack([np.ones(count), *(size * basis[:, n % count] for n, size in amounts.items())], axis=1)[
        :, None
    ]


@pytest.mark.parametrize(("amounts", "degrees"), [
    ({1: 0.1, -3: 0.1, -2: 0.049, -1: 0.15}, 20), ({1: 0.1, -3: 0.1, -2: 0.051, -1: 0.15}, None),
    ({1: 0.3, 3: 0.05, 4: 0.06}, 4), ({1: 0.3, 3: 0.05, 4: 0.04}, 2), ({1: 0.3, 3: 0.05, 4: 0.101}, 5), ({1: 0.0}, 2),
])  # fmt: skip
def test_a_layer_has_the_degrees_from_which_on_coefficients_sum_to_a_tenth_of_the_tolerance(amounts, degrees):
    """It has none where more than a fifth of it is left in the last two."""
    given = {n: size * (1.0 if n == 1 else TOL) for n, size in amounts.items()}
    x, windows = series(given)
    layer = traced_windows._layer(-1.0, 1.0, x, windows, TOL)
    assert (layer and layer.weights.shape[1]) == degrees
