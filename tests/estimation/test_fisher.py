"""What images can tell: closed forms, properties that hold whatever the lens, and the scatter of fits."""

from __future__ import annotations

import math
import runpy
from pathlib import Path

import numpy as np
import pytest

import lommel as lm
from lommel.estimation.fisher import Information
from objectives import OIL

LENS = lm.Lens(focal_length=50e-3, f_number=2.8, focus_distance=2.0, wavelength=550e-9)
CAMERA = {"shape": 15, "pixel": 3.45e-6, "photons": 1e4, "background": 5.0, "noise": lm.Noise(read=2.0)}
COMA = lm.Pupil(lm.Wavefront(1.2, 0.4, nonradial={(3, 1): 0.7, (2, -2): 0.5}), wavelength=550e-9, f_number=4.0)


def errors(information: Information) -> np.ndarray:
    return np.stack(list(information.errors.values()))


@pytest.mark.parametrize(("window", "over"), [(16, 1.0235), (32, 1.0115), (64, 1.0057)])
def test_a_star_is_placed_to_lambda_n_over_pi_and_the_root_of_its_photons(window, over):
    # Ober et al. 2004 over all the plane; a window lacks what its outside would tell.
    photons, fine = 1e4, 8
    found = lm.fisher(lm.Pupil(), fine * window + 1, 1 / fine, of=("row", "column"), photons=photons, tol=1e-9)
    assert errors(found) / fine * math.pi * math.sqrt(photons) == pytest.approx(over, abs=1e-4)
    assert found.correlation[0, 1] == pytest.approx(0.0, abs=1e-9)


def test_in_focus_defocus_is_infinite_and_named_and_never_zero():
    found = lm.fisher(LENS.pupil(), of=("defocus", "row", "column", "photons"), **CAMERA)
    assert found.unidentifiable == ("defocus",)
    assert found.errors["defocus"] == math.inf
    alone = lm.fisher(LENS.pupil(), of=("defocus",), **CAMERA)
    assert alone.unidentifiable == ("defocus",)
    rest = lm.fisher(LENS.pupil(), of=("row", "column", "photons"), **CAMERA)
    assert errors(found)[1:] == pytest.approx(errors(rest), rel=1e-9)
    depth = lm.fisher(LENS.pupil([1.9, 2.0, 2.1]), of=("object_distance",), **CAMERA).errors["object_distance"]
    assert np.isinf(depth).tolist() == [False, True, False]


def test_in_focus_no_even_term_can_be_known_and_every_odd_one_can():
    terms = ((2, 2), (2, -2), (3, 1), (3, -1), (3, 3), (4, 0), (4, 2))
    found = lm.fisher(lm.Pupil(), 15, 0.4, of=terms, photons=1e4, background=1.0)
    assert found.unidentifiable == tuple(term for term in terms if term[0] % 2 == 0)


def test_one_parameter_by_two_names_is_known_by_neither():
    pairs = [("defocus", (2, 0)), ("row", (1, -1)), ("column", "noll 2")]
    for pair in pairs:
        found = lm.fisher(COMA, 15, 2e-6, of=(*pair, (3, -1)), photons=1e4, background=1.0)
        assert found.unidentifiable == pair
        assert abs(found.correlation[0, 1]) == pytest.approx(1.0, abs=1e-6)
        alone = lm.fisher(COMA, 15, 2e-6, of=(pair[0], (3, -1)), photons=1e4, background=1.0)
        assert found.errors[3, -1] == pytest.approx(alone.errors[3, -1], rel=1e-6)


def test_wavelength_and_f_number_are_told_apart_by_aberrations_in_metres_only():
    question = {"of": ("wavelength", "f_number"), "photons": 1e5, "background": 1.0}
    without = lm.Pupil(wavelength=550e-9, f_number=4.0)
    found = lm.fisher(without, 15, 1.5e-6, **question)
    assert found.unidentifiable == ("wavelength", "f_number")
    assert found.correlation[0, 1] == pytest.approx(-1.0, abs=1e-6)
    assert lm.fisher(COMA, 15, 1.5e-6, **question).unidentifiable == ()
    one = lm.fisher(without, 15, 1.5e-6, **(question | {"of": ("f_number",)}))
    other = lm.fisher(without, 15, 1.5e-6, **(question | {"of": ("wavelength",)}))
    # What is known is their product.
    assert one.errors["f_number"] / 4.0 == pytest.approx(other.errors["wavelength"] / 550e-9, rel=1e-6)


def test_the_matrix_is_the_sum_over_pixels_of_products_of_derivatives_over_variances():
    names = ("defocus", (3, 1), "row")
    read = np.random.default_rng(3).uniform(0.5, 4.0, (9, 11))
    answer = lm.psf(COMA, (9, 11), 2e-6, derivatives=names, tol=1e-9, dtype=np.float64)
    slopes = [300.0 * answer.derivatives[name] for name in names]
    slopes = np.array([*slopes, answer.values, np.ones((9, 11))])
    expected = np.einsum("aij,bij,ij->ab", slopes, slopes, 1.0 / (300.0 * answer.values + 2.5 + read**2))
    found = lm.fisher(
        COMA,
        (9, 11),
        2e-6,
        of=(*names, "photons", "background"),
        photons=300.0,
        background=2.5,
        noise=lm.Noise(read=read),
    )
    assert found.matrix == pytest.approx(expected, rel=1e-6)
    assert found.covariance == pytest.approx(np.linalg.inv(expected), rel=1e-5)
    assert found.units == {
        "defocus": "rad",
        (3, 1): "rad",
        "row": "pixels",
        "photons": "electrons",
        "background": "electrons/pixel",
    }


def test_a_dark_pixel_hides_nothing_that_others_tell():
    # On the first dark ring of an Airy pattern, whose values there are known to their bound only.
    line = {"shape": (1, 41), "pixel": lm.Pupil().airy_radius, "of": ("column",), "photons": 1e6}
    found = lm.fisher(lm.Pupil(), **line)
    assert found.unidentifiable == ()
    assert found.errors["column"] == pytest.approx(
        lm.fisher(lm.Pupil(), **line, tol=1e-10).errors["column"], rel=1e-3
    )


def test_what_no_light_reaches_tells_nothing():
    far = lm.fisher(lm.Pupil(), 3, 1e-3, center=(1, 1e3 * lm.Pupil().airy_radius), of=("defocus",), photons=1e-3)
    assert far.unidentifiable == ("defocus",)
    assert not np.isnan(far.matrix).any()


def test_depth_is_known_by_defocus():
    lens = LENS.pupil(1.9)
    found = lm.fisher(lens, of=("object_distance",), **CAMERA).errors["object_distance"]
    radius = 0.5 * LENS.aperture_diameter
    rate = math.pi * radius**2 / (2.0 * LENS.wavelength * 1.9**2)
    assert found * rate == pytest.approx(lm.fisher(lens, of=("defocus",), **CAMERA).errors["defocus"], rel=1e-9)


def test_a_stack_is_a_scene_each():
    stack = LENS.pupil([[1.8, 1.9, 2.1], [2.2, 2.3, 2.4]])
    names = ("object_distance", "row", "photons")
    found = lm.fisher(stack, of=names, **CAMERA)
    assert found.matrix.shape == (2, 3, 3, 3)
    for index in np.ndindex(2, 3):
        one = lm.fisher(stack[index], of=names, **CAMERA)
        assert found.matrix[index] == pytest.approx(one.matrix, rel=1e-6, abs=1e-9 * one.matrix.max())
        assert found.errors["row"][index] == pytest.approx(one.errors["row"], rel=1e-6)
    light = lm.fisher(stack, of=names, **(CAMERA | {"photons": [[[1e4]], [[2e4]]], "background": [1.0, 2.0, 5.0]}))
    assert light.matrix.shape == (2, 2, 3, 3, 3)
    assert light.matrix[0, :, 2] == pytest.approx(found.matrix[:, 2], rel=1e-12)


def test_light_broadcasts_with_stacks_and_with_images_of_one_scene():
    column = LENS.pupil([[1.9], [2.1]])
    found = lm.fisher(column, of=("row",), **(CAMERA | {"photons": [1e3, 1e4, 1e5]}))
    assert found.matrix.shape == (2, 3, 1, 1)
    one = lm.fisher(LENS.pupil(2.1), of=("row",), **(CAMERA | {"photons": 1e5}))
    assert found.matrix[1, 2] == pytest.approx(one.matrix, rel=1e-6)
    pair = [LENS.pupil([1.8, 1.9]), LENS.focused(2.1).pupil([1.8, 1.9])]
    levels = np.reshape([1e3, 1e4, 1e5], (3, 1, 1))
    many = lm.fisher(pair, of=("row", "photons"), **(CAMERA | {"photons": levels}))
    assert many.names == ("row", "photons[0]", "photons[1]")
    assert many.matrix.shape == (3, 2, 3, 3)
    one = lm.fisher(pair, of=("row", "photons"), **(CAMERA | {"photons": 1e5}))
    assert many.matrix[2] == pytest.approx(one.matrix, rel=1e-12)


def test_each_image_of_a_scene_has_its_own_light():
    wave = lm.Wavefront(nonradial={(2, 2): 0.4, (3, 1): 0.6})
    stack = lm.Pupil(wave + lm.Wavefront([-2.0, 0.0, 2.0]))
    names = ("photons", (3, 1), "background", (2, 2))
    question = {"of": names, "photons": [1e3, 2e3, 4e3], "background": 3.0}
    apart = lm.fisher(stack, 11, 0.5, **question)
    found = lm.fisher(stack, 11, 0.5, together=True, **question)
    own = [[f"{name}[{i}]" for i in range(3)] for name in ("photons", "background")]
    assert found.names == (*own[0], (3, 1), *own[1], (2, 2))
    assert found.units["photons[2]"] == "electrons"
    assert found.matrix[3, 3] == pytest.approx(apart.matrix[:, 1, 1].sum(), rel=1e-12)
    assert found.matrix[:3, :3] == pytest.approx(np.diag(apart.matrix[:, 0, 0]), rel=1e-12)
    assert found.matrix[1, 3] == pytest.approx(apart.matrix[1, 0, 1], rel=1e-12)
    assert found.matrix[1, 4] == 0.0
    assert found.matrix[1, 5] == pytest.approx(apart.matrix[1, 0, 2], rel=1e-12)
    listed = lm.fisher(list(stack), 11, 0.5, **question)
    assert listed.names == found.names
    assert listed.covariance == pytest.approx(found.covariance, rel=1e-6, abs=1e-9 * found.covariance.max())
    # One of them is in focus, where even terms are not to be known; together they are.
    assert apart.unidentifiable == ()
    assert (errors(found)[3] < errors(apart)[1]).all()
    pairs = lm.fisher([stack, stack], 11, 0.5, of=("photons",), photons=1e3, together=True)
    assert pairs.names[:4] == ("photons[0, 0]", "photons[0, 1]", "photons[0, 2]", "photons[1, 0]")


def test_what_one_image_in_focus_does_not_tell_two_out_of_focus_do():
    terms = ("defocus", (2, 2), (4, 0))
    light = {"photons": 1e4, "background": 1.0}
    assert lm.fisher(lm.Pupil(), 11, 0.5, of=terms, **light).unidentifiable == terms
    stack = lm.Pupil(lm.Wavefront([-2.0, 2.0]))
    assert lm.fisher(stack, 11, 0.5, of=terms, together=True, **light).unidentifiable == ()


def test_the_inverse_of_the_matrix_is_the_covariance_of_fits():
    script = runpy.run_path(str(Path(__file__).parents[2] / "benchmarks" / "fisher.py"))
    found = script["compared"](1000, seed=7)
    assert found.scatter == pytest.approx(1.0, abs=0.12)
    assert found.difference < 0.15
    assert (np.abs(found.bias) < 4.5).all()


@pytest.mark.parametrize(
    ("changes", "error", "said"),
    [
        ({"pupil": [LENS.pupil([1.9, 2.1]), LENS.pupil([1.8, 1.9, 2.0])]}, ValueError, r"must broadcast.*\(2,\)"),
        ({"photons": [1e3, 1e4]}, ValueError, r"photons, background and images must broadcast.*\(2,\)"),
        ({"pupil": [LENS.pupil(1.9)], "photons": [1.0] * 3}, ValueError, r"images of shape \(1,\), got \(3,\)"),
        ({"noise": lm.Noise(read=np.ones((3, 4)))}, ValueError, r"read, of shape \(3, 4\), .* \(15, 15\)"),
    ],
)
def test_bad_input_is_refused_in_a_line_that_says_what_is_wrong(changes, error, said):
    given = {"pupil": LENS.pupil([1.8, 1.9, 2.1]), "of": ("defocus",), **CAMERA} | changes
    with pytest.raises(error, match=said) as caught:
        lm.fisher(**given)
    assert "\n" not in str(caught.value)


def test_bead_stacks_of_an_objective_tell_z_and_aberrations_as_their_differences_do():
    given = {"depth": 1e-6, "z": np.array([-0.4e-6, 0.0, 0.4e-6]), "wavelength": 600e-9}
    camera, start = {"shape": 9, "pixel": 6.5e-6}, {(2, 2): 0.4, (3, -1): -0.2}
    steps = {"z": 2e-9, "row": 1e-3, (2, 2): 1e-3, (3, -1): 1e-3, (4, 0): 1e-3}

    def image(name=None, step=0.0):
        terms = start | ({name: start.get(name, 0.0) + step} if isinstance(name, tuple) else {})
        moved = given | {"z": given["z"] + (step if name == "z" else 0.0)}
        pupil = OIL.pupil(**moved, aberrations=lm.Wavefront.zernike(terms, normalization="edge"))
        center = (4.0 + (step if name == "row" else 0.0), 4.0)
        return 1e3 * lm.psf(pupil, **camera, center=center, tol=1e-9).values + 5.0

    slopes = [(image(name, h) - image(name, -h)) / (2.0 * h) for name, h in steps.items()]
    information = np.array([[(a * b / image()).sum() for a in slopes] for b in slopes])
    pupil = OIL.pupil(**given, aberrations=lm.Wavefront.zernike(start, normalization="edge"))
    found = lm.fisher(pupil, **camera, of=tuple(steps), photons=1e3, background=5, together=True)
    assert list(found.errors.values()) == pytest.approx(np.sqrt(np.diag(np.linalg.inv(information))), rel=1e-4)
    assert [found.units[name] for name in steps] == ["m", "pixels", "rad", "rad", "rad"]
    assert repr(found).splitlines()[1].endswith("nm")
