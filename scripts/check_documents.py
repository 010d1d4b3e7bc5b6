"""Checks the Markdown files of the repository, or the pages of the site: called by scripts/docs.

    check_documents.py          each relative link of a Markdown file leads to a file and to a heading; each page of
                                docs/ has an example: a code block with a command or with source text; each picture of
                                docs/figures/ is in docs/gallery.md
    check_documents.py SITE     each relative link of a page leads to a file and to an element; no page loads a file
                                from the network
"""
import html.parser
import pathlib
import re
import sys
import urllib.parse

ROOT = pathlib.Path(__file__).resolve().parent.parent
COMMAND = re.compile(r"\s*(?:\$ )?(?:\w+=\S+ )*(?:fpkcheck|scripts/|build/|cmake|ctest|mpirun|python3?|gnuplot) ?\S")


def code_and_text(markdown):
    """The code blocks (language, text) of a Markdown file, and the text without code."""
    blocks = []

    def fenced(match):
        blocks.append((match[2], match[3]))
        return "\n"

    text = re.sub(r"^( *)```(\S*)[^\n]*\n(.*?)^ *```$", fenced, markdown, flags=re.MULTILINE | re.DOTALL)
    text = re.sub(r"(?:(?<=\n\n)(?: {4}[^\n]*\n)+)", lambda match: blocks.append(("", match[0])) or "\n", text)
    return blocks, text


def slug(heading):
    """The anchor of a heading, by the rule of GitHub."""
    heading = re.sub(r"\[([^]]*)\]\([^)]*\)", r"\1", heading).strip().lower()
    return re.sub(r"[^\w\- ]", "", heading).replace(" ", "-")


def check_markdown():
    documents = [ROOT / "README.md", ROOT / "CHANGELOG.md", *sorted((ROOT / "docs").glob("*.md")),
                 *sorted((ROOT / "third_party").rglob("*.md"))]
    parts = {document: code_and_text(document.read_text()) for document in documents}
    anchors = {document: {slug(heading) for heading in re.findall(r"^#+ (.*)$", text, re.MULTILINE)}
               for document, (_, text) in parts.items()}
    problems = []
    for document, (blocks, text) in parts.items():
        name = document.relative_to(ROOT)
        for target in re.findall(r"\]\(([^)\s]*)\)", re.sub(r"`[^`\n]*`", "`", text)):
            path, _, anchor = target.partition("#")
            if ":" in path:
                continue
            file = (document.parent / path).resolve() if path else document
            if not file.exists():
                problems.append(f"{name}: link to {target}: no such file")
            elif anchor and anchor not in anchors.get(file, ()):
                problems.append(f"{name}: link to {target}: no such heading")
        has_example = any(language not in ("", "text") or any(map(COMMAND.match, code.splitlines()))
                          for language, code in blocks)
        if name.parts[0] == "docs" and not has_example:
            problems.append(f"{name}: no example")
    gallery = (ROOT / "docs/gallery.md").read_text()
    pictures = (picture.relative_to(ROOT / "docs") for picture in sorted((ROOT / "docs/figures").rglob("*.png")))
    return problems + [f"docs/gallery.md: no {picture}" for picture in pictures if f"({picture})" not in gallery]


class Page(html.parser.HTMLParser):
    """Targets of links, files that a page loads, and identifiers of a page."""

    def __init__(self, text):
        super().__init__()
        self.targets, self.loaded, self.identifiers = set(), set(), set()
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        values = dict(attributes)
        self.identifiers |= {values[key] for key in ("id", "name") if values.get(key)}
        target = values.get("href") or values.get("src")
        if target:
            self.targets.add(target)
            if tag in ("script", "img", "iframe") or (tag == "link" and values.get("rel") != "canonical"):
                self.loaded.add(target)


def check_site(site):
    pages = {path: Page(path.read_text()) for path in sorted(site.rglob("*.html"))}
    problems = []
    for path, page in pages.items():
        name = path.relative_to(site)
        problems += [f"{name}: loads {target}" for target in page.loaded if re.match("(https?:)?//", target)]
        for target in page.targets:
            link = urllib.parse.urlsplit(target)
            if link.scheme or link.netloc:
                continue
            file = (path.parent / urllib.parse.unquote(link.path)).resolve() if link.path else path
            anchor = urllib.parse.unquote(link.fragment)
            if not file.exists():
                problems.append(f"{name}: link to {target}: no such file")
            elif anchor and file in pages and anchor not in pages[file].identifiers:
                problems.append(f"{name}: link to {target}: no such element")
    return problems


if __name__ == "__main__":
    found = check_site(pathlib.Path(sys.argv[1]).resolve()) if len(sys.argv) > 1 else check_markdown()
    sys.exit("\n".join(found) or 0)
