#!/usr/bin/env python3
"""Mutation testing of the rooms that read and keep drafts: single faults are made in a copy of a source file, and the
unit tests of its room have to notice. What they do not notice is printed, to be looked at.

    cmake --build build/check --target wif_test draft_test session_test
    tests/mutation.py build/check --room wif --sample 100 --seed 1

A mutant is one file compiled alone and linked before the libraries, so the build folder is only read. The faults:
comparisons, arithmetic, logic, whole numbers, true and false, and deleted statements.
"""
import argparse
import json
import pathlib
import random
import re
import shlex
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent
# Files of the room, its test program, and which of the tests.
ROOMS = {
    "wif": ("core/wif/*.cpp", "wif_test", "*"),
    "draft": ("core/draft/*.cpp", "draft_test", "*"),
    "journal": ("editor/session/recovery/journal*.cpp", "session_test", "Journal*:Recovery*:BringBack*"),
}
# clang-format sets binary operators between blanks, which tells them from templates and references.
SWAPS = [
    (r" < ", " <= "), (r" <= ", " < "), (r" > ", " >= "), (r" >= ", " > "), (r" == ", " != "), (r" != ", " == "),
    (r" && ", " || "), (r" \|\| ", " && "), (r" \+ ", " - "), (r" - ", " + "), (r" \* ", " / "), (r" / ", " * "),
    (r" % ", " / "), (r" \+= ", " -= "), (r" -= ", " += "), (r"\+\+", "--"), (r"(?<=[(\s])!(?=[\w(])", ""),
    (r"\btrue\b", "false"), (r"\bfalse\b", "true"),
    (r"(?<![\w.'])(\d+)(?![\w.'])", lambda m: str(int(m[1]) + 1)),
]
STATEMENT = re.compile(r"^\s+(?!return|using|case|const|auto|static|else|if|for|while|struct|template)"
                       r"([\w.\[\]]+(->|\.|::))*[\w.\[\]]+(\(.*\)| [-+|&]?= .*);$|^\s+(continue|break|return);$")
NOT_CODE = re.compile(r'^\s*(//|#|using |static_assert|///|namespace |template|\})')
LITERALS = re.compile(r'"(?:\\.|[^"\\])*"|\'(?:\\.|[^\'\\])\'|//.*$')


def mutants_of(path):
    """(line, old, new) of each fault of a file."""
    found = []
    lines = path.read_text().split("\n")
    for at, line in enumerate(lines):
        if NOT_CODE.match(line) or not line.strip():
            continue
        code = LITERALS.sub(lambda m: "\0" * len(m[0]), line)  # faults in texts and comments are none
        for pattern, to in SWAPS:
            for m in re.finditer(pattern, code):
                new = to(m) if callable(to) else to
                found.append((at, line, line[:m.start()] + new + line[m.end():]))
        if STATEMENT.match(code):
            found.append((at, line, ""))
    return found


def commands(build, program):
    """How each source file is compiled, and how the test program is linked."""
    compiled = {e["file"]: e["command"] for e in json.loads((build / "compile_commands.json").read_text())}
    lines = subprocess.run(["ninja", "-C", build, "-t", "commands", program], capture_output=True, text=True,
                           check=True).stdout.splitlines()
    link = next(l for l in reversed(lines) if f"-o tests/{program}" in l)
    return compiled, re.sub(r"^: && | && :.*$", "", link)


class Lab:
    """Compiles, links and runs mutants of one room."""

    def __init__(self, build, room):
        self.build, self.room = build, room
        _, self.program, self.filter = ROOMS[room]
        self.compiled, self.link = commands(build, self.program)
        self.folder = tempfile.TemporaryDirectory(prefix="weftlight-mutant-")
        self.at = pathlib.Path(self.folder.name)
        begun = time.monotonic()
        if self.run(build / "tests" / self.program, 300) != 0:
            sys.exit(f"{self.program} fails without a fault")
        self.longest = 10 + 3 * (time.monotonic() - begun)

    def run(self, program, longest):
        """The exit status; a program that hangs has noticed, too."""
        try:
            return subprocess.run([program, f"--gtest_filter={self.filter}", "--gtest_fail_fast"], cwd=self.build / "tests",
                                  stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, timeout=longest,
                                  check=False).returncode
        except subprocess.TimeoutExpired:
            return "hangs"

    def try_one(self, path, line, new):
        """"killed", "survived", or "no program"."""
        text = path.read_text().split("\n")
        text[line] = new
        mutant, made, program = self.at / path.name, self.at / "mutant.o", self.at / self.program
        mutant.write_text("\n".join(text))
        words = shlex.split(self.compiled[str(path)])
        words = [w for w in words if w not in ("-O3", "-Werror") and not w.startswith("-W")]
        words[words.index("-o") + 1], words[words.index("-c") + 1] = str(made), str(mutant)
        if subprocess.run(words + ["-O0", "-w"], cwd=self.build, stderr=subprocess.DEVNULL, check=False).returncode != 0:
            return "no program"
        words = shlex.split(self.link)
        words[words.index("-o") + 1] = str(program)
        first = next(i for i, w in enumerate(words) if w.endswith(".o"))
        words.insert(first, str(made))
        if subprocess.run(words, cwd=self.build, stderr=subprocess.DEVNULL, check=False).returncode != 0:
            return "no program"
        return "survived" if self.run(program, self.longest) == 0 else "killed"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("--room", choices=ROOMS, required=True)
    parser.add_argument("--sample", type=int, default=50, help="faults, drawn at random (default: 50; 0: all)")
    parser.add_argument("--seed", type=int, default=1, help="default: 1")
    parser.add_argument("--only", default="", help="regular expression of file:line (default: every line)")
    o = parser.parse_args()
    lab = Lab(o.build.resolve(), o.room)
    faults = [(path, *fault) for path in sorted(ROOT.glob(ROOMS[o.room][0])) for fault in mutants_of(path)]
    faults = [f for f in faults if re.search(o.only, f"{f[0].relative_to(ROOT)}:{f[1] + 1}")]
    chosen = random.Random(o.seed).sample(faults, min(o.sample, len(faults)) if o.sample else len(faults))
    count = {"killed": 0, "survived": 0, "no program": 0}
    try:
        for path, line, old, new in sorted(chosen):
            result = lab.try_one(path, line, new)
            count[result] += 1
            print(f"{sum(count.values())} of {len(chosen)}", end="\r", file=sys.stderr, flush=True)
            if result == "survived":
                print(f"{path.relative_to(ROOT)}:{line + 1}\n  - {old.strip()}\n  + {new.strip() or '(deleted)'}",
                      flush=True)
    except KeyboardInterrupt:
        print("interrupted")
    tried = count["killed"] + count["survived"]
    print(f"{o.room}: {tried} faults of {len(faults)} tried, {count['killed']} noticed "
          f"({100 * count['killed'] / max(1, tried):.0f} %), {count['survived']} survived")


if __name__ == "__main__":
    main()
