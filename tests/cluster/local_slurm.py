"""A real SLURM on this one machine: a slurmctld and two slurmd, each a node of one processor; no munge, no database."""

import os
import shlex
import shutil
import signal
import socket
import subprocess
import time
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from pathlib import Path

CONF = Path("/etc/slurm/slurm.conf")  # where the srun inside a job looks, whatever SLURM_CONF says
MARK = "# Written by the tests of twistbench, which remove it."
PROGRAMS = ("slurmctld", "slurmd", "sbatch", "srun", "squeue", "scancel", "rsync", "strace", "unshare")
NODES = ("n1", "n2")
WITHIN_S = 600

TEXT = """{mark}
ClusterName=one
SlurmctldHost={host}(127.0.0.1)
SlurmUser=root
SlurmdUser=root
AuthType=auth/none
AuthInfo=cred_expire=5
CredType=cred/none
CryptoType=crypto/none
SlurmctldPort={port}
SlurmctldPidFile={place}/ctld.pid
SlurmdPidFile={place}/slurmd.%n.pid
SlurmdSpoolDir={place}/spool.%n
StateSaveLocation={place}/state
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
JobCompType=jobcomp/none
MpiDefault=none
ReturnToService=2
SlurmdTimeout=10
SchedulerParameters=sched_interval=2,batch_sched_delay=0
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
SwitchType=switch/none
SlurmdParameters=config_overrides
{nodes}
PartitionName=main Nodes=n1,n2 Default=YES MaxTime=600 State=UP
"""


def why_not() -> str:
    """Why no SLURM can be started here, or nothing."""
    missing = [name for name in PROGRAMS if shutil.which(name) is None]
    if missing:
        return f"not installed: {', '.join(missing)} (apt-get install slurmctld slurmd slurm-client rsync strace)"
    if os.geteuid():
        return "only root starts a slurmd that runs jobs"
    if CONF.exists() and MARK not in CONF.read_text(encoding="utf-8"):
        return f"{CONF} is of a SLURM of this machine, and stays as it is"
    if subprocess.run(["unshare", "--mount", "true"], capture_output=True).returncode:
        return "this machine gives no process a mount of its own (unshare --mount)"
    return ""


def free_port() -> int:
    """A port that nobody listens on."""
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return int(probe.getsockname()[1])


class Cluster:
    """The daemons. `hidden` are folders that are not shared: each node sees an empty one of its own there."""

    def __init__(self, place: Path, hidden: Iterable[Path] = ()) -> None:
        self.place, self.hidden = place, list(hidden)
        self.daemons: dict[str, subprocess.Popen[bytes]] = {}

    def start(self) -> None:
        """Start the controller and both nodes, and wait until these are idle."""
        host = socket.gethostname()
        nodes = "\n".join(
            f"NodeName={name} NodeHostname={host} NodeAddr=127.0.0.1 Port={free_port()} CPUs=1 RealMemory=16000"
            for name in NODES
        )
        for name in ("state", *(f"spool.{node}" for node in NODES)):
            (self.place / name).mkdir(parents=True)
        CONF.parent.mkdir(exist_ok=True)
        CONF.write_text(TEXT.format(mark=MARK, host=host, port=free_port(), place=self.place, nodes=nodes))
        self._start("slurmctld", ["slurmctld", "-D"])
        for name in NODES:
            command = ["slurmd", "-D", "-N", name]
            mounts = "mount --make-rprivate /; "
            for number, folder in enumerate(self.hidden):
                own = self.place / f"disk.{name}" / str(number)
                for each in (own, folder):
                    each.mkdir(parents=True, exist_ok=True)
                mounts += f"mount --bind {shlex.quote(str(own))} {shlex.quote(str(folder))}; "
            if self.hidden:
                command = ["unshare", "--mount", "sh", "-ec", f"{mounts} exec {shlex.join(command)}"]
            self._start(name, command)
        self.wait(lambda: self.said("sinfo", "-h", "-N", "-o", "%t").split() == ["idle"] * len(NODES), "idle nodes")

    def _start(self, name: str, command: list[str]) -> None:
        with open(self.place / f"{name}.log", "wb") as log:
            self.daemons[name] = subprocess.Popen(command, stdout=log, stderr=log, start_new_session=True)

    def said(self, *command: str) -> str:
        """What a command of SLURM prints."""
        return subprocess.run(command, capture_output=True, text=True).stdout

    def running(self) -> list[tuple[str, str]]:
        """Id and node of each job that runs now."""
        lines = self.said("squeue", "-h", "-t", "R", "-o", "%A %N").splitlines()
        return [(line.split()[0], line.split()[1]) for line in lines if len(line.split()) == 2]

    def wait(self, true: Callable[[], object], what: str, within_s: float = WITHIN_S) -> None:
        """Wait until something is true."""
        until_s = time.monotonic() + within_s
        while not true():
            assert time.monotonic() < until_s, f"no {what} in {within_s} s; see {self.place}"
            time.sleep(0.2)

    def lose(self, node: str) -> None:
        """Kill a node: its slurmd, and all that it runs, without a word to the controller."""
        jobs = [job for job, where in self.running() if where == node]
        self.daemons[node].kill()
        self.daemons.pop(node).wait()
        for _ in range(2):  # what a dying process started meanwhile
            for process in Path("/proc").glob("[0-9]*"):
                try:
                    words = (process / "cmdline").read_bytes().replace(b"\0", b" ").decode(errors="replace")
                    its = f"SLURMD_NODENAME={node}\0".encode() in (process / "environ").read_bytes() + b"\0"
                except OSError:
                    continue
                if its or any(words.startswith(f"slurmstepd: [{job}.") for job in jobs):
                    os.kill(int(process.name), signal.SIGKILL)

    def stop(self) -> None:
        """Cancel what runs, end the daemons, and leave no configuration behind."""
        self.said("scancel", "--user=root", "--full")
        for daemon in reversed(self.daemons.values()):
            daemon.terminate()
        for daemon in self.daemons.values():
            try:
                daemon.wait(20)
            except subprocess.TimeoutExpired:
                daemon.kill()
        CONF.unlink(missing_ok=True)


@contextmanager
def cluster(place: Path, hidden: Iterable[Path] = ()) -> Iterator[Cluster]:
    """A SLURM for as long as a test needs one."""
    local_cluster = Cluster(place, hidden)
    try:
        local_cluster.start()
        yield local_cluster
    finally:
        local_cluster.stop()
