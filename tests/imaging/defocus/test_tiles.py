"""Tiles of photographs tell what the whole does."""

from __future__ import annotations

import numpy as np

import lommel as lm
from lommel.imaging import defocus_depth
from planes import CAMERA, PAIR, PIXEL, shoot, texture


def test_tiles_tell_what_the_whole_does(monkeypatch):
    images = [one[:, :100] for one in shoot(texture(side=152), 1.5, PAIR)]
    whole = lm.imaging.depth_from_defocus(images, PAIR, PIXEL, **CAMERA)
    monkeypatch.setattr(defocus_depth, "_CORE", 48)
    seen = []
    parts = lm.imaging.depth_from_defocus(images, PAIR, PIXEL, progress=lambda *at: seen.append(at), **CAMERA)
    assert seen[-1] == (9, 9)
    known = np.isfinite(whole.deviation) & np.isfinite(parts.deviation)
    assert known.mean() > 0.97
    # The weights are those of each tile's own texture.
    assert np.median(np.abs(parts.depth - whole.depth)[known] / whole.deviation[known]) < 0.1
    assert np.abs(parts.depth - whole.depth)[known].max() < 3.0 * whole.deviation[known].max()
    assert np.abs(parts.sharp - whole.sharp)[8:-8, 8:-8].std() < 0.1 * (whole.sharp - images[0])[8:-8, 8:-8].std()


def test_mirrored_copies_are_not_counted_as_pixels():
    images = shoot(texture(), 1.5, PAIR)
    found = lm.imaging.depth_from_defocus(images, PAIR, PIXEL, **CAMERA)
    parts = np.s_[20:-20, 20:-20], np.s_[:2, 20:-20], np.s_[:3, :3]
    inner, edge, corner = (np.median(found.deviation[part]) for part in parts)
    assert edge > 1.1 * inner
    assert corner > 1.3 * inner
    few = lm.imaging.depth_from_defocus([one[:2, :2] for one in images], PAIR, PIXEL, **CAMERA)
    assert few.deviation.min() > 4.0 * inner
