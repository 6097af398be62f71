"""The light beyond the windows of a bank, so that nothing of a PSF is lost."""
