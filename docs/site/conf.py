# SPDX-License-Identifier: BSD-3-Clause
"""The docs as a site: Sphinx over the pages of the repository, as they are. `cmake/docs.sh` calls it.

Its source folder is a stage that docs.sh lays out like the repository, with the generated pages beside the
written ones; so links between pages, and from pages to files, are the same here as in the repository.
"""

import re
from pathlib import Path

from docutils import nodes

project = "Stroma"
html_title = "Stroma"
extensions = ["myst_parser"]
root_doc = "README"
include_patterns = ["*.md", "docs/*.md", "input_decks/README.md", "input_decks/*/README.md", "tests/data/README.md"]
highlight_language = "none"
smartquotes = False
myst_enable_extensions = ["dollarmath"]
myst_heading_anchors = 4

html_theme = "furo"
html_static_path = ["static", "/usr/share/javascript/katex"]
html_css_files = ["katex.min.css", "stroma.css"]
html_js_files = ["katex.min.js", "equations.js"]
html_math_renderer = "katex"
html_show_sourcelink = False
html_show_copyright = False

# The pages in the order of the navigation. What stands in no list follows in the last one.
NAVIGATION = {
    "Use": ["docs/first_run", "docs/looking_at_results", "docs/deck_reference", "input_decks/README", "docs/rigs", "docs/report", "docs/studies", "docs/study_reference", "docs/fit", "docs/fit_reference", "docs/performance"],
    "Method": ["docs/theory", "docs/notation", "docs/verification", "docs/paper_study"],
    "Code": ["docs/architecture", "docs/extending", "docs/coupling", "docs/api"],
}


def with_navigation(stage, text):
    """The front page, with the lists of all pages that Sphinx makes the navigation from."""
    pages = [str(page.relative_to(stage).with_suffix("")) for page in sorted(stage.glob("*.md"))]
    pages += [str(page.relative_to(stage).with_suffix("")) for page in sorted(stage.glob("docs/*.md"))]
    pages += ["input_decks/README", "tests/data/README"]
    pages = [page for page in pages if page != root_doc and (stage / f"{page}.md").is_file()]
    listed = {page for names in NAVIGATION.values() for page in names}
    lists = {caption: [name for name in names if name in pages] for caption, names in NAVIGATION.items()}
    lists["Project"] = [page for page in pages if page not in listed]
    for caption, names in lists.items():
        text += "\n```{toctree}\n:hidden:\n:caption: " + caption + "\n\n" + "\n".join(names) + "\n```\n"
    return text


def with_linked_readme(page, link):
    """A link to a folder leads to its README."""
    return f"]({link[1].rstrip('/')}/README.md)" if (page.parent / link[1] / "README.md").is_file() else link[0]


def read_page(app, name, source):
    stage = Path(app.srcdir)
    page = stage / f"{name}.md"
    text = re.sub(r"^```math$", "```{math}", source[0], flags=re.MULTILINE)
    text = re.sub(r"\]\(([^)#:]+)\)", lambda link: with_linked_readme(page, link), text)
    if name == root_doc:
        text = with_navigation(stage, text)
    if name == "input_decks/README":
        decks = sorted(deck.parent.name for deck in page.parent.glob("*/README.md"))
        text += "\n```{toctree}\n:hidden:\n\n" + "\n".join(f"{deck}/README" for deck in decks) + "\n```\n"
    source[0] = text


def write_equation(visitor, node, tag):
    visitor.body.append(visitor.starttag(node, tag, "", CLASS="math") + visitor.encode(node.astext()) + f"</{tag}>")
    raise nodes.SkipNode


def setup(app):
    app.connect("source-read", read_page)
    app.add_html_math_renderer(
        "katex",
        (lambda visitor, node: write_equation(visitor, node, "span"), None),
        (lambda visitor, node: write_equation(visitor, node, "div"), None),
    )
