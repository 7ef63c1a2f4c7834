"""Ctrl-C stops every long call within 0.2 s."""

from __future__ import annotations

import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest
from cases import ROOT

#: Calls that take several seconds, after the line `arm, tool = …`.
CALLS = {
    "tolerate": 'percuss.tolerate(arm, tool, "mass=2%,com=1mm", samples=100_000)',
    "compare": 'percuss.compare([percuss.Design("a", arm, tool), percuss.Design("b", arm, tool)], random=3_000_000)',
    "safe_speed": 'percuss.safe_speed(arm, tool, "chest", force=140.0, random=10_000_000)',
    "sweep_report": "percuss.sweep_report(arm, tool, random=10_000_000)",
    "extremes": 'percuss.extremes(arm, tool, ranges={"yaw": (-3, 3), "shoulder": (-2, 2), "elbow": (-2, 2)}, starts=1_000_000)',
    "sweep": "percuss.sweep(arm, tool, np.zeros((20_000_000, arm.position_count)), gradient=True)",
    "contact_map": "[arm.pose().contact_map('tool', points, points) for _ in range(1000)]",
}
#: From the signal to KeyboardInterrupt. 0.2 s on an idle machine; processors are shared with other tests here.
LIMIT = 1.0

PROGRAM = """
import sys, time
import numpy as np
import percuss
ROOT = {model!r}
arm = percuss.load(ROOT)
tool = percuss.Contact("tool", [0.08, 0, 0], [0, 1, 0])
points = np.random.default_rng(1).uniform(0.1, 1, (2_000_000, 3))
print("ready", flush=True)
try:
    {call}
    print("finished", flush=True)
except KeyboardInterrupt:
    print("stopped", time.time(), flush=True)
"""


@pytest.mark.parametrize("name", CALLS)
def test_ctrl_c(name: str, tmp_path: Path) -> None:
    program = PROGRAM.format(model=str(ROOT / "models/six_r_arm.urdf"), call=CALLS[name])
    run = subprocess.Popen([sys.executable, "-c", program], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    assert run.stdout is not None
    assert run.stdout.readline() == "ready\n"
    time.sleep(1.0)
    sent = time.time()
    run.send_signal(signal.SIGINT)
    printed, errors = run.communicate(timeout=30)
    words = printed.split()
    assert words[:1] == ["stopped"], (printed, errors[-2000:])
    assert float(words[1]) - sent <= LIMIT, f"{float(words[1]) - sent:.2f} s"
