"""m̄ as a function of PyTorch and JAX: values, gradients against differences, arrays without copies.

    arrays.py --package FOLDER     runs what can be imported; prints `N passed, N failed`
"""

import argparse
import importlib.util
import sys
from pathlib import Path

import numpy as np

ROOT = Path(__file__).resolve().parents[4]

passed = failed = 0


def check(what, found, expected, tolerance):
    global passed, failed
    found, expected = np.asarray(found), np.asarray(expected)
    scale = max(1.0, np.abs(expected).max())
    if found.shape == expected.shape and np.abs(found - expected).max() <= tolerance * scale:
        passed += 1
    else:
        failed += 1
        print(f"{what}: {found}, expected {expected}")


def arm_and_rows():
    arm = percuss.load(ROOT / "models/six_r_arm.urdf")
    tool = percuss.Contact("tool", [0.08, 0.01, -0.02], [0.3, 1, -0.2])
    return arm, tool, np.random.default_rng(5).uniform(-1, 1, (7, arm.position_count))


def torch_arrays():
    import torch

    from percuss.torch import effective_mass

    arm, tool, rows = arm_and_rows()
    q = torch.tensor(rows, requires_grad=True)
    swept = percuss.sweep(arm, tool, rows, gradient=True)
    mass = effective_mass(arm, tool, q)
    check("torch, values", mass.detach().numpy(), swept.effective_mass, 0)
    weights = torch.arange(1.0, 8.0, dtype=torch.float64)
    (mass * weights).sum().backward()
    gradient = percuss.converters.position_gradient(arm, rows, swept.gradient)
    check("torch, gradient", q.grad.numpy(), weights.numpy()[:, None] * gradient, 1e-15)
    # Differences of torch itself: step 1e-6, so 1e-9 by rounding.
    assert torch.autograd.gradcheck(lambda x: effective_mass(arm, tool, x), (q[:2].detach().requires_grad_(),), atol=1e-6)
    check("torch, in", percuss.sweep(arm, tool, q.detach()).effective_mass, swept.effective_mass, 0)
    single = effective_mass(arm, tool, q.detach().float())
    check("torch, float32", single.numpy(), swept.effective_mass, 1e-5)
    assert single.dtype == torch.float32


def jax_arrays():
    import jax
    import jax.numpy as jnp

    from percuss.jax import effective_mass

    jax.config.update("jax_enable_x64", True)
    arm, tool, rows = arm_and_rows()
    q = jnp.asarray(rows)
    swept = percuss.sweep(arm, tool, rows, gradient=True)
    mass = effective_mass(arm, tool)
    gradient = percuss.converters.position_gradient(arm, rows, swept.gradient)
    check("jax, values", mass(q), swept.effective_mass, 0)
    check("jax, jit", jax.jit(mass)(q), swept.effective_mass, 0)
    check("jax, vmap", jax.vmap(mass)(q), swept.effective_mass, 0)
    check("jax, grad", jax.grad(lambda x: mass(x).sum())(q), gradient, 1e-15)
    check("jax, vmap of grad", jax.jit(jax.vmap(jax.grad(mass)))(q), gradient, 1e-15)
    change = jnp.ones_like(q)
    check("jax, jvp", jax.jvp(mass, (q,), (change,))[1], gradient.sum(axis=1), 1e-14)
    check("jax, in", percuss.sweep(arm, tool, q).effective_mass, swept.effective_mass, 0)
    # A chain: positions from a parameter.
    parameter = jax.grad(lambda t: mass(q[0] * jnp.sin(t)))(0.7)
    at = np.asarray(rows[0] * np.sin(0.7))[None]
    own = percuss.converters.position_gradient(arm, at, percuss.sweep(arm, tool, at, gradient=True).gradient)
    check("jax, chain", parameter, own[0] @ (rows[0] * np.cos(0.7)), 1e-12)


flags = argparse.ArgumentParser()
flags.add_argument("--package", type=Path)
given = flags.parse_args()
if given.package:
    sys.path.insert(0, str(given.package))
import percuss  # noqa: E402

for name, work in (("torch", torch_arrays), ("jax", jax_arrays)):
    if importlib.util.find_spec(name):
        work()
print(f"{passed} passed, {failed} failed")
sys.exit(failed > 0 or passed == 0)
