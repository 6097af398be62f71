"""Lens files and Zernike coefficients that are opened on the live page, against the package's own reading of them."""

from __future__ import annotations

import math
import re
import warnings
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import lommel as lm
from lens_file_texts import lens_file
from live_page import rest, state
from lommel.page.state import FIELDS, Terms, complete, further_terms, state_of

OPEN = """async ([name, text]) => {
    const taken = await live.open(new File([text], name));
    const root = document.querySelector(".lommel-live-host").shadowRoot;
    return { taken, state: live.state, said: root.querySelector(".notice").textContent };
}"""
LOOKS = ("view", "side", "stretch", "map", "waves_unit", "length_unit", "picture", "light", "noise", "rays")


def opened(page: Any, name: str, text: str) -> dict[str, Any]:
    """Open a file on the page and return whether it was taken, the state, and the notice."""
    return page.evaluate(OPEN, [name, text])


def assert_same(found: dict[str, Any], wanted: dict[str, Any]) -> None:
    """Compare two states to the nine digits that they are rounded to; directions only where there is something."""
    for key, field in FIELDS.items():
        got, value = found[key], wanted[key]
        if key in LOOKS or (key == "defocus" and wanted["focus"] == "distances"):
            continue
        if isinstance(field, Terms):
            got, value = further_terms(got), further_terms(value)
            for term in {*got, *value}:
                assert got.get(term, 0.0) == pytest.approx(value.get(term, 0.0), rel=2e-8, abs=2e-10), (key, term)
        elif isinstance(value, str):
            assert got == value, key
        elif not key.endswith("_angle") or wanted.get(key.removesuffix("_angle"), 1) > 1e-9:
            assert got == pytest.approx(value, rel=2e-8, abs=2e-9), key


def test_every_lens_file_of_the_package_is_read_as_the_package_does(
    visit: Callable[..., Any], lenses: dict[str, Path]
) -> None:
    page = visit("/mounted?controls=numbers#side=32")
    for path in lenses.values():
        instrument = lm.load_instrument(path)
        seen = opened(page, path.name, path.read_text(encoding="utf-8"))
        assert seen["taken"], seen["said"]
        assert_same(seen["state"], complete(state_of(instrument)[0]))


def test_random_lens_files_are_read_as_the_package_does(visit: Callable[..., Any], tmp_path: Path) -> None:
    page = visit("/mounted?controls=numbers#side=32")
    rng = np.random.default_rng(20)
    path = tmp_path / "random.toml"
    taken = 0
    for _ in range(120):
        text = lens_file(rng)
        path.write_text(text, encoding="utf-8")
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", UserWarning)
            instrument = lm.load_instrument(path)
        wanted, refused = {}, ""
        try:
            wanted, _ = state_of(instrument)
        except ValueError as error:
            refused = str(error).split(",")[0].replace("the live page", "this page")
        seen = opened(page, path.name, text)
        if refused:
            assert not seen["taken"]
            assert refused in seen["said"]
            continue
        assert seen["taken"], (text, seen["said"])
        assert_same(seen["state"], complete(wanted))
        taken += 1
    assert taken > 100


LISTING = """\
Listing of Zernike {kind} Coefficient Data

File : /lens.zmx
Wavelength                      : 0.6328 \u00b5m
Peak to Valley (to centroid)    : 1.2 waves
RMS (to centroid)               : 0.2 waves

Z   1     0.10000000    :  1
Z   2    -0.01250000    :  p COS (A)
Z   3     0.00000000    :  p
Z   4     0.25000000    :  (2p^2 - 1)
Z   5    -0.03000000    :  p^2
Z   6     0.00000000    :  p
Z   7     0,12500000    :  p^3
Z   8     0.00000000    :  p
Z   9     0.00000000    :  p
Z  10     0.00000000    :  p
Z  11       4.5E-002    :  p^4
Z  12     0.00000000    :  p
Z  13     0.00000000    :  p
Z  14     0.00000000    :  p
Z  15     0.00000000    :  p
Z  16     0.00000000    :  p
Z  17     0.00000000    :  p
Z  18     0.00000000    :  p
Z  19     0.00000000    :  p
Z  20     0.00000000    :  p
Z  21     0.00000000    :  p
Z  22    -0.00125000    :  p^6
"""
CODE_V = "A lens\n{kind} 9 WFR WVL 0.55 SSZ 1000.0\n! comment\n 0 10 -20 300 40.5\n-50 60 7.0D1 -80\n"
TABLES = {
    "fringe.txt": LISTING.format(kind="Fringe"),
    "standard.txt": LISTING.format(kind="Standard"),
    "zrn.int": CODE_V.format(kind="ZRN"),
    "zfr.int": CODE_V.format(kind="ZFR"),
    "nm.csv": "# unit: nm\n# normalization: rms\n# wavelength: 633 nm\nn, m, value\n3, 1, 25\n2, -2, -3.5e1\n",
    "noll.csv": "# normalization: rms\nnoll;name;coeff (waves)\n4;defocus;0.1\n8;coma;-0.2\n",
    "ansi.csv": "# order: ansi\n# unit: radians\n# normalization: edge\nj,c\nZ3,0.5\nZ4,-1\nZ12,0.25\n",
    "table.json": '{"order": "noll", "unit": "um", "normalization": "rms", "wavelength":"1 um","terms": {"7": 0.1}}',
    "table.toml": 'order = "fringe"\nunit = "waves"\nnormalization = "edge"\n[terms]\n4 = 0.5 # defocus\n37 = 0.01\n',
}


@pytest.mark.parametrize("name", TABLES)
def test_zernike_coefficients_become_the_wavefront(visit: Callable[..., Any], tmp_path: Path, name: str) -> None:
    path = tmp_path / name
    path.write_text(TABLES[name], encoding="utf-8")
    table = lm.load_zernike(path)
    page = visit("/mounted?controls=numbers#side=32&f_number=7&pixel=3&obscuration=0.25&coma=2")
    seen = opened(page, name, TABLES[name])
    assert seen["taken"], seen["said"]
    got = seen["state"]
    assert (got["f_number"], got["pixel"], got["obscuration"]) == (7, 3, 0.25)
    wavelength = table.wavelength or 550e-9
    assert got["wavelength"] == pytest.approx(wavelength * 1e9, rel=1e-8)
    wavefront = table.wavefront(None if table.unit in ("waves", "radians") else wavelength)
    wanted = {term: float(c) / math.tau for term, c in wavefront.edge_terms().items() if term != (0, 0)}
    found = {(2, 0): 0.5 * (got["defocus"] + got["spherical"]), (4, 0): got["spherical"] / 6}
    for key, (n, m) in {"coma": (3, 1), "astigmatism": (2, 2), "trefoil": (3, 3)}.items():
        turn = m * math.radians(got[f"{key}_angle"])
        found[n, m], found[n, -m] = got[key] * math.cos(turn), got[key] * math.sin(turn)
    for (n, m), rms in further_terms(got["zernike"]).items():
        found[n, m] = rms * math.sqrt((n + 1) * (2 if m else 1))
    for term in {*wanted, *found}:
        assert found.get(term, 0.0) == pytest.approx(wanted.get(term, 0.0), abs=1e-8), term


def test_plain_columns_and_utf_16_are_read(visit: Callable[..., Any]) -> None:
    page = visit("/mounted?controls=numbers#side=32")
    text = "# unit: waves\n# normalization: rms\nn m value\n2 0 0.1\n3 -3 0.05\n"
    assert opened(page, "columns.txt", text)["taken"]
    assert state(page)["defocus"] == pytest.approx(0.2 * math.sqrt(3), rel=1e-8)
    page.evaluate("live.set({ defocus: 0 })")
    listing = list(LISTING.format(kind="Fringe").encode("utf-16"))
    taken = page.evaluate("bytes => live.open(new File([new Uint8Array(bytes)], 'zemax.TXT'))", listing)
    assert taken
    assert state(page)["defocus"] == pytest.approx(0.5 - 0.0, rel=1e-8)


def lens_with_table(name: str, title: str = "A lens") -> str:
    lens = '[lens]\nfocal_length = "6 mm"\nf_number = 2.8\nfocus_distance = "0.7 m"\nwavelength = "550 nm"\n'
    return f'name = "{title}"\n{lens}[sensor]\npixel = "2 um"\n[aberrations]\nzernike = {{ file = "{name}" }}\n'


@pytest.mark.parametrize("together", [False, True])
def test_a_listing_that_a_lens_file_names_becomes_the_wavefront_of_that_lens(
    visit: Callable[..., Any], tmp_path: Path, together: bool
) -> None:
    texts = {"terms.txt": LISTING.format(kind="Fringe"), "lens.toml": lens_with_table("terms.txt")}
    for name, text in texts.items():
        (tmp_path / name).write_text(text, encoding="utf-8")
    page = visit("/mounted#side=32")
    if together:
        page.locator("input[type=file]").set_input_files([tmp_path / name for name in texts])
        page.wait_for_function("live.state.coma !== 0")
    else:
        assert opened(page, "lens.toml", texts["lens.toml"])["taken"]
        page.get_by_text("terms.txt, which can be opened after this file").wait_for()
        assert opened(page, "terms.txt", texts["terms.txt"])["taken"]
    rest(page)
    assert_same(state(page), complete(state_of(lm.load_instrument(tmp_path / "lens.toml"))[0]))
    assert page.get_by_role("heading", name="A lens", exact=True).count()
    assert not page.get_by_text("which can be opened after").count()
    # Without such a lens it is a wavefront at its own wavelength, as ever.
    assert opened(page, "terms.txt", texts["terms.txt"])["state"]["wavelength"] == pytest.approx(632.8)


GOOD = '[lens]\nfocal_length = "50 mm"\nf_number = 2\nwavelength = "550 nm"\n[sensor]\npixel = "3 um"\n'
FAULTS = {
    "a key given twice": (GOOD + 'pixel = "4 um"', ".toml", ["line 7: pixel is given twice"]),
    "a key of another section": (GOOD + "f_number = 2", ".toml", ["sensor.f_number (line 7)", "it is in [lens]"]),
    "no unit": (GOOD.replace('"50 mm"', "50"), ".toml", ["lens.focal_length (line 2)", "unit", "50"]),
    "degrees": (GOOD + '[aperture.spider]\nvanes = 4\nwidth = "1 mm"\nfirst = 45\n', ".toml", ["turns", "got 45"]),
    "both apertures": (GOOD.replace("f_number = 2", 'f_number = 2\naperture_diameter = "2 mm"'), ".toml", ["one of"]),
    "rectangular pixels": (GOOD.replace('"3 um"', '["3 um", "4 um"]'), ".toml", ["sensor.pixel (line 6)", "square"]),
    "no unit of coefficients": ("# normalization: rms\nn,m,value\n3,1,2\n", ".csv", ["unit", "waves"]),
    "no order": ("index,value\n3,2\n", ".csv", ['the line "# order: noll": is missing']),
    "a column of each term": ("# order: ansi\nZ3,Z4\n0.5,-1\n", ".csv", ["line 2", '"index,value"', "Z3,Z4"]),
    "annular terms": (LISTING.format(kind="Annular"), ".txt", ["annular"]),
    "a surface": (CODE_V.format(kind="ZFR").replace("WFR", "SUR"), ".int", ["WFR"]),
    "too few values": (CODE_V.format(kind="ZFR").replace(" 9 ", " 12 "), ".int", ["12 values, got 9"]),
}


MORE_FAULTS = {
    "sections": (GOOD + "fill = 0.5\nintegrate = 1\n[aperture]\nspider = 3\n[foo]\na = 1\n", ".toml"),
    "values": (GOOD.replace("f_number = 2", 'f_number = "x"\nobscuration = 1\nmodel = "foo"'), ".toml"),
    "lengths": (
        '[lens]\nf_number = 0.1\nfocal_length = "0 mm"\nfocus_distance = "inf"\nwavelength = "5 m"\n',
        ".toml",
    ),
    "vanes": (
        GOOD + '[aperture.spider]\nvanes = 2.5\nwidth = "1 mm"\n[aberrations]\nfield = [1]\nzernike = 4\n',
        ".toml",
    ),
    "large": (GOOD + "[aberrations]\ndefocus = 4000\n", ".toml"),
    "no sections": ('focal_length = "1 mm"', ".toml"),
    "a microscope": ("[objective]\nna = 1", ".toml"),
    "a list": ("[1]", ".json"),
    "another suffix": ("x", ".abc"),
    "no quote": (GOOD.replace('"3 um"', '"3 um'), ".toml"),
    "no comma": (GOOD + "a = [1 2]\n", ".toml"),
    "no key": (GOOD + "= 2\n", ".toml"),
    "two entries": (GOOD + "a = 1 b = 2\n", ".toml"),
    "twice": (GOOD + "[sensor]\n", ".toml"),
    "no table": (GOOD + "pixel.x = 1\n", ".toml"),
    "wrong orders": ("# order: noll\n# unit: parsec\n# normalization: rms\n# foo: 1\nj,c\n0,1\n4,x\n", ".csv"),
    "wrong terms": ("# unit: waves\n# normalization: rms\nn,m,c\n3,2,1\n70,0,1\n2,0,1\n2,0,2\n", ".csv"),
    "other columns": ("# order: ansi\n# unit: waves\n# normalization: rms\nn,m,c (nm)\n1,2\n", ".csv"),
    "no kind": ("Using Zernike\nZ 5 foo\n", ".txt"),
}
ENGLISH = re.compile(r"\b(the|of|and|with|is|are|from|to|by|not|or|no|at|must|got|has|line|there|missing|below)\b")
KEPT = re.compile(r'"[^"]*"|nm \(n and m\)|\b(true|false) or\b|Listing of|Peak to Valley')


def test_errors_are_german_where_the_page_is(visit: Callable[..., Any]) -> None:
    page = visit("/mounted?controls=numbers&lang=de#side=32&coma=1")
    faults = FAULTS | MORE_FAULTS
    for name, (text, suffix, *_) in faults.items():
        seen = opened(page, f"file{suffix}", text)
        assert not seen["taken"], name
        assert not ENGLISH.search(KEPT.sub("", seen["said"])), (name, seen["said"])
    # What stands in a file is not translated.
    assert '"# unit: waves"' in opened(page, "file.csv", FAULTS["no unit of coefficients"][0])["said"]
    assert "nicht 0.5" in opened(page, "file.toml", MORE_FAULTS["sections"][0])["said"]


def test_errors_name_the_line_and_what_is_allowed_and_change_nothing(visit: Callable[..., Any]) -> None:
    page = visit("/mounted?controls=numbers#side=32&coma=1")
    before = state(page)
    for name, (text, suffix, told) in FAULTS.items():
        seen = opened(page, f"file{suffix}", text)
        assert not seen["taken"], name
        assert seen["said"].startswith(f"file{suffix}: "), name
        for part in told:
            assert part in seen["said"], (name, part, seen["said"])
        assert seen["state"] == before, name
    assert opened(page, "big.toml", "# " + "x" * 1_000_001)["said"].endswith("the limit is 1000000.")
    assert opened(page, "good.toml", GOOD)["taken"]
    assert page.locator(".notice").is_hidden()
