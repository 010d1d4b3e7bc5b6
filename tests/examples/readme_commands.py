#!/usr/bin/env python3
"""Tests the commands in README.md, in a temporary folder with links to examples/ and cases/.

usage: readme_commands.py SOURCE FPKCHECK [--run]     without --run: only tests that their files exist

Every command must end with exit code 0, or 1 (a solver has no density).
"""
import pathlib
import re
import shlex
import subprocess
import sys
import tempfile


def commands(readme):
    """The commands of all code blocks that begin with `fpkcheck`, without comments."""
    blocks = re.findall(r"^```\n(fpkcheck .*?)^```", readme, re.MULTILINE | re.DOTALL)
    assert blocks, "README.md has no block of commands"
    return [shlex.split(line, comments=True) for block in blocks for line in block.splitlines() if line.strip()]


def main(source, program, *options):
    source = pathlib.Path(source).resolve()
    all_commands = commands((source / "README.md").read_text())
    assert len(all_commands) > 10, all_commands
    failed = []
    with tempfile.TemporaryDirectory() as folder:
        for name in ("examples", "cases"):
            (pathlib.Path(folder) / name).symlink_to(source / name)
        for command in all_commands:
            assert command[0] == "fpkcheck", command
            for path in re.findall(r"\b[\w./-]+\.(?:csv|ini)\b", " ".join(command)):
                if not (pathlib.Path(folder) / path).is_file():
                    failed.append(f"{' '.join(command)}: no file {path}")
            if "--run" in options:
                done = subprocess.run([program, *command[1:]], cwd=folder, capture_output=True, text=True)
                if done.returncode not in (0, 1):
                    failed.append(f"{' '.join(command)}: exit code {done.returncode}: {done.stderr}")
    print("\n".join(failed) or f"{len(all_commands)} commands")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
