"""Findings of the checks of a result, and the verdict that follows from them."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, Literal, TypeAlias, get_args

import numpy as np

from lommel.base.arrays import fields_of, plain

Severity: TypeAlias = Literal["error", "doubt", "note"]

CODES: Mapping[str, str] = {
    "another_minimum": "another set of parameters, far from the estimate, fits as well",
    "asymmetric": "the profile of an edge is not symmetric: another encoding, clipping, or coma",
    "below_offset": "most counts are below the offset that was stated",
    "blur_compared": "other blurs were compared with the stated one",
    "blur_doubtful": "the images agree better with a smaller blur than the stated one, or with motion",
    "blur_shape": "the most likely shape of the blur",
    "clipped": "noise or light of a side of an edge ends at one value",
    "compressed": "the images are compressed (JPEG), which changes their blur and noise",
    "contradiction": "values that were stated contradict each other, or what the images show",
    "correlated_noise": "noise of neighbours is correlated, or uneven, as of denoised or resized pictures",
    "crowded": "many images contain other molecules in addition to the fitted molecule",
    "curved_edge": "the edge is curved: a polynomial was fitted",
    "distance_estimated": "the distance of the scene was estimated from its blur",
    "errors_change": "a standard error changes within one standard deviation of the estimate",
    "estimated": "a stated value, or an effect that the model lacked, is estimated: the images favour it",
    "estimated_noise": "the noise is estimated from the images, which therefore cannot test it",
    "exchanged": "the images agree better in another order",
    "excess_noise": "the variance is that of an electron-multiplying camera, whose excess noise was not stated",
    "fewer_beads": "terms and constants are those of a part of the beads, with which the others are placed",
    "flat_top": "pixels have a full scale of 8 to 16 bits, or many have the largest value: they may be saturated",
    "gain": "the variance is that of another gain (electrons per count) than the stated one",
    "held_out": "data that were held out of the fit are inconsistent with it",
    "hot_pixels": "pixels of the camera are hot (brighter than their neighbours, whatever is in focus) or defective",
    "interrupted": "the search was interrupted: the result is that of the completed steps",
    "left_out": "some sources, windows, edges or pixels were left out",
    "lens_scale": "blurs differ by more, or less, than the stated lenses imply",
    "many_rejected": "many sources do not follow the fit",
    "missed_light": "the model misses a part of the light: errors hold between exposures of the same set-up",
    "measured_psf": "the PSF is a measured one: number of beads, noise, voxel and light on the rim",
    "missing_chunks": "chunks of a Zarr folder are missing, and count as dark",
    "misfit": "the images differ from the model by more than noise",
    "model_error": "images of the search differ from images with a proven error bound",
    "moved": "planes are shifted relative to the other planes",
    "multiples": "all values are multiples of an integer, such as 12 bits that are stored in 16",
    "no_counts": "the largest value is less than one electron, as of images that were divided by their full scale",
    "no_depth": "no depth was estimated: there is no texture, or all texture is out of range",
    "no_light": "the light of a source is within the noise",
    "not_flat": "a plane, or z over the field of a movie, is tilted or curved",
    "not_settled": "the steps of the search did not settle",
    "one_focus": "all depths are where frames are blurred alike, as with frames of one focus",
    "opposite_astigmatism": "the astigmatism is of the opposite sign, and z is reversed",
    "other_explanation": "an effect that the model lacks, or another value of a constant, explains the data better",
    "outliers": "single values are far from their neighbours",
    "pattern": "residuals have stripes, or offsets of rows or columns, as due to pick-up or readout",
    "pixel_pitch": "the pixel pitch is not that of the camera, or not that which the images state",
    "plane_light": "the light of the planes of a stack rises or falls along z, all over the field, as by fading",
    "psf_compared": "other PSFs were compared with the PSF of the fit, and none agrees better",
    "psf_doubtful": "photons that were held out agree better with another PSF",
    "rare_chi2": "noise alone seldom causes so large a chi2",
    "recurring": "sources are in the same place in many frames: beads, or hot pixels",
    "rejected": "sources that do not follow the fit were left out",
    "reversed_z": "planes in the reversed order fit far better",
    "saturation_assumed": "the smallest value of saturated pixels was estimated from the images",
    "scatter": "values scatter by more than their standard errors",
    "sharpened": "the photograph was sharpened, or has more noise than stated",
    "sign_open": "the sign of the even terms is ambiguous: another wavefront has the same images",
    "stated": "a stated value that is used without a test",
    "tilted_background": "the background of images is not flat, but tilted",
    "tone_curve": "the noise is that of light behind a tone curve, which was not stated",
    "too_dim": "too little light: images are not linear within the standard errors, and other wavefronts fit as well",
    "too_quiet": "the images are less noisy than gain, offset and read noise state, or than light is",
    "unchecked": "the checks of the fit that take long were omitted",
    "undetermined": "the images do not determine a parameter",
    "uneven_background": "a floor of light between structures may be a background that is not flat",
    "uneven_light": "the light on both sides of an edge changes across the picture",
    "unit_sum": "the images sum to 1, as PSFs do and electrons do not",
    "unlike_directions": "the sharpness in the centre differs between two directions: motion or astigmatism",
    "unlike_sides": "the sharpness differs between left and right, or top and bottom: a tilted lens or chart",
    "untested": "values or effects that these images do not test, exclude or determine",
    "z_range": "many fits end at a limit of the range of z",
}
"""Codes of findings, and their meanings."""

_SEVERITIES: tuple[Severity, ...] = get_args(Severity)
# Pixels or values that may be the cause of anything that is found.
_DATA = ("flat_top", "multiples", "no_counts", "unit_sum")
# Findings that name what is wrong: they are printed before the statistics that show that something is.
_CAUSES = (
    "contradiction", "pixel_pitch", "reversed_z", "exchanged", "opposite_astigmatism", "excess_noise",
    "gain", "other_explanation", "hot_pixels", "pattern", "lens_scale", "one_focus", "left_out",
    "missing_chunks",
)  # fmt: skip
_MOST_CHARACTERS = 800  # of the texts of findings that are printed: ten lines
_MOST_LINES = 12  # of a result
_MOST_WORDS = 15  # of the finding "untested"


@dataclass(frozen=True)
class Finding:
    """A finding of a check of a result.

    Parameters
    ----------
    code : str
        One of ``lommel.fit.CODES``, such as "misfit".
    severity : {"error", "doubt", "note"}
        "error": the result did not converge. "doubt": the result is not reliable. "note": no effect on the verdict.
    text : str
        The finding and advice, in a sentence without initial capital and final period.
    numbers : mapping of str to number or text
        The numbers in the sentence, such as ``{"chi2": 3.1, "limit": 1.2}``.

    Raises
    ------
    ValueError
        If there is no such code or severity.
    """

    code: str
    severity: Severity
    text: str
    numbers: Mapping[str, Any] = field(default_factory=dict)

    def __post_init__(self) -> None:
        for name, value, choices in (("code", self.code, CODES), ("severity", self.severity, _SEVERITIES)):
            if value not in choices:
                raise ValueError(f"{name} must be one of {', '.join(choices)}, got {value!r}")

    def __str__(self) -> str:
        return self.text

    def to_dict(self) -> dict[str, Any]:
        """Return the finding as plain data.

        Returns
        -------
        dict
        """
        data: dict[str, Any] = plain(fields_of(self))
        return data


class Findings(tuple[Finding, ...]):
    """Findings of one result, errors first, then doubts, then notes; a tuple, from which the verdict follows.

    Parameters
    ----------
    findings : iterable of Finding
    """

    __slots__ = ()

    def __new__(cls, findings: Iterable[Finding] = ()) -> Findings:
        """Sort findings by severity; findings of the same severity keep their order."""
        return super().__new__(cls, sorted(findings, key=lambda finding: _SEVERITIES.index(finding.severity)))

    @property
    def converged(self) -> bool:
        """Whether no finding is an error."""
        return not any(finding.severity == "error" for finding in self)

    @property
    def reliable(self) -> bool:
        """Whether no finding is an error or a doubt."""
        return all(finding.severity == "note" for finding in self)

    @property
    def status(self) -> str:
        """The code of the first error, else "doubtful" or "converged"."""
        if not self.converged:
            return self[0].code
        return "converged" if self.reliable else "doubtful"

    @property
    def codes(self) -> tuple[str, ...]:
        """The codes, in order of decreasing severity."""
        return tuple(finding.code for finding in self)

    @property
    def printed(self) -> Findings:
        """The findings in the order in which they are printed: named causes first, what is not tested last.

        A note on what was estimated is no reason of a doubt, which comes before it.
        """
        found = sorted(self, key=lambda finding: place_of(finding.code, finding.severity, self.reliable))
        if self.status == "doubtful" and (found[0].code, found[0].severity) == ("estimated", "note"):
            reason = next(one for one in found if one.severity != "note")
            found.sort(key=lambda finding: finding is not reason)
        return tuple.__new__(Findings, found)

    @property
    def text(self) -> str:
        """The texts of the findings in the order of `printed`, separated by semicolons; at most ten lines."""
        return "; ".join(shortened([(finding.code, finding.text) for finding in self.printed]))

    def get(self, code: str) -> Finding | None:
        """Return the first finding with a code.

        Parameters
        ----------
        code : str

        Returns
        -------
        Finding or None
        """
        return next((finding for finding in self if finding.code == code), None)


def place_of(code: str, severity: str, reliable: bool) -> int:
    """Return the place of a finding among those printed, ascending: below 0 for causes; `reliable`: of the result."""
    if code in _DATA:
        return 1 if reliable else -3
    is_cause = code == "estimated" or (code in _CAUSES and severity != "note")
    return -2 if is_cause else {"missed_light": -1, "untested": 2}.get(code, 0)


def in_words(findings: Iterable[Finding], severity: Severity = "doubt") -> list[str]:
    """Return a sentence for each finding of a severity."""
    return [f"{one.text[0].upper()}{one.text[1:]}." for one in findings if one.severity == severity]


def shortened(findings: Sequence[tuple[str, str]]) -> list[str]:
    """Return the texts of findings (code, text), at most ten lines; the codes of the others are in the last text.

    The first text, and a summary, which has no code, are never left out.
    """
    lengths = np.cumsum([len(text) * bool(code) for code, text in findings])
    kept = [k == 0 or not code or lengths[k] <= _MOST_CHARACTERS for k, (code, _) in enumerate(findings)]
    texts = [text for (_, text), is_kept in zip(findings, kept, strict=True) if is_kept]
    others = dict.fromkeys(code for (code, _), is_kept in zip(findings, kept, strict=True) if not is_kept)
    return [*texts, *([f"and {', '.join(others).replace('_', ' ')}: see findings, --json"] if others else [])]


def untested_finding(items: Sequence[str], numbers: Mapping[str, Any], state: str = "not tested") -> Finding:
    """Return the note on effects that may be present, in at most 15 words; all `items` are in ``numbers["what"]``.

    Items are names, the most important first, with explanations in brackets. `state` is two words: "not tested", "not
    excluded" (tested, but possible up to the size in brackets) or "not determined" (values that are only stated).
    """
    names, count = [item.partition(" (")[0] for item in items], len(items)
    texts = [", ".join(items), ", ".join(names)]
    texts += [f"{', '.join(names[:k])} and {count - k} more" for k in range(count - 1, 0, -1)]
    first = f"{' '.join(names[0].split()[: _MOST_WORDS - 6])} ..." + f" and {count - 1} more" * (count > 1)
    text = next((text for text in texts if len(text.split()) <= _MOST_WORDS - 2), first)
    return Finding("untested", "note", f"{state}: {text}", {**numbers, "what": list(items)})


class Judged:
    """A result with `findings`, from which its verdict follows."""

    findings: Findings

    @property
    def converged(self) -> bool:
        """Whether no finding is an error: the model explains what was recorded."""
        return self.findings.converged

    @property
    def reliable(self) -> bool:
        """Whether no finding is an error or a doubt: estimates and standard errors are reliable."""
        return self.findings.reliable

    @property
    def status(self) -> str:
        """The code of the first error, "doubtful", or "converged"."""
        return self.findings.status

    def _message(self, summary: str) -> str:
        """Return status, named causes, summary and the texts of the other findings."""
        status_text = {"doubtful": "converged, but in doubt"}.get(self.status, self.status.replace("_", " "))
        printed = self.findings.printed
        texts = [(finding.code, finding.text) for finding in printed]
        places = [place_of(finding.code, finding.severity, self.reliable) for finding in printed]
        causes = max((k for k, place in enumerate(places, 1) if place < 0), default=0)
        texts.insert(causes, ("", summary))
        return f"{status_text}: {'; '.join(shortened(texts))}"


@dataclass(frozen=True, eq=False, repr=False, kw_only=True)
class FitReport(Judged):
    """Base class of the results of fits: findings, the verdict that follows from them, and plain data.

    Attributes
    ----------
    findings : Findings
        Findings of the checks of the fit; empty if there are none.
    summary : str
        Goodness of fit, and numbers such as the number of steps.
    """

    findings: Findings
    summary: str

    @property
    def message(self) -> str:
        """Status, named causes, summary and the texts of the other findings, at most twelve lines."""
        return self._message(self.summary)

    def __repr__(self) -> str:
        return self._shown([])

    def _shown(self, estimates: Sequence[str]) -> str:
        """Return the message and a line for each estimate, at most twelve lines."""
        lines = [f"<{type(self).__name__}: {self.message}", *(f"  {text}" for text in estimates)]
        if more := lines[_MOST_LINES:]:
            lines[_MOST_LINES - 1 :] = [f"  ... and {len(more) + 1} more: coefficients, errors"]
        return "\n".join(lines) + ">"

    def to_dict(self) -> dict[str, Any]:
        """Return the result as plain data for JSON, without images.

        Returns
        -------
        dict
            Status, converged, reliable, message, findings, and the numbers of the fit; None for numbers that are not
            finite.
        """
        verdict = {name: getattr(self, name) for name in ("status", "converged", "reliable", "message")}
        numbers: dict[str, Any] = plain(fields_of(self))
        return verdict | numbers
