"""A headless Chromium that a test drives: it opens a page, runs a sentence of JavaScript, and takes a picture.

It hears what a page says to the console: an error there, or one that nobody catches, ends the test.
"""

import base64
import itertools
import json
import os
import shutil
import subprocess
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import pytest

CHROMIUM = pytest.mark.skipif(not shutil.which("chromium"), reason="there is no chromium here")
WORDS = ("--headless", "--no-sandbox", "--disable-gpu", "--remote-debugging-pipe", "--window-size=1100,1700")


class Browser:
    """The DevTools protocol over two pipes; each message ends with a zero byte."""

    def __init__(self, says: int, hears: int) -> None:
        self._says, self._hears, self._rest, self._numbers = says, hears, b"", itertools.count(1)
        self.faults: list[str] = []  # of scripts; what a server refuses is no fault of a page
        target = self._ask("Target.createTarget", url="about:blank")["targetId"]
        self._session = self._ask("Target.attachToTarget", targetId=target, flatten=True)["sessionId"]
        self._ask("Runtime.enable", self._session)

    def _ask(self, method: str, session: str | None = None, **params: Any) -> dict:
        number = next(self._numbers)
        request = {"id": number, "method": method, "params": params} | ({"sessionId": session} if session else {})
        os.write(self._says, json.dumps(request).encode() + b"\0")
        while True:
            while b"\0" not in self._rest:
                self._rest += os.read(self._hears, 1 << 16)
            message, self._rest = self._rest.split(b"\0", 1)
            reply = json.loads(message)
            self._hear(reply.get("method"), reply.get("params", {}))
            if reply.get("id") == number:
                assert "error" not in reply, reply
                return reply["result"]

    def _hear(self, method: str | None, params: dict) -> None:
        """Keep an error that nobody catches, or that a script says to the console."""
        if method == "Runtime.exceptionThrown":
            self.faults.append(json.dumps(params["exceptionDetails"]))
        elif method == "Runtime.consoleAPICalled" and params["type"] in ("error", "assert"):
            self.faults.append(" ".join(str(each.get("description", each.get("value"))) for each in params["args"]))

    def well(self) -> None:
        """Ask that the page says nothing in red of itself, and nothing to the console."""
        red = self.run("[...document.querySelectorAll('.bad')].filter((e) => e.offsetParent).map((e) => e.textContent)")
        assert (red, self.faults, self.text("link")) == ([], [], "connected")

    def open(self, address: str) -> None:
        """Open an address."""
        self._ask("Page.navigate", self._session, url=address)

    def run(self, script: str) -> Any:
        """The value of a sentence, whose promise is waited for."""
        params = {"expression": script, "returnByValue": True, "awaitPromise": True}
        reply = self._ask("Runtime.evaluate", self._session, **params)
        assert "exceptionDetails" not in reply, reply
        return reply["result"].get("value")

    def until(self, script: str, seconds: float = 90.0) -> Any:
        """Wait until a sentence is true."""
        end_s = time.monotonic() + seconds
        while not (is_true := self.run(f"Boolean({script})")):
            assert time.monotonic() < end_s, (script, self.run("document.body.innerText"))
            time.sleep(0.2)
        return is_true

    def text(self, name: str) -> str:
        """What stands in an element."""
        return self.run(f"document.getElementById('{name}').textContent")

    def press(self, name: str) -> None:
        """Click an element."""
        self.run(f"document.getElementById('{name}').click()")

    def picture(self, path: Path) -> None:
        """Write what is seen as PNG."""
        path.write_bytes(base64.b64decode(self._ask("Page.captureScreenshot", self._session)["data"]))


@contextmanager
def browser(home: Path) -> Iterator[Browser]:
    """A browser of its own, until the end."""
    theirs_in, says = os.pipe()
    hears, theirs_out = os.pipe()
    # Chromium reads descriptor 3 and writes descriptor 4
    plumbing = f"exec chromium {' '.join(WORDS)} --user-data-dir={home}/profile 3<&{theirs_in} 4>&{theirs_out}"
    quiet = {"stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL}
    environment = {**os.environ, "HOME": str(home)}
    with subprocess.Popen(
        ["bash", "-c", plumbing], pass_fds=(theirs_in, theirs_out), env=environment, **quiet
    ) as chromium:
        try:
            os.close(theirs_in)
            os.close(theirs_out)
            seen = Browser(says, hears)
            yield seen
            seen.run("0")  # hears what was said last
            assert not seen.faults, seen.faults
        finally:
            chromium.terminate()
            os.close(says)
            os.close(hears)
