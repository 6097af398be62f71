"""Pupils and fields of lenses that other packages trace rays through; each is imported when it is asked for."""
