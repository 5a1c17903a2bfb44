#!/usr/bin/python3
"""Opens a page of scripts/report in Chromium and looks at it as a reader would: on a phone and on a desk, in light and
dark, on paper, and through what a screen reader is told. Prints each fault; exit code 1 if there is any.

    page_in_browser.py PAGE
"""

import shutil
import sys
import tempfile
from pathlib import Path

from browser import Browser

LEAST_SIDE = 20  # of a picture, in pixels
LEAST_SCALE = 0.65  # of a chart, below which its letters cannot be read
LEAST_CONTRAST = 4.5  # WCAG 2, level AA
TEXTS = ["body", "h1", "p", "a", "figcaption", "caption", "th", "td", "summary", "pre", "strong"]

PICTURES = """[...document.querySelectorAll('svg[role=img], img')].map(picture => {
    const box = picture.getBoundingClientRect();
    return {name: picture.getAttribute('alt') ?? picture.getAttribute('aria-labelledby'), width: box.width,
            height: box.height, natural: +picture.getAttribute('width'), is_chart: picture.tagName == 'svg',
            broken: picture.tagName == 'IMG' && (!picture.complete || picture.naturalWidth == 0)};
})"""

CONTRASTS = """(names => {
    const light = text => {
        const [r, g, b] = text.match(/[0-9.]+/g).map(c => c / 255).map(
            c => c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4);
        return 0.2126 * r + 0.7152 * g + 0.0722 * b;
    };
    const ground = element => {
        const own = getComputedStyle(element).backgroundColor;
        return own != 'rgba(0, 0, 0, 0)' || !element.parentElement ? own : ground(element.parentElement);
    };
    return names.flatMap(name => [...document.querySelectorAll(name)].slice(0, 40)).map(element => {
        const [a, b] = [light(getComputedStyle(element).color), light(ground(element))];
        return [element.tagName + ' ' + element.className, (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05)];
    });
})"""


def faults_of_loading(events):
    for method, of in events:
        if method == "Runtime.exceptionThrown":
            yield f"an exception: {of['exceptionDetails']['text']}"
        elif method == "Runtime.consoleAPICalled":
            yield f"console: {of['type']}: {of['args']}"
        elif method == "Log.entryAdded":
            yield f"log: {of['entry']['level']}: {of['entry']['text']}"
        elif method == "Network.requestWillBeSent" and not of["request"]["url"].startswith(("file:", "data:")):
            yield f"asks for {of['request']['url']}"


def faults_of_pictures(browser):
    for picture in browser.value(PICTURES):
        if picture["broken"]:
            yield f"{picture['name']} cannot be shown"
        if min(picture["width"], picture["height"]) < LEAST_SIDE:
            yield f"{picture['name']} is {picture['width']}x{picture['height']} pixels"
        if picture["is_chart"] and picture["width"] < LEAST_SCALE * picture["natural"]:
            yield f"{picture['name']} is drawn at {picture['width'] / picture['natural']:.2f} of its size"


def faults_of_screen(browser, width):
    wide = browser.value("document.documentElement.scrollWidth")
    if wide > width:
        yield f"the page is {wide} pixels wide"
    yield from faults_of_pictures(browser)
    for name, contrast in browser.value(f"{CONTRASTS}({TEXTS})"):
        if contrast < LEAST_CONTRAST:
            yield f"{name} has a contrast of {contrast:.2f}"


def faults_of_paper(browser):
    """Printed in a dark room it is black on white all the same."""
    if browser.value("getComputedStyle(document.body).backgroundColor") != "rgb(255, 255, 255)":
        yield "the paper is dark"
    if browser.value("getComputedStyle(document.querySelector('nav')).display") != "none":
        yield "links are printed"


def faults_of_reading(browser):
    """What assistive technology is told."""
    nodes = [node for node in browser.ask("Accessibility.getFullAXTree")["nodes"] if not node["ignored"]]

    def of(*roles):
        return [node for node in nodes if node["role"]["value"] in roles]

    def name(node):
        return node.get("name", {}).get("value", "").strip()
    pictures, wanted = of("image", "img"), browser.value("document.querySelectorAll('svg[role=img], img').length")
    if len(pictures) != wanted:
        yield f"{len(pictures)} pictures are announced; {wanted} are there"
    for node in pictures + of("table", "region", "navigation"):
        if not name(node):
            yield f"a {node['role']['value']} without a name"
    if not of("main") or not of("navigation"):
        yield "no landmarks"


def faults(browser, path):
    browser.show(1400)
    browser.open(path)
    yield from faults_of_loading(browser.events)
    yield from faults_of_reading(browser)
    for width in (400, 1400):
        for scheme in ("light", "dark"):
            browser.show(width, scheme)
            is_dark = browser.value("getComputedStyle(document.body).backgroundColor") != "rgb(255, 255, 255)"
            if is_dark != (scheme == "dark"):
                yield f"{scheme}: the ground is " + ("dark" if is_dark else "light")
            yield from (f"{width} pixels, {scheme}: {fault}" for fault in faults_of_screen(browser, width))
    browser.show(1400, "dark", "print")
    yield from faults_of_paper(browser)


def main():
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as profile:
        with Browser(shutil.which("chromium"), profile) as browser:
            found = list(faults(browser, Path(sys.argv[1])))
    print(*found[:20], sep="\n", end="\n" if found else "")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
