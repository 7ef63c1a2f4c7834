"""Tests the exported snippets with compilers and readers, if installed: Jolt's and PhysX's C++ with a compiler and
their headers, MATLAB with Octave, SDF with the SDFormat program. Each reader raises Absent if its program is
missing.

The headers are those of the packages in `headers/Cargo.toml` (fetched by `cargo fetch`), or are in
PERCUSS_PHYSX_HEADERS and PERCUSS_JOLT_HEADERS."""

import functools
import json
import os
import re
import shutil
import subprocess
import tempfile
import xml.etree.ElementTree as ElementTree
from pathlib import Path

from scenes import Absent

MANIFEST = Path(__file__).parent / "headers/Cargo.toml"
NUMBER = r"[-+]?\d+\.?\d*(?:e[-+]?\d+)?"
PHYSX = """#include <PxPhysicsAPI.h>
using namespace physx;
void paste(PxMaterial *material, PxScene *scene, PxRigidDynamic *body) {{
{}}}
"""
PHYSX_STOP = """#include <PxPhysicsAPI.h>
using namespace physx;
void paste(%s *joint, float lower, float upper, PxScene *scene) {{
{}}}
"""
JOLT = """#include <Jolt/Jolt.h>
#include <Jolt/Physics/Body/BodyCreationSettings.h>
#include <Jolt/Physics/PhysicsSystem.h>
void paste(JPH::BodyCreationSettings &settings, JPH::PhysicsSystem &system, JPH::TempAllocator *allocator, JPH::JobSystem *jobs) {{
{}}}
"""


def output(*command, **options):
    run = subprocess.run([str(word) for word in command], capture_output=True, text=True, **options)
    if run.returncode:
        raise RuntimeError(f"{command[0]}: exit {run.returncode}\n{run.stderr[-2000:]}")
    return run.stdout


def needs(program, install):
    if not shutil.which(program):
        raise Absent(install)


@functools.cache
def headers():
    """{package: its folder} of the packages fetched by cargo."""
    needs("cargo", "cargo")
    host = re.search("host: (.*)", output("rustc", "-vV"))[1]
    words = ("--offline", "--locked", "--format-version", "1", "--filter-platform", host, "--manifest-path", MANIFEST)
    try:
        found = json.loads(output("cargo", "metadata", *words))
    except RuntimeError:
        raise Absent("headers: cargo fetch --manifest-path tests/external/contact/headers/Cargo.toml") from None
    return {package["name"]: Path(package["manifest_path"]).parent for package in found["packages"]}


# Compiled snippets without their numbers: snippets that differ only in numbers are compiled once.
_compiled = set()


def compiles(text, frame, variable, package, *folders):
    needs("c++", "c++")
    shape = re.sub(NUMBER, "0", text)
    if (package, shape) in _compiled:
        return
    given = os.environ.get(variable)
    paths = [Path(given)] if given else [headers()[package] / folder for folder in folders]
    flags = [word for path in paths for word in ("-isystem", path)]
    output("c++", "-std=c++17", "-fsyntax-only", "-Werror", "-Wfloat-conversion", "-DNDEBUG", *flags, "-x", "c++", "-", input=frame.format(text))
    _compiled.add((package, shape))


def of(pattern, text):
    """The number that follows a pattern."""
    return float(re.search(pattern + f"({NUMBER})", text)[1])


def physx(text, parameters):
    if "limit_stiffness" in parameters:
        return physx_stop(text, parameters)
    damping = "compliant_contact_damping" + ("_tgs" if "eTGS" in text else "")
    assert of(r"setRestitution\(", text) == -parameters["compliant_contact_stiffness"]
    assert of(r"setDamping\(", text) == parameters[damping]
    assert of(r"simulate\(", text) == parameters["dt"]
    compiles(text, PHYSX, "PERCUSS_PHYSX_HEADERS", "physx-sys", "physx/physx/include")


def physx_stop(text, parameters):
    """Checks the numbers for the joint named in the text."""
    spring = [float(number) for number in re.search(rf"PxSpring\(({NUMBER})f, ({NUMBER})f\)", text).groups()]
    assert spring == [parameters["limit_stiffness"], parameters["limit_damping"]], spring
    assert of(r"simulate\(", text) == parameters["dt"]
    joint = re.search(r"joint is a physx::(\w+)", text)[1]
    compiles(text, PHYSX_STOP % joint, "PERCUSS_PHYSX_HEADERS", "physx-sys", "physx/physx/include")


def jolt(text, parameters):
    for name in ("mRestitution", "mFriction", "mMinVelocityForRestitution", "mNumVelocitySteps"):
        assert of(f"{name} = ", text) == parameters[name], name
    assert of(r"Update\(", text) == parameters["inDeltaTime"]
    compiles(text, JOLT, "PERCUSS_JOLT_HEADERS", "joltc-sys", "JoltC/JoltPhysics")


def matlab(text, parameters):
    """Runs the snippet in Octave; prints the settings for Simulink."""
    needs("octave-cli", "octave (packages.sh --with-octave)")
    test = (
        "gcs = 'model';\nfunction set_param(model, varargin)\n  printf('%s\\n', varargin{:});\nend\n"
        + text
        + "printf('%.17g\\n', contact_stiffness, contact_damping, contact_transition_width);\n"
    )
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "pasted.m"
        path.write_text("1;\n" + test)
        *settings, k, c, width = output("octave-cli", "--quiet", "--norc", path).split("\n")[:-1]
    names = ("Stiffness", "Damping", "Transition Region Width")
    assert [float(k), float(c), float(width)] == [parameters[name] for name in names]
    settings = dict(zip(settings[::2], settings[1::2]))
    for name in ("RelTol", "AbsTol"):
        assert float(settings[name]) == parameters[name], name


@functools.cache
def specification(version):
    return ElementTree.fromstring(output("ign", "sdf", "-d", version))


def sdf(text, parameters):
    """The SDFormat program accepts the text, and every element is in the specification of its stated version: the
    program silently accepts unknown elements."""
    needs("ign", "ignition-tools and libsdformat-dev (packages.sh)")
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "pasted.sdf"
        path.write_text(text)
        try:
            said = output("ign", "sdf", "-k", path)
        except RuntimeError as error:
            if "cannot find any available" in str(error):
                raise Absent("libsdformat-dev (packages.sh)") from None
            raise
    assert "Valid." in said, said
    root = ElementTree.fromstring(text)
    known(root, specification(root.get("version")))


def known(element, described):
    for child in element:
        places = [place for place in described.findall("element") if place.get("name") == child.tag]
        assert places, f"<{child.tag}> is not in <{element.tag}>"
        known(child, places[0])


READERS = {
    ("gazebo", "xml"): sdf,
    ("gazebo-classic", "xml"): sdf,
    ("jolt", "cpp"): jolt,
    ("physx", "cpp"): physx,
    ("simscape", "matlab"): matlab,
}
