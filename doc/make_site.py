# SPDX-License-Identifier: GPL-3.0-or-later
"""make_site.py SOURCE BUILD: the manual as static pages in BUILD/html, from BUILD/Doxyfile; the target `doc` calls it.

Fails if doxygen warns, if a link of a page leads nowhere or a page shows doxygen's commands, if a page is missing in the navigation, or if an example is not shown
with what it prints. Then also writes BUILD/html/search/pages.js, the text that search.js searches.
"""

import html.parser
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import urllib.parse

source, build = map(pathlib.Path, sys.argv[1:])
site = build / "html"
problems: list[str] = []


class Page(html.parser.HTMLParser):
    """Links and anchors of a page, and its text by sections: a section begins at a heading with an anchor."""

    def __init__(self, path: pathlib.Path):
        super().__init__()
        self.links: list[str] = []
        self.anchors: set[str] = set()
        self.sections: list[list[str]] = [["", ""]]  # anchor and text
        self.title = ""
        self.inside: list[str] = []
        self.text_starts = False
        self.feed(path.read_text())

    def handle_starttag(self, tag, attributes):
        values = dict(attributes)
        self.links += [values[name] for name in ("href", "src", "data") if values.get(name)]
        self.anchors |= {values[name] for name in ("id", "name") if values.get(name)}
        if values.get("class") == "contents":
            self.text_starts = True
        anchor = values.get("id")
        if anchor and self.text_starts and (tag in ("h1", "h2", "h3") or tag == "a" and "anchor" in values.get("class", "")):
            self.sections.append([anchor, ""])
        if tag in ("title", "script", "style"):
            self.inside.append(tag)

    def handle_endtag(self, tag):
        if self.inside and tag == self.inside[-1]:
            self.inside.pop()
        if tag in ("p", "td", "th", "li", "dt", "dd", "div", "h1", "h2", "h3", "pre"):
            self.handle_data(" ")

    def handle_data(self, text):
        if self.inside == ["title"]:
            self.title += text
        elif self.text_starts and not self.inside:
            self.sections[-1][1] += text


def run_doxygen() -> None:
    shutil.rmtree(site, ignore_errors=True)
    man_page = build.parent / "src/manual/spherical-parameterization.1"
    (build / "man_page.html").write_text(
        subprocess.run(["mandoc", "-T", "html", "-O", "fragment", man_page], stdout=subprocess.PIPE, text=True, check=True).stdout)
    live = source / "web/dist/index.html"
    environment = os.environ | {"LIVE_PAGE": "LIVE_PAGE" if live.exists() else ""}
    done = subprocess.run(["doxygen", build / "Doxyfile"], env=environment, stderr=subprocess.PIPE, text=True)
    if done.returncode or done.stderr:
        sys.exit(f"doxygen warns:\n{done.stderr}")
    if live.exists():
        (site / "live").mkdir()
        shutil.copy(live, site / "live")
    shutil.copy(source / "doc/Spherical_parameterization/search.js", site / "search")
    for path in site.glob("*.html"):  # doxygen names a file that only a server would have
        path.write_text(re.sub('<link rel="search".*\n', "", path.read_text()))


def check_pages(pages: dict[str, Page]) -> None:
    for name, page in pages.items():
        for anchor, text in page.sections:
            if raw := re.search(r"@(section|subsection|ref)\b.{,50}", text):
                problems.append(f"{name} shows the command {raw[0]}")
        for link in sorted(set(page.links)):
            url = urllib.parse.urlparse(link)
            if url.scheme in ("https", "http", "mailto", "javascript", "data"):
                continue
            target = urllib.parse.unquote(url.path) or name
            anchor = urllib.parse.unquote(url.fragment)
            if url.scheme or target.startswith("/") or not (site / target).is_file():
                problems.append(f"{name} links to {link}, which is not there")
            elif anchor and target in pages and anchor not in pages[target].anchors:
                problems.append(f"{name} links to {link}, but {target} has no such anchor")


def check_chapters() -> None:
    manual = source / "doc/Spherical_parameterization"
    chapters = "".join(path.read_text() for path in manual.glob("*.txt"))
    for example in (source / "examples").glob("*.cpp"):
        name = example.stem
        problems.extend(f"no chapter has {command}"
                        for command in (f"\\example {name}.cpp", f"\\cgalExample{{{name}.cpp}}", f"\\output{{{name}}}")
                        if command not in chapters)
    labels = re.findall(r"\\page (\w+)", chapters) + [path.stem for path in (source / "doc").glob("*.md")]
    layout = (manual / "layout.xml").read_text()
    problems.extend(f"layout.xml does not have the page {label}" for label in labels if f"@ref {label}\"" not in layout)


def write_search_index(pages: dict[str, Page]) -> None:
    index = []
    for name, page in pages.items():
        title = page.title.split(": ", 1)[-1]
        for anchor, text in page.sections:
            text = " ".join(text.split())
            if text and not name.endswith(("-members.html", "-example.html")):
                index.append([f"{name}#{anchor}" if anchor else name, title, text])
    (site / "search/pages.js").write_text(f"searchPages({json.dumps(index, ensure_ascii=False)});\n")


run_doxygen()
pages = {path.name: Page(path) for path in sorted(site.glob("*.html"))}
check_pages(pages)
check_chapters()
if problems:
    sys.exit("\n".join(problems))
write_search_index(pages)
print(f"{len(pages)} pages, no warnings: {site}/index.html")
