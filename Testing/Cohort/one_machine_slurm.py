"""A Slurm of this machine alone, for as long as a test needs it: munged, slurmctld and slurmd with a configuration, keys and
ports of their own, so that one that is installed and runs is not touched."""
import os
import pathlib
import shutil
import signal
import socket
import subprocess
import tempfile
import time

PROGRAMS = ("munged", "mungekey", "slurmctld", "slurmd", "sbatch", "srun", "squeue", "scontrol", "scancel")


class Unavailable(RuntimeError):
    """Why there is no Slurm here."""


def find(name):
    """Where Debian has it: the path of a user lacks the folders of daemons."""
    return shutil.which(name, path=os.environ.get("PATH", "") + ":/usr/sbin:/sbin")


def free_port():
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


class OneMachineSlurm:
    """`with OneMachineSlurm() as slurm`: slurm.environment is what its clients need."""

    def __init__(self, processors=2):
        missing = [name for name in PROGRAMS if find(name) is None]
        if missing:
            raise Unavailable(f"{', '.join(missing)} not installed (Debian: slurmctld slurmd slurm-client munge)")
        if os.geteuid() != 0:
            # slurmd starts jobs as their owners, and munged checks who owns its socket.
            raise Unavailable("slurmd needs root to start jobs")
        self._processors = processors
        self._daemons = []

    def __enter__(self):
        # Short: a socket's name may have 107 characters.
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="slurm-"))
        self.folder.chmod(0o755)
        try:
            self._start()
        except BaseException:
            self.__exit__()
            raise
        return self

    def __exit__(self, *_):
        if (self.folder / "slurm.conf").exists() and len(self._daemons) > 1:
            subprocess.run([find("scancel"), "--user", "root"], env=self.environment, capture_output=True, timeout=30)
        for daemon in reversed(self._daemons):
            daemon.send_signal(signal.SIGTERM)
            try:
                daemon.wait(timeout=20)
            except subprocess.TimeoutExpired:
                daemon.kill()
                daemon.wait()
        shutil.rmtree(self.folder, ignore_errors=True)

    def said(self):
        """What the daemons have logged, for a message of a test that fails."""
        return "\n".join(f"--- {path.name}\n{path.read_text()[-3000:]}" for path in sorted(self.folder.glob("*.log")))

    def call(self, name, *arguments):
        return subprocess.run(
            [find(name), *arguments], env=self.environment, capture_output=True, text=True, timeout=60, check=True
        ).stdout

    def _daemon(self, name, *arguments):
        with open(self.folder / f"{name}.log", "w") as log:
            self._daemons.append(
                subprocess.Popen([find(name), *arguments], stdout=log, stderr=log, env=self.environment, cwd=self.folder)
            )

    def _wait(self, what, ready, seconds=30):
        deadline = time.monotonic() + seconds
        while not ready():
            if time.monotonic() > deadline or any(daemon.poll() is not None for daemon in self._daemons):
                raise Unavailable(f"{what} does not start:\n{self.said()}")
            time.sleep(0.2)

    def _start(self):
        folder = self.folder
        socket_file = folder / "munge.socket"
        self.environment = {
            **os.environ,
            "SLURM_CONF": str(folder / "slurm.conf"),
            "PATH": f"{folder}/bin:" + os.environ.get("PATH", "") + ":/usr/sbin:/sbin",
        }
        # In a job the plugin of Snakemake calls srun without the variables of Slurm, among them SLURM_CONF: this one brings it.
        (folder / "bin").mkdir()
        (folder / "bin" / "srun").write_text(f'#!/bin/sh\nSLURM_CONF={folder}/slurm.conf exec {find("srun")} "$@"\n')
        (folder / "bin" / "srun").chmod(0o755)
        # munged refuses a key that others can read, and a folder that others can write.
        (folder / "munge").mkdir(mode=0o755)
        subprocess.run([find("mungekey"), "--create", f"--keyfile={folder}/munge/key"], check=True, timeout=60)
        host = socket.gethostname().split(".")[0]
        (folder / "state").mkdir()
        (folder / "spool").mkdir()
        (folder / "slurm.conf").write_text(
            f"""ClusterName=test
SlurmctldHost={host}(127.0.0.1)
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
AuthInfo=socket={socket_file}
CredType=cred/munge
CryptoType=crypto/munge
SlurmctldPort={free_port()}
SlurmdPort={free_port()}
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd.pid
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
MpiDefault=none
# The plugin asks squeue how a job ended, which knows it for so many seconds.
MinJobAge=300
ReturnToService=2
SchedulerParameters=sched_interval=1,batch_sched_delay=0
NodeName={host} NodeAddr=127.0.0.1 CPUs={self._processors} RealMemory=4000 State=UNKNOWN
PartitionName=all Nodes={host} Default=YES MaxTime=INFINITE DefMemPerCPU=100 State=UP
"""
        )
        self._daemon(
            "munged",
            "--foreground",
            "--force",
            f"--key-file={folder}/munge/key",
            f"--socket={socket_file}",
            f"--pid-file={folder}/munge/pid",
            f"--seed-file={folder}/munge/seed",
            f"--log-file={folder}/munge/log",
        )
        self._wait("munged", socket_file.exists)
        self._daemon("slurmctld", "-D", "-f", str(folder / "slurm.conf"))
        self._daemon("slurmd", "-D", "-f", str(folder / "slurm.conf"), "-N", host)

        def idle():
            asked = subprocess.run(
                [find("sinfo") or "sinfo", "-h", "-o", "%T"], env=self.environment, capture_output=True, text=True, timeout=60
            )
            return asked.stdout.strip() == "idle"

        self._wait("Slurm", idle, 60)
