"""
Accuracy and speed of all methods
=================================

One PSF of a defocused lens, computed by every method of the package: largest error against computing time.
"""

import time

import matplotlib.pyplot as plt
import numpy as np

import lommel as lm

# %%
# A 50 mm lens at f/8, an object out of focus by :math:`C_d` of about 20 radians (6.3 waves), an image of 129 x 129
# samples. Lommel's series, exact for pure defocus, is the reference: nothing in it is shared with the other methods
# but the Bessel functions.

lens = lm.Lens(focal_length=50e-3, f_number=8.0, focus_distance=2.0, wavelength=550e-9)
pupil = lens.pupil(0.8217)
size = {"shape": 129, "pixel": 0.5 * pupil.scale, "dtype": "float64", "threads": 1}


def image(method: lm.methods.Method) -> lm.PSF:
    """Return samples, or averages over pixels from Geometric, which has no point values."""
    return lm.psf(pupil, method=method, integrate=None if method.sampling == "pixel" else False, **size)


exact = image(lm.paper.LommelSeries())


def measure(method: lm.methods.Method) -> tuple[float, float]:
    """Return the time of the fastest of a few runs, after one to warm up, and the peak error."""
    start = time.perf_counter()
    answer = image(method)
    first = time.perf_counter() - start
    times = []
    for _ in range(1 if first > 0.2 else 5):
        start = time.perf_counter()
        image(method)
        times.append(time.perf_counter() - start)
    return min(times), max(lm.peak_error(answer, exact), 1e-16)


families = {
    "NijboerZernike(tol)": [lm.methods.NijboerZernike(tol) for tol in (1e-3, 1e-6, 1e-9, 1e-11)],
    "Hankel(tol)": [lm.methods.Hankel(tol) for tol in (1e-4, 1e-9, 1e-14)],
    "Fraunhofer(samples)": [lm.paper.Fraunhofer(samples) for samples in (96, 128, 256, 512, 1024)],
    'Fraunhofer(samples, edge="grey")': [lm.paper.Fraunhofer(n, edge="grey") for n in (96, 128, 256, 512, 1024)],
    "ClosedForm(), three error functions": [
        lm.paper.ClosedForm(erf=erf)
        for erf in (lm.paper.FresnelErf(), lm.paper.TableErf(), lm.paper.AbramowitzErf(30))
    ],
    "ClosedForm.best()": [lm.paper.ClosedForm.best(pupil, size["shape"], size["pixel"])],
    "TunedClosedForm(tol)": [lm.paper.TunedClosedForm(tol) for tol in (1e-2, 1e-3, 1e-4, 1e-5)],
    "HuygensFresnel()": [lm.paper.HuygensFresnel()],
    "Geometric()": [lm.paper.Geometric()],
}

# %%
# Points to the upper left are faster and less accurate. Bars above points are proven error bounds.

figure, axes = plt.subplots(figsize=(9.5, 5.8), layout="constrained")
for k, (name, methods) in enumerate(families.items()):
    points = np.array([measure(method) for method in methods])
    axes.plot(points[:, 0] * 1e3, points[:, 1], "o-", color=f"C{k}", label=name, linewidth=1.2)
    for method, (seconds, error) in zip(methods, points, strict=True):
        bound = image(method).error_bound
        if bound is not None:
            axes.plot([seconds * 1e3] * 2, [error, bound], color=f"C{k}", linewidth=0.8)
            axes.plot(seconds * 1e3, bound, "_", color=f"C{k}", markersize=9)
        print(f"{method!r:90.90} {1e3 * seconds:9.3f} ms   error {error:.1e}")
axes.set_xscale("log")
axes.set_yscale("log")
axes.set_ylim(3e-17, 3)
axes.set_xlabel("time (ms), one thread")
axes.set_ylabel("largest error over the peak")
axes.grid(alpha=0.3)
axes.legend(loc="lower right", fontsize=9)
plt.show()

# %%
# Two points are not errors of a method: ``HuygensFresnel`` uses exact distances and differs by the Fresnel
# approximation of all others; ``Geometric`` ignores diffraction and is pixel-integrated. Times are those of the
# machine that built these pages; ``NijboerZernike``, ``TunedClosedForm`` and ``HuygensFresnel`` are compiled, the
# others use NumPy and SciPy.
