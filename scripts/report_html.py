"""Elements of a page. Text is escaped, so that no name in a result can become markup; the output is well-formed XML,
which a test can parse."""

import html

EMPTY = {"img", "link", "meta"}
WITHIN_LINES = {"a", "code", "span", "strong"}  # where a new line would be a space


class Html(str):
    """Markup; any other string is text."""

    def __add__(self, other):
        return Html(str.__add__(self, text(other)))


def text(value):
    return value if isinstance(value, Html) else Html(html.escape(str(value)))


def join(parts, between=""):
    return Html(text(between).join(text(part) for part in parts))


def tag(name, /, *children, **attributes):
    """class_ stands for class, aria_label for aria-label; an attribute that is None is left out."""
    said = "".join(f' {key.rstrip("_").replace("_", "-")}="{html.escape(str(value))}"'
                   for key, value in attributes.items() if value is not None)
    if name in EMPTY:
        return Html(f"<{name}{said} />")
    return Html(f"<{name}{said}>{join(children)}</{name}>" + ("" if name in WITHIN_LINES else "\n"))


def scrolling(content, label):
    """What may be wider than a phone: it scrolls by itself, by keys too."""
    return tag("div", content, class_="scroll", role="group", tabindex="0", aria_label=label)


def caption_of(said):
    """It stays in sight where a table is wider than the window."""
    return tag("caption", tag("span", said))


def heading(said, **attributes):
    """Of a column; names may go on below after a slash, so that they are not wider than the figures."""
    return tag("th", Html(text(said).replace("/", "/<wbr />")), **attributes)


def plain_table(caption, header, rows):
    """The first cell of each row names it."""
    lines = [tag("tr", tag("th", row[0], scope="row"), *(tag("td", cell) for cell in row[1:])) for row in rows]
    return scrolling(tag("table", caption_of(caption),
                         tag("thead", tag("tr", *(heading(name, scope="col") for name in header))),
                         tag("tbody", *lines)), caption)


def facts(caption, pairs):
    """A table of two columns, names and values; what is not known is left out."""
    rows = [tag("tr", tag("th", name, scope="row"), tag("td", value)) for name, value in pairs
            if value not in (None, "")]
    return scrolling(tag("table", caption_of(caption), tag("tbody", *rows), class_="facts"), caption)


def more(summary, *content):
    return tag("details", tag("summary", summary), *content)
