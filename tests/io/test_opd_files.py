"""Measured maps in files: those that other programs write, as their layouts are published, and lommel's own."""

from __future__ import annotations

import math
import struct

import h5py
import numpy as np
import pytest
from astropy.io import fits

import lommel as lm
from lommel.io import opd_files
from lommel.io.opd_files import OPDFileError

WAVE = 632.8e-9
WAVEFRONT = lm.Wavefront(2.0, -0.7, nonradial={(2, 2): 0.5, (3, -1): 0.8})
VALUES = WAVE * lm.opd_map(WAVEFRONT, (40, 44), unit="waves")
VALUES[10:14, 20:25] = np.nan
MAP = lm.OPDMap(VALUES, spacing=1.5e-4, wavelength=WAVE)


def same_wavefront(opd: lm.OPDMap, tol: float = 1e-9) -> None:
    found = lm.fit_opd(opd).wavefront - WAVEFRONT
    assert max(abs(float(c)) for c in found.edge_terms().values()) < tol


@pytest.mark.parametrize("suffix", [".fits", ".fit", ".fits.gz", ".csv"])
def test_what_is_saved_comes_back_with_all_that_was_known(suffix, tmp_path):
    lm.save_opd(tmp_path / f"a{suffix}", MAP)
    found = lm.load_opd(tmp_path / f"a{suffix}")
    np.testing.assert_array_equal(found.values, MAP.values)
    np.testing.assert_array_equal(found.mask, MAP.mask)
    assert (found.spacing, found.wavelength) == (1.5e-4, WAVE)
    same_wavefront(found)


def test_an_array_alone_comes_back_where_the_call_says_the_rest(tmp_path):
    lm.save_opd(tmp_path / "a.npy", MAP)
    found = lm.load_opd(tmp_path / "a.npy", unit="metres", spacing=1.5e-4, wavelength=WAVE)
    np.testing.assert_array_equal(found.values, MAP.values)
    same_wavefront(found)
    with pytest.raises(ValueError, match=r"unit must be given, since .*a\.npy does not state it"):
        lm.load_opd(tmp_path / "a.npy")


@pytest.mark.parametrize(
    ("unit", "size"), [("nm", 1e-9), ("um", 1e-6), ("waves", WAVE), ("radians", WAVE / 2 / math.pi)]
)
def test_an_array_may_be_in_any_unit(unit, size, tmp_path):
    np.save(tmp_path / "a.npy", VALUES / size)
    same_wavefront(lm.load_opd(tmp_path / "a.npy", unit=unit, wavelength=WAVE))


def test_waves_need_a_wavelength(tmp_path):
    np.save(tmp_path / "a.npy", VALUES / WAVE)
    with pytest.raises(OPDFileError, match=r"a\.npy cannot .*: wavelength must be given, since its unit is waves"):
        lm.load_opd(tmp_path / "a.npy", unit="waves")


@pytest.mark.parametrize(
    ("unit", "size"), [("m", 1.0), ("micron", 1e-6), ("um", 1e-6), ("nm", 1e-9), ("waves", WAVE)]
)
def test_fits_by_astropy_is_read_in_its_unit(unit, size, tmp_path):
    made = fits.PrimaryHDU(np.float64(VALUES / size))
    made.header.update(BUNIT=unit, WAVELEN=WAVE, PUPLSCAL=1.5e-4)
    fits.HDUList([made]).writeto(tmp_path / "a.fits")
    found = lm.load_opd(tmp_path / "a.fits")
    assert found.spacing == 1.5e-4
    same_wavefront(found)


def test_fits_may_have_its_image_in_an_extension_scaled_to_integers_and_the_spacing_in_millimetres(tmp_path):
    counts = np.where(np.isnan(VALUES), -32768, np.rint(np.nan_to_num(VALUES) / 1e-10)).astype(np.int16)
    made = fits.ImageHDU(counts)
    made.header.update(BUNIT="nm", BLANK=-32768, CDELT1=0.15, CUNIT1="mm", BSCALE=0.1)
    fits.HDUList([fits.PrimaryHDU(), made]).writeto(tmp_path / "a.fits")
    found = lm.load_opd(tmp_path / "a.fits", wavelength=WAVE)
    assert found.spacing == pytest.approx(1.5e-4)
    np.testing.assert_array_equal(found.mask, MAP.mask)
    np.testing.assert_allclose(found.values, VALUES, atol=0.6e-10)


def test_astropy_reads_a_saved_map(tmp_path):
    lm.save_opd(tmp_path / "a.fits", MAP)
    with fits.open(tmp_path / "a.fits", checksum=True) as file:
        file.verify("exception")
        np.testing.assert_array_equal(file[0].data, VALUES)
        header = file[0].header
        assert (header["BUNIT"], header["PUPLSCAL"], header["CDELT2"], header["WAVELEN"]) == (
            "m",
            1.5e-4,
            1.5e-4,
            WAVE,
        )


def metropro(
    values, *, size=834, magic=0x881B036F, resolution=1, intensity=(0, 0, 0), scale=0.5, obliquity=1.0
) -> bytes:
    """A file by its published layout: numbers are big-endian."""
    head = bytearray(size)
    for place, kind, value in ((0, "I", magic), (6, "I", size), (52, "3H", intensity), (68, "2H", values.shape[::-1]),
                               (164, "f", scale), (168, "f", WAVE), (176, "f", obliquity), (184, "f", 1.5e-4),
                               (218, "H", resolution)):  # fmt: skip
        struct.pack_into(f">{kind}", head, place, *np.atleast_1d(value).tolist())
    fringes = values / (WAVE * scale * obliquity) * {0: 4096, 1: 32768, 2: 131072}[resolution]
    counts = np.where(np.isnan(fringes), 2147483640, np.rint(np.nan_to_num(fringes))).astype(">i4")
    return bytes(head) + bytes(2 * math.prod(intensity)) + counts.tobytes()


@pytest.mark.parametrize("resolution", [0, 1, 2])
@pytest.mark.parametrize(
    "how",
    [{}, {"size": 4096, "magic": 0x881B0371, "intensity": (8, 6, 2)}, {"scale": 1.0, "obliquity": 1.1}],
    ids=str,
)
def test_a_file_of_metropro_is_read(resolution, how, tmp_path):
    (tmp_path / "a.dat").write_bytes(metropro(VALUES, resolution=resolution, **how))
    found = lm.load_opd(tmp_path / "a.dat")
    assert (found.spacing, found.wavelength) == (1.5e-4, WAVE)
    np.testing.assert_allclose(found.values, VALUES, rtol=1e-6, atol=WAVE * 1.1 / 4096)
    np.testing.assert_array_equal(found.mask, MAP.mask)


def datx(path, *, place: str, unit: bytes, size: float) -> None:
    with h5py.File(path, "w") as file:
        stored = np.where(np.isnan(VALUES), 1.7e308, VALUES / size)
        found = file.create_dataset(place, data=stored, compression="gzip")
        found.attrs["No Data"] = [1.7e308]
        found.attrs["Unit"] = np.array([unit], dtype=h5py.string_dtype())
        found.attrs["Wavelength"] = [WAVE]
        found.attrs["Interferometric Scale Factor"] = [0.5]
        found.attrs["Obliquity Factor"] = [1.0]
        kind = np.dtype([("c", "S8"), ("u", "S8"), ("p", "f8", (4,))])
        found.attrs["X Converter"] = np.array([(b"LateralCat", b"Pixels", (0.0, 1.5e-4, 0.0, 0.0))], kind)


@pytest.mark.parametrize("place", ["Measurement/Surface", "Data/Surface/{A1B2}"])
@pytest.mark.parametrize(
    ("unit", "size"),
    [
        (b"Fringes", 0.5 * WAVE),
        (b"NanoMeters", 1e-9),
        (b"MicroInches", 25.4e-9),
        (b"Angstroms", 1e-10),
        (b"Waves", WAVE),
        (b"Radians", WAVE / (2.0 * math.pi)),
    ],
)
def test_a_datx_is_read_in_fringes_or_a_length(place, unit, size, tmp_path):
    datx(tmp_path / "a.datx", place=place, unit=unit, size=size)
    found = lm.load_opd(tmp_path / "a.datx")
    assert (found.spacing, found.wavelength) == (1.5e-4, WAVE)
    np.testing.assert_array_equal(found.mask, MAP.mask)
    same_wavefront(found)


def test_a_unit_that_is_not_known_is_stated_by_the_caller(tmp_path):
    datx(tmp_path / "a.datx", place="Measurement/Surface", unit=b"Furlongs", size=1e-9)
    with pytest.raises(OPDFileError, match="it has the unknown unit 'Furlongs'; give `unit`"):
        lm.load_opd(tmp_path / "a.datx")
    same_wavefront(lm.load_opd(tmp_path / "a.datx", unit="nm"))


def test_a_datx_that_leads_to_another_file_is_refused(tmp_path):
    datx(tmp_path / "other.datx", place="Measurement/Surface", unit=b"Fringes", size=1.0)
    with h5py.File(tmp_path / "a.datx", "w") as file:
        file["Measurement/Surface"] = h5py.ExternalLink(str(tmp_path / "other.datx"), "/Measurement/Surface")
    with pytest.raises(OPDFileError, match=r"a\.datx cannot be read .*: it holds no surface"):
        lm.load_opd(tmp_path / "a.datx")


def test_a_grid_of_code_v_is_read(tmp_path):
    counts = np.where(np.isnan(VALUES), 32767, np.rint(np.nan_to_num(VALUES) / WAVE * 10000)).astype(int)
    rows = "\n".join(" ".join(map(str, row)) for row in counts)
    head = "! a comment\ntitle\nGRD 44 40 WFR WVL 0.6328 NNB NDA 32767 SSZ 10000"
    (tmp_path / "a.int").write_text(f"{head}\n{rows}\n")
    found = lm.load_opd(tmp_path / "a.int")
    assert found.wavelength == pytest.approx(WAVE)
    np.testing.assert_array_equal(found.mask, MAP.mask)
    np.testing.assert_allclose(found.values, VALUES, atol=0.51e-4 * WAVE)


def test_rows_of_numbers_are_read(tmp_path):
    (tmp_path / "a.csv").write_text("# measured today\n# unit: nm\n# spacing: 0.1 mm\n1, 2, nan\n3, , 5e1\n")
    found = lm.load_opd(tmp_path / "a.csv")
    np.testing.assert_allclose(found.values, [[1e-9, 2e-9, np.nan], [3e-9, np.nan, 5e-8]])
    assert found.spacing == pytest.approx(1e-4)


def bad(name: str, data: bytes | str, told: str):
    return pytest.param(name, data if isinstance(data, bytes) else data.encode(), told, id=f"{name} {told[:30]}")


GOOD = metropro(VALUES)
POSITIONS = "".join(
    f"{x / 4:.4f},{y / 4:.4f},{x * y / 7:.4f}\n" for y in range(-4, 4) for x in range(-4, 4) if abs(x) + abs(y) < 7
)


@pytest.mark.parametrize("head", ["", "px,py,W (waves)\n", "# unit: waves\nx,y,W\n"])
@pytest.mark.parametrize(("side", "digits"), [(33, 4), (64, 4), (129, 3)])
def test_a_list_of_positions_and_values_is_a_map(head, side, digits, tmp_path):
    axis = np.linspace(-1, 1, side)
    x, y = np.meshgrid(axis, axis)
    waves = 0.3 * (3 * (x**2 + y**2) - 2) * y + 0.2 * (x**2 - y**2) - 0.1 * x * y
    inside = (x**2 + y**2 <= 1 + 1e-9) & (np.abs(x - 0.3) > 0.05)  # a vane
    order = np.random.default_rng(1).permutation(inside.sum())
    rows = np.column_stack([x[inside], y[inside], waves[inside]])[order]
    text = "".join(f"{a:.{digits}f},{b:.{digits}f},{c:.6f}\n" for a, b, c in rows)
    (tmp_path / "a.csv").write_text(head + text)
    opd = lm.load_opd(tmp_path / "a.csv", unit="waves", wavelength=WAVE)
    # Without the rows and columns at the rim that have no position.
    first, last = (axis.min() for axis in np.nonzero(inside)), (axis.max() + 1 for axis in np.nonzero(inside))
    known = tuple(map(slice, first, last))
    expected_map = np.where(inside, waves * WAVE, np.nan)[known]
    np.testing.assert_allclose(opd.values, expected_map, atol=1e-6 * WAVE)
    found = lm.fit_opd(opd, degree=3).coefficients
    expected = {(3, -1): 0.3 / math.sqrt(8), (2, 2): 0.2 / math.sqrt(6), (2, -2): -0.05 / math.sqrt(6)}
    for term, value in found.items():
        if term[0] > 1:
            assert value / WAVE == pytest.approx(expected.get(term, 0.0), abs=1e-5)


@pytest.mark.parametrize(
    ("name", "data", "told"),
    [
        bad("a.dat", b"", "it does not begin like a file of MetroPro"),
        bad("a.dat", b"\0" * 4096, "it does not begin like a file of MetroPro"),
        bad("a.dat", GOOD[:-1], "44 x 40 values end beyond its"),
        bad("a.dat", GOOD[:6] + b"\xff\xff\xff\xff" + GOOD[10:], "its header has 4294967295 bytes"),
        bad("a.dat", GOOD[:68] + b"\xff\xff\xff\xff" + GOOD[72:], "pixels; the limit is"),
        bad("a.dat", GOOD[:218] + b"\0\7" + GOOD[220:], "its phase has the resolution 7"),
        bad("a.dat", GOOD[:168] + b"\0" * 4 + GOOD[172:], "its wavelength must be > 0"),
        bad("a.dat", GOOD[:164] + b"\x7f\xc0\0\0" + GOOD[168:], "its scale factor must be finite"),
        bad("a.datx", b"", "cannot be read"),
        bad("a.datx", b"\x89HDF\r\n\x1a\n" + b"\0" * 100, "cannot be read"),
        bad("a.fits", b"", "cannot be read"),
        bad("a.fits", b"SIMPLE  =                    T" + b" " * 2850, "cannot be read"),
        bad("a.fits.gz", b"\x1f\x8b\x08" + b"\0" * 30, "cannot be read"),
        bad("a.csv", "1,2\n3\n", "it must hold rows with the same number of values, got 1 in line 2, and 2 before"),
        bad("a.csv", "1,2\n3,x\n", "it must hold rows with the same number of values, got '3, x' in line 2"),
        bad("a.csv", POSITIONS.replace("0.2500,", "0.3000,"), "x, y and a value on a square grid, got 59 on none"),
        bad(
            "a.csv",
            f"{POSITIONS}x,y,W\n",
            "it must hold rows with the same number of values, got 'x, y, W' in line 60",
        ),
        bad("a.csv", "x,y,W\n1,2,3\n", "it must hold rows with the same number of values, got 'x, y, W' in line 1"),
        bad("a.csv", "", "it must hold rows with the same number of values"),
        bad("a.csv", "# unit: furlong\n1,2\n", "it has the unknown unit 'furlong'"),
        bad("a.csv", "# Unit: nm\n1,2\n", "it states 'Unit', which is unknown"),
        bad("a.csv", "# unit: nm\nnan,\n", "not NaN at every pixel"),
        bad("a.csv", "# unit: nm\n1,inf\n", "values must be finite"),
        bad("a.int", "title\nZFR 2 WFR WVL 0.5 SSZ 1\n1 2\n", "it holds coefficients; load_zernike"),
        bad("a.npy", b"\x93NUMPY", "magic string"),
    ],
)
def test_a_file_that_is_none_is_told_in_one_line(name, data, told, tmp_path):
    (tmp_path / name).write_bytes(data)
    with pytest.raises(OPDFileError, match=name) as caught:
        lm.load_opd(tmp_path / name, unit=None if name == "a.csv" else "nm" if name in ("a.npy", "a.fits") else None)
    assert told in str(caught.value)
    assert len(str(caught.value).splitlines()) == 1


def test_a_fits_header_that_claims_more_than_the_file_holds_is_refused_before_it_is_read(tmp_path):
    lm.save_opd(tmp_path / "a.fits", MAP)
    data = (tmp_path / "a.fits").read_bytes()
    for card, value in ((b"NAXIS1  =", b"99999999"), (b"NAXIS1  =", b"-44"), (b"BITPIX  =", b"-128")):
        at = data.index(card)
        (tmp_path / "a.fits").write_bytes(data[:at] + card + value.rjust(21) + data[at + 30 :])
        with pytest.raises(OPDFileError, match=r"a\.fits cannot be read as an OPD map: "):
            lm.load_opd(tmp_path / "a.fits")


def test_what_a_file_states_is_not_stated_otherwise(tmp_path):
    lm.save_opd(tmp_path / "a.fits", MAP)
    assert lm.load_opd(tmp_path / "a.fits", unit="m", wavelength=WAVE).wavelength == WAVE
    for how in ({"unit": "nm"}, {"wavelength": 5e-7}, {"spacing": 1.0}):
        with pytest.raises(OPDFileError, match=rf"it states the {next(iter(how))} .*, not "):
            lm.load_opd(tmp_path / "a.fits", **how)


def test_a_map_knows_its_mask_its_sign_and_its_double():
    assert repr(MAP) == "<OPDMap 40x44, 70.7 % measured, spacing 0.00015 m, wavelength 6.328e-07 m>"
    np.testing.assert_array_equal((2 * MAP).values, 2.0 * VALUES)
    np.testing.assert_array_equal(np.asarray(-MAP), -VALUES)
    assert (2 * MAP).spacing == 1.5e-4
    masked = lm.OPDMap(np.ma.masked_array(np.nan_to_num(VALUES), mask=np.isnan(VALUES)), wavelength=WAVE)
    np.testing.assert_array_equal(masked.mask, MAP.mask)
    for values, error in (
        ([1.0, 2.0], ValueError),
        ([[math.inf]], ValueError),
        ([[math.nan]], ValueError),
        ([["a"]], TypeError),
    ):
        with pytest.raises(error, match="values must"):
            lm.OPDMap(values)


def test_fit_opd_takes_a_map_and_a_mask_besides():
    same_wavefront(MAP)
    left = np.zeros(VALUES.shape, bool)
    left[:, :30] = True
    found = lm.fit_opd(MAP, mask=left, degree=4)
    assert int(found.samples) == int((left & MAP.mask).sum())
    assert found.unit == "metres"
    other = lm.fit_opd(MAP, wavelength=2 * WAVE, degree=4).wavefront
    assert float(other.defocus) == pytest.approx(float(WAVEFRONT.defocus) / 2)
    with pytest.raises(ValueError, match="unit must be left out for an OPDMap, which is in metres, got 'waves'"):
        lm.fit_opd(MAP, unit="waves")
    with pytest.raises(TypeError, match="unit must be given"):
        lm.fit_opd(VALUES)
    with pytest.raises(ValueError, match="needs the wavelength"):
        lm.fit_opd(lm.OPDMap(VALUES))


def test_maps_that_a_format_does_not_hold_are_told(tmp_path):
    stack = lm.OPDMap(np.stack([VALUES, VALUES]))
    with pytest.raises(ValueError, match=r"a \.csv holds a single map, got a stack"):
        lm.save_opd(tmp_path / "a.csv", stack)
    lm.save_opd(tmp_path / "a.fits", stack)
    np.testing.assert_array_equal(lm.load_opd(tmp_path / "a.fits").values, stack.values)


@pytest.mark.parametrize(
    ("name", "near", "far"), [("wavelength", 1.0 + 0.99e-6, 1.0 + 1.01e-6), ("unit", "nm", "um")]
)
def test_what_is_stated_twice_may_differ_by_a_millionth(name, near, far):
    first = "nm" if name == "unit" else 1.0
    assert opd_files._merge_stated(name, near, first) == first
    with pytest.raises(ValueError, match=f"it states the {name} {first}, not {far}"):
        opd_files._merge_stated(name, far, first)
