"""A page in a headless Chromium that draws a view: what the adapters of three.js and of WebGL call."""

import subprocess
import tempfile
import threading
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from urllib.parse import parse_qs, urlsplit

import numpy
from entrant import Failed

LONGEST_S = 600
SOFTWARE_GL = ["--use-angle=swiftshader", "--enable-unsafe-swiftshader"]


class Answer:
    """What the page sends back: an image and its time, or why there is none."""

    def __init__(self):
        self.came = threading.Event()
        self.failure = None
        self.pixels = b""
        self.draw_ms = 0.0


def handler_for(folders, files, answer):
    """Serves the files of some folders, by the first part of an address, and takes the answer."""

    class Handler(SimpleHTTPRequestHandler):
        def translate_path(self, path):
            address = urlsplit(path).path.removeprefix("/")
            first, _, rest = address.partition("/")
            named = files.get(address) or folders.get(first, Path("/nowhere")).joinpath(*rest.split("/"))
            return "/nowhere" if ".." in address else str(named)

        def do_POST(self):
            body = self.rfile.read(int(self.headers.get("Content-Length", 0)))
            asked = urlsplit(self.path)
            if asked.path == "/drawn":
                answer.pixels = body
                answer.draw_ms = float(parse_qs(asked.query)["ms"][0])
            else:
                answer.failure = body.decode("utf-8", "replace").replace("\n", " ")
            self.send_response(204)
            self.end_headers()
            answer.came.set()

        def log_message(self, *_):
            pass

    return Handler


def wait_for(answer, browser, what):
    """Until the page answers. Raises Failed if the browser ends before, or takes too long."""
    for _ in range(10 * LONGEST_S):
        if answer.came.wait(0.1):
            return
        if browser.poll() is not None:
            raise Failed(f"Chromium ended with exit code {browser.returncode} before it drew")
    raise Failed(f"{what} did not draw within {LONGEST_S} s")


def drawn_by_page(what, chromium, page, view, switches):
    """The image of a view that a page draws and sends back, and the milliseconds by its own clock.

    `page` is (address, folders, files): an address below the server's, the folders that it serves by
    the first part of an address, and single files by theirs. Raises Failed, which names `what`, if
    the page does not draw.
    """
    address, folders, files = page
    answer = Answer()
    files = {"view/view.json": view.path, **files}
    server = ThreadingHTTPServer(("127.0.0.1", 0), handler_for(folders, files, answer))
    threading.Thread(target=server.serve_forever, daemon=True).start()
    with tempfile.TemporaryDirectory(prefix="inkbench-page-", ignore_cleanup_errors=True) as home:
        browser = subprocess.Popen(
            [chromium, "--headless=new", "--no-sandbox", "--disable-dev-shm-usage", *switches,
             "--no-first-run", "--no-proxy-server", "--disable-background-networking",
             "--disable-sync", "--disable-extensions", "--disable-breakpad",
             f"--user-data-dir={home}", f"http://127.0.0.1:{server.server_port}/{address}"],
            stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        try:
            wait_for(answer, browser, what)
        finally:
            browser.terminate()
            browser.wait()
            server.shutdown()
    if answer.failure is not None:
        raise Failed(f"{what}: {answer.failure[:180]}")
    width, height = view.size_px
    return numpy.frombuffer(answer.pixels, numpy.uint8).reshape(height, width), answer.draw_ms
