"""Seeded configurations and contacts: the questions for percuss and the other programs."""

import numpy as np

from urdf_file import ONE_VALUE, unit

REACH = 0.3  # m, from the link's origin


def configurations(robot, floating, count, contacts, rng):
    return [
        {
            "joints": {j.name: j.draw(rng) for j in robot.movable if robot.is_master(j)},
            "base": rng.uniform(-1, 1, 3).tolist() + unit(rng, 4).tolist() if floating else None,
            "contacts": [contact(robot, rng, KINDS[k % len(KINDS)]) for k in range(contacts)],
        }
        for _ in range(count)
    ]


def contact(robot, rng, kind):
    link, against, point, normal = kind(robot, rng) or anywhere(robot, rng)
    return {"link": link, "against": against, "point": point.tolist(), "normal": normal.tolist()}


def pick(rng, items):
    return items[rng.integers(len(items))] if items else None


def a_point(rng):
    return unit(rng) * rng.uniform(0, REACH)


def a_normal(rng):
    """Any direction, or along an axis of the link: the usual and the degenerate choice."""
    return unit(rng) if rng.random() < 0.7 else np.eye(3)[rng.integers(3)] * rng.choice([-1.0, 1.0])


def anywhere(robot, rng):
    """Any link, fixed links included, against the ground."""
    return pick(rng, robot.links), None, a_point(rng), a_normal(rng)


def moving(robot, rng):
    """The child of a movable joint against the ground."""
    joint = pick(rng, robot.movable)
    return joint and (joint.child, None, a_point(rng), a_normal(rng))


def pair(robot, rng):
    """The child of a movable joint against any other link."""
    joint = pick(rng, robot.movable)
    other = joint and pick(rng, [link for link in robot.links if link != joint.child])
    return other and (joint.child, other, a_point(rng), a_normal(rng))


def bearing(robot, rng, joints=None, against_ground=False):
    """A contact into the bearing of a joint: a point on the axis of a hinge, a normal across a slide. Immovable
    against the parent."""
    joint = pick(rng, [j for j in robot.movable if j.kind in ONE_VALUE] if joints is None else joints)
    if not joint:
        return None
    normal, point = unit(rng), joint.axis * rng.uniform(-REACH, REACH)
    if joint.kind == "prismatic":
        normal, point = np.cross(normal, joint.axis), a_point(rng)
    return joint.child, None if against_ground else joint.parent, point, normal / np.linalg.norm(normal)


def first_bearing(robot, rng):
    """The bearing of a joint nearest the root, against the ground: immovable for a fixed base."""
    first = [j for j in robot.movable if j.kind in ONE_VALUE and robot.chain(j.child) == [j]]
    return bearing(robot, rng, first, against_ground=True)


def at_random(robot, rng):
    return pick(rng, [anywhere, moving, first_bearing])(robot, rng)


KINDS = [moving, pair, bearing, at_random, moving]
