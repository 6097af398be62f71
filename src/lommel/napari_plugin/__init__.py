"""Plugin of napari: a PSF and a deconvolution widget, sample data, and a reader of PSF files; see napari.yaml."""
