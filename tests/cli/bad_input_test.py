"""Runs the program with every line of bad_inputs.txt. Each run must end within SECONDS and BYTES, with
exit code 2, a message of one line, and no files left behind.

usage: bad_input_test.py FPKCHECK [--sanitized]     --sanitized: no memory limit, six times the time limit
"""
import concurrent.futures
import os
import pathlib
import resource
import shlex
import subprocess
import sys
import tempfile

import bad_files

SECONDS = 5
SECONDS_SANITIZED = 30
BYTES = 500 * 2**20
LONGEST_MESSAGE = 400
PLACES = {"{long}": "x" * 100000, "{esc}": "\x1b", "{newline}": "\n"}
# Commands that have --out.
COMMANDS_WITH_OUT = ("run", "paper", "epc", "fd", "mcs", "bounds", "study", "check", "reference", "sweep")


def lines():
    table = pathlib.Path(__file__).with_name("bad_inputs.txt")
    for number, line in enumerate(table.read_text().splitlines(), 1):
        if line and not line.startswith("#"):
            arguments, expected = line.split("=>", 1)
            yield number, arguments.strip(), expected.strip()


def substitute(argument):
    for place, text in PLACES.items():
        argument = argument.replace(place, text)
    return argument


def files():
    """Paths of all files in the working directory with their modification times. Directories have
    the time 0: creating and removing a file changes their time."""
    return {path: 0 if os.path.isdir(path) else os.lstat(path).st_mtime_ns
            for folder, folders, names in os.walk(".")
            for path in (os.path.join(folder, name) for name in folders + names)}


def limit_memory():
    resource.setrlimit(resource.RLIMIT_AS, (BYTES, BYTES))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))


def failures(program, sanitized, number, text, expected):
    seconds = SECONDS_SANITIZED if sanitized else SECONDS
    arguments = [substitute(argument) for argument in shlex.split(text)]
    out = f"out-{number}"
    if len(arguments) > 1 and arguments[0] in COMMANDS_WITH_OUT and "--out" not in arguments:
        arguments += ["--out", out]
    try:
        done = subprocess.run([program, *arguments], stdin=subprocess.DEVNULL, capture_output=True,
                              timeout=seconds, preexec_fn=None if sanitized else limit_memory)
    except subprocess.TimeoutExpired:
        yield f"did not end within {seconds} s"
        return
    message = done.stderr.decode(errors="backslashreplace")
    if done.returncode != 2:
        yield f"exit code {done.returncode}"
    if not message.startswith("fpkcheck: ") or message.count("\n") != 1 or message[-1] != "\n":
        yield "not one line"
    if len(message) >= LONGEST_MESSAGE:
        yield f"{len(message)} characters"
    if any(ord(c) < 32 or ord(c) == 127 for c in message[:-1]):
        yield "control characters"
    if expected not in message:
        yield f"message lacks {expected!r}"
    if expected not in message or done.returncode != 2:
        yield f"but: {message[:300]!r}"
    if done.stdout:
        yield "text on standard output"
    if os.path.exists(out):
        yield f"left {os.listdir(out)} behind"


def main():
    program, sanitized = os.path.abspath(sys.argv[1]), "--sanitized" in sys.argv
    table = list(lines())
    failed = 0
    with tempfile.TemporaryDirectory() as directory:
        os.chdir(directory)
        bad_files.make(program)
        before = files()

        def judge(line):
            return list(failures(program, sanitized, *line))

        with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
            for (number, text, _), found in zip(table, pool.map(judge, table)):
                if found:
                    failed += 1
                    print(f"bad_inputs.txt:{number}: {text[:200]}: {'; '.join(found)}")
        changed = sorted(set(before.items()) ^ set(files().items()))
        if changed:
            failed += 1
            print("files were changed or left behind:", changed)
        os.chdir("/")
    print(f"{len(table)} bad inputs, {failed} failures")
    sys.exit(failed > 0)


if __name__ == "__main__":
    main()
