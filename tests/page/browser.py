"""What the page's tests stand on: the program, a headless Chromium, and a page opened in it.

Tests run by ctest with INKBENCH (the program) in the environment. Without Chromium, its driver or
Selenium they skip: the exit code is 77, and the last line says what is missing.
"""

import contextlib
import csv
import os
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

SKIPPED = 77
PATIENCE_S = 120  # where a machine's cores are all taken
PROGRAM = os.environ.get("INKBENCH", "build/release/inkbench")


def skip(what):
    print(f"Skipped: {what} (./bootstrap install browser installs it).")
    sys.exit(SKIPPED)


try:
    from selenium import webdriver
    from selenium.common.exceptions import StaleElementReferenceException, TimeoutException
    from selenium.webdriver.chrome.options import Options
    from selenium.webdriver.chrome.service import Service
    from selenium.webdriver.common.by import By
    from selenium.webdriver.common.keys import Keys
    from selenium.webdriver.support.ui import Select, WebDriverWait
except ImportError:
    skip("python3-selenium is not installed")

CHROMIUM = shutil.which("chromium")
DRIVER = shutil.which("chromedriver")
if not CHROMIUM or not DRIVER:
    skip("chromium or chromium-driver is not installed")


def inkbench(*words, codes=(0,)):
    """Runs the program; fails with what it printed."""
    done = subprocess.run([PROGRAM, *map(str, words)], capture_output=True, text=True)
    if done.returncode not in codes:
        raise AssertionError(f"inkbench {' '.join(map(str, words))}: exit {done.returncode}\n"
                             f"{done.stdout}{done.stderr}")
    return done.stdout


def give_times(run, ms):
    """Gives the rows of a run's folder these times, in ms by method, and writes its page again: what the
    page shows then depends on no machine."""
    file = run / "rows.csv"
    with open(file, newline="") as text:
        rows = list(csv.DictReader(text))
    for row in rows:
        if row["method"] in ms and row["draw_ns"]:
            for name in ("draw_ns", "draw_ns_median", "draw_ns_q75", "draw_ns_min", "draw_wall_ns", "draw_cpu_ns"):
                row[name] = round(1e6 * ms[row["method"]])
            row["time_doubt"] = ""
    with open(file, "w", newline="") as text:
        writer = csv.DictWriter(text, rows[0].keys(), lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)
    (run / "summary.csv").unlink()  # its answer is by the old times
    inkbench("report", run)


def open_browser(folder, switches=("--disable-gpu",)):
    options = Options()
    options.binary_location = CHROMIUM
    for switch in ("--headless=new", "--no-sandbox", *switches, "--disable-dev-shm-usage", "--no-first-run",
                   "--disable-background-networking", "--disable-sync",
                   "--hide-scrollbars", "--window-size=1280,900", f"--user-data-dir={folder}/profile"):
        options.add_argument(switch)
    options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
    browser = webdriver.Chrome(service=Service(DRIVER), options=options)
    browser.set_script_timeout(PATIENCE_S)
    return browser


class BrowserTest(unittest.TestCase):
    """A browser and a folder per class; after each test the console must have been silent."""

    switches = ("--disable-gpu",)
    harmless = ()  # what messages of the console may hold

    @classmethod
    def setUpClass(cls):
        cls.folder = Path(tempfile.mkdtemp(prefix="inkbench-page-"))
        cls.addClassCleanup(shutil.rmtree, cls.folder, ignore_errors=True)
        cls.make_runs()
        cls.browser = open_browser(cls.folder, cls.switches)
        cls.addClassCleanup(cls.browser.quit)

    @classmethod
    def make_runs(cls):
        """What a class opens, in its folder; `before/report.html` unless it says otherwise."""
        raise NotImplementedError

    def open(self, file=None, address="", part=None):
        """Opens a page, and gives one of its parts as `show` does."""
        self.browser.get("about:blank")
        self.browser.get_log("browser")
        self.browser.get((file or self.folder / "before" / "report.html").as_uri() + address)
        self.wait(lambda: self.script("return document.documentElement.dataset.ready === '1'"))
        return self.show(part) if part else None

    @contextlib.contextmanager
    def window(self, width, height=844):
        """A window of another size; one as narrow as a phone's is one."""
        self.browser.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", {
            "width": width, "height": height, "deviceScaleFactor": 1, "mobile": width < 500})
        try:
            yield
        finally:
            self.browser.execute_cdp_cmd("Emulation.clearDeviceMetricsOverride", {})

    def tearDown(self):
        said = [entry["message"] for entry in self.browser.get_log("browser")
                if entry["level"] in ("SEVERE", "WARNING")
                and not any(words in entry["message"] for words in self.harmless)]
        self.assertEqual(said, [], "the console is not silent")

    def script(self, text, *arguments):
        return self.browser.execute_script(text, *arguments)

    def wait(self, condition):
        # A part that is drawn anew between being found and being read is found again.
        wait = WebDriverWait(self.browser, PATIENCE_S, ignored_exceptions=[StaleElementReferenceException])
        return wait.until(lambda _: condition())

    def find(self, selector):
        return self.browser.find_element(By.CSS_SELECTOR, selector)

    def find_all(self, selector):
        return self.browser.find_elements(By.CSS_SELECTOR, selector)

    def show(self, section):
        """Unfolds a part, scrolls to it, waits until it is drawn, and gives it."""
        self.script("const part = sections.find(s => s.id === arguments[0]); if (part.fold) part.fold.open = true;"
                    "part.node.scrollIntoView()", section)
        self.wait(lambda: self.script("const part = sections.find(s => s.id === arguments[0]);"
                                      "return !part.isStale && part.body.childElementCount > 0", section))
        return self.find(f"#{section}")

    def address(self):
        return self.script("return location.hash")
