"""The page that is made of runs: its order, its headings, and what it explains."""

from pathlib import Path

from report_charts import draw_charts, figure
from report_environment import command, environment
from report_explained import EXPLAINED
from report_html import Html, join, plain_table, scrolling, tag
from report_images import gallery
from report_tables import paper_tables, summary_table
from report_warnings import WARNING, warnings_of

OF_EVERY_RUN = ["warnings", "environment", "command"]  # not listed where there are several


class Part:
    """A run with all that the page shows of it, drawn before anything is written."""

    def __init__(self, run, number):
        self.run, self.id = run, f"run{number}"
        self.warnings = list(warnings_of(run))
        self.sections = list(paper_tables(run))
        for chart, reading in draw_charts(run, self.warnings):
            self.sections.append((chart.name + "-chart", f"Chart: {chart.title}",
                                  figure(chart, reading, f"{self.id}-{chart.name}")))
            chart.close()
        if not self.sections and run.lines.get("summary.csv"):
            self.sections.append(("summary", "Speeds", summary_table(run)))
        self.sections.insert(0, ("warnings", "Warnings and notes", self._warned()))  # charts may have added some
        self.sections += [("environment", "Environment", environment(run)),
                          ("command", "How to run it again", command(run))]

    def _warned(self):
        if not self.warnings:
            return tag("p", "None.")
        return tag("ul", *(tag("li", tag("strong", kind + ": ", class_=kind), said) for kind, said in self.warnings),
                   class_="warnings")

    @property
    def grave(self):
        return sum(kind == WARNING for kind, _ in self.warnings)

    def html(self):
        when, rounds, rows = self.run.when, self.run.of("config", "rounds"), self.run.lines.get("rows.csv")
        facts = [when and f"Run on {when}.", rounds and f"Rounds: {rounds}.",
                 rows and f"Measurements in rows.csv: {len(rows):,}."]
        return tag("section", tag("h2", self.run.title, id=f"{self.id}-title"), tag("p", " ".join(filter(None, facts))),
                   *(tag("h3", title, id=f"{self.id}-{name}") + content for name, title, content in self.sections
                     if content), aria_labelledby=f"{self.id}-title", id=self.id)

    def contents(self, everything):
        return tag("li", tag("a", self.run.title, href=f"#{self.id}"),
                   tag("ul", *(tag("li", tag("a", title, href=f"#{self.id}-{name}")) for name, title, content in
                               self.sections if content and (everything or name not in OF_EVERY_RUN))))


def overview(parts):
    rows = [[tag("a", part.run.name, href=f"#{part.id}"), part.run.of("machine", "cpu") or "not known",
             part.run.of("gpu", "name") or "none", str(part.run.of("threads") or ""),
             str(part.run.of("config", "rounds") or ""), (part.run.of("build", "git_commit") or "")[:12],
             part.run.when or "", str(part.grave)] for part in parts]
    return plain_table("The runs on this page", ["run", "processor", "GPU", "threads", "rounds", "commit", "when",
                                                 "warnings"], rows)


def section(name, title, content):
    return tag("section", tag("h2", title, id=name), content, aria_labelledby=name)


def make_page(runs, remake):
    """`remake` is the command that made the page."""
    parts = [Part(run, number) for number, run in enumerate(runs, 1)]
    pictures = gallery(runs)
    title = f"ctpbench: {runs[0].title}" if len(runs) == 1 else f"ctpbench: {len(runs)} runs"
    links = [part.contents(len(parts) == 1) for part in parts]
    if pictures:
        links.append(tag("li", tag("a", "Pictures", href="#pictures")))
    links.append(tag("li", tag("a", "How to read this page", href="#reading")))
    body = [tag("a", "Skip to the results", href="#results", class_="skip"),
            tag("header", tag("h1", title),
                tag("p", "How an inner loop of a ray tracer may branch on type, measured. What ratios and intervals mean is ",
                    tag("a", "explained at the end", href="#reading"), ".")),
            tag("nav", tag("ul", *links), aria_label="Contents"),
            tag("main", overview(parts) if len(parts) > 1 else "", *(part.html() for part in parts),
                section("pictures", "Pictures", pictures) if pictures else "",
                section("reading", "How to read this page",
                        tag("dl", *(tag("dt", name) + tag("dd", said) for name, said in EXPLAINED))),
                id="results"),
            tag("footer", tag("p", "This page needs nothing but itself. It was made by ", tag("code", remake), "."))]
    style = Path(__file__).with_name("report.css").read_text(encoding="utf-8")
    head = [tag("meta", charset="utf-8"), tag("title", title),
            tag("meta", name="viewport", content="width=device-width, initial-scale=1"),
            tag("meta", name="color-scheme", content="light dark"), tag("link", rel="icon", href="data:,"),
            tag("style", Html(style))]
    return "<!DOCTYPE html>\n" + tag("html", tag("head", *head), tag("body", *body), lang="en")
