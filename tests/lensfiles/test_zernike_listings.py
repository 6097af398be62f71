"""Listings of other programs: each term is the polynomial that the program prints or documents beside it."""

from __future__ import annotations

import math
import re

import numpy as np
import pytest

import lommel as lm
from lommel.io.zernike_tables import ZernikeFileError, ZernikeTable
from lommel.special import zernike

STANDARD = """\
4^(1/2) (p) * COS (A)
4^(1/2) (p) * SIN (A)
3^(1/2) (2p^2 - 1)
6^(1/2) (p^2) * SIN (2A)
6^(1/2) (p^2) * COS (2A)
8^(1/2) (3p^3 - 2p) * SIN (A)
8^(1/2) (3p^3 - 2p) * COS (A)
8^(1/2) (p^3) * SIN (3A)
8^(1/2) (p^3) * COS (3A)
5^(1/2) (6p^4 - 6p^2 + 1)
10^(1/2) (4p^4 - 3p^2) * COS (2A)
10^(1/2) (4p^4 - 3p^2) * SIN (2A)
10^(1/2) (p^4) * COS (4A)
10^(1/2) (p^4) * SIN (4A)""".splitlines()
FRINGE = """\
(p) * COS (A)
(p) * SIN (A)
(2p^2 - 1)
(p^2) * COS (2A)
(p^2) * SIN (2A)
(3p^2 - 2) p * COS (A)
(3p^2 - 2) p * SIN (A)
(6p^4 - 6p^2 + 1)
(p^3) * COS (3A)
(p^3) * SIN (3A)
(4p^2-3) p^2 * COS (2A)""".splitlines()
# As Code V's manual has them.
CODE_V = """\
p * COS (A)
p * SIN (A)
p^2 * COS (2A)
(2p^2 - 1)
p^2 * SIN (2A)
p^3 * COS (3A)
(3p^3 - 2p) * COS (A)
(3p^3 - 2p) * SIN (A)
p^3 * SIN (3A)
p^4 * COS (4A)
(4p^4 - 3p^2) * COS (2A)
(6p^4 - 6p^2 + 1)
(4p^4 - 3p^2) * SIN (2A)
p^4 * SIN (4A)""".splitlines()
HEAD = """\
Listing of Zernike {kind} Coefficient Data

File : C:\\lenses\\telescope.zmx
Title: a telescope

Date : 9/19/2018

Using Zernike {kind} polynomials.
OPD referenced to chief ray.

Surface                      :\tImage
Field                        :\t0.7500 (deg)
Wavelength                   :\t0.7500 µm
Peak to Valley (to chief)    :\t    1.94926163 waves
RMS (to centroid)            :\t    0.20357417 waves
Variance                     :\t    0.04144244 waves squared
Strehl Ratio (Est)           :\t    0.19474154
RMS fit error                :\t    0.00858620 waves

"""
VALUES = [round(0.37 * math.cos(7.0 * k), 8) for k in range(1, 16)]
POINTS = np.random.default_rng(1).uniform(0.0, 1.0, (2, 40)) * [[1.0], [2.0 * math.pi]]


def value(formula: str, p, A):
    """What a printed polynomial is, read as arithmetic."""
    code = formula.replace("^", "**").replace("1/2", "0.5").replace("COS (", "C(").replace("SIN (", "S(")
    code = re.sub(r"(?<=[\dp)])\s*(?=[p(A])", "*", code)
    return eval(code, {"C": np.cos, "S": np.sin, "p": p, "A": A})


def listing(kind: str, formulas: list[str]) -> str:
    lines = [
        f"Z{k:4d}\t{c:14.8f}\t:\t  {f}" for k, (c, f) in enumerate(zip(VALUES, ["1", *formulas], strict=False), 1)
    ]
    return HEAD.format(kind=kind) + "\n".join(lines) + "\n"


def waves(table: ZernikeTable) -> np.ndarray:
    return table.wavefront().phase(*POINTS) / (2.0 * math.pi)


def summed(formulas: list[str]) -> np.ndarray:
    """The sum of the printed polynomials, without the constants: lommel's wavefronts have none."""
    return np.asarray(sum(c * value(f, *POINTS) for c, f in zip(VALUES[1:], formulas, strict=False)))


def same_but_for_a_constant(one, two) -> None:
    np.testing.assert_allclose(one - one.mean(), two - np.mean(two), atol=1e-12)


@pytest.mark.parametrize(("kind", "formulas"), [("Standard", STANDARD), ("Fringe", FRINGE)])
@pytest.mark.parametrize("encoding", ["utf-16", "utf-16-le", "utf-8", "utf-8-sig", "cp1252"])
def test_a_listing_of_opticstudio_is_the_sum_of_the_polynomials_that_it_prints(kind, formulas, encoding, tmp_path):
    mark = b"\xff\xfe" if encoding == "utf-16-le" else b""
    file = tmp_path / "listing.txt"
    file.write_bytes(mark + listing(kind, formulas).replace("\n", "\r\n").encode(encoding))
    table = lm.load_zernike(file)
    assert table.wavelength == 750e-9
    assert (table.order, table.unit) == ("noll" if kind == "Standard" else "fringe", "waves")
    same_but_for_a_constant(waves(table), summed(formulas))


def test_annular_terms_become_those_over_the_disc(tmp_path):
    e = 0.61
    text = listing("Annular", STANDARD[:10]).replace("Field ", f"Obscuration Factor           :\t{e}\nField ")
    (tmp_path / "a.txt").write_text(text, encoding="utf-16")
    table = lm.load_zernike(tmp_path / "a.txt")
    p, A = POINTS
    # Mahajan (1981), Table I.
    s2, s4 = 1 + e**2 + e**4, 1 + 4 * e**2 + e**4
    coma = math.sqrt(8) * (3 * (1 + e**2) * p**3 - 2 * s2 * p) / ((1 - e**2) * math.sqrt((1 + e**2) * s4))
    six = math.sqrt(1 + e**2 + e**4 + e**6)
    polynomials = [
        2 * p * np.cos(A) / math.sqrt(1 + e**2),
        2 * p * np.sin(A) / math.sqrt(1 + e**2),
        math.sqrt(3) * (2 * p**2 - 1 - e**2) / (1 - e**2),
        math.sqrt(6) * p**2 * np.sin(2 * A) / math.sqrt(s2),
        math.sqrt(6) * p**2 * np.cos(2 * A) / math.sqrt(s2),
        coma * np.sin(A),
        coma * np.cos(A),
        math.sqrt(8) * p**3 * np.sin(3 * A) / six,
        math.sqrt(8) * p**3 * np.cos(3 * A) / six,
        math.sqrt(5) * (6 * p**4 - 6 * (1 + e**2) * p**2 + s4) / (1 - e**2) ** 2,
    ]
    total = sum(c * f for c, f in zip(VALUES[1:], polynomials, strict=False))
    same_but_for_a_constant(waves(table), total)
    # What they are for: their rms over the annulus is that of their coefficients.
    pupil = lm.Pupil(table.wavefront(), obscuration=e)
    assert float(lm.rms(pupil, unit="waves")) == pytest.approx(math.hypot(*VALUES[1:11]), rel=1e-9)


def test_annular_terms_without_an_obscuration_are_those_of_the_disc():
    terms = {(4, 0): 0.3, (3, -1): -0.2, (6, 2): 0.1}
    found = zernike.over_disc(terms, 0.0)
    for term in found:
        assert found[term] == pytest.approx(terms.get(term, 0.0), abs=1e-14)
    assert all(zernike.index_of(*term, "noll") for term in found)


@pytest.mark.parametrize(("kind", "formulas"), [("ZFR", FRINGE), ("ZRN", CODE_V)])
@pytest.mark.parametrize("suffix", [".int", ".zfr"])
def test_a_file_of_code_v_is_the_sum_of_its_polynomials(kind, formulas, suffix, tmp_path):
    count = len(formulas) + 1
    scaled = [f"{1000 * c:.5f}" for c in VALUES[:count]]
    lines = [" ".join(scaled[k : k + 4]) for k in range(0, count, 4)]
    text = "\n".join(["! made by hand", "A title ZRN", f"{kind} {count} WFR WVL 0.6328 SSZ 1000 NDA 32767", *lines])
    (tmp_path / f"a{suffix}").write_text(text + "\n")
    table = lm.load_zernike(tmp_path / f"a{suffix}")
    assert table.wavelength == pytest.approx(632.8e-9)
    same_but_for_a_constant(waves(table), summed(formulas))


INT = "title\nZFR 4 WFR WVL 0.6328 SSZ 1000\n1 2 3 4\n"


@pytest.mark.parametrize(
    ("suffix", "text", "told"),
    [
        (".txt", listing("Fringe", FRINGE).replace("Fringe", ""), "must be Standard, Fringe or Annular, which"),
        (".txt", listing("Fringe", FRINGE).replace("Listing of Zernike Fringe", "Listing of Zernike Standard"),
         "must be Standard, Fringe or Annular, got fringe and standard"),
        (".txt", listing("Fringe", FRINGE).replace("0.7500 µm", "0.7500"), "the wavelength 0.7500 has no unit"),
        (".txt", listing("Fringe", FRINGE).replace(" waves", ""), "the unit is not stated"),
        (".txt", listing("Standard", FRINGE), "6p^4 - 6p^2 + 1 is the term 11 of Zernike Standard, which"),
        (".txt", listing("Fringe", STANDARD), "is the term 9 of Zernike Fringe, which the heading states, got"),
        (".txt", listing("Annular", STANDARD), "the obscuration of the annulus is not stated"),
        (".txt", listing("Fringe", FRINGE) + "Z   4   0.25\n", "line 32: the term 4 was given before"),
        (".txt", re.sub("Z   5.*\n", "", listing("Fringe", FRINGE)), "line 24: the term 5 is missing, got 6; a"),
        (".txt", re.sub("Z   1.*\n", "", listing("Fringe", FRINGE)), "line 20: the term 1 is missing, got 2; a"),
        (".txt", listing("Fringe", FRINGE) + "Z  13   0.0", "line 32: the term 13 is cut off, without the formula"),
        (".txt", listing("Fringe", FRINGE) + "Number of terms : 13\n", "line 32: states 13 terms, and the"),
        (".txt", listing("Fringe", FRINGE) + "Z  13   1.2.5\n", "line 32: the term 13 must be a finite number"),
        (".txt", listing("Fringe", FRINGE) + "Z  20 x\n", "line 32: a term must have a number and a value, got"),
        (".txt", "Listing of Zernike Fringe Coefficients\n1 waves", "it lists no term, such as 'Z   4     0.25'"),
        (".txt", "Listing of what it may be", "is no listing of Zernike coefficients of OpticStudio"),
        (".int", INT.replace("WVL 0.6328 ", ""), "it lacks a positive WVL"),
        (".int", INT.replace("SSZ 1000", ""), "it lacks a positive SSZ"),
        (".int", INT.replace("WFR", "SUR"), "must hold a wavefront (WFR), got the shape of a surface"),
        (".int", INT.replace("3 4", "3 4 5"), "it states 4 values, got 5"),
        (".int", INT.replace("1000", "1000 NDA 3"), "the term 3 has no value"),
    ],
)  # fmt: skip
def test_what_a_listing_does_not_state_is_refused(suffix, text, told, tmp_path):
    (tmp_path / f"a{suffix}").write_text(text, encoding="utf-8")
    with pytest.raises(ZernikeFileError, match=rf"a{suffix}") as caught:
        lm.load_zernike(tmp_path / f"a{suffix}")
    assert told in str(caught.value)


@pytest.mark.parametrize(
    "text",
    [
        "# normalization: edge\nnoll,coeff (waves)\n4,0.25\n8,-0.5\n",
        "# normalization: edge\n# order: noll\nj, coeff (waves)\nZ4,0.25\nz 8,-0.5\n",
        "# normalization: edge\n# order: noll\n# unit: wave\nTerm,Name,Coefficient\n4,defocus,0.25\n8,coma,-0.5\n",
        "# normalization: edge\nnoll;value [waves]\n4;0.25\n8;-0.5\n",
        "# normalization: edge\n# order: noll\nZ,coefficient_waves\nZ4,0.25\nZ8,-0.5\n",
        "# normalization: edge\n\nNoll\tC (wave)\n4\t0.25\n8\t-0.5\n",
        "# normalization: edge\nn,m,value (waves)\n2,0,0.25\n3,1,-0.5\n",
    ],
)
def test_columns_may_be_called_what_people_call_them(text, tmp_path):
    (tmp_path / "a.csv").write_text(text)
    found = lm.load_zernike(tmp_path / "a.csv").wavefront()
    expected = lm.Wavefront.zernike({4: 0.25, 8: -0.5}, order="noll", unit="waves", normalization="edge")
    assert found == expected


def test_columns_that_contradict_the_stated_unit_are_refused(tmp_path):
    (tmp_path / "a.csv").write_text("# normalization: edge\n# order: noll\n# unit: nm\nj,coeff (waves)\n4,1\n")
    with pytest.raises(ZernikeFileError, match="state the unit waves, line 3 states nm"):
        lm.load_zernike(tmp_path / "a.csv")


def test_a_wavefront_saves_itself(tmp_path):
    wavefront = lm.Wavefront(1.0, 0.5, nonradial={(3, 1): 0.25})
    wavefront.save(tmp_path / "a.csv")
    wavefront.save(tmp_path / "b.toml", order="fringe", unit="nm", normalization="edge", wavelength=500e-9)
    for name in ("a.csv", "b.toml"):
        found = lm.load_zernike(tmp_path / name).wavefront()
        np.testing.assert_allclose(found.phase(*POINTS), wavefront.phase(*POINTS), atol=1e-12)
    assert lm.load_zernike(tmp_path / "b.toml").unit == "nm"
