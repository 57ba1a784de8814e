#!/usr/bin/env python3
"""Runs a page of docs/guide as a reader would: all its ```sh blocks, one after the other, in a fresh folder, and compares
what each prints with the ```text block behind it. In such a block "..." stands for anything, and a line "..." for any lines.
Usage: run_page.py PAGE.md FOLDER_OF_THE_PROGRAM"""
import os
import re
import subprocess
import sys
import tempfile

MARK = "== block "


def blocks(page):
    """(commands, expected lines or None) in the order of the page."""
    found, kind, lines = [], None, []
    for line in open(page, encoding="utf-8"):
        fence = re.match(r"^```(\w*)\s*$", line)
        if not fence:
            lines.append(line.rstrip("\n"))
        elif kind is None:
            kind, lines = fence.group(1), []
        else:
            if kind == "sh":
                found.append(["\n".join(lines), None])
            elif kind == "text" and found and found[-1][1] is None:
                found[-1][1] = lines
            kind, lines = None, []
    return found


def pattern(lines):
    parts = []
    for line in lines:
        parts.append(r"(?:.*\n)*?" if line.strip() == "..." else
                     r"[^\n]*".join(re.escape(part) for part in line.rstrip().split("...")) + r"[ ]*\n")
    return re.compile(r"(?:.*\n)*?" + "".join(parts))


def main():
    page, program = sys.argv[1], os.path.abspath(sys.argv[2])
    todo = blocks(page)
    if not any(expected for _, expected in todo):
        sys.exit(f"{page}: no ```sh block with a ```text block behind it")
    script = "set -euo pipefail\n" + "".join(
        f"echo '{MARK}{i}'\n{commands}\n" for i, (commands, _) in enumerate(todo))
    environment = dict(os.environ, PATH=program + os.pathsep + os.environ["PATH"])
    with tempfile.TemporaryDirectory() as folder:
        ran = subprocess.run(["bash", "-c", script], cwd=folder, env=environment, stdout=subprocess.PIPE,
                             stderr=subprocess.STDOUT, text=True, errors="replace")
    printed = dict(enumerate(re.split(f"(?m)^{MARK}\\d+\n", ran.stdout)[1:]))
    if ran.returncode != 0:
        last = len(printed) - 1
        sys.exit(f"{page}: block {last} ended with status {ran.returncode}:\n{todo[last][0]}\n\n{printed[last]}")
    wrong = [f"{page}: the block\n{commands}\n\nprinted\n{printed[i]}\nand the page says\n" + "\n".join(expected)
             for i, (commands, expected) in enumerate(todo)
             if expected is not None and not pattern(expected).match(printed[i])]
    if wrong:
        sys.exit("\n\n".join(wrong))
    print(f"{page}: {len(todo)} blocks")


main()
