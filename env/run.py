"""Run a command in the project's environment, making that environment first where it is missing or out of date.

    python3 env/run.py snakemake --cores 2
    python3 env/run.py pytest
    python3 env/run.py --check       # reads every file of the environment, and makes it anew where one is damaged

Standard library only. `env/.venv` is a link to the environment, which lies beside it and is stamped when it is whole.
"""

import contextlib
import os
import shutil
import sys

ENV = os.path.dirname(os.path.abspath(__file__))
STOPPED = 130
ACTS = '"$`\\\n\r'  # what a shell acts on inside the double quotes of pip's scripts and of `activate`


def refuse() -> None:
    """End with a sentence on a system, a Python or a path that the project does not run on."""
    if os.name == "nt":
        sys.exit("env: Windows cannot run the workflow, which needs a POSIX shell; use WSL 2 (wsl --install)")
    if sys.platform == "darwin":
        mend = (
            "use Linux, or a Linux container or virtual machine (`pip install .` into an environment of yours is free)"
        )
        sys.exit(f"env: the workflow was never tried on macOS; {mend}")
    if sys.version_info < (3, 11):  # noqa: UP036 (this file must say so itself)
        sys.exit(f"env: Python 3.11 or newer is needed, this is {sys.version.split()[0]}: python3.11 env/run.py …")
    if any(sign in path for path in (ENV, os.path.realpath(ENV)) for sign in ACTS):
        mend = 'move or rename the folders so that no name has one of " $ ` \\ or a line break'
        sys.exit(f"env: {ENV!a}: a shell would act on a sign in this path; {mend}")


def prepare(check: bool) -> str:
    """The environment to run in, made first where needed."""
    from launcher import environment, swap

    place = environment.ready(check)
    with contextlib.suppress(OSError):  # a checkout of somebody else: the environment serves all the same
        swap.swap(place)
        swap.tidy(place)
    return str(place)


def become(command: list, place: str) -> None:
    """Turn this process into the command, in the environment."""
    from launcher.stale_locks import clear_stale_locks

    os.environ["VIRTUAL_ENV"] = place
    os.environ["PATH"] = os.path.join(place, "bin") + os.pathsep + os.environ.get("PATH", os.defpath)
    os.environ.setdefault("SNAKEMAKE_PROFILE", os.path.join(ENV, "profile"))
    os.environ.pop("PYTHONHOME", None)
    if command[0] == "snakemake":
        clear_stale_locks()
    program = shutil.which(command[0])
    if program is None:
        sys.exit(f"env: there is no command {command[0]!r} in the environment or on the PATH")
    try:
        os.execv(program, command)
    except OSError as error:
        sys.exit(f"env: {program}: cannot be run ({error.strerror})")


def main() -> None:
    """Make the environment if needed, then become the command."""
    command = sys.argv[1:]
    if not command or command[0] in ("-h", "--help"):
        sys.exit(__doc__)
    refuse()
    sys.path.insert(0, ENV)
    try:
        place = prepare(check=command[0] == "--check")
    except KeyboardInterrupt:
        print("env: stopped; run the same command again, nothing half-made is used", file=sys.stderr)
        sys.exit(STOPPED)
    except OSError as error:
        where = error.filename or ENV
        sys.exit(
            f"env: {where}: {error.strerror}. Make env/ writable and leave it 3 GB of disk, "
            "or copy the project into a folder of your own"
        )
    if command[0] == "--check":
        print(f"env: {place} is whole: every file is as its record says")
        return
    become(command, place)


if __name__ == "__main__":
    main()
