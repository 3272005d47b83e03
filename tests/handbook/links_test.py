"""Builds the handbook: links_test.py SOURCE. Each link, heading and picture is there (docs/handbook/build.py refuses
others), every picture is used, and a page needs nothing from outside its folder."""

import pathlib
import re
import subprocess
import sys
import tempfile

SOURCE = pathlib.Path(sys.argv[1])
HANDBOOK = SOURCE / "docs" / "handbook"
MOST_BYTES = 3_000_000  # of the pictures together


def main() -> int:
    try:
        import markdown  # noqa: F401
    except ImportError:
        print("skipped: python3-markdown is not installed")
        return 77
    wrong = []
    with tempfile.TemporaryDirectory() as folder:
        out = pathlib.Path(folder) / "handbook"
        built = subprocess.run([sys.executable, "-B", HANDBOOK / "build.py", out], stderr=subprocess.PIPE, text=True)
        if built.returncode:
            wrong.append(built.stderr)
        for page in out.glob("*.html"):
            for target in re.findall(r'(?:src|href)="([^"#]+)', page.read_text()):
                if not re.match("https?:", target) and not (out / target).is_file():
                    wrong.append(f"{page.name} needs {target}, which is not beside it")
        if any(re.search(r'<link[^>]*https?:|<script|src="https?:', page.read_text()) for page in out.glob("*.html")):
            wrong.append("a page needs the network or a script")
    texts = "".join(page.read_text() for page in HANDBOOK.glob("*.md"))
    pictures = list((HANDBOOK / "pictures").iterdir())
    wrong += [f"{p.name} is shown on no page" for p in pictures if f"pictures/{p.name}" not in texts]
    size = sum(p.stat().st_size for p in pictures)
    if size > MOST_BYTES:
        wrong.append(f"the pictures have {size} bytes")
    for script in re.findall(r"`(docs/\w+\.sh)`", texts):
        if not (SOURCE / script).is_file():
            wrong.append(f"there is no {script}")
    print("\n".join(wrong))
    return 1 if wrong else 0


sys.exit(main())
