"""PSFs as matrix products, inside NumPy, JAX, PyTorch, CuPy or any array API: differentiable, and as certified."""
