"""m̄ as a function of JAX, with its exact derivative by the positions.

    >>> from percuss.jax import effective_mass
    >>> mass = effective_mass(model, contact)                   # a function of q: jit, vmap, grad and jvp work
    >>> jax.grad(lambda q: mass(q).sum())(q)

The computation runs on the host (jax.pure_callback). With jax_enable_x64 numbers keep their digits; else they are rounded to
float32 on the way. The derivative is that of percuss.converters.position_gradient; it is not differentiable again.
"""

from __future__ import annotations

from collections.abc import Callable
from importlib import import_module
from typing import Any

import numpy as np

from .. import _gradients
from .._percuss import Assembly, Contact, Model, System

__all__ = ["effective_mass"]

# Not by an import statement: in this package the name would be that of this module for checkers of types.
jax: Any = import_module("jax")
jnp: Any = import_module("jax.numpy")


def effective_mass(
    model: Model | System | Assembly, contact: Contact | str, *, base_pose: Any = None, threads: int | None = None
) -> Callable[[Any], Any]:
    """Function from positions q (..., p) of all joints, loops closed, to m̄ (...); NaN unless finite."""
    own = _gradients.model_of(model)
    options = {"base_pose": base_pose, "threads": threads}

    def on_host(q: Any) -> Any:
        values = np.asarray(q)
        mass, _ = _gradients.mass_and_gradient(own, model, contact, values, options, gradient=False)
        return mass.astype(values.dtype)

    def both_on_host(q: Any) -> Any:
        values = np.asarray(q)
        mass, gradient = _gradients.mass_and_gradient(own, model, contact, values, options, gradient=True)
        return mass.astype(values.dtype), gradient.astype(values.dtype)

    @jax.custom_jvp
    def mass(q: Any) -> Any:
        shape = jax.ShapeDtypeStruct(q.shape[:-1], q.dtype)
        return jax.pure_callback(on_host, shape, q, vmap_method="broadcast_all")

    @mass.defjvp
    def derivative(primals: Any, tangents: Any) -> Any:
        (q,), (change,) = primals, tangents
        shapes = (jax.ShapeDtypeStruct(q.shape[:-1], q.dtype), jax.ShapeDtypeStruct(q.shape, q.dtype))
        value, gradient = jax.pure_callback(both_on_host, shapes, q, vmap_method="broadcast_all")
        return value, jnp.sum(gradient * change, axis=-1)

    return lambda q: mass(jnp.asarray(q))
