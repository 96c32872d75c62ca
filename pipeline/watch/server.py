"""The page over HTTP: a few fixed addresses, the files of reports/ for reading, and two buttons that need the token."""

import contextlib
import hmac
import json
import logging
import mimetypes
import os
from collections.abc import Callable
from pathlib import Path

import bottle
from waitress.server import create_server

PAGE = Path(__file__).parent / "page"
OWN = {"": "watch.html"} | {name: name for name in ("watch.css", "watch.js", "settling.js", "plot.js")}
OWN_POLICY = (
    "default-src 'none'; script-src 'self'; style-src 'self'; connect-src 'self'; "
    "base-uri 'none'; form-action 'none'; frame-ancestors 'none'"
)
REPORT_POLICY = (  # reports bring their own style; nothing of theirs runs, and nothing is fetched from elsewhere
    "default-src 'none'; style-src 'self' 'unsafe-inline'; img-src 'self' data:; object-src 'none'; "
    "base-uri 'none'; form-action 'none'; frame-ancestors 'none'"
)
LOCAL = ("127.0.0.1", "localhost", "[::1]")
TOKEN = "X-Watch-Token"  # a header that no other page can send, as no answer here allows it
LIMITS = {  # of clients that are slow, many or hostile
    "threads": 8,
    "connection_limit": 64,
    "channel_timeout": 10,
    "cleanup_interval": 2,
    "max_request_header_size": 16_384,
    "max_request_body_size": 4096,
}
Say = Callable[[str, dict[str, object]], str | None]  # a button and what came with it; why not, or None


class Page:
    """The content to serve: `data` of the moment, `reports`, a folder without links on its way, and the buttons.

    Reading needs the token unless `local`; a button always needs it, in a header and from this page alone.
    """

    def __init__(self, reports: Path, token: str, local: bool, say: Say) -> None:
        self.reports, self.token, self.local, self.say = reports, token, local, say
        self.data, self.cookie = b"{}", "twistbench_watch"
        self.app = bottle.Bottle()
        self.app.route("/<name:path>", "GET", self._read)
        self.app.route("/", "GET", self._read)
        self.app.route("/<button:re:approve|stop>", "POST", self._press)
        self.app.default_error_handler = lambda error: error.status_line + "\n"

    def _read(self, name: str = "") -> bottle.HTTPResponse:
        if not self._may_read():
            return self._answer(403, b"not allowed: open the address that was printed, with its token\n")
        if name == "data.json":
            return self._answer(200, self.data, "application/json")
        if name in OWN:
            return self._answer(200, (PAGE / OWN[name]).read_bytes(), mimetypes.guess_type(OWN[name])[0])
        if name.startswith("reports/"):
            return self._report(name.removeprefix("reports/"))
        return self._answer(404, b"there is nothing here\n")

    def _press(self, button: str) -> bottle.HTTPResponse:
        request, host = bottle.request, bottle.request.get_header("Host", "")
        mine = request.get_header("Origin", f"http://{host}") == f"http://{host}"
        token_right = self.same(request.get_header(TOKEN, ""))
        if not (mine and token_right and self._named() and request.content_type.startswith("application/json")):
            return self._answer(403, b"not allowed: open the address that was printed, with its token\n")
        with contextlib.suppress(ValueError, RecursionError):
            message = json.loads(request.body.read(LIMITS["max_request_body_size"]))
            if isinstance(message, dict):
                why = self.say(button, message)
                return self._answer(200 if why is None else 409, f"{why or 'done'}\n".encode())
        return self._answer(400, b"send one object of JSON\n")

    def same(self, token: str) -> bool:
        """Whether this is the token."""
        return hmac.compare_digest(token.encode(), self.token.encode())

    def _named(self) -> bool:
        """Whether the request names this machine; names of other machines may lead here too."""
        host = bottle.request.get_header("Host", "")
        return not self.local or (host.rpartition(":")[0] if not host.endswith("]") and ":" in host else host) in LOCAL

    def _may_read(self) -> bool:
        if self.local:
            return self._named()
        return self.same(bottle.request.query.get("token", "")) or self.same(bottle.request.get_cookie(self.cookie, ""))

    def _report(self, name: str) -> bottle.HTTPResponse:
        """A file below reports/; a path that leaves that folder or has a hidden part does not exist."""
        path = Path(os.path.realpath(self.reports / name)) if "\0" not in name else self.reports
        inside = path.is_relative_to(self.reports) and not any(part.startswith(".") for part in name.split("/"))
        if not inside or not path.is_file():
            return self._answer(404, b"there is no such report\n")
        response = bottle.static_file(path.name, str(path.parent))
        for key, value in self._headers(REPORT_POLICY).items():
            response.set_header(key, value)
        return response

    def _headers(self, policy: str) -> dict[str, str]:
        return {
            "Content-Security-Policy": policy,
            "X-Content-Type-Options": "nosniff",
            "Referrer-Policy": "no-referrer",
            "Cache-Control": "no-store",
        }

    def _answer(self, status: int, body: bytes, kind: str | None = None) -> bottle.HTTPResponse:
        kind = kind or "text/plain"
        text = kind.startswith("text/") or kind == "application/json"
        response = bottle.HTTPResponse(body, status, self._headers(OWN_POLICY))
        response.content_type = f"{kind}; charset=utf-8" if text else kind
        if status == 200 and not self.local:
            response.set_cookie(self.cookie, self.token, httponly=True, samesite="strict", path="/")
        return response


class Server:
    """A page at an address of this machine; raises OSError where it cannot be served there."""

    def __init__(self, host: str, port: int, page: Page) -> None:
        logging.getLogger("waitress").setLevel(logging.CRITICAL)  # a client that went away in the middle is no matter
        try:
            self._server = create_server(page.app, host=host, port=port, ident=None, **LIMITS)
        except ValueError as error:
            raise OSError(0, str(error)) from None
        listening = getattr(self._server, "effective_listen", None)
        self.port = int(listening[0][1]) if listening else int(self._server.effective_port)
        page.cookie = f"twistbench_watch_{self.port}"  # a browser keeps cookies by host, not by port

    def run(self) -> None:
        """Serve until Ctrl-C."""
        self._server.run()

    def close(self) -> None:
        """Let the address go."""
        self._server.close()
