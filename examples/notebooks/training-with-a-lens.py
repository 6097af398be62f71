# %% [markdown]
# # Training with a lens in the loop
#
# The focus distance of a lens and a filter that sharpens its photographs are learned together, by gradients through
# the PSF. Objects are between 1.7 m and 2.4 m away; the lens starts focused at 1.75 m. Also needed: `pip install
# ".[jax]"` in a clone of lommel.

# %%
import jax
import jax.numpy as jnp
import matplotlib.pyplot as plt
import numpy as np

import lommel as lm

steps, batch, side = 60, 6, 32
lens = lm.Lens(focal_length=20e-3, f_number=2.8, focus_distance=2.0, wavelength=550e-9)
noise = lm.Noise(white=5000, read=5)
blur = lm.imaging.traced_blur(lens, [1.7, 2.4], 3.45e-6, jnp, focus_distances=(1.7, 2.3))

# %% [markdown]
# Scenes are random bars at a random distance each. A photograph is blurred by the lens at its focus distance and has
# the noise of the sensor. The filter is a kernel of 7 by 7, added to the photograph.


# %%
def scenes(key):
    """Return images of random bars, and depth maps."""
    keys = jax.random.split(key, 3)
    x = jnp.arange(side)
    phase = jax.random.uniform(keys[0], (batch, 1, 1), maxval=2.0 * jnp.pi)
    period = jax.random.uniform(keys[1], (batch, 1, 1), minval=5.0, maxval=12.0)
    bars = 0.5 + 0.4 * jnp.sign(jnp.sin(2.0 * jnp.pi * (x[:, None] + 0.5 * x) / period + phase))
    depth = jax.random.uniform(keys[2], (batch, 1, 1), minval=1.7, maxval=2.4)
    return bars, jnp.broadcast_to(depth, bars.shape)


def photograph(focus, key):
    """Return scenes, and what the sensor records of them."""
    image, depth = scenes(key)
    normal = jax.random.normal(jax.random.fold_in(key, 1), image.shape)
    return image, lm.imaging.traced_noise(blur(image, depth, focus_distance=focus), noise, normal)


def restored(kernel, photo):
    return photo + jax.vmap(lambda one: jax.scipy.signal.convolve(one, kernel, mode="same"))(photo)


def loss(parameters, key):
    image, photo = photograph(parameters["focus"], key)
    inner = (slice(None), slice(5, -5), slice(5, -5))
    return jnp.mean((restored(parameters["kernel"], photo) - image)[inner] ** 2)


# %% [markdown]
# ## Training

# %%
parameters = {"focus": jnp.asarray(1.75), "kernel": jnp.zeros((7, 7))}
rates = {"focus": 0.03, "kernel": 0.04}
speeds = {name: jnp.zeros_like(value) for name, value in parameters.items()}
slope = jax.jit(jax.value_and_grad(loss))
losses, focuses = [], []
for step in range(steps):
    value, slopes = slope(parameters, jax.random.key(step))
    for name, part in slopes.items():
        speeds[name] = 0.9 * speeds[name] - 0.1 * rates[name] * part / (jnp.linalg.norm(part) + 1e-6)
        parameters[name] = parameters[name] + speeds[name]
    losses.append(float(value))
    focuses.append(float(parameters["focus"]))
print(f"focus distance {focuses[-1]:.2f} m, mean squared error {np.mean(losses[-10:]):.4f}, at first {losses[0]:.4f}")

figure, (left, right) = plt.subplots(1, 2, figsize=(9.0, 3.0), layout="constrained")
left.semilogy(losses)
left.set_yticks([0.003, 0.01, 0.03, 0.1], ["0.003", "0.01", "0.03", "0.1"])
left.minorticks_off()
left.set_xlabel("step")
left.set_ylabel("mean squared error")
right.plot(focuses)
right.set_xlabel("step")
right.set_ylabel("focus distance (m)")
right.grid(alpha=0.3)

# %% [markdown]
# ## What was learned
#
# The farthest of a few scenes: out of focus at first, sharper after training.

# %%
key = jax.random.key(10**6)
far = int(jnp.argmax(scenes(key)[1][:, 0, 0]))
image, before = photograph(jnp.asarray(1.75), key)
_, photo = photograph(parameters["focus"], key)
shown = {"scene": image, "photograph at first": before, "after training": photo}
shown["restored"] = restored(parameters["kernel"], photo)
figure, panels = plt.subplots(1, 4, figsize=(9.0, 2.8), layout="constrained")
panels[0].set_ylabel("y (pixels)")
for panel, (name, values) in zip(panels, shown.items(), strict=True):
    panel.imshow(values[far], "gray", vmin=0.0, vmax=1.0)
    panel.set_title(name)
    panel.set_xlabel("x (pixels)")
