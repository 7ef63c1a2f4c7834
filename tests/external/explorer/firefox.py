"""Opens the pages of the gallery in Firefox by its Marionette protocol: firefox.py FIREFOX PAGES PERCUSS ROOT [--headless]."""

import json
import pathlib
import shlex
import socket
import subprocess
import sys
import tempfile
import time

# Longest start of the browser, and longest work of a page, s.
START, WORK = 60, 60
# Relative difference: numbers of two processors after some thousand roundings.
SAME = 1e-9


class Browser:
    """Connection: every message is its length, a colon, and JSON."""

    def __init__(self, program, headless):
        # A port that is free now.
        with socket.socket() as free:
            free.bind(("127.0.0.1", 0))
            port = free.getsockname()[1]
        self.profile = tempfile.TemporaryDirectory()
        settings = {"marionette.port": port, "datareporting.policy.dataSubmissionEnabled": False, "app.update.enabled": False}
        pathlib.Path(self.profile.name, "user.js").write_text(
            "".join(f"user_pref({json.dumps(key)}, {json.dumps(value)});\n" for key, value in settings.items()))
        command = [program, "--marionette", "--no-remote", "--profile", self.profile.name, *(["--headless"] if headless else [])]
        self.process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        end = time.monotonic() + START
        while True:
            try:
                self.socket = socket.create_connection(("127.0.0.1", port), timeout=WORK)
                break
            except OSError:
                if time.monotonic() > end:
                    raise SystemExit("Firefox did not start") from None
                time.sleep(0.3)
        self.number = 0
        self.receive()
        self.ask("WebDriver:NewSession", {"capabilities": {"alwaysMatch": {}}})

    def receive(self):
        head = b""
        while not head.endswith(b":"):
            head += self.socket.recv(1)
        left, body = int(head[:-1]), b""
        while len(body) < left:
            body += self.socket.recv(left - len(body))
        return json.loads(body)

    def ask(self, name, values):
        self.number += 1
        text = json.dumps([0, self.number, name, values])
        self.socket.sendall(f"{len(text.encode())}:{text}".encode())
        _, _, error, result = self.receive()
        if error:
            raise SystemExit(f"{name}: {error}")
        return result

    def open(self, address):
        # A page that differs in its fragment only would not be loaded again.
        self.ask("WebDriver:Navigate", {"url": "about:blank"})
        self.ask("WebDriver:Navigate", {"url": address})

    def run(self, script):
        return self.ask("WebDriver:ExecuteScript", {"script": script, "args": [], "sandbox": None})["value"]

    def wait(self, script, what):
        end = time.monotonic() + WORK
        while not self.run(f"return {script}"):
            if time.monotonic() > end:
                raise SystemExit(f"{what}: not reached in {WORK} s")
            time.sleep(0.1)

    def close(self):
        self.ask("Marionette:Quit", {"flags": ["eForceQuit"]})
        self.process.wait(START)
        self.profile.cleanup()


def shown(browser, what):
    browser.wait("!!document.querySelector('[data-mass]') && window.percussView?.isSettled()", what)
    text = browser.run("return document.querySelector('[data-mass]').dataset.mass")
    try:
        return float(text)
    except ValueError:
        return text


def check(browser, percuss, root, what):
    """m̄ of the page is that of the command on the page."""
    here = shown(browser, what)
    command = shlex.split(browser.run("return document.querySelector('pre.text').textContent").replace("\\\n", " "))
    report = json.loads(subprocess.run([percuss, *command[1:], "--format", "json"], cwd=root, check=True, capture_output=True).stdout)
    there = report["effective_mass"] if report["effective_mass"] is not None else report["status"]
    agrees = here == there if isinstance(there, str) else abs(here - there) <= SAME * abs(there)
    if not agrees:
        raise SystemExit(f"{what}: {here} in the page, {there} by the command")
    return here


def main():
    program, pages, percuss, root = sys.argv[1:5]
    browser = Browser(program, "--headless" in sys.argv)
    # The folder also contains reports, which have no engine.
    found = [page for page in sorted(pathlib.Path(pages).glob("*.html")) if 'id="engine"' in page.read_text()]
    assert len(found) >= 12, "a dozen examples"
    for page in found:
        browser.open(page.resolve().as_uri())
        first = check(browser, percuss, root, page.name)
        # The first driver moves; its value is in the address, which opens the same state again.
        browser.run("const s = document.querySelector('.driver input[type=range]'); s.focus();"
                    "s.dispatchEvent(new KeyboardEvent('keydown', { key: 'ArrowRight', shiftKey: true, bubbles: true, cancelable: true })); s.blur()")
        moved = check(browser, percuss, root, f"{page.name}, moved")
        browser.wait("location.hash.length > 20", f"{page.name}: address")
        time.sleep(0.5)
        address = browser.run("return location.href")
        browser.open(address)
        again = shown(browser, f"{page.name}, link")
        if again != moved:
            raise SystemExit(f"{page.name}: {moved}, and {again} from its link")
        webgl = browser.run("return window.percussView.webgl")
        print(f"ok    {page.name}: {first}, then {moved} kg{'' if webgl else ' (no WebGL)'}")
    browser.close()
    print(f"all {len(found)} pages agree")


main()
