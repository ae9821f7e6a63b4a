"""Runs a command and writes what it used into a file descriptor: measured_command.py DESCRIPTOR JOB, the job as JSON.

A process begins with the most memory that the one which started it has had (execve(2) keeps ru_maxrss), and pytest has had
more than what is measured: so commands are started by this small one, which imports little."""
import json
import os
import signal
import sys


def main():
    descriptor, job = int(sys.argv[1]), json.loads(sys.argv[2])
    os.set_inheritable(descriptor, False)
    late = False
    process = os.posix_spawnp(job["command"][0], job["command"], job["env"])

    def end(number, frame):
        nonlocal late
        late = True
        os.kill(process, signal.SIGKILL)

    signal.signal(signal.SIGALRM, end)
    signal.setitimer(signal.ITIMER_REAL, job["timeout"])
    _, status, usage = os.wait4(process, 0)
    signal.setitimer(signal.ITIMER_REAL, 0)
    used = {
        "returncode": os.waitstatus_to_exitcode(status),
        "late": late,
        "seconds": usage.ru_utime + usage.ru_stime,
        "kibibytes": usage.ru_maxrss,
    }
    os.write(descriptor, json.dumps(used).encode())


main()
