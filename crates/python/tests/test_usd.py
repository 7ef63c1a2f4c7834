"""Stages of USD, against maximal coordinates of the same numbers, closed forms and refusals."""

from __future__ import annotations

import math
import warnings
from typing import Any

import numpy as np
import percuss
import pytest
from numpy.typing import NDArray
from percuss.errors import InputError, ModelWarning

pxr = pytest.importorskip("pxr", reason="the package usd-core is not installed")
from pxr import Gf, Sdf, Usd, UsdGeom, UsdPhysics

Array = NDArray[np.float64]
# Numbers of UsdPhysics are single precision, and the mechanisms here have conditions up to a thousand.
SINGLE = 1e-4
AXES = np.eye(3)


def single(x: Any) -> Array:
    return np.asarray(x, dtype=np.float32).astype(np.float64)


def rotation(w: float, x: float, y: float, z: float) -> Array:
    q = np.array([w, x, y, z]) / math.sqrt(w * w + x * x + y * y + z * z)
    w, v = q[0], q[1:]
    return np.asarray(2.0 * np.outer(v, v) + (w * w - v @ v) * np.eye(3) + 2.0 * w * skew(v))


def skew(v: Any) -> Array:
    return np.array([[0.0, -v[2], v[1]], [v[2], 0.0, -v[0]], [-v[1], v[0], 0.0]])


def about(axis: Any, angle: float) -> Array:
    k = skew(axis)
    return np.asarray(np.eye(3) + math.sin(angle) * k + (1.0 - math.cos(angle)) * k @ k)


def placed(turn: Array, position: Any) -> Array:
    frame = np.eye(4)
    frame[:3, :3], frame[:3, 3] = turn, position
    return frame


def stage_of(metre: float = 1.0, kilogram: float = 1.0, up: str = "Z") -> Any:
    stage = Usd.Stage.CreateInMemory()
    UsdGeom.SetStageMetersPerUnit(stage, metre)
    UsdPhysics.SetStageKilogramsPerUnit(stage, kilogram)
    UsdGeom.SetStageUpAxis(stage, up)
    return stage


def body(stage: Any, path: str, mass: float = 1.0, com: Any = (0, 0, 0), inertia: Any = (0.1, 0.1, 0.1), axes: Any = (1, 0, 0, 0)) -> Any:
    prim = UsdGeom.Xform.Define(stage, path).GetPrim()
    UsdPhysics.RigidBodyAPI.Apply(prim)
    api = UsdPhysics.MassAPI.Apply(prim)
    api.CreateMassAttr(mass)
    api.CreateCenterOfMassAttr(Gf.Vec3f(*map(float, com)))
    api.CreateDiagonalInertiaAttr(Gf.Vec3f(*map(float, inertia)))
    api.CreatePrincipalAxesAttr(Gf.Quatf(*map(float, axes)))
    return prim


def joint(stage: Any, kind: str, path: str, ends: tuple[str, str], axis: str = "Z", frames: Any = ()) -> Any:
    made = getattr(UsdPhysics, kind).Define(stage, path)
    for number, (end, position, turn) in enumerate(zip(ends, *(frames or (((0, 0, 0),) * 2, ((1, 0, 0, 0),) * 2)), strict=True)):
        if end:
            getattr(made, f"CreateBody{number}Rel")().SetTargets([Sdf.Path(end)])
        getattr(made, f"CreateLocalPos{number}Attr")(Gf.Vec3f(*map(float, position)))
        getattr(made, f"CreateLocalRot{number}Attr")(Gf.Quatf(*map(float, turn)))
    if kind in ("RevoluteJoint", "PrismaticJoint"):
        made.CreateAxisAttr(axis)
    return made


def mass_of(model: percuss.Model, link: str, normal: Any, positions: Any = None, point: Any = (0, 0, 0), base: str = "fixed") -> float:
    """kg; infinite for a point that cannot move."""
    system = model.system(base="floating") if base == "floating" else model.system()
    contact = percuss.Contact(link, point=list(point), normal=list(normal), normal_frame="world")
    found = system.pose(positions or {}).respond(contact).effective_mass
    return math.inf if found is None else found


class Mechanism:
    """Random tree with loops in maximal coordinates: 1/(J W Jᵀ), W the upper left block of the inverse of [[M, Cᵀ], [C, 0]]."""

    def __init__(self, seed: int) -> None:
        rng = np.random.default_rng(seed)
        self.rng = rng
        self.metre, self.kilogram, up = [(1.0, 1.0, "Z"), (0.01, 1.0, "Z"), (1.0, 0.001, "Y"), (0.01, 0.5, "Y")][seed % 4]
        self.stage = stage_of(self.metre, self.kilogram, up)
        self.upright = np.array([[1.0, 0, 0], [0, 0, -1], [0, 1, 0]]) if up == "Y" else np.eye(3)
        self.floating = seed % 3 == 0
        count = int(rng.integers(2, 6))
        self.names = [f"link_{n}" for n in range(count)]
        self.frames: list[Array] = []
        self.inertia: list[tuple[float, Array, Array]] = []
        self.rows: list[tuple[int, int, Array, Array]] = []
        self.positions: dict[str, Any] = {}
        for n, name in enumerate(self.names):
            mass, com = float(single(rng.uniform(0.5, 3.0))), single(rng.uniform(-0.1, 0.1, 3) / self.metre)
            a, b = rng.uniform(0.5, 1.0, 2)
            diagonal = single(np.array([a, b, rng.uniform(abs(a - b) + 0.1, a + b)]) * 0.05 * mass / self.metre**2)
            axes = single(rng.normal(size=4))
            axes = single(axes / np.linalg.norm(axes))
            body(self.stage, f"/robot/{name}", mass, com, diagonal, axes)
            turn = rotation(*axes)
            scale = self.kilogram * self.metre**2
            self.inertia.append((self.kilogram * mass, self.metre * com, scale * turn @ np.diag(diagonal) @ turn.T))
            if n == 0:
                self.frames.append(np.eye(4))
                if self.floating:
                    UsdPhysics.ArticulationRootAPI.Apply(self.stage.GetPrimAtPath(f"/robot/{name}"))
                else:
                    self.attach(-1, 0)
                continue
            self.attach(int(rng.integers(0, n)), n)

    def quaternion(self) -> Array:
        q = self.rng.normal(size=4)
        return single(q / np.linalg.norm(q))

    def attach(self, parent: int, child: int) -> None:
        """A joint whose body 0 is the parent, or the child for every third."""
        rng, number = self.rng, child
        kind = ["RevoluteJoint", "PrismaticJoint", "SphericalJoint", "FixedJoint", "Joint"][int(rng.integers(0, 5))]
        reverse = bool(rng.integers(0, 3) == 0) and parent >= 0 and kind != "SphericalJoint"
        ends = [f"/robot/{self.names[n]}" if n >= 0 else "" for n in (parent, child)]
        placings = [(single(rng.uniform(-0.3, 0.3, 3) / self.metre), self.quaternion()) for _ in ends]
        if rng.integers(0, 2):
            placings[1] = (np.zeros(3), np.array([1.0, 0, 0, 0]))
        local = [placed(rotation(*turn), self.metre * position) for position, turn in placings]
        if parent < 0:
            local[0] = placed(self.upright, np.zeros(3)) @ local[0]
        order = (1, 0) if reverse else (0, 1)
        axis = "XYZ"[int(rng.integers(0, 3))]
        path = f"/robot/joint_{number}"
        made = joint(
            self.stage, kind, path, (ends[order[0]], ends[order[1]]), axis,
            ([placings[n][0] for n in order], [placings[n][1] for n in order]),
        )
        # Relative motion of frame 1 in frame 0, and its free twists (angular first) at frame 1 with the axes of frame 0.
        motion, free = np.eye(4), []
        name = f"joint_{number}"
        if kind == "RevoluteJoint":
            q = float(rng.uniform(-1, 1))
            self.positions[name] = q
            motion[:3, :3] = about(AXES["XYZ".index(axis)], q)
            free = [np.concatenate([AXES["XYZ".index(axis)], np.zeros(3)])]
        elif kind == "PrismaticJoint":
            q = float(rng.uniform(-0.2, 0.2))
            self.positions[name] = q
            motion[:3, 3] = q * AXES["XYZ".index(axis)]
            free = [np.concatenate([np.zeros(3), AXES["XYZ".index(axis)]])]
        elif kind == "SphericalJoint":
            q4 = rng.normal(size=4)
            q4 /= np.linalg.norm(q4)
            self.positions[name] = q4.tolist()
            motion[:3, :3] = rotation(*q4)
            free = [np.concatenate([a, np.zeros(3)]) for a in AXES]
        elif kind == "Joint":
            degrees = [d for d in ("transX", "transY", "transZ", "rotX", "rotY", "rotZ") if rng.integers(0, 2)]
            degrees = degrees[:-1] if {"rotX", "rotY", "rotZ"} <= set(degrees) else degrees
            for degree in ("transX", "transY", "transZ", "rotX", "rotY", "rotZ"):
                limit = UsdPhysics.LimitAPI.Apply(made.GetPrim(), degree)
                held = degree not in degrees
                limit.CreateLowAttr(1.0 if held else -170.0)
                limit.CreateHighAttr(-1.0 if held else 170.0)
            for degree in degrees:
                q = float(rng.uniform(-0.2, 0.2))
                self.positions[f"{name}:{degree}" if len(degrees) > 1 else name] = q
                e = AXES["XYZ".index(degree[-1])]
                if degree.startswith("trans"):
                    free.append(np.concatenate([np.zeros(3), e]))
                    motion[:3, 3] += q * e
                else:
                    free.append(np.concatenate([motion[:3, :3] @ e, np.zeros(3)]))
                    motion[:3, :3] = motion[:3, :3] @ about(e, q)
        before = self.frames[parent] if parent >= 0 else np.eye(4)
        moved = np.linalg.inv(motion) if reverse else motion
        child_frame = before @ local[0] @ moved @ np.linalg.inv(local[1])
        if child < len(self.frames):
            self.frames[child] = child_frame
        else:
            self.frames.append(child_frame)
        # Both ends in the order of the stage.
        pair = [(parent, local[0]), (child, local[1])]
        (zero, frame0), (one, frame1) = (pair[n] for n in order)
        place = [self.frames[n] if n >= 0 else np.eye(4) for n in (zero, one)]
        axes = (place[0] @ frame0)[:3, :3]
        at = (place[1] @ frame1)[:3, 3]
        twists = np.array([np.concatenate([axes @ f[:3], axes @ f[3:]]) for f in free]).reshape(-1, 6)
        null = np.linalg.svd(twists)[2][len(free):] if free else np.eye(6)
        self.rows.append((zero, one, null, at))

    def effective_mass(self, link: int, point: Array, normal: Array) -> float:
        n = 6 * len(self.names)
        m = np.zeros((n, n))
        for k, (mass, com, tensor) in enumerate(self.inertia):
            turn = self.frames[k][:3, :3]
            c = turn @ com
            world = turn @ tensor @ turn.T - mass * skew(c) @ skew(c)
            m[6 * k : 6 * k + 6, 6 * k : 6 * k + 6] = np.block([[world, mass * skew(c)], [-mass * skew(c), mass * np.eye(3)]])
        # Twist of a body: angular velocity, and the velocity of its origin.
        def at_point(k: int, at: Array) -> Array:
            return np.block([[np.eye(3), np.zeros((3, 3))], [-skew(at - self.frames[k][:3, 3]), np.eye(3)]])

        blocks = []
        for zero, one, null, at in self.rows:
            row = np.zeros((len(null), n))
            if one >= 0:
                row[:, 6 * one : 6 * one + 6] += null @ at_point(one, at)
            if zero >= 0:
                row[:, 6 * zero : 6 * zero + 6] -= null @ at_point(zero, at)
            blocks.append(row)
        c = np.concatenate(blocks) if blocks else np.zeros((0, n))
        saddle = np.block([[m, c.T], [c, np.zeros((len(c), len(c)))]])
        at = (self.frames[link] @ np.append(point, 1.0))[:3]
        j = np.zeros(n)
        j[6 * link : 6 * link + 6] = normal @ at_point(link, at)[3:]
        solution = np.linalg.lstsq(saddle, np.append(j, np.zeros(len(c))), rcond=1e-12)[0]
        mobility = j @ solution[:n]
        return math.inf if mobility < 1e-9 else float(1.0 / mobility)


@pytest.mark.parametrize("seed", range(40))
def test_random_mechanisms_agree_with_maximal_coordinates(seed: int) -> None:
    mechanism = Mechanism(seed)
    model = percuss.from_usd(mechanism.stage)
    rng = np.random.default_rng(seed + 1000)
    for link in range(len(mechanism.names)):
        point, normal = rng.uniform(-0.3, 0.3, 3), rng.normal(size=3)
        normal /= np.linalg.norm(normal)
        expected = mechanism.effective_mass(link, point, normal)
        base = "floating" if mechanism.floating else "fixed"
        found = mass_of(model, mechanism.names[link], normal, mechanism.positions, point, base)
        if math.isinf(expected):
            assert found > 1e6, (link, found)
        else:
            assert found == pytest.approx(expected, rel=SINGLE), link


def test_four_bar_with_a_joint_outside_the_articulation() -> None:
    # Parallelogram of rods 0.2 kg, 1 m: coupler moves on a circle. m̄ tangential at the coupler = 0.2 + 2 · 0.2/3.
    stage = stage_of()
    for name in ("one", "coupler", "two"):
        body(stage, f"/{name}", 0.2, (0.5, 0, 0), (0.0, 0.2 / 12.0, 0.2 / 12.0))
    straight = (1, 0, 0, 0)
    turned = (math.sqrt(0.5), 0, 0, math.sqrt(0.5))
    joint(stage, "RevoluteJoint", "/a", ("", "/one"), frames=(((0, 0, 0), (0, 0, 0)), (turned, straight)))
    joint(stage, "RevoluteJoint", "/b", ("/one", "/coupler"), frames=(((1, 0, 0), (0, 0, 0)), (straight, turned)))
    joint(stage, "RevoluteJoint", "/c", ("", "/two"), frames=(((1, 0, 0), (0, 0, 0)), (turned, straight)))
    closing = joint(stage, "RevoluteJoint", "/d", ("/two", "/coupler"), frames=(((1, 0, 0), (1, 0, 0)), (straight, turned)))
    closing.CreateExcludeFromArticulationAttr(True)
    expected = 0.2 + 2.0 * 0.2 / 3.0
    model = percuss.from_usd(stage)
    assert len(model.closures) == 1
    assert mass_of(model, "coupler", (1, 0, 0)) == pytest.approx(expected, rel=1e-6)
    # Without the attribute the fourth joint closes the loop by itself.
    closing.CreateExcludeFromArticulationAttr(False)
    assert mass_of(percuss.from_usd(stage), "coupler", (1, 0, 0)) == pytest.approx(expected, rel=1e-6)


def test_armature_and_mimic_are_those_of_three_programs() -> None:
    for name in ("newton:armature", "physxJoint:armature", "mjc:armature"):
        stage = stage_of(metre=0.01)
        body(stage, "/arm", 2.0, (50, 0, 0), (1, 1, 1))
        hinge = joint(stage, "RevoluteJoint", "/hinge", ("", "/arm"))
        hinge.GetPrim().CreateAttribute(name, Sdf.ValueTypeNames.Float).Set(30000.0)
        # J = 1e-4 + 2 · 0.5² + 3 kg·m², at 0.5 m.
        assert mass_of(percuss.from_usd(stage), "arm", (0, 1, 0), point=(0.5, 0, 0)) == pytest.approx((0.5001 + 3.0) / 0.25, rel=1e-6)
    for programs in ("newton", "physx"):
        stage = stage_of()
        body(stage, "/leader", 2.0)
        body(stage, "/follower", 3.0)
        joint(stage, "PrismaticJoint", "/lead", ("", "/leader"), "X")
        prim = joint(stage, "PrismaticJoint", "/follow", ("", "/follower"), "Y").GetPrim()
        if programs == "newton":
            prim.CreateRelationship("newton:mimicJoint").SetTargets([Sdf.Path("/lead")])
            prim.CreateAttribute("newton:mimicCoef1", Sdf.ValueTypeNames.Float).Set(-2.0)
        else:
            prim.CreateRelationship("physxMimicJoint:transY:referenceJoint").SetTargets([Sdf.Path("/lead")])
            prim.CreateAttribute("physxMimicJoint:transY:gearing", Sdf.ValueTypeNames.Float).Set(2.0)
        assert mass_of(percuss.from_usd(stage), "leader", (1, 0, 0)) == pytest.approx(2.0 + 4.0 * 3.0, rel=1e-6)


@pytest.mark.parametrize("program", ["newton", "physx", "mjc"])
def test_a_slide_follows_a_hinge_in_the_units_of_its_program(program: str) -> None:
    # 2 cm a turn: 0.02/(2π) m/rad.
    stage = stage_of(metre=0.01)
    body(stage, "/screw", 2.0, inertia=(100, 100, 100))
    body(stage, "/nut", 3.0)
    joint(stage, "RevoluteJoint", "/turn", ("", "/screw"), "Z")
    prim = joint(stage, "PrismaticJoint", "/slide", ("", "/nut"), "Z").GetPrim()
    if program == "physx":
        prim.CreateRelationship("physxMimicJoint:transZ:referenceJoint").SetTargets([Sdf.Path("/turn")])
        prim.CreateAttribute("physxMimicJoint:transZ:gearing", Sdf.ValueTypeNames.Double).Set(-2.0 / 360.0)
    else:
        names = {"newton": ("newton:mimicJoint", "newton:mimicCoef1"), "mjc": ("mjc:target", "mjc:coef1")}[program]
        prim.CreateRelationship(names[0]).SetTargets([Sdf.Path("/turn")])
        factor = 2.0 / 360.0 if program == "newton" else 2.0 / math.tau
        prim.CreateAttribute(names[1], Sdf.ValueTypeNames.Double).Set(factor)
    expected = 3.0 + 0.01 / (0.02 / math.tau) ** 2
    assert mass_of(percuss.from_usd(stage), "nut", (0, 0, 1)) == pytest.approx(expected, rel=1e-6)


def test_masses_of_colliders() -> None:
    stage = stage_of()
    shapes: list[tuple[Any, float, Array]] = []
    for number, kind in enumerate(("Cube", "Sphere", "Cylinder", "Capsule", "Cone", "Mesh")):
        prim = UsdGeom.Xform.Define(stage, f"/body_{kind}").GetPrim()
        UsdPhysics.RigidBodyAPI.Apply(prim)
        UsdPhysics.MassAPI.Apply(prim).CreateDensityAttr(500.0)
        shape = getattr(UsdGeom, kind).Define(stage, f"/body_{kind}/shape")
        UsdPhysics.CollisionAPI.Apply(shape.GetPrim())
        if kind == "Mesh":
            corners = [(x, y, z) for x in (0, 0.4) for y in (0, 0.2) for z in (0, 0.1)]
            shape.CreatePointsAttr([Gf.Vec3f(*corner) for corner in corners])
            shape.CreateFaceVertexCountsAttr([4] * 6)
            shape.CreateFaceVertexIndicesAttr([0, 1, 3, 2, 4, 6, 7, 5, 0, 4, 5, 1, 2, 3, 7, 6, 0, 2, 6, 4, 1, 5, 7, 3])
        elif kind == "Cube":
            shape.CreateSizeAttr(2.0)
            shape.AddScaleOp().Set(Gf.Vec3f(0.2, 0.1, 0.05))
        elif kind == "Sphere":
            shape.CreateRadiusAttr(0.1)
        else:
            shape.CreateRadiusAttr(0.1)
            shape.CreateHeightAttr(0.4)
            shape.CreateAxisAttr("X")
        r, h = 0.1, 0.4
        ball, rod = 4 / 3 * math.pi * r**3, math.pi * r * r * h
        volume = {"Cube": 0.008, "Sphere": ball, "Cylinder": rod, "Capsule": rod + ball, "Cone": rod / 3, "Mesh": 0.008}[kind]
        across = {
            "Cube": 0.008 * (0.4**2 + 0.1**2) / 12,
            "Mesh": 0.008 * (0.4**2 + 0.1**2) / 12,
            "Sphere": 0.4 * ball * r * r,
            "Cylinder": rod * (3 * r * r + h * h) / 12,
            "Capsule": rod * (3 * r * r + h * h) / 12 + ball * (0.4 * r * r + 0.25 * h * h + 0.375 * r * h),
            "Cone": rod / 3 * (0.15 * r * r + 0.0375 * h * h),
        }[kind]
        centre = {"Cone": np.array([-0.1, 0, 0]), "Mesh": np.array([0.2, 0.1, 0.05])}.get(kind, np.zeros(3))
        shapes.append((kind, 500.0 * volume, centre))
        # Hinge about y at the origin: J = I_yy + m (x² + z²) of the centre.
        joint(stage, "RevoluteJoint", f"/hinge_{number}", ("", f"/body_{kind}"), "Y")
        expected = 500.0 * (across + volume * (centre[0] ** 2 + centre[2] ** 2))
        model = percuss.from_usd(stage)
        assert mass_of(model, f"body_{kind}", (0, 0, 1), point=(1, 0, 0)) == pytest.approx(expected, rel=1e-5), kind


def test_two_kinematic_and_free_bodies() -> None:
    stage = stage_of()
    for name in ("base", "arm", "ball"):
        body(stage, f"/{name}", 2.0)
    UsdPhysics.RigidBodyAPI(stage.GetPrimAtPath("/base")).CreateKinematicEnabledAttr(True)
    UsdGeom.XformCommonAPI(stage.GetPrimAtPath("/base")).SetTranslate((1.0, 0, 0))
    joint(stage, "RevoluteJoint", "/hinge", ("/base", "/arm"))
    with pytest.warns(ModelWarning, match="kinematic"):
        model = percuss.from_usd(stage)
    assert mass_of(model, "arm", (0, 1, 0), point=(1, 0, 0)) == pytest.approx(0.1, rel=1e-6)
    assert mass_of(model, "ball", (0, 1, 0)) == pytest.approx(2.0, rel=1e-6)
    # The hinge is at the base.
    assert mass_of(model, "arm", (0, 1, 0)) > 1e6


def test_sequence_of_joints_as_in_mjcf() -> None:
    stage = stage_of()
    body(stage, "/trunk", 5.0)
    body(stage, "/arm", 1.0, (0, 0, -0.5), (0.1, 0.1, 0.01))
    joint(stage, "FixedJoint", "/weld", ("", "/trunk"))
    first = joint(stage, "RevoluteJoint", "/first", ("/trunk", "/arm"), "X")
    second = joint(stage, "RevoluteJoint", "/second", ("/trunk", "/arm"), "Y")
    with pytest.raises(InputError, match="join the same bodies"):
        percuss.from_usd(stage)
    for made in (first, second):
        made.GetPrim().CreateAttribute("mjc:damping", Sdf.ValueTypeNames.Float).Set(1.0)
    model = percuss.from_usd(stage)
    assert model.position_names == ["first", "second"]
    for normal in ((1, 0, 0), (0, 1, 0)):
        assert mass_of(model, "arm", normal, point=(0, 0, -1)) == pytest.approx(0.1 + 0.25, rel=1e-6)
    # Second after first: its axis turns with the first.
    turned = mass_of(model, "arm", (1, 0, 0), {"first": 1.0}, point=(0, 0, -1))
    assert turned == pytest.approx(0.35, rel=1e-6)


def with_gear(stage: Any) -> None:
    prim = stage.DefinePrim("/gear", "PhysxPhysicsGearJoint")
    prim.CreateRelationship("physics:hinge0").SetTargets([Sdf.Path("/hinge")])


def with_open_mesh(stage: Any) -> None:
    UsdGeom.Xform.Define(stage, "/bowl")
    UsdPhysics.RigidBodyAPI.Apply(stage.GetPrimAtPath("/bowl"))
    mesh = UsdGeom.Mesh.Define(stage, "/bowl/mesh")
    mesh.CreatePointsAttr([Gf.Vec3f(0, 0, 0), Gf.Vec3f(1, 0, 0), Gf.Vec3f(0, 1, 0), Gf.Vec3f(0, 0, 1)])
    mesh.CreateFaceVertexCountsAttr([3, 3, 3])
    mesh.CreateFaceVertexIndicesAttr([0, 2, 1, 0, 1, 3, 0, 3, 2])
    UsdPhysics.CollisionAPI.Apply(mesh.GetPrim())
    UsdPhysics.MeshCollisionAPI.Apply(mesh.GetPrim()).CreateApproximationAttr("none")


def with_curve(stage: Any) -> None:
    body(stage, "/other")
    prim = joint(stage, "RevoluteJoint", "/other_hinge", ("", "/other")).GetPrim()
    prim.CreateRelationship("newton:mimicJoint").SetTargets([Sdf.Path("/hinge")])
    prim.CreateAttribute("mjc:coef2", Sdf.ValueTypeNames.Float).Set(0.5)


def with_limits_without_schema(stage: Any) -> None:
    body(stage, "/other")
    prim = joint(stage, "Joint", "/other_joint", ("", "/other")).GetPrim()
    for degree in ("rotX", "rotY"):
        prim.CreateAttribute(f"limit:{degree}:physics:low", Sdf.ValueTypeNames.Float).Set(0.0)


def with_itself(stage: Any) -> None:
    joint(stage, "RevoluteJoint", "/self", ("/arm", "/arm"))


def without_inertia(stage: Any) -> None:
    body(stage, "/other", inertia=(0, 0, 0))
    joint(stage, "RevoluteJoint", "/other_hinge", ("", "/other"))


def with_two_armatures(stage: Any) -> None:
    for name, value in (("newton:armature", 1.0), ("physxJoint:armature", 2.0)):
        stage.GetPrimAtPath("/hinge").CreateAttribute(name, Sdf.ValueTypeNames.Float).Set(value)


@pytest.mark.parametrize(
    ("change", "words"),
    [
        (with_gear, "PhysxPhysicsGearJoint"),
        (with_open_mesh, "not closed"),
        (with_curve, "by a curve"),
        (with_limits_without_schema, "PhysicsLimitAPI"),
        (with_itself, "with itself"),
        (with_two_armatures, "several armatures"),
        (without_inertia, "neither physics:diagonalInertia"),
    ],
)
def test_refusals(change: Any, words: str) -> None:
    stage = stage_of()
    body(stage, "/arm")
    joint(stage, "RevoluteJoint", "/hinge", ("", "/arm"))
    percuss.from_usd(stage)
    change(stage)
    with pytest.raises(InputError, match=words):
        percuss.from_usd(stage)


def test_an_empty_stage_and_a_limited_distance() -> None:
    with pytest.raises(InputError, match="no rigid body"):
        percuss.from_usd(stage_of())
    stage = stage_of()
    body(stage, "/arm", 2.0)
    rope = joint(stage, "DistanceJoint", "/rope", ("", "/arm"), frames=(((0, 0, 1), (0, 0, 0)), ((1, 0, 0, 0),) * 2))
    rope.CreateMaxDistanceAttr(1.0)
    with pytest.warns(ModelWarning, match="limits a distance"):
        model = percuss.from_usd(stage)
    assert mass_of(model, "arm", (0, 0, 1), base="floating") == pytest.approx(2.0, rel=1e-6)
    rope.CreateMinDistanceAttr(1.0)
    with warnings.catch_warnings():
        warnings.simplefilter("error", ModelWarning)
        model = percuss.from_usd(stage)
    assert mass_of(model, "arm", (0, 0, 1)) > 1e6
    assert mass_of(model, "arm", (1, 0, 0)) == pytest.approx(2.0, rel=1e-6)
