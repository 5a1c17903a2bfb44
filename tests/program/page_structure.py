#!/usr/bin/python3
"""What must hold of a page of scripts/report without a browser: it is well-formed, stands alone, and says in words what
it shows. Prints each fault; exit code 1 if there is any.

    page_structure.py PAGE
"""

import re
import sys
from pathlib import Path
from xml.etree import ElementTree

SVG = "{http://www.w3.org/2000/svg}"
REFERRING = ["aria-labelledby", "aria-describedby"]
ONCE = ["h1", "main", "nav", "title", "header", "footer"]


def words(element):
    return " ".join("".join(element.itertext()).split())


def faults_of_names(page):
    ids = [element.get("id") for element in page.iter() if element.get("id") is not None]
    yield from (f"two elements have the id {name}" for name in sorted({name for name in ids if ids.count(name) > 1}))
    for element in page.iter():
        wanted = [name for key in REFERRING for name in (element.get(key) or "").split()]
        for value in element.attrib.values():
            wanted += re.findall(r"url\(#([^)]+)\)", value)
        if (element.get("href") or "").startswith("#"):
            wanted.append(element.get("href")[1:])
        yield from (f"{element.tag} refers to {name}, which is not there" for name in wanted if name not in ids)


def faults_of_structure(page):
    for name in ONCE:
        if len(list(page.iter(name))) != 1:
            yield f"{len(list(page.iter(name)))} elements {name}; expected one"
    if page.get("lang") != "en":
        yield "no language"
    if not any(meta.get("name") == "viewport" for meta in page.iter("meta")):
        yield "no viewport, so that a phone would show it as wide as a desk"
    level = 0
    for element in page.iter():
        if re.fullmatch("h[1-6]", str(element.tag)):
            if int(element.tag[1]) > level + 1:
                yield f"\"{words(element)}\" is {element.tag} after h{level}"
            level = int(element.tag[1])
            if not words(element):
                yield f"an empty {element.tag}"


def faults_of_pictures(page):
    by_id = {element.get("id"): element for element in page.iter() if element.get("id")}
    for svg in page.iter(SVG + "svg"):
        title, read = (by_id.get(svg.get(key)) for key in REFERRING)
        if svg.get("role") != "img" or title is None or not words(title) or read is None or not words(read):
            yield f"a chart without a role, a name or a description: {svg.get('aria-labelledby')}"
        if list(svg.iter(SVG + "style")):
            yield "a chart with a style sheet, which would hold for the whole page"
    for picture in page.iter("img"):
        if not (picture.get("alt") or "").strip():
            yield "a picture without words for it"
    for picture in [*page.iter("img"), *page.iter(SVG + "svg")]:
        if not all(re.fullmatch("[1-9][0-9]*", picture.get(side) or "") for side in ("width", "height")):
            yield f"a picture without a size: {dict(list(picture.attrib.items())[-4:])}"[:200]
    if not list(page.iter(SVG + "svg")) and not list(page.iter("table")):
        yield "neither a chart nor a table"


def faults_of_tables(page):
    for table in page.iter("table"):
        caption = table.find("caption")
        if caption is None or not words(caption):
            yield "a table without a caption"
        for heading in table.iter("th"):
            if heading.get("scope") not in ("row", "col", "colgroup"):
                yield f"a heading without a scope: {words(heading)}"
        spans = {sum(int(cell.get("colspan", 1)) for cell in row) for row in table.find("tbody")}
        if len(spans) > 1:
            yield f"rows of {sorted(spans)} cells in \"{words(caption)}\""


def faults_of_scrolling(page):
    for element in page.iter():
        if "scroll" in (element.get("class") or "").split():
            if element.get("tabindex") != "0" or not (element.get("aria-label") or "").strip():
                yield "something scrolls that keys cannot reach, or that has no name"


def faults_of_standing_alone(page):
    for element in page.iter():
        if element.tag == "script":
            yield "a script"
        for key in ("src", "href", "{http://www.w3.org/1999/xlink}href", "data", "action"):
            value = element.get(key) or ""
            if value and not value.startswith(("#", "data:")):
                yield f"{element.tag} needs {value[:80]}"
    for style in page.iter("style"):
        if re.search(r"url\(|@import", style.text or ""):
            yield "a style sheet that needs another file"


def main():
    text = Path(sys.argv[1]).read_text(encoding="utf-8")
    if not text.startswith("<!DOCTYPE html>"):
        print("no document type: a browser would show it as it showed pages long ago")
        return 1
    try:
        page = ElementTree.fromstring(text)
    except ElementTree.ParseError as error:
        print(f"{sys.argv[1]}: is not well-formed: {error}")
        return 1
    found = [fault for check in (faults_of_names, faults_of_structure, faults_of_pictures, faults_of_tables,
                                 faults_of_scrolling, faults_of_standing_alone) for fault in check(page)]
    print(*found[:20], sep="\n", end="\n" if found else "")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
