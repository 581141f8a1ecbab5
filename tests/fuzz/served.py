"""Runs of a program that is started once and forks for each of them (fork_server.cpp)."""
import os
import pathlib
import socket
import subprocess
import time

TICKS = os.sysconf("SC_CLK_TCK")


class Served:
    """The program at `path`, started with fork_server.so; `name` is that of its socket. Ends with this object."""

    def __init__(self, path, library, name, environment):
        self.path, self.at = str(path), str(name)
        self.process = subprocess.Popen([self.path], env={**environment, "LD_PRELOAD": str(library),
                                                          "TALUS_FORKS_AT": self.at})
        while not pathlib.Path(self.at).exists():
            if self.process.poll() is not None:
                raise RuntimeError(f"{path} cannot be served")
            time.sleep(0.01)

    def __del__(self):
        self.process.kill()
        self.process.wait()

    def run(self, arguments, errors, patience):
        """The exit code, or minus the signal; None after `patience` s. `errors`: a file for the standard error."""
        with socket.socket(socket.AF_UNIX, socket.SOCK_SEQPACKET) as case, open(os.devnull, "r+b") as nothing:
            case.connect(self.at)
            case.settimeout(patience)
            words = b"".join(os.fsencode(word) + b"\0" for word in [self.path, *arguments])
            socket.send_fds(case, [words], [nothing.fileno(), nothing.fileno(), errors.fileno()])
            try:
                return os.waitstatus_to_exitcode(int.from_bytes(case.recv(4), "little"))
            except TimeoutError:
                return None

    def processor_time(self):
        """Of all its cases that have ended, s."""
        fields = pathlib.Path(f"/proc/{self.process.pid}/stat").read_text(encoding="ascii").rpartition(")")[2].split()
        return (int(fields[13]) + int(fields[14])) / TICKS
