"""The effective mass from the velocities of all bodies, every joint as rows; and the same bodies written as a URDF+
file with a random spanning tree."""

from xml.sax.saxutils import quoteattr

import numpy as np

from cars import CHASSIS


def cross(v):
    return np.array([[0, -v[2], v[1]], [v[2], 0, -v[0]], [-v[1], v[0], 0]])


def across(line):
    """Two directions normal to a line."""
    u, _, _ = np.linalg.svd(line.reshape(3, 1))
    return u[:, 1], u[:, 2]


class Velocities:
    """Columns: the angular velocity and the velocity of the centre of mass of each body, in the vehicle's axes."""

    def __init__(self, built):
        self.built = built
        self.column = {name: 6 * i for i, name in enumerate(built.bodies)}
        self.width = 6 * len(built.bodies)

    def turning(self, name, direction):
        row = np.zeros(self.width)
        if name != CHASSIS:
            row[self.column[name] :][:3] = direction
        return row

    def moving(self, name, at, direction):
        row = np.zeros(self.width)
        if name != CHASSIS:
            start, com = self.column[name], self.built.bodies[name].com
            row[start : start + 3] = np.cross(at - com, direction)
            row[start + 3 : start + 6] = direction
        return row

    def rows(self, joint):
        apart = lambda n: self.moving(joint.second, joint.at, n) - self.moving(joint.first, joint.at, n)  # noqa: E731
        turn = lambda n: self.turning(joint.second, n) - self.turning(joint.first, n)  # noqa: E731
        everywhere = list(np.eye(3))
        if joint.kind == "rod":
            other_end = joint.at + joint.along
            return [self.moving(joint.second, other_end, joint.along) - self.moving(joint.first, joint.at, joint.along)]
        moved, turned = {
            "ball": (everywhere, []),
            "universal": (everywhere, [joint.along]),
            "hinge": (everywhere, None),
            "cylinder": (None, None),
            "slide": (None, everywhere),
            "fixed": (everywhere, everywhere),
        }[joint.kind]
        moved = across(joint.along) if moved is None else moved
        turned = across(joint.along) if turned is None else turned
        return [apart(n) for n in moved] + [turn(n) for n in turned]

    def mass_matrix(self):
        m = np.zeros((self.width, self.width))
        for name, body in self.built.bodies.items():
            i = self.column[name]
            m[i : i + 3, i : i + 3] = body.inertia
            m[i + 3 : i + 6, i + 3 : i + 6] = body.mass * np.eye(3)
        return m


class Independent:
    """min { vᵀ M v : A v = 0, j v = 1 } of built bodies."""

    def __init__(self, built):
        self.velocities = Velocities(built)
        rows = np.array([row for joint in built.joints for row in self.velocities.rows(joint)])
        # A rod's row is proportional to its length; rows are normalised for the rank decision.
        rows /= np.linalg.norm(rows, axis=1, keepdims=True)
        _, s, vt = np.linalg.svd(rows)
        rank = int((s > 1e-9 * s[0]).sum())
        self.gap = s[rank - 1] / s[0]
        self.free = vt[rank:].T
        self.freedom = self.free.shape[1]
        self.mass = self.free.T @ self.velocities.mass_matrix() @ self.free

    def effective_mass(self, link, at, direction, against=CHASSIS):
        """Along a line to a point of `against`: its velocity along the line is the same at both ends."""
        j = self.velocities.moving(link, at, direction) - self.velocities.moving(against, at, direction)
        j = j @ self.free
        return 1 / (j @ np.linalg.solve(self.mass, j))


def numbers(values):
    return " ".join(repr(float(x)) for x in values)


def rpy(r):
    return np.arctan2(r[2, 1], r[2, 2]), -np.arcsin(np.clip(r[2, 0], -1, 1)), np.arctan2(r[1, 0], r[0, 0])


def random_rotation(rng):
    """A random rotation away from a pitch of 90°, where roll and yaw are ill-defined."""
    while True:
        q, r = np.linalg.qr(rng.normal(size=(3, 3)))
        q = q * np.sign(np.diag(r))
        q[:, 0] *= np.linalg.det(q)
        if abs(q[2, 0]) < 0.9:
            return q


class Twin:
    """A URDF+ file of built bodies: links with random axes, the tree grown from the chassis in random order."""

    def __init__(self, built, rng):
        self.built, self.rng, self.text = built, rng, ['<robot name="twin">', '  <link name="chassis"/>']
        # Axes (columns) and origin of each link, in the vehicle's frame.
        self.frames = {CHASSIS: (np.eye(3), np.zeros(3))}
        self.crosses = 0
        self.grow()
        self.text.append("</robot>\n")

    def origin(self, link, at, axes):
        """An <origin> in a link's frame."""
        r, p = self.frames[link]
        return f'<origin xyz="{numbers(r.T @ (at - p))}" rpy="{numbers(rpy(r.T @ axes))}"/>'

    def link(self, name, at):
        axes = random_rotation(self.rng)
        self.frames[name] = (axes, at)
        if name not in self.built.bodies:
            self.text.append(f"  <link name={quoteattr(name)}/>")
            return
        body = self.built.bodies[name]
        i = axes.T @ body.inertia @ axes
        i = (i + i.T) / 2
        entries = zip(("ixx", "ixy", "ixz", "iyy", "iyz", "izz"), i[np.triu_indices(3)])
        inertia = " ".join(f'{key}="{float(value)!r}"' for key, value in entries)
        com = axes.T @ (body.com - at)
        self.text.append(
            f'  <link name={quoteattr(name)}><inertial><origin xyz="{numbers(com)}"/><mass value="{float(body.mass)!r}"/>'
            f"<inertia {inertia}/></inertial></link>"
        )

    def joint(self, kind, parent, child, at, along=None):
        self.link(child, at)
        axes = self.frames[child][0]
        axis = "" if along is None else f'<axis xyz="{numbers(axes.T @ along)}"/>'
        limit = '<limit lower="-9" upper="9" effort="1" velocity="1"/>' if kind == "prismatic" else ""
        self.text.append(
            f"  <joint name={quoteattr('to_' + child)} type={quoteattr(kind)}>{self.origin(parent, at, axes)}"
            f"<parent link={quoteattr(parent)}/><child link={quoteattr(child)}/>{axis}{limit}</joint>"
        )

    def between(self):
        self.crosses += 1
        return f"cross_{self.crosses}"

    def in_tree(self, joint, parent, child):
        at, along = joint.at, joint.along
        if joint.kind == "universal":
            one, other = across(along)
            angle = self.rng.uniform(0, np.pi)
            cross_link = self.between()
            self.joint("continuous", parent, cross_link, at, np.cos(angle) * one + np.sin(angle) * other)
            self.joint("continuous", cross_link, child, at, np.cos(angle) * other - np.sin(angle) * one)
        elif joint.kind == "cylinder":
            slider = self.between()
            self.joint("prismatic", parent, slider, at, along)
            self.joint("continuous", slider, child, at, along)
        else:
            kind = {"ball": "spherical", "hinge": "continuous", "slide": "prismatic", "fixed": "fixed"}[joint.kind]
            self.joint(kind, parent, child, at, None if kind in ("spherical", "fixed") else along)

    def loop(self, joint):
        spelled = {"ball": "spherical", "hinge": "revolute", "cylinder": "cylindrical", "rod": "distance", "slide": "prismatic"}
        kind = spelled.get(joint.kind, joint.kind)
        first_at, second_at = joint.at, joint.at
        extra = ""
        if kind == "distance":
            second_at = joint.at + joint.along
        elif kind == "universal":
            one, other = across(joint.along)
            extra = f'<axis xyz="{numbers(one)}"/><axis2 xyz="{numbers(other)}"/>'
        elif kind in ("revolute", "cylindrical", "prismatic"):
            extra = f'<axis xyz="{numbers(joint.along)}"/>'
        name = quoteattr(f"loop_{len(self.text)}")
        self.text.append(
            f'  <loop name={name} type="{kind}">'
            f"<predecessor link={quoteattr(joint.first)}>{self.origin(joint.first, first_at, np.eye(3))}</predecessor>"
            f"<successor link={quoteattr(joint.second)}>{self.origin(joint.second, second_at, np.eye(3))}</successor>{extra}</loop>"
        )

    def grow(self):
        left = [self.built.joints[i] for i in self.rng.permutation(len(self.built.joints))]
        bodies = [name for name in self.built.bodies]
        while left or any(name not in self.frames for name in bodies):
            reach = lambda joint: (joint.first in self.frames) != (joint.second in self.frames)  # noqa: E731
            grown = next((j for j in left if j.kind != "rod" and reach(j)), None)
            if grown is not None:
                left.remove(grown)
                ends = (grown.first, grown.second)
                parent, child = ends if grown.first in self.frames else ends[::-1]
                self.in_tree(grown, parent, child)
                continue
            # Bodies connected only by rods or loops get a joint to the chassis with all six velocities.
            alone = next((name for name in bodies if name not in self.frames), None)
            if alone is not None:
                self.joint("floating", CHASSIS, alone, self.built.bodies[alone].com)
                continue
            for joint in left:
                self.loop(joint)
            left = []

    def xml(self):
        return "\n".join(self.text)

    def contact(self, link, at, direction):
        """Flags of the contact in the link's own frame."""
        axes, origin = self.frames[link]
        numbers_of = lambda v: ",".join(repr(float(x)) for x in v)  # noqa: E731
        return ["--link", link, "--point", numbers_of(axes.T @ (at - origin)), "--normal", numbers_of(axes.T @ direction)]
