"""Impacts in Drake. `parameters` has Drake's own names, as in percuss's export, the same for both geometries of the
pair: "point_contact_stiffness", "hunt_crossley_dissipation", "relaxation_time"; and for the plant:
"integration_scheme", "accuracy", "max_step_size" (continuous), "time_step_lagged", "time_step_sap". `mode` selects
the plant.

This file contains no contact law: the parameters come from the caller."""

import logging

import numpy as np
from pydrake.geometry import AddContactMaterial, HalfSpace, ProximityProperties, Sphere
from pydrake.math import RigidTransform
from pydrake.multibody.parsing import Parser
from pydrake.multibody.plant import AddMultibodyPlantSceneGraph, CoulombFriction, DiscreteContactApproximation
from pydrake.multibody.tree import FixedOffsetFrame, PrismaticJoint, SpatialInertia, default_model_instance
from pydrake.systems.analysis import ApplySimulatorConfig, Simulator, SimulatorConfig
from pydrake.systems.framework import DiagramBuilder, EventStatus

from impacts import RADIUS, Outcome

# Drake warns that half spaces do not touch deformable bodies.
logging.getLogger("drake").setLevel(logging.ERROR)
# mode: the approximation of a discrete plant, and its time step.
MODES = {
    "continuous": None,
    "lagged": (DiscreteContactApproximation.kLagged, "time_step_lagged"),
    "sap": (DiscreteContactApproximation.kSap, "time_step_sap"),
}
# Flight before an impact in a continuous plant, and limit of the impact's duration, both in steps of the integrator.
FLIGHT, LONGEST = 200, 20_000


def ball(parameters, mode, mass, speed):
    """A ball thrown perpendicularly at a half space. Effective mass: `mass`."""

    def build(plant):
        body = plant.AddRigidBody("ball", SpatialInertia.SolidSphereWithMass(mass, RADIUS))
        plant.AddJoint(PrismaticJoint("along", plant.world_frame(), body.body_frame(), [0, 0, 1]))
        return body, RigidTransform()

    return impacts(build, parameters, mode, [1.0], [-1.0], speed)


def two_bodies(parameters, mode, bodies):
    """A lever against a free ball below it."""
    lever, share = bodies.lever, bodies.share

    def build(plant):
        Parser(plant).AddModelsFromString(lever.urdf, "urdf")
        inertia = SpatialInertia.SolidSphereWithMass(bodies.mass, bodies.radius)
        ball = plant.AddRigidBody("ball", default_model_instance(), inertia)
        place = RigidTransform([lever.lever, 0, -bodies.distance])
        plant.AddJoint(PrismaticJoint("along", plant.AddFrame(FixedOffsetFrame("below", plant.world_frame(), place)), ball.body_frame(), [0, 0, 1]))
        sides = ((plant.GetBodyByName("rod"), RigidTransform([lever.lever, 0, 0]), lever.radius), (ball, RigidTransform(), bodies.radius))
        for body, at, radius in sides:
            plant.RegisterCollisionGeometry(body, at, Sphere(radius), body.name(), material(parameters))

    motion = [-share / lever.lever, 1 - share]
    return Outcome.of(lambda phase: impact(build, parameters, mode, [lever.lever, -1.0], motion, lever.speed, phase))


def pendulum(parameters, mode, urdf, length, rotor_inertia, speed):
    """The pendulum of a URDF, read by Drake, swung against a stop below its end."""

    def build(plant):
        Parser(plant).AddModelsFromString(urdf, "urdf")
        actuator = plant.AddJointActuator("rotor", plant.GetJointByName("hinge"))
        actuator.set_default_rotor_inertia(rotor_inertia)
        return plant.GetBodyByName("rod"), RigidTransform([length, 0, 0])

    return impacts(build, parameters, mode, [length], [-1 / length], speed)


def impacts(build, parameters, mode, row, motion, speed):
    """A body against a half space; `build` returns the body and the place of its sphere."""

    def dressed(plant):
        body, place = build(plant)
        plant.RegisterCollisionGeometry(body, place, Sphere(RADIUS), "struck", material(parameters))
        stop = RigidTransform([0, 0, -RADIUS])
        plant.RegisterCollisionGeometry(plant.world_body(), stop, HalfSpace(), "stop", material(parameters))

    return Outcome.of(lambda phase: impact(dressed, parameters, mode, row, motion, speed, phase))


def impact(build, parameters, mode, row, motion, speed, phase):
    """Impact in a plant; `row`: gap in metres per unit of each coordinate; `motion`: rates at a closing speed of 1 m/s. In a continuous plant,
    the phase is the start of the contact within a step of the integrator."""
    row, motion = np.array(row), np.array(motion)
    discrete = MODES[mode]
    builder = DiagramBuilder()
    plant, _ = AddMultibodyPlantSceneGraph(builder, time_step=parameters[discrete[1]] if discrete else 0.0)
    plant.mutable_gravity_field().set_gravity_vector([0, 0, 0])
    build(plant)
    if discrete:
        plant.set_discrete_contact_approximation(discrete[0])
    plant.Finalize()
    simulator = Simulator(builder.Build())
    if not discrete:
        ApplySimulatorConfig(simulation(parameters), simulator)
    context = plant.GetMyMutableContextFromRoot(simulator.get_mutable_context())
    step = plant.time_step() if discrete else parameters["max_step_size"]
    flight = phase if discrete else FLIGHT + phase
    plant.SetPositions(context, -flight * speed * step * motion)
    plant.SetVelocities(context, speed * motion)
    watch = Watch(plant, row)
    simulator.set_monitor(watch)
    simulator.Initialize()
    simulator.AdvanceTo((flight + LONGEST) * step)
    if watch.rebound is None:
        raise RuntimeError("the impact did not end")
    return watch.rebound / speed, watch.depth


def material(parameters):
    properties = ProximityProperties()
    AddContactMaterial(
        dissipation=parameters["hunt_crossley_dissipation"],
        point_stiffness=parameters["point_contact_stiffness"],
        friction=CoulombFriction(0.0, 0.0),
        properties=properties,
    )
    properties.AddProperty("material", "relaxation_time", parameters["relaxation_time"])
    return properties


def simulation(parameters):
    config = SimulatorConfig()
    config.integration_scheme = parameters["integration_scheme"]
    config.accuracy = parameters["accuracy"]
    config.max_step_size = parameters["max_step_size"]
    return config


class Watch:
    """Monitors each step, and ends the run after the gap has opened again."""

    def __init__(self, plant, row):
        self.plant, self.context, self.nothing = plant, None, EventStatus.DidNothing()
        # Height and opening speed of positions and velocities.
        self.rows = np.kron(np.eye(2), row)
        self.depth, self.rebound = 0.0, None

    def __call__(self, root):
        # The simulator has one context for all steps.
        if self.context is None:
            self.context = self.plant.GetMyContextFromRoot(root)
        height, opening = self.rows.dot(self.plant.GetPositionsAndVelocities(self.context)).tolist()
        if -height > self.depth:
            self.depth = -height
        if opening > 0 and height > 0:
            self.rebound = opening
            return EventStatus.ReachedTermination(self.plant, "the gap has opened")
        return self.nothing
