"""Show RUN_DIR on a page of this machine while it is recorded; only reads files. Ctrl-C ends it."""

import argparse
import secrets
import threading
import time
from pathlib import Path

from ..ground.command import command
from ..ground.errors import BadInput, program
from .recording import Followed
from .server import LOCAL, Server
from .snapshot import snapshot

EVERY_S = 0.5


def follow(followed: Followed, server: Server) -> None:
    """Read what is new and lay it out for all clients, twice a second; a file that cannot be read is tried again."""
    while True:
        try:
            followed.poll()
            server.data = snapshot(followed, server.reports)
        except OSError:  # removed or replaced between two looks
            pass
        time.sleep(EVERY_S)


@program
def main() -> None:
    """Command line."""
    parser = argparse.ArgumentParser(prog=command("watch"), description=__doc__)
    parser.add_argument("run_dir", type=Path, metavar="RUN_DIR", help="raw/<run>, which may be recorded later")
    parser.add_argument("--host", default="127.0.0.1", help="any but 127.0.0.1 needs the token that is printed")
    parser.add_argument("--port", type=int, default=8770, help="0: any that is free")
    parser.add_argument("--reports", type=Path, default=Path("reports"), metavar="DIR", help="served for reading")
    arguments = parser.parse_args()
    folder: Path = arguments.run_dir
    if not (folder / "run.yaml").is_file():
        raise BadInput(folder, "run.yaml", "is missing", f"make the run's folder with {command('new_run')}")
    if not 0 <= arguments.port <= 65535:
        parser.error("--port must be from 0 to 65535")
    token = None if arguments.host in LOCAL else secrets.token_urlsafe(24)
    try:
        server = Server((arguments.host, arguments.port), arguments.reports, token)
    except OSError as error:
        mend = "choose another --port, or end the program that has it"
        raise BadInput("arguments", "--host, --port", f"cannot be served at ({error.strerror})", mend) from None
    threading.Thread(target=follow, args=(Followed(folder.resolve()), server), daemon=True).start()
    query = f"/?token={token}" if token else "/"
    print(f"http://{arguments.host}:{server.server_address[1]}{query}", flush=True)
    try:
        server.serve_forever()
    except KeyboardInterrupt:
        pass
    finally:
        server.server_close()


if __name__ == "__main__":
    main()
