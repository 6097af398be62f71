"""What notebooks show: plots beside numbers, in the colours of any page, without raising."""

from __future__ import annotations

import base64
import io
import re
from html.parser import HTMLParser
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
import pytest
from PIL import Image

import lommel as lm
from lommel.show import notebook

CAMERA = {"wavelength": 550e-9, "f_number": 4.0}
WAVEFRONT = lm.Wavefront(1.0, nonradial={(3, 1): 1.5})
ASKED = {"pixel": 0.5, "terms": [(3, 1)], "defocus": [-2.0, 2.0]}
LENS = lm.Lens(focal_length=50e-3, f_number=1.8, focus_distance=2.0, wavelength=550e-9)
OIL = Path(__file__).parents[2] / "examples" / "objectives" / "zeiss-63x-1.4-oil.toml"
OBJECTIVE = lm.Objective(
    NA=1.2, magnification=60, immersion=1.333, working_distance=0.28e-3, coverslip=lm.Layer(1.52, 170e-6), sample=1.36
)


class Told(HTMLParser):
    """The words of a page and its pictures; fails where elements do not nest."""

    def __init__(self, page: str) -> None:
        super().__init__()
        self.open: list[str] = []
        self.words: list[str] = []
        self.pictures: list[np.ndarray] = []
        self.feed(page)
        self.close()
        assert not self.open

    def handle_starttag(self, tag, attrs):
        if tag == "img":
            data = dict(attrs)["src"].removeprefix("data:image/png;base64,")
            self.pictures.append(np.asarray(Image.open(io.BytesIO(base64.b64decode(data)))))
        elif tag != "br":
            self.open.append(tag)

    def handle_endtag(self, tag):
        assert self.open.pop() == tag

    def handle_data(self, data):
        self.words.append(data)


def told(thing) -> tuple[dict[str, str], list[np.ndarray], list[str]]:
    page = thing._repr_html_()
    assert not re.search(r"#[0-9a-f]{3}|white|black|rgb", re.sub(r"base64,[^\"]*", "", page))
    found = Told(page)
    # The table comes last, after the title.
    names = Told(page[page.index("<table") : page.index("</table>") + 8]).words
    return dict(zip(names[::2], names[1::2], strict=True)), found.pictures, found.words


def things() -> dict[str, object]:
    stack = lm.Wavefront(np.arange(6.0).reshape(2, 3))
    stars = 3e4 * lm.psf(lm.Pupil(lm.Wavefront([-2.0, 2.0], nonradial={(3, 1): 1.5})), 17, 0.5).values
    noise = lm.Noise(read=2.0)
    return {
        "PSF": lm.psf(lm.Pupil(WAVEFRONT, **CAMERA), 33, 1e-6),
        "PSFs": lm.psf(lm.Pupil(stack), 9, 0.5),
        "Pupil": lm.Pupil(WAVEFRONT, obscuration=0.3, spider=lm.Spider.equal(3, width=0.05), **CAMERA),
        "Pupils": LENS.pupil([1.5, 2.0, 3.0]),
        "Wavefront": WAVEFRONT,
        "Wavefronts": stack,
        "Lens": LENS,
        "ObjectivePupil": OBJECTIVE.pupil(depth=1e-6, z=np.arange(3) * 1e-6, wavelength=520e-9),
        "Microscope": lm.load_microscope(OIL),
        "PSFGrid": lm.FieldMap.from_seidel(20.0, W131=1.0).grid(2, 3, sensor=(20, 30), shape=(9, 7), pixel=0.5),
        "Retrieval": lm.retrieve(noise.record(stars, seed=1), lm.Pupil(), noise=noise, **ASKED),
    }


@pytest.fixture(scope="module")
def shown() -> dict[str, object]:
    return things()


@pytest.mark.parametrize("name", ["PSF", "PSFs", "Pupil", "Pupils", "Wavefront", "Wavefronts", "Lens", "PSFGrid"])
def test_things_are_shown_as_their_plot_and_a_table(name, shown):
    rows, (picture,), words = told(shown[name])
    assert words[0].startswith(name.removesuffix("s") if name != "Lens" else name)
    assert rows
    assert np.ptp(picture[..., :3]) > 200
    assert not any("Error" in word for word in words)
    assert not plt.get_fignums()


def test_the_table_of_a_psf_has_its_numbers(shown):
    psf = shown["PSF"]
    rows, _, _ = told(psf)
    assert rows["pixels"] == "33 × 33 of 1 µm, averaged over each pixel"
    assert rows["largest value"] == f"{psf.values.max():.4g}"
    assert rows["light in the window"] == f"{psf.values.sum(dtype=float):.4g}"
    assert rows["error bound"] == f"{psf.error_bound:.2g} of the peak"
    assert rows["pupil"] == "550 nm, f/4"


def test_the_table_of_a_pupil_says_over_what_its_terms_are(shown):
    rows, _, _ = told(shown["Pupil"])
    assert rows["coma x"] == f"{1.5 / np.sqrt(8) / (2 * np.pi):.3g} waves rms over the full disc"
    assert "rms" not in rows  # over what vanes leave that takes long
    assert rows["aperture"] == "obscured to 0.3, spider"


def test_of_a_stack_up_to_four_members_are_drawn():
    assert notebook._part(np.arange(30).reshape(3, 10), (3, 10)).tolist() == [10, 13, 16, 19]
    assert notebook._part(np.arange(4), (4,)).tolist() == [0, 1, 2, 3]


def test_numbers_are_said_in_units(shown):
    rows, _, _ = told(LENS)
    assert rows["focal length"] == "50 mm"
    assert rows["focused at"] == "2 m"
    assert told(shown["PSFs"])[0]["stack"] == "W020 0 waves to W020 1.59 waves"
    assert told(shown["ObjectivePupil"])[0]["stage"] == "0 m to 2 µm"
    assert told(shown["Microscope"])[0]["objective"] == "NA 1.4, 63x, immersion 1.518"
    assert told(shown["PSFGrid"])[0]["sensor"] == "20 λN × 30 λN"
    found = shown["Retrieval"]
    assert told(found)[0]["noll 8 coma x"].startswith(f"{found.coefficients[3, 1]:.4g} ± ")


def test_what_cannot_be_told_is_told_why_and_nothing_is_raised():
    near = lm.Lens(focal_length=50e-3, f_number=2.0, sensor_distance=40e-3, wavelength=550e-9)
    _, pictures, words = told(near)
    assert not pictures
    assert words[1].startswith("object_distance must be given: no object is in focus")
    # However long a text is, and whatever stands in it.
    page = notebook._html(
        "<b>", [("a & b", "<script>" * 99), ("x", lambda: 1 / 0)], lambda: lm.psf(lm.Pupil(), 9, 0.5).plot()
    )
    assert "<script>" not in page
    assert "division by zero" in page
    assert len(page.partition("<table")[2]) < 2000


@pytest.mark.parametrize(
    "pupil",
    [lm.Pupil(WAVEFRONT), lm.Pupil(WAVEFRONT, obscuration=0.5), lm.Pupil(WAVEFRONT, apodization=1.0)],
    ids=["disc", "annulus", "Gaussian"],
)
def test_the_rms_is_that_over_the_aperture(pupil):
    name = "rms over the clear aperture" if pupil.obscuration else "rms"
    assert told(pupil)[0][name] == f"{float(lm.rms(pupil, unit='waves')):.3g} waves"
    assert told(WAVEFRONT)[0]["rms"] == f"{float(lm.rms(WAVEFRONT, unit='waves')):.3g} waves"


def test_without_matplotlib_there_are_the_numbers():
    import subprocess
    import sys

    code = "import sys, lommel as lm\nfor name in ('matplotlib', 'PIL'): sys.modules[name] = None\n"
    code += "p = lm.Pupil(lm.Wavefront(3.0))\n"
    code += "pages = [x._repr_html_() for x in (p, p.wavefront, lm.psf(p, 9, 0.5))]\n"
    code += "print(all('<table' in x and '<img' not in x and '<i>' not in x for x in pages))"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True, timeout=300)
    assert done.stdout == "True\n"


@pytest.mark.parametrize(
    ("method", "bound"), [("hankel", r"\d(\.\d)?e-\d\d of the peak"), ("matrix-fourier", "none")]
)
def test_the_bound_of_a_psf_is_told_or_that_there_is_none(method, bound, monkeypatch):
    monkeypatch.setattr(notebook, "device", lambda _, rows, __: dict(rows))
    rows = notebook.psf(lm.psf(lm.Pupil(**CAMERA), 3, 1e-6, method=method))
    assert re.fullmatch(bound, rows["error bound"])
