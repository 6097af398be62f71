"""The way back: what a scene was before a known blur."""
