"""A Cooke triplet of ray-optics: rays, focus and PSF agree with the pupils made of it."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

import lommel as lm
from lommel.adapters import ray_tracing
from lommel.adapters import rayoptics as adapter

# What ray-optics and what it imports warn of is not ours.
pytestmark = pytest.mark.filterwarnings("ignore")

WAVELENGTH = 587.5618e-9
SURFACES = [
    [23.713, 4.831, "N-LAK9", "Schott"],
    [7331.288, 5.86],
    [-24.456, 0.975, "N-SF5", "Schott"],
    [21.896, 4.822],
    [86.759, 3.127, "N-LAK9", "Schott"],
    [-20.4942, 41.2365],
]


@pytest.fixture(scope="module")
def triplet() -> Any:
    """f/4, 20 degrees of field, millimetres."""
    return made_with(("object", "angle"), 20.0)


def made_with(key: tuple[str, str], edge: float, distance: float = 1e10) -> Any:
    """A triplet with a field of this kind up to an edge, and an object at a distance."""
    module = pytest.importorskip("rayoptics.optical.opticalmodel")
    try:
        adapter.pupil(module.OpticalModel())
    except ImportError as old:
        pytest.skip(str(old))
    except Exception:  # of an empty model
        pass
    model = module.OpticalModel()
    spec = pytest.importorskip("rayoptics.raytr.opticalspec")
    lens, optics = model["seq_model"], model["optical_spec"]
    optics["pupil"] = spec.PupilSpec(optics, key=["object", "epd"], value=12.5)
    optics["fov"] = spec.FieldSpec(optics, key=list(key), value=edge, flds=[0.0, 1.0], is_relative=True)
    optics["wvls"] = spec.WvlSpec([(1e9 * WAVELENGTH, 1.0)], ref_wl=0)
    model.radius_mode = True
    lens.gaps[0].thi = distance
    for surface in SURFACES:
        lens.add_surface(surface)
        if len(lens.ifcs) == 6:
            lens.set_stop()
    if distance < 1e10:
        lens.gaps[-1].thi = 46.5
    model.update_model()
    return model


@pytest.mark.parametrize(
    ("key", "edge", "distance"),
    [
        (("image", "height"), 15.0, 1e10),
        (("image", "real height"), 15.0, 1e10),
        (("object", "height"), 150.0, 500.0),
        (("object", "angle"), 15.0, 500.0),
        (("image", "height"), 15.0, 500.0),
    ],
)
def test_phases_agree_with_the_rays_in_every_kind_of_field(key, edge, distance):
    made = adapter.pupil(made_with(key, edge, distance), (0.4, 0.5), apertures=False, tol=0.2)
    assert 4.0 < made.f_number < 4.6


def test_phases_that_are_tilted_against_the_rays_are_refused(triplet, monkeypatch):
    exact = ray_tracing.TracedField
    monkeypatch.setattr(ray_tracing, "TracedField", lambda x, y, phase, *rest: exact(x, y, phase + 9.0 * y, *rest))
    with pytest.raises(ValueError, match=r"phases that agree with its rays; .* differ by a tilt of 9"):
        pupil(triplet, (0.0, 0.7))


def pupil(model: Any, field: tuple[float, float] = (0.0, 0.0)) -> lm.Pupil:
    return adapter.pupil(model, field, apertures=False, circular=True)


def rays(model: Any, field: tuple[float, float], x: np.ndarray, y: np.ndarray) -> np.ndarray:
    """Where rays meet the sensor, from the chief ray: (2, n), metres, y upwards."""
    from rayoptics.raytr import trace
    from rayoptics.raytr.opticalspec import Field

    at = Field(fov=model["optical_spec"]["fov"])
    at.xf, at.yf = field
    trace.setup_pupil_coords(model, at, 1e9 * WAVELENGTH, 0.0)
    found = []
    for point in [(0.0, 0.0), *zip(x, y, strict=True)]:
        package, _ = trace.trace_safe(
            model, np.array(point), at, 1e9 * WAVELENGTH, None, None, apply_vignetting=False, check_apertures=False
        )
        found.append(1e-3 * package[0][-1][0][:2])
    return (np.array(found[1:]) - found[0]).T


def slope(made: lm.Pupil, x: np.ndarray, y: np.ndarray) -> np.ndarray:
    """Where rays through the pupil meet the sensor: the gradient of the phase, (2, n), metres."""
    h = 1e-5

    def phase(dx: float, dy: float) -> np.ndarray:
        return made.wavefront.phase(np.hypot(x + dx, y + dy), np.arctan2(y + dy, x + dx))

    return np.stack([phase(h, 0) - phase(-h, 0), phase(0, h) - phase(0, -h)]) * made.scale / math.pi / (2.0 * h)


@pytest.mark.parametrize(("field", "within"), [((0.0, 0.0), 0.005), ((0.0, 0.7), 0.07), ((0.4, 0.5), 0.07)])
def test_rays_meet_the_sensor_at_the_gradient_of_the_phase(triplet, field, within):
    angle = np.linspace(0.0, 6.0, 12)
    for radius in (0.3, 0.9):
        x, y = radius * np.cos(angle), radius * np.sin(angle)
        across, up = rays(triplet, field, x, y)
        found = slope(pupil(triplet, field), x, -y)
        # Off the axis the two directions have f-numbers of their own.
        np.testing.assert_allclose(found, [across, -up], atol=within * np.hypot(across, up).max())


@pytest.mark.parametrize(("field", "across", "along"), [((0.0, 1.0), 1.0, None), ((1.0, 0.0), None, 1.0)])
def test_the_pupil_off_the_axis_is_narrower_along_the_field(triplet, field, across, along):
    made = adapter.pupil(triplet, field, apertures=False)
    ratio = made.vignetting.b
    assert 0.85 < ratio < 0.95
    ax, ay = across or ratio, along or ratio
    angle = np.linspace(0.0, 6.0, 12)
    x, y = 0.9 * np.cos(angle), 0.9 * np.sin(angle)
    traced = rays(triplet, field, x, y)
    found, of_circle = (
        slope(one, a * x, -b * y) for one, a, b in ((made, ax, ay), (pupil(triplet, field), 1.0, 1.0))
    )
    errors = [np.abs(part - traced * [[1.0], [-1.0]]).max() / np.hypot(*traced).max() for part in (found, of_circle)]
    assert errors[0] < 0.02
    assert errors[1] > 0.04


def test_a_sensor_farther_from_the_lens_has_a_lower_defocus(triplet):
    before = pupil(triplet)
    focus = triplet["optical_spec"]["focus"]
    focus.focus_shift = 0.05
    try:
        after = pupil(triplet)
    finally:
        focus.focus_shift = 0.0
    by_hand = -math.pi * 50e-6 / (8 * WAVELENGTH * before.f_number**2)
    change = float(after.wavefront.edge_terms()[2, 0] - before.wavefront.edge_terms()[2, 0])
    assert change == pytest.approx(by_hand, rel=0.03)


def test_the_opd_on_a_grid_is_theirs(triplet):
    grid = pytest.importorskip("rayoptics.raytr.analyses").RayGrid(triplet, f=1, num_rays=17, clip_rays=False)
    x, y, opd = grid.grid
    inside = np.hypot(x, y) < 1.0
    ours = pupil(triplet, (0.0, 1.0)).wavefront.phase(np.hypot(x, y), np.arctan2(-y, x))
    rest = (ours + 2.0 * math.pi * opd)[inside & np.isfinite(opd)]
    assert rest.size > 150
    # But for piston.
    assert np.abs(rest - rest.mean()).max() < 0.05


def test_the_psf_is_theirs_turned_as_the_adapter_says(triplet):
    from rayoptics.raytr import analyses
    from rayoptics.raytr.opticalspec import Field

    at = Field(fov=triplet["optical_spec"]["fov"])
    at.xf, at.yf = 0.5, 0.4
    count, side = 128, 1024
    x, y, opd = analyses.RayGrid(triplet, f=at, num_rays=count, clip_rays=False).grid
    theirs = analyses.calc_psf(np.where(np.hypot(x, y) <= 1.0, opd, np.nan), count, side)
    made = pupil(triplet, (0.5, 0.4))
    # A transform of samples dx apart in the pupil has samples 2 / (side dx) lambda N apart in the image.
    pitch = made.scale * 2.0 / (side * (x[1, 0] - x[0, 0]))
    ours = lm.psf(made, 65, pitch, method=lm.paper.Fraunhofer(samples=512, edge="grey"), normalize="peak").values
    # Its first index is x. Its sign turns the image by half a turn, which together with y upwards mirrors x.
    window = theirs[side // 2 - 32 : side // 2 + 33, side // 2 - 32 : side // 2 + 33].T
    assert np.abs(ours - window[:, ::-1]).max() < 0.01
    assert all(np.abs(ours - other).max() > 0.1 for other in (window, window[::-1], window[::-1, ::-1]))


def test_the_map_is_exact_where_it_was_traced_and_close_in_between(triplet):
    field = adapter.field_map(triplet, heights=9, apertures=False)
    assert field.pupil_without_wavefront.f_number == pytest.approx(4.0, abs=0.01)
    assert field.pupil_without_wavefront.wavelength == pytest.approx(WAVELENGTH)
    reach = field.reach
    assert reach == pytest.approx(50e-3 * math.tan(math.radians(20.0)), rel=0.02)
    edge = field.pupil(0.0, -reach).wavefront - pupil(triplet, (0.0, 1.0)).wavefront
    assert all(abs(float(c)) < 1e-6 for c in edge.edge_terms().values())
    right = field.pupil(reach, 0.0).wavefront - pupil(triplet, (1.0, 0.0)).wavefront
    assert all(abs(float(c)) < 0.05 for c in right.edge_terms().values())


def test_rays_that_miss_an_aperture_are_an_error(triplet):
    with pytest.raises(ValueError, match=r"rays do not reach the image; vignetting"):
        adapter.pupil(triplet, (0.0, 1.0))


def test_what_is_no_lens_is_refused(triplet):
    with pytest.raises(TypeError, match="model must be a ray-optics OpticalModel, got 5"):
        adapter.pupil(5)
    with pytest.raises(TypeError, match="apertures must be True or False, got 1"):
        adapter.pupil(triplet, apertures=1)
    with pytest.raises(ValueError, match=r"wavelength is in metres .* for 550 nm give 550e-9"):
        adapter.pupil(triplet, wavelength=550)


def test_versions_with_a_wrong_sign_are_refused():
    adapter._require_version("0.9.10")
    adapter._require_version("1.0.dev3+g12")
    with pytest.raises(ImportError, match=r"needs ray-optics 0\.9\.10 or newer, which needs Python 3\.12, got"):
        adapter._require_version("0.9.8")
