#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""What a run shows on a terminal, in a pipe and under mpirun: one line of progress on the terminal, below the lines of the log, and
gone at the end; nothing of it anywhere else. Claim V-PROGRESS-1, docs/verification.md.

    check_terminal.py STROMA MPIRUN...
"""
import fcntl
import os
import pty
import re
import struct
import subprocess
import sys
import tempfile
import termios

STROMA, MPIRUN = sys.argv[1], sys.argv[2:]
DECK = """
Stroma:
  Image:
    Phantom:
      Kind: Uniform
      Size: [8, 8, 8]
      Voxel Size [um]: [1, 1, 1]
  Materials:
    gel:
      Label: 0
      Model: Neo-Hookean
      Shear Modulus [Pa]: 500
      Poisson Ratio: 0.3
  Grid:
    Element Size [um]: [2, 2, 2]
  Boundary Conditions:
    foot:
      Face: y-
      Components: xyz
    head:
      Face: y+
      Components: xyz
      Displacement [um]: [0, 1, 0]
  Loading:
    Steps: 4
  Output:
    Pictures: false
    Report: false
"""


def command(ranks, *more):
    start = [] if ranks == 1 else [*MPIRUN, str(ranks)]
    return [*start, STROMA, "run", "gel.yaml", "-o", "out", *more]


def on_terminal(words, term="xterm", columns=100):
    """Exit status, and all that a terminal is sent, with the line breaks that the program wrote."""
    child, terminal = pty.fork()
    if child == 0:
        fcntl.ioctl(1, termios.TIOCSWINSZ, struct.pack("HHHH", 24, columns, 0, 0))
        os.environ["TERM"] = term
        os.execvp(words[0], words)
    sent = b""
    try:
        while piece := os.read(terminal, 65536):
            sent += piece
    except OSError:  # the other end is closed
        pass
    return os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]), sent.decode().replace("\r\n", "\n")


def screen(sent):
    """What stays of it on the screen."""
    lines = [""]
    for part in re.split(r"(\r|\n|\033\[K)", sent):
        if part == "\n":
            lines.append("")
        elif part == "\r":
            lines[-1] = "\0" + lines[-1].replace("\0", "")
        elif part == "\033[K":
            lines[-1] = lines[-1].split("\0")[0]
        elif part:
            before, _, after = lines[-1].partition("\0") if "\0" in lines[-1] else (lines[-1], "", "")
            lines[-1] = before + part + "\0" + after[len(part):]
    return "\n".join(line.replace("\0", "") for line in lines)


def log():
    with open("out/log.txt", encoding="utf-8") as file:
        return file.read()


def piped(words):
    done = subprocess.run(words, capture_output=True, text=True, check=True)
    return done.stdout


def check_terminal():
    status, sent = on_terminal(command(1))
    assert status == 0, sent
    assert screen(sent) == log(), "the screen is not as the log"
    shown = re.findall(r"\r([^\r\n]+)\033\[K", sent)
    for step, (begin, end) in enumerate([("0", "0.25"), ("0.25", "0.5"), ("0.5", "0.75"), ("0.75", "1")], start=1):
        head = f"step {step} of 4   load {begin} to {end}"
        assert any(line.startswith(head) for line in shown), (head, shown)
        residuals = re.findall(rf"step +{step} +load.*residual (\S+)", log())
        assert any(line.startswith(head + "   Newton") and residuals[0] in line for line in shown), (residuals, shown)
    left = re.findall(r"\rstep (\d) of 4[^\r]*   \d+ s(, about \d+ s left)?\033\[K", sent)
    assert left and all((step != "1") == bool(told) for step, told in left), left
    assert not re.search("\033(?!\\[K)", sent), "other sequences than that which clears a line"


def check_narrow_terminal():
    _, sent = on_terminal(command(1), columns=40)
    widths = [len(line) for line in re.findall(r"\r([^\r\n]+)\033\[K", sent)]
    assert max(widths) == 39, "none is cut, or the terminal breaks it"
    assert screen(sent) == log()


def check_plain():
    for what, run in [("TERM=dumb", lambda: on_terminal(command(1), "dumb")[1]), ("a pipe", lambda: piped(command(1))),
                      ("mpirun on a terminal", lambda: on_terminal(command(2))[1]), ("mpirun in a pipe", lambda: piped(command(2)))]:
        assert run() == log(), f"{what}: not as the log"
        assert "\r" not in log() and "\033" not in log(), what
    assert on_terminal(command(1, "--quiet"))[1] == "", "--quiet: not quiet"


def check_errors():
    """A step that fails: the message begins a line."""
    status, sent = on_terminal(command(1, "--set", "Solver|Newton Iterations=1", "--set", "Loading|Smallest Step=0.2"))
    assert status == 1, sent
    assert re.search(r"^stroma: the load step from", screen(sent), re.M), screen(sent)


with tempfile.TemporaryDirectory() as folder:
    os.chdir(folder)
    with open("gel.yaml", "w", encoding="utf-8") as deck:
        deck.write(DECK)
    check_terminal()
    check_narrow_terminal()
    check_plain()
    check_errors()
print("the line of progress is on terminals alone")
