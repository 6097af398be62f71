"""Images of stars over a field."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import numpy as np

from lommel.estimation.field_stars import FieldStars, SingleStars


def test_images_of_the_latest_parameters_are_not_computed_again():
    computed = []

    def images(chosen, waves, squared_widths, nuisance, *, fast, derivatives):
        computed.append((fast, derivatives, len(chosen)))
        return [np.array(len(computed)), waves]

    layout = {"exposures": 1, "width_count": 1, "parameters_per_image": 4, "size": 7, "degrees_of_freedom": 9}
    stars: Any = FieldStars.__new__(FieldStars)
    first_star = SimpleNamespace(directions=np.eye(2))
    vars(stars).update(layout, latest=[(None, b"", [])], images=images, first_star=first_star)
    model, x = SingleStars(stars, np.arange(3), 9.0), np.ones((3, 7))
    other = x.copy()
    other[2, 6] = 2.0
    assert [int(model.images(x)[0]) for _ in range(2)] == [1, 1]
    assert int(SingleStars(stars, np.arange(3), 9.0).images(x)[0]) == 1  # another model of the same stars
    assert int(SingleStars(stars, np.arange(1, 4), 9.0).images(x)[0]) == 2
    assert int(model.images(other)[0]) == 3
    assert int(model.images(other, fast=True)[0]) == 4
    assert int(SingleStars(stars.copy_with(blur=None), np.arange(3), 9.0).images(other, fast=True)[0]) == 5
    assert len(computed) == 5
