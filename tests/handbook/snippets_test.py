"""Runs what the handbook shows: snippets_test.py SOURCE WEFTLIGHT. The ```sh blocks of a page run in one folder, in their
order, and so do its ```python blocks, in one program.

Sizes are made small first. Of the commands that draw, one is drawn; the others are run with graphics turned off, which
they report (exit code 4) only after their options and their draft were accepted."""

import os
import pathlib
import re
import subprocess
import sys
import tempfile

SOURCE, WEFTLIGHT = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]).resolve()
HANDBOOK = SOURCE / "docs" / "handbook"
NO_GRAPHICS = 4
DRAWN = "near.png"  # of artists.md
PROGRAM = f"""
weftlight() {{
  case "$1 $*" in
    *{DRAWN}*) '{WEFTLIGHT}' "$@" || test $? -eq {NO_GRAPHICS} ;;
    render\\ *|reference\\ *) WEFTLIGHT_OFFSCREEN=none '{WEFTLIGHT}' "$@" || test $? -eq {NO_GRAPHICS} ;;
    *) '{WEFTLIGHT}' "$@" ;;
  esac
}}
"""


def blocks(page: pathlib.Path, language: str) -> str:
    return "\n".join(re.findall(rf"^```{language}\n(.*?)^```", page.read_text(), re.S | re.M))


def small(commands: str) -> str:
    for pattern, with_ in [
        (r"--size \d+x\d+", "--size 32x24"),
        (r"--size \d+", "--size 64"),
        (r"--px-per-mm \d+", "--px-per-mm 1"),
        (r"--tile-cm \d+", "--tile-cm 1"),
        (r"--patch \d+x\d+", "--patch 1x1"),
        (r"--spp \d+", "--spp 1"),
        (r"--jobs \d+", "--jobs 1"),
    ]:
        commands = re.sub(pattern, with_, commands)
    return commands


def has_module() -> bool:
    return subprocess.run([sys.executable, "-c", "import weftlight"], capture_output=True).returncode == 0


def run(page: pathlib.Path, language: str, code: str, folder: str) -> str:
    """Nothing, or what went wrong."""
    program = ["bash", "-euc", PROGRAM + small(code)] if language == "sh" else [sys.executable, "-c", code]
    environment = {**os.environ, "LC_ALL": "C.UTF-8"}
    done = subprocess.run(program, cwd=folder, capture_output=True, text=True, env=environment)
    if done.returncode == 0:
        return ""
    return f"{page.name}, {language}: exit code {done.returncode}\n{done.stdout[-2000:]}{done.stderr[-3000:]}"


def main() -> int:
    languages = ["sh"] + ["python"] * has_module()
    if "python" not in languages:
        print("without the blocks in Python: its module is not built")
    failed, ran = [], 0
    for page in sorted(HANDBOOK.glob("*.md")):
        with tempfile.TemporaryDirectory() as folder:
            if page.stem == "weavers":  # where the reader has a draft
                subprocess.run([WEFTLIGHT, "weave", "huck", "-o", "towel.wif"], cwd=folder, check=True)
            for language in languages:
                if code := blocks(page, language):
                    ran += 1
                    failed += filter(None, [run(page, language, code, folder)])
    print("\n".join(failed) or f"{ran} programs of the handbook ran")
    return 1 if failed or ran < 4 else 0


sys.exit(main())
