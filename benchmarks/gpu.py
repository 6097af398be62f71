"""Traced plans on a graphics processor: ``python -m benchmarks.gpu --framework torch --out gpu.json``.

For each case images and gradients a second at the best batch, bytes and the share of what the bandwidth of the memory
allows, measured first, images a second of the compiled core with a thread for each processor of the same machine, and
errors against it, with products rounded to TF32 and not.
"""

from __future__ import annotations

import argparse
import json
import statistics
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager, nullcontext
from pathlib import Path
from typing import Any

import numpy as np

import lommel as lm
from lommel.base import atomic

_ROUNDS, _SECONDS, _JUDGED = 20, 2.0, 64
_TERMS = [(2, 0), (2, 2), (2, -2), (3, 1), (3, -1), (3, 3), (3, -3), (4, 0), (4, 2), (4, -2), (4, 4), (4, -4), (5, 1)]


class Device:
    """A framework on its device: arrays, waiting, and clocks."""

    def __init__(self, framework: str, where: str | None) -> None:
        self.framework = framework
        if framework == "torch":
            import torch

            self.xp, self.device = torch, torch.device(where or ("cuda" if torch.cuda.is_available() else "cpu"))
            self.name = torch.cuda.get_device_name() if self.device.type == "cuda" else self.device.type
        elif framework == "jax":
            import jax

            jax.config.update("jax_enable_x64", True)
            if where is not None:
                jax.config.update("jax_default_device", jax.devices(where)[0])
            self.xp, self.device = jax.numpy, None
            self.name = jax.devices(where)[0].device_kind
        else:
            import cupy

            self.xp, self.device = cupy, None
            self.name = cupy.cuda.runtime.getDeviceProperties(0)["name"].decode()

    def array(self, values: Any) -> Any:
        """Return an array of float64 there."""
        own = np.array(values)
        return self.xp.asarray(own) if self.device is None else self.xp.asarray(own, device=self.device)

    def wait(self, made: Any) -> None:
        """Wait until something has been computed."""
        if self.framework == "torch":
            if self.device.type == "cuda":
                self.xp.cuda.synchronize()
        elif self.framework == "jax":
            made.block_until_ready()
        else:
            self.xp.cuda.Stream.null.synchronize()

    def seconds(self, run: Callable[[], Any]) -> float:
        """Return the median time of a call, of fewer where a call takes long."""
        self.wait(run())
        times: list[float] = []
        while len(times) < 3 or (len(times) < _ROUNDS and sum(times) < _SECONDS):
            begin = time.perf_counter()
            self.wait(run())
            times.append(time.perf_counter() - begin)
        return statistics.median(times)

    def compiled(self, function: Callable[[Any], Any]) -> Callable[[Any], Any]:
        """Return a function compiled where that is usual."""
        if self.framework == "jax":
            import jax

            return jax.jit(function)
        return function

    def gradient(self, function: Callable[[Any], Any]) -> Callable[[Any], Any] | None:
        """Return the gradient of a sum of squares, where there are any."""
        if self.framework == "jax":
            import jax

            return jax.jit(jax.grad(lambda c: (function(c) ** 2).sum()))
        if self.framework == "cupy":
            return None

        def of(c: Any) -> Any:
            given = c.detach().requires_grad_(True)
            return self.xp.autograd.grad((function(given) ** 2).sum(), given)[0]

        return of

    @contextmanager
    def rounded(self, to_tf32: bool) -> Iterator[None]:
        """Let products of float32 be rounded, where a flag says so."""
        if self.framework != "torch":
            with nullcontext():
                yield
            return
        before = self.xp.get_float32_matmul_precision()
        self.xp.set_float32_matmul_precision("high" if to_tf32 else "highest")
        try:
            yield
        finally:
            self.xp.set_float32_matmul_precision(before)


def cases(precision: str) -> dict[str, tuple[lm.Plan, lm.Pupil]]:
    """Return plans and stacks of pupils: radial windows of three sides, averages, and fifteen terms or so."""
    draw = np.random.default_rng(0)
    radial = lm.Pupil(lm.Wavefront(*(draw.uniform(-1, 1, (2, _JUDGED)) * [[10.0], [1.0]])))
    edge = draw.normal(size=(_JUDGED, len(_TERMS)))
    edge *= 2.0 / np.linalg.norm(edge, axis=1, keepdims=True)
    terms = lm.Pupil(lm.Wavefront.zernike(dict(zip(_TERMS, edge.T, strict=True)), normalization="edge"))
    # What is proven of float32 is stated, not asked for.
    tol: dict[str, Any] = {"tol": 1e-6 if precision == "float64" else 9e-2, "dtype": np.float32}
    return {
        "33": (lm.Plan(33, 0.5, **tol), radial),
        "64": (lm.Plan(64, 0.5, **tol), radial),
        "512": (lm.Plan(512, 0.25, **tol), radial),
        "33, averages": (lm.Plan(33, 0.5, integrate=True, **tol), radial),
        "33, terms": (lm.Plan(33, 0.5, **tol), terms),
    }


def bandwidth(on: Device) -> float:
    """Return bytes a second of a copy, read and written."""
    much = on.array(np.zeros(2**27))  # so much that the call itself takes no part of the time
    run = on.compiled(lambda a: a + 1.0)
    return 2.0 * 8.0 * 2**27 / on.seconds(lambda: run(much))


def measure(on: Device, name: str, plan: lm.Plan, pupils: lm.Pupil, precision: str, largest: int) -> dict[str, Any]:
    """Return what was measured of a case."""
    f = plan.traced(pupils, on.xp, device=on.device, precision=precision)
    ns = f._static.namespace
    c = pupils.wavefront.edge if isinstance(f.terms[0], tuple) else _powers(pupils)
    exact = lm.psf(pupils, f.shape, plan._sampled.pixel, tol=1e-9, integrate=plan.integrate).values
    images, bound = f.certified(on.array(c))
    error = np.abs(ns.to_numpy(images).astype(np.float64) - exact).max(axis=(1, 2)) / exact.max(axis=(1, 2))
    told = np.asarray(ns.to_numpy(bound), dtype=np.float64)
    found: dict[str, Any] = {
        "case": name,
        "precision": precision,
        "error": float(error.max()),
        "bound": float(told.max()),
        "kept": bool((error <= told).all()),
    }
    run, gradient = on.compiled(lambda c: f(c, check=False)), on.gradient(lambda c: f(c, check=False))
    for way, call in (("images", run), ("gradients", gradient)):
        best, most = 0.0, max(1, largest // (f.shape[0] * f.shape[1]))
        for batch in sorted({min(most, 2**k) for k in range(10, 21, 2)}) if call else []:
            many = on.array(np.tile(c, (batch // _JUDGED + 1, 1))[:batch])
            try:
                best = max(best, batch / on.seconds(lambda call=call, many=many: call(many)))
            except (MemoryError, RuntimeError) as full:  # each framework has its own
                found[f"{way}, stopped"] = f"at a batch of {batch}: {str(full)[:200]}"
                break
        found[f"{way} a second"] = best or None
    found["images a second of the core"] = core_rate(plan, pupils)
    nodes, points = f.tables[0]["table"].shape if "table" in f.tables[0] else (0, 0)
    width = 8 if precision == "float64" else 4
    found["bytes"] = 4.0 * width * (nodes + points) + 4.0 * f.shape[0] * f.shape[1] if nodes else None
    return found


def core_rate(plan: lm.Plan, pupils: lm.Pupil) -> float:
    """Return images a second of the compiled core, with a thread for each processor."""
    many = pupils[np.tile(np.arange(_JUDGED), max(1, 2**21 // plan(pupils).values.size))]
    times: list[float] = []
    while len(times) < 4:
        begin = time.perf_counter()
        plan(many)
        times.append(time.perf_counter() - begin)
    return float(many.shape[0] / statistics.median(times[1:]))


def _powers(pupils: lm.Pupil) -> np.ndarray:
    return pupils.coefficients() * [0.5, 1.0]


def main() -> None:
    """Measure all cases, print them, and write them to a file."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--framework", choices=("torch", "jax", "cupy"), default="torch")
    parser.add_argument("--device", help="as the framework calls it, such as cpu; else that which it prefers")
    parser.add_argument("--out", type=Path)
    parser.add_argument("--largest", type=int, default=2**30, help="pixels of a batch, at most")
    asked = parser.parse_args()
    on = Device(asked.framework, asked.device)
    report: dict[str, Any] = {"device": on.name, "bandwidth": bandwidth(on), "rows": []}
    print(f"{on.name}: {report['bandwidth']:.3g} bytes/s")
    for to_tf32 in (False, True) if asked.framework == "torch" else (False,):
        for precision in ("float64", "float32"):
            for name, (plan, pupils) in cases(precision).items():
                with on.rounded(to_tf32):
                    try:
                        row = measure(on, name, plan, pupils, precision, asked.largest)
                    except lm.ToleranceError as fault:
                        row = {"case": name, "precision": precision, "refused": str(fault)}
                row["TF32"] = to_tf32
                if row.get("bytes"):
                    row["share of the bandwidth"] = row["images a second"] * row["bytes"] / report["bandwidth"]
                report["rows"].append(row)
                print(json.dumps(row))
    if asked.out:
        atomic.write(asked.out, json.dumps(report, indent=1).encode())


if __name__ == "__main__":
    main()
