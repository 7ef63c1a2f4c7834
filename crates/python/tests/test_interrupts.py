"""Ctrl-C stops every long call.

The time from the signal to the exception is printed. It is compared with LIMIT only if PERCUSS_JUDGE_TIMES is set: it depends on the
machine and on the other programs that run."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest
from cases import ROOT

#: Calls that take longer than 3 s, after the preparations of PROGRAM.
CALLS = {
    "tolerate": 'percuss.reports.tolerate(arm, tool, "mass=2%,com=1mm", samples=100_000)',
    "tolerate a sheet": 'percuss.reports.tolerate(corner, "bump_stop", "mass=2%,point=0.5mm", samples=100_000)',
    "compare": 'percuss.study.compare([percuss.study.Design("a", arm, tool), percuss.study.Design("b", arm, tool)], random=3_000_000)',
    "compare poses": 'percuss.study.compare([percuss.study.Design(str(k), corner, "bump_stop") for k in range(2000)])',
    "safe_speed": 'percuss.safe_speed(arm, tool, "chest", force=140.0, random=30_000_000)',
    "sweep_report": "percuss.reports.sweep_report(arm, tool, random=10_000_000)",
    "sweep_report of loops": 'percuss.reports.sweep_report(corner, "bump_stop", vary="wheel-travel=-60mm:60mm:1000000")',
    "extremes": '[percuss.extremes(arm, tool, ranges={"yaw": (-3, 3), "shoulder": (-2, 2), "elbow": (-2, 2)}, starts=2000) for _ in range(100)]',
    "impact in time": "[percuss.impact(chain, percuss.Contact('link_59', [0.1, 0, 0], [0, 0, 1]), 0.5, speed=1.0, stiffness=1e5, "
    "in_time=True, gravity=[0, 0, -9.81]) for _ in range(100)]",
    "impact_history": "[percuss.contact_law.impact_history(2.0, percuss.contact_law.Damping(0.5, 1e5, speed=1.0), 1_000_000) for _ in range(1000)]",
    "kinematics": "percuss.suspension.kinematics(corner, wheel_travel=np.linspace(-0.05, 0.05, 1_000_000))",
    "map_point": "percuss.reports.map_point(percuss.loads(urdf(200)), percuss.Contact('link_99', [0, 0, 0], [0, 0, 1]), 1_000_000)",
    "map": "[percuss.map(shaped, edge=0.002) for _ in range(100)]",
    "map of small facets": "percuss.map(shaped, edge=0.0005)",
    "sweep": "percuss.sweep(arm, tool, np.zeros((20_000_000, arm.position_count)), gradient=True)",
    "sweep of a path": "percuss.sweep(corner, seat, np.linspace(-0.2, 0.2, 30_000_000)[:, None], joints=[corner.assemble().drivers[0]])",
    "contact_map": "[arm.pose().contact_map('tool', points, points) for _ in range(1000)]",
    "effective_mass": "[percuss.effective_mass(matrix, matrix[0]) for _ in range(100)]",
    "effective_mass with A": "[percuss.effective_mass(matrix, matrix[0], rows) for _ in range(100)]",
    "effective_mass of redundant rows": "[percuss.effective_mass(matrix, matrix[0], np.vstack([rows, rows])) for _ in range(100)]",
    "effective_masses": "percuss.effective_masses(np.tile(matrix[:300, :300], (256, 1, 1)), matrix[0, :300], rows[:100, :300])",
    "respond": "[chain.pose().respond(percuss.Contact('link_59', [0.1, 0, 0], [0, 0, 1]), route='dense') for _ in range(10_000)]",
    "load": "[percuss.loads(text) for _ in range(100)]",
    "changed": "[corner.changed(move={corner.hardpoints[0]: (0, 0, 1e-4)}) for _ in range(100_000)]",
}
#: From the signal to KeyboardInterrupt, s: a person sees a reaction within 0.2 s as immediate.
LIMIT = 0.2

PROGRAM = """
import sys, time, warnings
import numpy as np
import percuss
warnings.simplefilter("ignore")
MODELS = {models!r}
arm = percuss.load(MODELS + "/six_r_arm.urdf")
shaped = percuss.load(MODELS + "/shaped_arm.urdf")
corner = percuss.load(MODELS + "/suspensions/double-wishbone.toml")
tool = percuss.Contact("tool", [0.08, 0, 0], [0, 1, 0])
seat = percuss.Contact("spindle", [0.0, 0, 0], [0, 0, 1])

def urdf(count):
    links = "".join(
        f'<link name="link_{{k}}"><inertial><origin xyz="0.05 0.01 0"/><mass value="1"/>'
        '<inertia ixx=".01" iyy=".02" izz=".015" ixy="0" ixz="0" iyz="0"/></inertial></link>' for k in range(count)
    )
    joints = "".join(
        f'<joint name="joint_{{k}}" type="continuous"><parent link="link_{{k - 1}}"/><child link="link_{{k}}"/>'
        f'<origin xyz="0.1 0 0"/><axis xyz="{{k % 2}} {{1 - k % 2}} 0"/></joint>' for k in range(1, count)
    )
    return '<robot name="chain">' + links + joints + "</robot>"

chain, text = percuss.loads(urdf(60)), urdf(30_000)
random = np.random.default_rng(1)
points = random.uniform(0.1, 1, (2_000_000, 3))
root = random.normal(size=(1000, 1000))
matrix, rows = root @ root.T + np.eye(1000), random.normal(size=(400, 1000))
print("ready", flush=True)
try:
    {call}
    print("finished", flush=True)
except KeyboardInterrupt:
    print("stopped", time.time(), time.process_time(), flush=True)
    # Until no thread of the call works any more.
    spent = {watched}
    for _ in range({watches}):
        before = time.process_time()
        time.sleep({watched})
        spent = time.process_time() - before
        if spent <= {idle}:
            break
    print("idle", spent, flush=True)
"""
#: After an interrupted call its threads end when their present step is done. The process is watched for WATCHED, s, up to WATCHES times,
#: until the CPU time within one of them is that of sleeping, at most IDLE, s.
WATCHED, WATCHES, IDLE = 0.5, 40, 0.05


def cpu_seconds(process: int) -> float:
    """CPU time of a process, s."""
    fields = Path(f"/proc/{process}/stat").read_text().rsplit(")", 1)[1].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


@pytest.mark.parametrize("name", CALLS)
def test_ctrl_c(name: str) -> None:
    program = PROGRAM.format(models=str(ROOT / "models"), call=CALLS[name], watched=WATCHED, watches=WATCHES, idle=IDLE)
    run = subprocess.Popen([sys.executable, "-c", program], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    assert run.stdout is not None
    assert run.stdout.readline() == "ready\n", run.communicate()[1][-2000:]
    # The delay differs between calls, so that the signal arrives in different parts of the work.
    time.sleep(0.7 + 0.5 * (sum(map(ord, name)) % 97) / 97)
    sent, spent = time.time(), cpu_seconds(run.pid)
    run.send_signal(signal.SIGINT)
    printed, errors = run.communicate(timeout=60)
    words = printed.split()
    assert words[:1] == ["stopped"], (printed, errors[-2000:])
    elapsed, spent = float(words[1]) - sent, float(words[2]) - spent
    print(f"{name}: {elapsed:.2f} s, {spent:.2f} s of CPU time")
    if "PERCUSS_JUDGE_TIMES" in os.environ:
        # Other processes may delay this one: the smaller of the elapsed time and the CPU time of all threads since the signal.
        assert min(elapsed, spent) <= LIMIT, f"{elapsed:.2f} s, {spent:.2f} s of CPU time"
    assert float(words[4]) <= IDLE, f"{words[4]} s of CPU time in {WATCHED} s, {WATCHED * WATCHES} s after the call was stopped"
