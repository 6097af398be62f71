"""Differentiable PSFs: matrix products inside NumPy, JAX, PyTorch, CuPy or any array API."""
