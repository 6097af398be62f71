"""Apertures of telescopes from published dimensions: ELT, Hubble, James Webb, Keck, Subaru, VLT.

Each function returns an aperture for :class:`lommel.Pupil` or :class:`lommel.Lens`, in units of the radius of the
telescope's aperture. :data:`DIAMETERS` lists the diameters of the apertures in metres.
"""

from __future__ import annotations

import math
from functools import reduce
from operator import or_

from lommel.optics.aperture.shapes import Disc, Polygon, Segments, Shape

DIAMETERS = {"elt": 40.1758, "hst": 2.4, "jwst": 6.603464, "keck": 10.9668, "subaru": 7.92, "vlt": 8.0}
"""Diameter of each aperture in metres; for segmented mirrors, of the circle through the farthest corners."""


def elt() -> Segments:
    """Return the aperture of the Extremely Large Telescope: 798 hexagonal segments behind six vanes.

    The segments fill a hexagon whose six corners are cut off.

    The vanes are 0.4 m wide and point towards the cut corners.

    Returns
    -------
    Segments
        In units of 20.09 m, the distance of the farthest corners. The aperture is 39.05 m wide across opposite cuts.
        Segments have sides of 0.725 m, two of them parallel to x, and gaps of 4 mm.

    References
    ----------
    "The E-ELT Construction Proposal", European Southern Observatory (2011), figure 3.66, with the numbers of HCIPy,
    E. Por et al., Proc. SPIE 10703, 1070342 (2018), doi:10.1117/12.2314407. Later designs have wider vanes, and a
    round stop at the secondary mirror.
    """
    radius = 0.5 * DIAMETERS["elt"]
    pitch, side = (0.725 * math.sqrt(3.0) + 0.004) / radius, 0.725 / radius
    # A ring is the set of segments a number of steps from the axis; the mirror has rings 5 to 17. Corners of the
    # hexagon farther than 15.25 pitches from the axis are cut off.
    hexagons = [(a * math.sqrt(0.75), b + 0.5 * a, max(abs(a), abs(b), abs(a + b)))
                for a in range(-17, 18) for b in range(-17, 18)]  # fmt: skip
    corners = [(math.cos(t), math.sin(t)) for t in (math.pi / 6.0, math.pi / 2.0, 5.0 * math.pi / 6.0)]
    centers = [(pitch * x, pitch * y) for x, y, ring in hexagons
               if 5 <= ring <= 17 and all(abs(x * c + y * s) < 15.25 for c, s in corners)]  # fmt: skip
    segments = Segments(tuple(Polygon.regular(6, side, center) for center in centers))
    return segments - _spokes(6, 0.4 / radius, math.pi / 6.0)


def hst() -> Shape:
    """Return the aperture of the Hubble Space Telescope: obscuration 0.33, four vanes, three pads of the mirror.

    The vanes lie along x and y; the pads, discs near the edge, hold the primary mirror.

    Returns
    -------
    Shape
        In units of the radius, 1.2 m.

    References
    ----------
    J. E. Krist, R. N. Hook and F. Stoehr, "20 years of Hubble Space Telescope optical modeling using Tiny Tim",
    Proc. SPIE 8127, 81270J (2011), doi:10.1117/12.892762: radii, widths and positions of the file wfpcwf4.pup of
    Tiny Tim, July 2000. x and y are the telescope's axes V3 and V2. Obscurations inside the cameras are not included.
    """
    # Numbers from the file wfpcwf4.pup, in units of the radius of the mirror.
    vanes = Polygon.strip((-2.0, 0.0), (2.0, 0.0), 0.022), Polygon.strip((0.0, -2.0), (0.0, 2.0), 0.022)
    pads = [Disc(0.065, center) for center in ((0.8921, 0.0), (-0.4615, 0.7555), (-0.4564, -0.7606))]
    return Disc() - reduce(or_, [Disc(0.33), *vanes, *pads])


# Corners (V2, V3) of the segments A1, B1 and C1 in metres. Rotation by multiples of 60 degrees gives the other
# segments.
_JWST = (
    ((-0.38101, 0.667604), (-0.758826, 1.321999), (-0.38101, 1.976407),
     (0.38101, 1.976407), (0.758826, 1.321999), (0.38101, 0.667604)),
    ((0.38101, 3.279674), (0.758826, 2.631791), (0.38101, 1.98402),
     (-0.38101, 1.98402), (-0.758826, 2.631791), (-0.38101, 3.279674)),
    ((0.765201, 2.627516), (1.517956, 2.629178), (1.892896, 1.976441),
     (1.521076, 1.325812), (0.765454, 1.325807), (0.387649, 1.980196)),
)  # fmt: skip


def jwst() -> Segments:
    """Return the aperture of the James Webb Space Telescope: 18 segments behind three struts.

    The struts hold the secondary mirror.

    Returns
    -------
    Segments
        In units of 3.301732 m, in the order A1 to A6, B1 to B6, C1 to C6; :meth:`lommel.Segments.phased` sets the
        phase of each segment.

    References
    ----------
    P. A. Lightsey et al., "James Webb Space Telescope: large deployable cryogenic telescope in space", Opt. Eng. 51,
    011003 (2012), doi:10.1117/1.OE.51.1.011003. Corners in the coordinates V2, V3 from the transmission budget of
    Ball Aerospace (16 March 2010), as in WebbPSF; x is V2, y is V3.
    """
    radius = 0.5 * DIAMETERS["jwst"]
    shapes = [
        Polygon(tuple((x / radius, y / radius) for x, y in corners)).turned(-k * math.pi / 3.0)
        for corners in _JWST
        for k in range(6)
    ]
    lower = (Polygon.strip((0.0, 0.0), (3.3 * c, -3.3 * math.sqrt(0.75)), 0.12243) for c in (0.5, -0.5))
    upper = ((0.0, 3.3, 0.11887), (2.14627, 2.3645, 0.16519), (2.48335, 2.54445, 0.13959))
    struts = [*lower, *(Polygon.strip((0.0, start), (0.0, end), width) for start, end, width in upper)]
    return Segments(tuple(shapes)) - reduce(or_, [_scaled(strut, radius) for strut in struts])


def keck() -> Segments:
    """Return the aperture of the Keck telescopes: 36 hexagonal segments behind a central obscuration and six vanes.

    The vanes are 25.4 mm wide.

    Returns
    -------
    Segments
        In units of 5.4834 m, the distance of the farthest corners. Segments have sides of 0.9 m, two of them parallel
        to x, and gaps of 3 mm. The obscuration is a disc 2.65 m in diameter.

    References
    ----------
    J. Nelson, "Optical parameters of the Keck telescope", Keck Observatory Technical Note 163, rev. 3 (1991):
    segments of a = 0.9 m, a diameter of 10.949 m, to which the gaps are added here. Secondary mirror and vanes: notes
    on the Keck pupil of the Next Generation Adaptive Optics project (0.266 of 9.96 m; 25.4 mm); directions of the
    vanes as in HCIPy, E. Por et al., Proc. SPIE 10703, 1070342 (2018), doi:10.1117/12.2314407.
    """
    radius = 0.5 * DIAMETERS["keck"]
    segments = Segments.hexagonal(rings=3, gap=0.003 / radius) - Disc(0.5 * 2.65 / radius)
    return segments - _spokes(6, 0.0254 / radius)


def subaru() -> Shape:
    """Return the aperture of the Subaru telescope: an obscuration of 2.3 m and four vanes.

    The vanes are 0.1735 m wide in projection, at 51.75 degrees to the x axis, two vanes from each of two points on
    the x axis 0.639 m from the centre.

    Returns
    -------
    Shape
        In units of the radius, 3.96 m.

    References
    ----------
    N. Jovanovic et al., "The Subaru Coronagraphic Extreme Adaptive Optics system: enabling high-contrast imaging on
    solar-system scales", Publ. Astron. Soc. Pac. 127, 890 (2015), doi:10.1086/682989; dimensions of this instrument's
    pupil from the programs of F. Martinache (diameters, angle, offset) and M. Lucas (width of the vanes).
    """
    return _vaned(3.96, 1.15, ((0.639, 0.0), (-0.639, 0.0)), math.radians(51.75), 0.1735)


def vlt() -> Shape:
    """Return the aperture of the Very Large Telescope (UT1 to UT3): a central obscuration and four tangential vanes.

    The vanes are 40 mm wide: two vanes, 101 degrees apart, from each of two points on the x axis.

    Returns
    -------
    Shape
        In units of the radius, 4 m, which the secondary mirror determines. The obscuration is 1.116 m in diameter.

    References
    ----------
    ERIS pupil documentation VLT-SPE-AES-11310-0006, European Southern Observatory, as quoted by HCIPy, E. Por et al.,
    Proc. SPIE 10703, 1070342 (2018), doi:10.1117/12.2314407; equal within 3 % to the dimensions of G. Guerri et al.,
    Exp. Astron. 30, 59 (2011), doi:10.1007/s10686-011-9220-y. The pupil is rotated by 45 degrees here, so that the
    two points lie on the x axis.
    """
    offset = 0.4045 / math.cos(math.radians(45.0 - 5.5))
    return _vaned(4.0, 0.558, ((offset, 0.0), (-offset, 0.0)), math.radians(50.5), 0.040)


def _vaned(
    radius: float,
    obscuration: float,
    points: tuple[tuple[float, float], ...],
    angle: float,
    width: float,
) -> Shape:
    """Return a disc without a central obscuration and without two vanes from each point.

    The vanes run outwards from the point, at `angle` above and below the x axis. Lengths are in metres; `obscuration`
    is a radius.
    """
    blocked: list[Shape] = [Disc(obscuration / radius)]
    for x, y in points:
        # Vanes end outside the disc, whose rim cuts them off.
        outwards = math.copysign(2.0 * radius, x)
        ends = ((x + outwards * math.cos(angle), y + side * 2.0 * radius * math.sin(angle)) for side in (1.0, -1.0))
        blocked += [_scaled(Polygon.strip((x, y), end, width), radius) for end in ends]
    return Disc() - reduce(or_, blocked)


def _spokes(count: int, width: float, start: float = 0.0) -> Shape:
    """Return `count` vanes from the axis to outside the aperture, at equal angles beginning with `start` (rad)."""
    angles = (start + 2.0 * math.pi * k / count for k in range(count))
    return reduce(or_, (Polygon.strip((0.0, 0.0), (2.0 * math.cos(t), 2.0 * math.sin(t)), width) for t in angles))


def _scaled(part: Polygon, radius: float) -> Shape:
    """Return a polygon with its corners divided by `radius`."""
    return Polygon(tuple((x / radius, y / radius) for x, y in part.corners))
