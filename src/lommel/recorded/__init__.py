"""Images as a camera recorded them: values, known and saturated pixels, noise, and where they come from."""
