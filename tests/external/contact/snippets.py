"""Checks the snippets of `percuss damp … --for all` in their target programs.

All XML and JSON must parse, and all Python must compile. MuJoCo loads its snippets; Drake's Python is run, and Drake
reads its URDF and SDF in their place; Drake's SDFormat library reads Gazebo's SDF. The values read must equal the
exported parameters. Snippets of other tools go to the compilers and readers of compilers.py, if installed; unread
snippets are reported."""

import ast
import json
import xml.etree.ElementTree as ElementTree

import mujoco
import numpy as np
from pydrake.multibody.parsing import Parser
from pydrake.multibody.plant import AddMultibodyPlantSceneGraph
from pydrake.systems.framework import DiagramBuilder

import compilers
from scenes import Absent

PARSERS = {"xml": ElementTree.fromstring, "json": json.loads, "python": ast.parse}
# Required snippets: a missing snippet is a failure.
EXPECTED = {
    ("mujoco", "xml"),
    ("drake", "xml"),
    ("drake", "python"),
    ("gazebo-classic", "xml"),
    ("bullet", "python"),
    ("physx", "python"),
    ("jolt", "cpp"),
    ("physx", "cpp"),
    ("simscape", "matlab"),
}
# Required snippets of a joint's stop.
EXPECTED_OF_STOPS = {("mujoco", "xml"), ("ode", "cpp"), ("newton", "python"), ("physx", "cpp")}
INERTIAL = '<mass value="1"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/>'


def check(report, where, tally, expected=EXPECTED):
    """Tests all snippets of a report. Returns a line for each snippet without its program."""
    seen, absents = set(), set()
    for tool, export in report["exports"].items():
        for snippet in export["snippets"]:
            language, text = snippet["language"], snippet["text"]
            seen.add((tool, language))
            readers = [PARSERS.get(language)]
            for loader in (LOADERS.get((tool, language)), compilers.READERS.get((tool, language))):
                if loader:
                    readers.append(lambda text, load=loader, of=export["parameters"]: load(text, of))
            for reader in filter(None, readers):
                wrong = ""
                try:
                    reader(text)
                except Absent as absent:
                    absents.add(f"snippets not read: {tool}, {language}; install {absent}")
                    continue
                except Exception as error:  # any exception of an external reader is a failure of the snippet
                    wrong = f"{type(error).__name__}: {error}"
                tally.check(f"snippets: {tool}, {language}", f"{where}, {snippet['title']}", not wrong, wrong)
    # Slow impacts move so little in a step that tools of single precision are refused.
    refused = {tool for tool, export in report["exports"].items() if "single precision" in (export["error"] or "")}
    missing = {(tool, language) for tool, language in expected - seen if tool not in refused}
    tally.check("snippets: none is missing", where, not missing, f"{missing}")
    return absents


def same(theirs, ours):
    assert np.array_equal(theirs, ours), f"{theirs} was read where {ours} was exported"


def in_mujoco(text, parameters):
    spec = mujoco.MjSpec.from_string(text)
    spec.worldbody.add_geom(type=mujoco.mjtGeom.mjGEOM_SPHERE, size=[1, 0, 0])
    body = spec.worldbody.add_body(name="held", mass=1, inertia=[1, 1, 1])
    body.add_freejoint()
    limited = spec.worldbody.add_body(name="limited", mass=1, inertia=[1, 1, 1])
    limited.add_joint(name="stopped", range=[-1, 1], limited=True)
    spec.add_equality(type=mujoco.mjtEq.mjEQ_WELD, objtype=mujoco.mjtObj.mjOBJ_BODY, name1="held")
    model = spec.compile()
    same(model.opt.timestep, parameters["timestep"])
    if "solreflimit" in parameters:
        joint = model.joint("stopped").id
        same(model.jnt_solref[joint], parameters["solreflimit"])
        same(model.jnt_solimp[joint][:3], parameters["solimplimit"])
    else:
        standard = model.geom_solref[0][0] > 0
        same(model.geom_solref[0], parameters["solref_standard" if standard else "solref"])
        same(model.geom_solimp[0][:3], parameters["solimp"])
    if "equality_solref" in parameters:
        same(model.eq_solref[0], parameters["equality_solref"])
        same(model.eq_solimp[0][:3], parameters["equality_solimp"])


def drake_properties(properties, parameters):
    for name in ("point_contact_stiffness", "hunt_crossley_dissipation", "relaxation_time"):
        same(properties.GetProperty("material", name), parameters[name])


def in_pydrake(text, parameters):
    names = {}
    exec(text, names)
    drake_properties(names["properties"], parameters)
    for name in ("integration_scheme", "accuracy", "max_step_size"):
        same(getattr(names["config"], name), parameters[name])


def in_drake_file(text, parameters):
    """The notation of numbers distinguishes the two formats."""
    if 'value="' in text:
        collision = f'<collision><geometry><sphere radius="1"/></geometry>{text}</collision>'
        document, kind = f'<robot name="r"><link name="l"><inertial>{INERTIAL}</inertial>{collision}</link></robot>', "urdf"
    else:
        collision = f'<collision name="c"><geometry><sphere><radius>1</radius></sphere></geometry>{text}</collision>'
        document, kind = f'<sdf version="1.9"><model name="r"><link name="l">{collision}</link></model></sdf>', "sdf"
    plant, scene = read_by_drake(document, kind)
    (geometry,) = plant.GetCollisionGeometriesForBody(plant.GetBodyByName("l"))
    drake_properties(scene.model_inspector().GetProximityProperties(geometry), parameters)


def read_by_drake(document, kind):
    plant, scene = AddMultibodyPlantSceneGraph(DiagramBuilder(), time_step=0.0)
    Parser(plant).AddModelsFromString(document, kind)
    return plant, scene


LOADERS = {
    ("mujoco", "xml"): in_mujoco,
    ("drake", "python"): in_pydrake,
    ("drake", "xml"): in_drake_file,
    ("gazebo", "xml"): lambda text, _: read_by_drake(text, "sdf"),
    ("gazebo-classic", "xml"): lambda text, _: read_by_drake(text, "sdf"),
}
