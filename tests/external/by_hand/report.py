"""Reports in a browser: no network access, no console messages, all pictures present, correct numbers.

    python3 tests/external/by_hand/report.py PERCUSS [CHROMIUM]

Needs Debian's package chromium. Every study of models/, and an initial study of each model by percuss init, is reported
and opened headless; each page is also printed on A4. Takes about 5 s per report.
"""

import json
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[3]
FLAGS = """--headless --no-sandbox --disable-gpu --disable-quic --no-first-run --disable-background-networking --disable-component-update
--disable-sync --disable-extensions --enable-logging=stderr --virtual-time-budget=4000""".split()
# Added to a copy of the page, in which scripts may run: counts the pictures and the drawn pictures.
COUNT = """<script>addEventListener('load', () => { const all = [...document.images];
document.title = 'pictures ' + all.length + ' drawn ' + all.filter(i => i.complete && i.naturalWidth > 100).length; })</script>"""


def opened(chromium, folder, page, *more):
    log = folder / "net.json"
    command = [chromium, *FLAGS, f"--user-data-dir={folder / 'profile'}", f"--log-net-log={log}", *more, page.as_uri()]
    done = subprocess.run(command, capture_output=True, text=True, timeout=120)
    asked = set(re.findall(r'"url":"([a-z]+:[^"]{0,80})', log.read_text())) if log.exists() else set()
    fetched = {url.split("/")[2] for url in asked if not url.startswith(("file:", "data:", "chrome"))}
    console = [line for line in done.stderr.splitlines() if "CONSOLE" in line]
    return done.stdout, fetched, console


def main():
    percuss = str(pathlib.Path(sys.argv[1]).resolve())
    chromium = sys.argv[2] if len(sys.argv) > 2 else shutil.which("chromium")
    assert chromium, "no chromium: name it as the second argument"
    failures, checked = [], 0
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        shutil.copytree(ROOT / "models", folder / "models")
        # Requests of the browser itself, independent of the page.
        empty = folder / "empty.html"
        empty.write_text("<!DOCTYPE html><title>empty</title><p>empty</p>")
        _, own, _ = opened(chromium, folder, empty, "--dump-dom")
        studies = sorted((folder / "models").glob("*.toml")) + sorted((folder / "models/studies").glob("*.toml"))
        for model in sorted((folder / "models").glob("*.urdf")):
            study = model.with_name(f"init-{model.stem}.toml")
            subprocess.run([percuss, "init", model, "-o", study], check=True, capture_output=True)
            studies.append(study)
        for study in studies:
            page = study.with_suffix(".html")
            made = subprocess.run([percuss, "run", study, "--report", page], capture_output=True, text=True)
            if made.returncode:
                failures.append(f"{study.name}: {made.stderr}")
                continue
            text, fetched, console = opened(chromium, folder, page, "--dump-dom")
            answer = json.loads(page.with_suffix(".json").read_text())
            mass = answer["effective_mass"]
            if mass is not None and f"m̄ = {mass:.9g}" not in text and f"m̄ = {mass:.3f}"[:-1] not in text:
                failures.append(f"{study.name}: {mass} kg is not in the page")
            counted = page.with_name(page.stem + "-counted.html")
            source = re.sub(r"<meta http-equiv=\"Content-Security-Policy\"[^>]*>", COUNT, page.read_text())
            counted.write_text(source)
            shown, _, _ = opened(chromium, folder, counted, "--dump-dom")
            found = re.search(r"<title>pictures (\d+) drawn (\d+)</title>", shown)
            if not found or found[1] != found[2] or int(found[1]) < 1:
                failures.append(f"{study.name}: pictures: {found and found[0]}")
            if fetched - own or console:
                failures.append(f"{study.name}: fetched {fetched - own}, console {console}")
            paper = page.with_suffix(".pdf")
            opened(chromium, folder, page, "--no-pdf-header-footer", f"--print-to-pdf={paper}")
            if not paper.exists() or b"/Page" not in paper.read_bytes():
                failures.append(f"{study.name}: it does not print")
            checked += 1
    print("\n".join(failures))
    print(f"{checked} reports, {len(failures)} failures")
    sys.exit(1 if failures or checked < 20 else 0)


main()
