"""The page over HTTP: four fixed addresses and the files of reports/, for reading alone."""

import hmac
import mimetypes
import os
import threading
from http.cookies import CookieError, SimpleCookie
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from urllib.parse import parse_qs, unquote, urlsplit

PAGE = Path(__file__).parent / "page"
OWN = {"/": "watch.html", "/watch.css": "watch.css", "/watch.js": "watch.js"}
OWN_POLICY = (
    "default-src 'none'; script-src 'self'; style-src 'self'; connect-src 'self'; "
    "base-uri 'none'; form-action 'none'; frame-ancestors 'none'"
)
REPORT_POLICY = (  # reports bring their own style; nothing of theirs runs, and nothing is fetched from elsewhere
    "default-src 'none'; style-src 'self' 'unsafe-inline'; img-src 'self' data:; object-src 'none'; "
    "base-uri 'none'; form-action 'none'; frame-ancestors 'none'"
)
LOCAL = ("127.0.0.1", "localhost", "[::1]")
CLIENTS = 16  # at once; the next ones are closed
PIECE = 1 << 16


class Server(ThreadingHTTPServer):
    """Serves `data` as it is at the time; with a token nothing is served without it."""

    daemon_threads = True

    def __init__(self, address: tuple[str, int], reports: Path, token: str | None) -> None:
        self.reports, self.token, self.data = reports.resolve(), token, b"{}"
        self._room = threading.BoundedSemaphore(CLIENTS)
        super().__init__(address, Handler)
        self.cookie = f"twistbench_watch_{self.server_address[1]}"  # a browser keeps cookies by host, not by port

    def process_request(self, request, client_address) -> None:  # type: ignore[no-untyped-def]
        """Answer in a thread of its own, or not at all when there are too many."""
        if self._room.acquire(blocking=False):
            super().process_request(request, client_address)
        else:
            self.shutdown_request(request)

    def process_request_thread(self, request, client_address) -> None:  # type: ignore[no-untyped-def]
        """Answer, and make room for the next."""
        try:
            super().process_request_thread(request, client_address)
        finally:
            self._room.release()

    def handle_error(self, request, client_address) -> None:  # type: ignore[no-untyped-def]
        """A client that went away in the middle is no matter."""


class Handler(BaseHTTPRequestHandler):
    """One request."""

    server: Server
    timeout = 10
    server_version, sys_version = "twistbench", ""

    def do_GET(self) -> None:
        """Answer."""
        parts = urlsplit(self.path)
        if not self._allowed(parts.query):
            self._send(403, b"not allowed: open the address that was printed, with its token\n")
        elif parts.path == "/data.json":
            self._send(200, self.server.data, "application/json")
        elif parts.path in OWN:
            name = OWN[parts.path]
            self._send(200, (PAGE / name).read_bytes(), mimetypes.guess_type(name)[0] or "text/plain")
        elif parts.path.startswith("/reports/"):
            self._report(unquote(parts.path.removeprefix("/reports/")))
        else:
            self._send(404, b"there is nothing here\n")

    def _allowed(self, query: str) -> bool:
        token = self.server.token
        if token is None:  # a name of elsewhere that leads here is not this machine's page
            host = self.headers.get("Host", "")
            return (host.rpartition(":")[0] if not host.endswith("]") and ":" in host else host) in LOCAL
        try:
            cookie = SimpleCookie(self.headers.get("Cookie", "")).get(self.server.cookie)
        except CookieError:
            cookie = None
        given = [*parse_qs(query).get("token", []), *([cookie.value] if cookie else [])]
        return any(hmac.compare_digest(one.encode(), token.encode()) for one in given)

    def _report(self, name: str) -> None:
        """Send a file below reports/; what leads out of it, or begins with a dot, is not there."""
        asked = self.server.reports / name
        path = Path(os.path.realpath(asked)) if "\0" not in name else self.server.reports
        inside = path.is_relative_to(self.server.reports) and not any(one.startswith(".") for one in name.split("/"))
        if not inside or not path.is_file():
            self._send(404, b"there is no such report\n")
            return
        kind = mimetypes.guess_type(path.name)[0] or "text/plain"
        with open(path, "rb") as file:
            self._head(200, kind, os.fstat(file.fileno()).st_size, REPORT_POLICY)
            while piece := file.read(PIECE):
                self.wfile.write(piece)

    def _send(self, status: int, body: bytes, kind: str = "text/plain") -> None:
        self._head(status, kind, len(body), OWN_POLICY)
        self.wfile.write(body)

    def _head(self, status: int, kind: str, size: int, policy: str) -> None:
        self.send_response(status)
        text = kind.startswith("text/") or kind in ("application/json", "image/svg+xml")
        self.send_header("Content-Type", f"{kind}; charset=utf-8" if text else kind)
        self.send_header("Content-Length", str(size))
        self.send_header("Content-Security-Policy", policy)
        self.send_header("X-Content-Type-Options", "nosniff")
        self.send_header("Referrer-Policy", "no-referrer")
        self.send_header("Cache-Control", "no-store")
        if self.server.token and status == 200:
            self.send_header(
                "Set-Cookie", f"{self.server.cookie}={self.server.token}; HttpOnly; SameSite=Strict; Path=/"
            )
        self.end_headers()

    def log_message(self, format: str, *values: object) -> None:
        """Say nothing: a token would stand in it."""
