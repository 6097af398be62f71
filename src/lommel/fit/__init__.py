"""Estimation from images: scoring, score tests, goodness of fit, and the findings that make a verdict."""

from lommel.fit.findings import CODES, Finding, Findings, FitReport
from lommel.fit.score_tests import ScoreTest

__all__ = ["CODES", "Finding", "Findings", "FitReport", "ScoreTest"]
