"""Reports in a browser, among them that of a user who begins in an empty folder.

    python3 tests/external/reports.py --percuss PATH [--every] [--chromium PATH] [--keep FOLDER]

Needs Debian's package chromium. Checked for each report: no network access, no console messages, all pictures present, the
number of the command in the page, links of the contents with a target, pages on A4. Without --every: the own car, and the study
that has all sections; with it also every other study of models/, and an initial study of each model by percuss init (2 min).
"""

import argparse
import json
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
FLAGS = """--headless --no-sandbox --disable-gpu --disable-quic --no-first-run --disable-background-networking --disable-component-update
--disable-sync --disable-extensions --enable-logging=stderr --virtual-time-budget=4000""".split()
# Added to a copy of the page, in which scripts may run: counts the pictures and the drawn pictures.
COUNT = """<script>addEventListener('load', () => { const all = [...document.querySelectorAll('figure svg')];
const isDrawn = s => s.getBoundingClientRect().width > 100 && s.getBBox().height > 100;
document.title = 'pictures ' + all.length + ' drawn ' + all.filter(isDrawn).length; })</script>"""


def opened(chromium, folder, page, *more):
    log = folder / "net.json"
    command = [chromium, *FLAGS, f"--user-data-dir={folder / 'profile'}", f"--log-net-log={log}", *more, page.as_uri()]
    done = subprocess.run(command, capture_output=True, text=True, timeout=120)
    asked = set(re.findall(r'"url":"([a-z]+:[^"]{0,80})', log.read_text())) if log.exists() else set()
    fetched = {url.split("/")[2] for url in asked if not url.startswith(("file:", "data:", "chrome"))}
    console = [line for line in done.stderr.splitlines() if "CONSOLE" in line]
    return done.stdout, fetched, console


class Checker:
    def __init__(self, percuss, chromium, folder):
        self.percuss, self.chromium, self.folder = percuss, chromium, folder
        self.passed, self.failed = 0, 0
        # Requests of the browser itself, independent of the page.
        empty = folder / "empty.html"
        empty.write_text("<!DOCTYPE html><title>empty</title><p>empty</p>")
        _, self.own_requests, _ = opened(chromium, folder, empty, "--dump-dom")

    def verdict(self, good, what):
        self.passed, self.failed = self.passed + bool(good), self.failed + (not good)
        if not good:
            print(f"FAILED {what}", flush=True)
        return good

    def command(self, folder, *words):
        """Output of a command that a user types in a folder."""
        done = subprocess.run([self.percuss, *words], cwd=folder, capture_output=True, text=True)
        self.verdict(done.returncode == 0, f"percuss {' '.join(words)}: {done.stderr}")
        return done.stdout

    def report(self, study):
        """Reports a study and checks the page; returns its text and the result, None without a report."""
        page = study.with_suffix(".html")
        made = subprocess.run([self.percuss, "run", study, "--report", page], capture_output=True, text=True)
        if not self.verdict(made.returncode == 0, f"{study.name}: {made.stderr}"):
            return None
        text, fetched, console = opened(self.chromium, self.folder, page, "--dump-dom")
        answer = json.loads(page.with_suffix(".json").read_text())
        # The list of several contacts has the result of each; the page details the first.
        reports = [contact["report"] for contact in answer.get("contacts", []) if contact["report"]]
        mass = (reports[0] if reports else answer)["effective_mass"]
        # Four significant digits, with tolerances only those that they support.
        numbers = [float(number) for number in re.findall(r"\b\d+(?:\.\d+)?(?:e[+-]?\d+)?\b", re.sub("<svg.*?</svg>", "", text, flags=re.S))]
        has_number = mass is None or any(abs(number - mass) <= 6e-4 * mass for number in numbers)
        self.verdict(has_number, f"{study.name}: {mass} kg is not in the page")
        targets = set(re.findall(r'href="#([^"]+)"', text))
        missing = [target for target in targets if f'id="{target}"' not in text]
        self.verdict(not missing, f"{study.name}: links without a target: {missing}")
        counted = page.with_name(page.stem + "-counted.html")
        counted.write_text(re.sub(r"<meta http-equiv=\"Content-Security-Policy\"[^>]*>", COUNT, page.read_text()))
        shown, _, _ = opened(self.chromium, self.folder, counted, "--dump-dom")
        found = re.search(r"<title>pictures (\d+) drawn (\d+)</title>", shown)
        drawn = found and found[1] == found[2] and int(found[1]) >= 1
        self.verdict(drawn, f"{study.name}: pictures: {found and found[0]}")
        quiet = not (fetched - self.own_requests or console)
        self.verdict(quiet, f"{study.name}: fetched {fetched - self.own_requests}, console {console}")
        paper = page.with_suffix(".pdf")
        opened(self.chromium, self.folder, page, "--no-pdf-header-footer", f"--print-to-pdf={paper}")
        # Every page object states the size of A4, 595 by 842 points.
        is_a4 = paper.exists() and re.search(rb"/MediaBox \[0 0 59[45][.0-9]* 84[12]", paper.read_bytes())
        self.verdict(is_a4, f"{study.name}: it does not print on A4")
        return text, answer

    def own_car(self, folder):
        """From an empty folder to the report of an own car, in the axes of Adams and in millimetres."""
        self.command(folder, "template", "pushrod-rocker", "--unit", "mm", "--axes", "adams", "-o", "car.toml")
        sheet = folder / "car.toml"
        text = sheet.read_text()
        changed = text.replace("[0.0, -520.0, 140.0] ", "[4.0, -528.0, 143.0] ").replace("mass = 18.5", "mass = 17.2")
        changed = re.sub(r'name = "[^"]*"', 'name = "front corner, car 27"', changed)
        self.verdict(changed.count("143.0") == 1 and changed.count("17.2") == 1, "the template has other values")
        sheet.write_text(changed)
        listed = self.command(folder, "mass", "car.toml", "--at", "all")
        self.verdict(all(name in listed for name in ["bump_stop", "spring", "contact_patch"]), f"--at all: {listed}")
        asked = self.command(folder, "mass", "car.toml", "--at", "bump_stop", "--format", "json")
        expected = json.loads(asked or "{}").get("effective_mass")
        self.command(folder, "init", "car.toml", "-o", "study.toml")
        study = folder / "study.toml"
        head = '[report]\ntitle = "Bump stop, front"\nauthor = "A. Engineer"\nobject = "Car 27"\ndate = 2026-11-26\n\n'
        # The suggestions of the initial study, as a user takes them: without the "# ".
        lines, taken = [], False
        for line in study.read_text().splitlines():
            if re.match(r"# \[(sweep|mass|damping|\[variant\])\]", line):
                taken = True
            if not line.strip():
                taken = False
            is_key = taken and re.match(r"# (\[|[a-z_]+ = )", line)
            lines.append(line[2:] if is_key and "output" not in line else line)
        study.write_text(head + "\n".join(lines) + "\n")
        made = self.report(study)
        if made is None:
            return
        page, answer = made
        self.verdict(answer["effective_mass"] == expected, f"report {answer['effective_mass']}, command {expected}")
        words = ["Bump stop, front", "A. Engineer", "Car 27", "2026-11-26", "The mechanism", "The damper", "The sweep", "Variants"]
        missing = [word for word in words if word not in page]
        self.verdict(not missing, f"the report of the own car lacks {missing}")
        self.other_contacts(folder, sheet, head)

    def other_contacts(self, folder, sheet, head):
        """A contact of the user's own, a search for a hardpoint, kinematics, and the report of all contacts of two designs."""
        skid = '\n[contact.skid]\npoint = [0.0, -420.0, 120.0]\non = "lower_arm"\ndirection = [0.0, 0.0, -1.0]\n'
        sheet.write_text(sheet.read_text() + skid)
        search = ["--solve", "rocker_back.z", "--for", "motion_ratio=0.95", "--within", "15mm"]
        found = self.command(folder, "kinematics", "car.toml", *search, "-o", "changed.toml")
        self.verdict("0.95" in found and (folder / "changed.toml").exists(), f"search: {found}")
        ratio = self.command(folder, "kinematics", "changed.toml", "--columns", "spring.motion_ratio", "--format", "csv")
        self.verdict(abs(float(ratio.split()[-1]) - 0.95) < 1e-9, f"the ratio of the changed car: {ratio}")
        study = folder / "contacts.toml"
        study.write_text(
            head + '[model]\npath = "car.toml"\n[contact]\nat = "all"\n[mass]\ntolerance = "mass=2%,point=0.5mm"\n'
            '[damping]\nstiffness = "250 N/mm"\nrestitution = 0.3\nspeed = "0.4 m/s"\n'
            '[sweep]\nvary = "wheel-travel=-30mm:20mm:11"\n[kinematics]\nvary = "wheel-travel=-30mm:20mm:11"\n'
            '[[variant]]\nname = "changed"\nmodel = "changed.toml"\n'
        )
        made = self.report(study)
        if made is None:
            return
        page, answer = made
        names = {contact["name"] for contact in answer["contacts"]}
        expected = {"bump_stop", "rebound_stop", "spring", "damper", "contact_patch", "skid"}
        self.verdict(names == expected, f"contacts of the report: {names}")
        words = ["Effective mass at skid", "Effective mass at bump_stop", "changed: skid", "± tolerances", "Kinematics", "touch"]
        missing = [word for word in words if word not in page]
        self.verdict(not missing, f"the report of all contacts lacks {missing}")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--percuss", required=True, type=lambda path: str(pathlib.Path(path).resolve()))
    parser.add_argument("--every", action="store_true")
    parser.add_argument("--chromium", default=shutil.which("chromium"))
    parser.add_argument("--keep", type=pathlib.Path)
    args = parser.parse_args()
    if not args.chromium:
        sys.exit("no chromium: install Debian's package chromium, or name the program by --chromium")
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        checker = Checker(args.percuss, args.chromium, folder)
        own = args.keep or folder / "own"
        own.mkdir(parents=True, exist_ok=True)
        checker.own_car(own)
        shutil.copytree(ROOT / "models", folder / "models")
        studies = [folder / "models/studies/report.toml"]
        if args.every:
            studies = sorted((folder / "models").glob("*.toml")) + sorted((folder / "models/studies").glob("*.toml"))
            for model in sorted((folder / "models").glob("*.urdf")):
                study = model.with_name(f"init-{model.stem}.toml")
                checker.command(folder, "init", str(model), "-o", str(study))
                studies.append(study)
        for study in studies:
            checker.report(study)
        print(f"{checker.passed} passed, {checker.failed} failed")
        sys.exit(1 if checker.failed or checker.passed < 15 else 0)


main()
