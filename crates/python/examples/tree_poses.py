"""100,000 poses of a tree of 30 joints with a free root: the effective mass of a hand against the ground. Positions
in column order are the fastest."""

from __future__ import annotations

import time

import numpy as np

import percuss

COUNT = 100_000


def humanoid() -> str:
    """A trunk with two arms and two legs of seven joints each, and two joints to the head. The dimensions are
    invented."""
    inertia = '<inertial><origin xyz="0 0 -0.06"/><mass value="{mass}"/><inertia ixx="{i}" iyy="{i}" izz="{i}" ixy="0" ixz="0" iyz="0"/></inertial>'
    axes = ["1 0 0", "0 1 0", "0 0 1"]
    parts = ['<robot name="humanoid"><link name="pelvis">' + inertia.format(mass=12, i=0.2) + "</link>"]

    def limb(name: str, at: str, count: int) -> None:
        before = "pelvis"
        for i in range(count):
            link, place = f"{name}_{i}", at if i == 0 else "0 0 -0.11"
            parts.append(f'<link name="{link}">' + inertia.format(mass=2.5 - 0.2 * i, i=0.02 - 0.002 * i) + "</link>")
            parts.append(
                f'<joint name="{name}_joint_{i}" type="continuous"><parent link="{before}"/><child link="{link}"/>'
                f'<origin xyz="{place}"/><axis xyz="{axes[i % 3]}"/></joint>'
            )
            before = link

    for name, at in (("left_arm", "0 0.2 0.5"), ("right_arm", "0 -0.2 0.5"), ("left_leg", "0 0.1 -0.1"), ("right_leg", "0 -0.1 -0.1")):
        limb(name, at, 7)
    limb("head", "0 0 0.6", 2)
    return "".join(parts) + "</robot>"


def main() -> None:
    model = percuss.loads(humanoid(), name="humanoid.urdf")
    assert model.position_count == 30
    system = model.system(base="floating")
    contact = percuss.Contact("left_arm_6", [0, 0, -0.11], [0, 0, -1])
    q = np.random.default_rng(0).uniform(-1, 1, (COUNT, model.position_count))
    for order, array in (("rows", q), ("columns", np.asfortranarray(q))):
        begun = time.perf_counter()
        swept = percuss.sweep(system, contact, array)
        elapsed = time.perf_counter() - begun
        print(f"{order:8} {swept}: {elapsed:.3f} s, {1e6 * elapsed / COUNT:.2f} µs a pose")


if __name__ == "__main__":
    main()
