"""One paraboloid in three ray tracers: its coma points away from the axis, seen from behind the sensor.

After the mirror, light travels along -z in optiland and ray-optics, and along +z in batoid. From behind the sensor,
with y upwards, x runs to the left where light travels along -z.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

import lommel as lm
from lommel.adapters import batoid, optiland, rayoptics

pytestmark = pytest.mark.filterwarnings("ignore")  # what the ray tracers warn of is not ours
FOCUS, DIAMETER, ANGLE, WAVELENGTH = 0.5, 0.125, math.radians(0.5), 550e-9
Mirror = tuple[Callable[[tuple[int, int]], lm.Pupil], Callable[[tuple[int, int]], tuple[float, float]]]


def of_optiland() -> Mirror:
    lens: Any = pytest.importorskip("optiland.optic").Optic()
    lens.add_surface(index=0, thickness=np.inf)
    lens.add_surface(index=1, radius=-1000.0, conic=-1.0, thickness=-500.0, material="mirror", is_stop=True)
    lens.add_surface(index=2)
    lens.set_aperture("EPD", 1e3 * DIAMETER)
    lens.set_field_type("angle")
    for field in ({"y": 0}, {"y": 0.5}, {"y": 0, "x": 0.5}):
        lens.add_field(**field)
    lens.add_wavelength(1e6 * WAVELENGTH, is_primary=True)

    def seen(field: tuple[int, int]) -> tuple[float, float]:
        chief = lens.trace_generic(*field, 0.0, 0.0, 1e6 * WAVELENGTH)
        assert float(chief.N[0]) < 0.0
        return -1e-3 * float(chief.x[0]), 1e-3 * float(chief.y[0])

    return lambda field: optiland.pupil(lens, field), seen


def of_batoid() -> Mirror:
    library: Any = pytest.importorskip("batoid")
    detector = library.Detector(library.Plane(), name="D", coordSys=library.CoordSys((0.0, 0.0, FOCUS)))
    telescope = library.CompoundOptic(
        [library.Mirror(library.Paraboloid(2.0 * FOCUS), name="M"), detector], name="T", pupilSize=DIAMETER,
        pupilObscuration=0.0, backDist=2.0, sphereRadius=FOCUS, stopSurface=library.Interface(library.Plane()),
    )  # fmt: skip

    def seen(field: tuple[int, int]) -> tuple[float, float]:
        at = {"theta_x": field[0] * ANGLE, "theta_y": field[1] * ANGLE}
        chief = telescope.trace(library.RayVector.fromStop(0.0, 0.0, optic=telescope, wavelength=WAVELENGTH, **at))
        assert chief.vz[0] > 0.0
        return float(chief.x[0]), float(chief.y[0])

    directions = {field: (field[0] * ANGLE, field[1] * ANGLE) for field in ((1, 0), (0, 1))}
    return lambda field: batoid.pupil(telescope, directions[field], wavelength=WAVELENGTH), seen


def of_rayoptics() -> Mirror:
    model: Any = pytest.importorskip("rayoptics.optical.opticalmodel").OpticalModel()
    spec = pytest.importorskip("rayoptics.raytr.opticalspec")
    conic = pytest.importorskip("rayoptics.elem.profiles").Conic
    sequence, system = model["seq_model"], model["optical_spec"]
    system["pupil"] = spec.PupilSpec(system, key=["object", "epd"], value=1e3 * DIAMETER)
    system["fov"] = spec.FieldSpec(system, key=["object", "angle"], value=0.5, flds=[0.0, 1.0], is_relative=True)
    system["wvls"] = spec.WvlSpec([(1e9 * WAVELENGTH, 1.0)], ref_wl=0)
    model.radius_mode = True
    sequence.gaps[0].thi = 1e10
    sequence.add_surface([-1000.0, -500.0, "REFL"])
    sequence.ifcs[sequence.cur_surface].profile = conic(r=-1000.0, cc=-1.0)
    sequence.set_stop()
    model.update_model()

    def seen(field: tuple[int, int]) -> tuple[float, float]:
        rays = pytest.importorskip("rayoptics.raytr.trace")
        one = spec.Field(fov=system["fov"])
        one.xf, one.yf = field
        ray = rays.setup_pupil_coords(model, one, 1e9 * WAVELENGTH, 0.0)[1][0][0][-1]
        assert ray[1][2] < 0.0
        return -1e-3 * float(ray[0][0]), 1e-3 * float(ray[0][1])

    return lambda field: rayoptics.pupil(model, field), seen


@pytest.mark.parametrize("field", [(1, 0), (0, 1)])
@pytest.mark.parametrize("mirror", [of_optiland, of_batoid, of_rayoptics])
def test_the_coma_of_a_paraboloid_points_away_from_the_axis_in_every_ray_tracer(mirror, field, monkeypatch):
    monkeypatch.setattr(rayoptics, "_require_version", lambda installed: None)  # older ones have right images
    pupil, seen = mirror()
    values = lm.psf(pupil(field), 101, 1e-6, tol=1e-4).values
    rows, columns = np.mgrid[:101, :101] - 50.0
    centroid = (values * columns).sum() / values.sum(), -(values * rows).sum() / values.sum()  # y upwards
    x, y = seen(field)
    assert math.hypot(x, y) == pytest.approx(FOCUS * math.tan(ANGLE), rel=1e-3)
    # A third of the tangential coma of third order, 3 angle / (16 N^2), of which the window holds most.
    coma = FOCUS * ANGLE / (16.0 * (FOCUS / DIAMETER) ** 2)
    outward = (centroid[0] * x + centroid[1] * y) / math.hypot(x, y)
    assert outward == pytest.approx(1e6 * coma, rel=0.08)
