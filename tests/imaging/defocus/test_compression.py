"""Photographs compressed as JPEG, and those by which nothing can be tested."""

from __future__ import annotations

import io

import numpy as np
import pytest
from PIL import Image

from lommel.imaging.defocus_verdict import DefocusVerdict
from lommel.imaging.pair_noise import is_compressed
from lommel.recorded.noise import Noise


@pytest.mark.parametrize("quality", [75, 95, None])
def test_blocks_of_jpeg_are_found_and_only_these(quality):
    rng = np.random.default_rng(3)
    scene = 120.0 + 60.0 * np.sin(np.arange(240) / 7.0)[:, None] * np.cos(np.arange(200) / 5.0)
    values = np.round(scene + rng.normal(0.0, 2.0, scene.shape)).astype(np.uint8)
    if quality is not None:
        file = io.BytesIO()
        Image.fromarray(values).save(file, "JPEG", quality=quality)
        values = np.asarray(Image.open(file))
    # Cropping moves the edges of blocks.
    assert is_compressed((values[3:, 5:] / 255.0) ** 2.2) == (quality is not None)


def test_a_verdict_by_which_nothing_is_tested_is_not_reliable():
    noise = Noise(white=5e3, read=2.0)
    verdict = DefocusVerdict.of(1.0, noise=noise, compressed=True)
    assert not verdict.reliable
    assert verdict.findings.get("undetermined").severity == "doubt"
    assert "use raw images or PNG" in verdict.findings.get("untested").numbers["what"][0]
    assert "undetermined" not in DefocusVerdict.of(1.0, 1.0, 0.03, noise=noise).findings.codes
