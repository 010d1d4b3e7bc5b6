"""Sphinx configuration of the site that scripts/docs builds from the Markdown files of the repository.

The source folder of Sphinx is the root of the repository, so that a link between two files of the repository is also
a link between two pages of the site. The tables of docs/README.md are the only list of pages: the navigation of the
site is made from their links.
"""
import pathlib
import re

project = "fpkcheck"
root_doc = "docs/README"
include_patterns = ["README.md", "CHANGELOG.md", "docs/*.md", "third_party/**.md"]
exclude_patterns = ["build*", "fpkcheck-*", ".git"]
extensions = ["myst_parser", "breathe"]

myst_heading_anchors = 4
highlight_language = "text"
smartquotes = False  # y' is a velocity

breathe_projects = {"fpkcheck": str(pathlib.Path(__file__).parent.parent / "build/site-api/xml")}
breathe_default_project = "fpkcheck"
breathe_domain_by_extension = {"hpp": "cpp"}

html_theme = "furo"
html_title = "fpkcheck"
html_static_path = ["site"]
html_css_files = ["site.css"]
html_js_files = ["site.js"]
html_use_index = False
html_copy_source = False
html_show_sphinx = False
html_show_copyright = False


def add_navigation(text):
    """Adds to each section of a list of pages a hidden toctree of the pages in its table."""
    sections = re.split(r"^(?=## )", text, flags=re.MULTILINE)
    for number, section in enumerate(sections):
        pages = re.findall(r"^\| \[[^]]*\]\(([^)#]*)\.md\)", section, re.MULTILINE)
        if pages:
            caption = section.splitlines()[0].lstrip("# ")
            sections[number] += f"\n```{{toctree}}\n:hidden:\n:caption: {caption}\n\n" + "\n".join(pages) + "\n```\n\n"
    return "".join(sections)


def add_declarations(text):
    """Adds to each section of docs/api.md about a library the declarations of its namespace."""
    directive = r"\g<0>\n```{doxygennamespace} fpkcheck::\1\n:content-only:\n```\n\n"
    return re.sub(r"^## `(\w+)`.*?(?=^## |\Z)", directive, text, flags=re.MULTILINE | re.DOTALL)


def prepare_source(_, page, source):
    if page in (root_doc, "third_party/README"):
        source[0] = add_navigation(source[0])
    if page == "docs/api":
        source[0] = add_declarations(source[0])


def setup(app):
    app.connect("source-read", prepare_source)
