"""m̄ as a function of PyTorch, with its exact gradient by the positions.

    >>> from percuss.torch import effective_mass
    >>> q = torch.zeros(1000, model.position_count, dtype=torch.float64, requires_grad=True)
    >>> effective_mass(model, contact, q).sum().backward()      # q.grad: (1000, p)

Tensors of float64 on the CPU are read and returned without a copy. The gradient is that of percuss.converters.position_gradient: exact,
computed with m̄, not by differences. It is not differentiable again.
"""

from __future__ import annotations

from importlib import import_module
from typing import Any

from .. import _gradients
from .._percuss import Assembly, Contact, Model, System

__all__ = ["effective_mass"]

# Not by an import statement: in this package the name would be that of this module for checkers of types.
torch: Any = import_module("torch")


class _EffectiveMass(torch.autograd.Function):
    @staticmethod
    def forward(ctx: Any, q: Any, system: Any, contact: Contact | str, options: dict[str, Any]) -> Any:
        model = _gradients.model_of(system)
        wanted = bool(ctx.needs_input_grad[0])
        values = q.detach().to(device="cpu", dtype=torch.float64).numpy()
        mass, gradient = _gradients.mass_and_gradient(model, system, contact, values, options, gradient=wanted)
        if wanted:
            ctx.save_for_backward(torch.from_numpy(gradient).to(device=q.device, dtype=q.dtype))
        return torch.from_numpy(mass).to(device=q.device, dtype=q.dtype)

    @staticmethod
    @torch.autograd.function.once_differentiable
    def backward(ctx: Any, output: Any) -> Any:
        (gradient,) = ctx.saved_tensors
        return output.unsqueeze(-1) * gradient, None, None, None


def effective_mass(
    model: Model | System | Assembly, contact: Contact | str, q: Any, *, base_pose: Any = None, threads: int | None = None
) -> Any:
    """m̄ (...) of positions q (..., p) of all joints, loops closed; NaN unless finite. Arguments as those of percuss.sweep."""
    return _EffectiveMass.apply(q, model, contact, {"base_pose": base_pose, "threads": threads})
