"""Reports on lenses, microscopes and PSFs, as facts for JSON and as tables."""
