"""Builds the handbook to HTML that works offline: build.py OUT. Needs the package python3-markdown.

The handbook's pages, the reference pages that it leads to, their pictures and one style sheet, in one folder. Links to
files that are not built here become plain text. A link to a page, heading or picture that does not exist fails the build.
"""

import html
import pathlib
import re
import shutil
import sys

import markdown

HERE = pathlib.Path(__file__).resolve().parent
DOCS = HERE.parent
CHAPTERS = ["README", "weavers", "artists", "graphics", "scripts", "coming_from"]
REFERENCE = ["commands", "python", "yarns", "wif", "engines", "install", "privacy", "gates"]
EXTENSIONS = ["tables", "fenced_code", "sane_lists", "toc"]
MENU_ARROW = " \N{SINGLE RIGHT-POINTING ANGLE QUOTATION MARK} "
PAGE = """<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark">
<title>{title}</title>
<link rel="stylesheet" href="style.css">
</head>
<body>
<nav>{nav}</nav>
<main>
{body}
</main>
</body>
</html>
"""


def source(name: str) -> pathlib.Path:
    return (HERE if name in CHAPTERS else DOCS) / f"{name}.md"


def out_name(name: str) -> str:
    return "index.html" if name == "README" else f"{name}.html"


def title_of(text: str) -> str:
    return re.search(r"^# (.*)", text, re.M).group(1)


class Book:
    def __init__(self, out: pathlib.Path):
        self.out = out
        self.texts = {name: source(name).read_text() for name in CHAPTERS + REFERENCE}
        self.by_path = {source(name): name for name in self.texts}
        self.wrong: list[str] = []
        self.anchors: dict[str, set[str]] = {}
        self.pages: dict[str, str] = {}

    def render(self) -> None:
        for name, text in self.texts.items():
            made = markdown.Markdown(extensions=EXTENSIONS, extension_configs={"toc": {"toc_depth": "2-3"}})
            body = made.convert(text)
            self.anchors[name] = set(re.findall(r'id="([^"]*)"', body))
            if name in CHAPTERS[1:]:
                body = body.replace("</h1>", f"</h1>\n{made.toc}", 1)
            self.pages[name] = body

    def link(self, name: str, target: str, inner: str) -> str:
        if re.match(r"[a-z]+:", target):
            return f'<a href="{target}">{inner}</a>'
        path, _, anchor = target.partition("#")
        to = self.by_path.get((source(name).parent / path).resolve()) if path else name
        if to is None:
            if not (source(name).parent / path).exists():
                self.wrong.append(f"{source(name)}: there is no {target}")
            return inner
        if anchor and anchor not in self.anchors[to]:
            self.wrong.append(f"{source(name)}: there is no heading {target}")
        return f'<a href="{out_name(to) if path else ""}{"#" + anchor if anchor else ""}">{inner}</a>'

    def picture(self, name: str, target: str) -> str:
        path = (source(name).parent / target).resolve()
        if not path.exists():
            self.wrong.append(f"{source(name)}: there is no picture {target}")
            return ""
        flat = f"{path.parent.name}_{path.name}"
        shutil.copyfile(path, self.out / flat)
        return flat

    def nav(self, name: str) -> str:
        def entry(other: str) -> str:
            title = "Weftlight" if other == "README" else html.escape(title_of(self.texts[other]))
            here = ' aria-current="page"' if other == name else ""
            return f'<a href="{out_name(other)}"{here}>{title}</a>'

        return " ".join(map(entry, CHAPTERS))

    def write(self) -> None:
        shutil.rmtree(self.out, ignore_errors=True)
        self.out.mkdir(parents=True)
        for name, body in self.pages.items():
            body = re.sub(r'<a href="([^"]*)">(.*?)</a>', lambda m: self.link(name, m[1], m[2]), body, flags=re.S)
            body = re.sub(r'src="([^"]*)"', lambda m: f'src="{self.picture(name, m[1])}"', body)
            body = re.sub(r"<strong>[^<]*</strong>", lambda m: m[0].replace(" &gt; ", MENU_ARROW), body)
            body = body.replace("<table>", '<div class="wide"><table>').replace("</table>", "</table></div>")
            page = PAGE.format(title=html.escape(title_of(self.texts[name])), nav=self.nav(name), body=body)
            (self.out / out_name(name)).write_text(page)
        shutil.copyfile(HERE / "style.css", self.out / "style.css")


def main() -> int:
    book = Book(pathlib.Path(sys.argv[1]))
    book.render()
    book.write()
    print("\n".join(book.wrong), file=sys.stderr, end="\n" if book.wrong else "")
    return 1 if book.wrong else 0


sys.exit(main())
