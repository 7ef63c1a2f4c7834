"""Programs of this folder, compiled into target/external where they are older than their source."""

import shutil
import subprocess
from pathlib import Path

from impacts import PHASES, Outcome
from scenes import Absent, velocities

HERE, BUILT = Path(__file__).parent, Path("target/external")


def needs(package, *programs):
    for program in programs:
        if not shutil.which(program):
            raise Absent(f"{package} ({program} is missing)")


def output(*command, **options):
    run = subprocess.run([str(word) for word in command], capture_output=True, text=True, **options)
    if run.returncode:
        raise RuntimeError(f"{command[0]}: exit {run.returncode}\n{run.stderr[-2000:]}")
    return run.stdout


def c(name, flags, compiler=("cc", "-O2"), variant=None):
    """The program of a source file; `variant`: where there are several of one file."""
    source, program = HERE / name, BUILT / "-".join(filter(None, (Path(name).stem, variant)))
    if not program.exists() or program.stat().st_mtime < source.stat().st_mtime:
        BUILT.mkdir(parents=True, exist_ok=True)
        output(*compiler, "-o", program, source, *flags)
    return program


def compiles(text, *flags):
    """C++ text."""
    output("c++", "-std=c++17", "-x", "c++", "-fsyntax-only", *flags, "-", input=text)


def outcome(program, arguments, travel):
    """A program's: its arguments, then the gap at the start for each phase, `travel` being the way of one step; it prints a
    restitution and a penetration for each."""
    gaps = [repr(phase * travel) for phase in PHASES]
    words = [repr(word) if isinstance(word, float) else str(word) for word in arguments]
    lines = iter(output(program, *words, *gaps).splitlines())
    return Outcome.of(lambda _: [float(word) for word in next(lines).split()])


def linkage(linkage, speed):
    """As the programs take it: the numbers of bodies and of hinges, then as four_bar."""
    return [len(linkage.bodies), len(linkage.hinges), *four_bar(linkage, speed)]


def four_bar(four_bar, speed):
    """As Chrono's program takes it: the sphere's radius and place; of each body mass, inertia, centre, velocity and rate; of each hinge its
    two bodies (-1: the ground) and place."""
    numbers, names = [four_bar.radius, *four_bar.point], [*four_bar.bodies]
    for name, (velocity, rate) in velocities(four_bar, speed).items():
        mass, inertia, centre, _ = four_bar.bodies[name]
        numbers += (mass, inertia, *centre, *velocity, rate)
    for a, b, at in four_bar.hinges:
        numbers += (names.index(a), names.index(b) if b else -1, *at)
    return numbers
