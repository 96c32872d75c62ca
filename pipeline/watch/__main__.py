"""Show RUN_DIR on a page of this machine while it is recorded; approve or stop what settles its tie. Ctrl-C ends it."""

import os
import secrets
import threading
import time
from pathlib import Path

from ..ground.command import command
from ..ground.errors import BadInput, program
from ..ground.input.parser import Parser
from ..run.run_arguments import run_dir
from .followed_recording import Followed
from .jobs import Jobs
from .server import LOCAL, Page, Server
from .settling import Settling
from .snapshot import snapshot

EVERY_S = 0.5


class Buttons:
    """The actions of the two buttons: they write files that the loop reads."""

    def __init__(self, settling: Settling) -> None:
        self._settling, self._lock = settling, threading.Lock()

    def __call__(self, button: str, message: dict[str, object]) -> str | None:
        """Press one; returns why it did nothing, or None."""
        with self._lock:
            state = self._settling.told(self._settling.step())
            if state is None or not state["at_work"]:
                return "no loop is at work"
            if button == "stop":
                self._settling.answers.stop()
                return None
            question = message.get("question")
            if isinstance(question, str) and question == state["question"] and self._settling.answers.approve(question):
                return None
            return "this is not what is asked now: look again"


def follow(run_dir: Path, settling: Settling, page: Page) -> None:
    """Read what is new and lay it out for all clients, twice a second; a file that cannot be read is tried again."""
    followed, jobs = Followed(run_dir), Jobs(page.reports.parent)
    while True:
        try:
            step = settling.step()
            now = settling.run_dir(step)
            if now != followed.folder:
                followed = Followed(now)
            followed.poll()
            jobs.poll()
            page.data = snapshot(followed, page.reports, {"loop": settling.told(step), "jobs": jobs.told()})
        except OSError:  # removed or replaced between two looks
            pass
        time.sleep(EVERY_S)


def real(path: Path) -> Path:
    """The target of a path, whatever becomes of the working folder; a link that leads to itself stays as it is."""
    return Path(os.path.realpath(path))


@program
def main() -> None:
    """Command line."""
    parser = Parser(prog=command("watch"), description=__doc__)
    parser.add_argument("run_dir", type=run_dir, metavar="RUN_DIR", help="raw/<run>, which may be recorded later")
    parser.add_argument("--host", default="127.0.0.1", help="from any but 127.0.0.1 reading needs the token too")
    parser.add_argument("--port", type=int, default=8770, help="0: any that is free")
    parser.add_argument("--reports", type=Path, default=Path("reports"), metavar="DIR", help="served for reading")
    settle = f"the --out of {command('settle')}; default: settle/<run> below --reports"
    parser.add_argument("--settle", type=Path, metavar="DIR", help=settle)
    arguments = parser.parse_args()
    folder = real(arguments.run_dir)
    if not (folder / "run.yaml").is_file():
        raise BadInput(arguments.run_dir, "run.yaml", "is missing", f"make the run's folder with {command('new_run')}")
    if not 0 <= arguments.port <= 65535:
        parser.error("--port must be from 0 to 65535")
    settling = Settling(real(arguments.settle or arguments.reports / "settle" / folder.name), folder)
    token = secrets.token_urlsafe(24)
    page = Page(real(arguments.reports), token, arguments.host in LOCAL, Buttons(settling))
    try:
        server = Server(arguments.host.strip("[]"), arguments.port, page)
    except OSError as error:
        mend = "choose another --port, or end the program that has it"
        raise BadInput("arguments", "--host, --port", f"cannot be served at ({error.strerror})", mend) from None
    threading.Thread(target=follow, args=(folder, settling, page), daemon=True).start()
    print(f"http://{arguments.host}:{server.port}/?token={token}", flush=True)
    try:
        server.run()
    finally:
        server.close()


if __name__ == "__main__":
    main()
