"""What a reader must know before believing a run: what was rejected, left out, stood in for, or cut short."""

from report_meta import SCHEMA_VERSION

FEWEST_ROUNDS = 9  # below, an interval from a bootstrap is narrower than it should be
WARNING, NOTE = "Warning", "Note"


def of_meta(run):
    if not run.has_meta:
        yield WARNING, "There is no meta.json: machine, build, settings and command of this run are not known."
        return
    version = run.of("schema_version")
    if version != SCHEMA_VERSION:
        yield WARNING, (f"meta.json has schema version {version or 'none'}, and this page is made for "
                        f"{SCHEMA_VERSION}: something may be missing or misread.")
    if run.of("state") != "complete":
        yield WARNING, (f"The run is {run.of('state') or 'in a state that is not known'}: what it did not come to is "
                        "missing in its tables and charts.")


def of_build(run):
    if run.of("build", "git_dirty"):
        yield WARNING, (f"The program was built from commit {(run.of('build', 'git_commit') or 'unknown')[:12]} with "
                        "changes that were not committed: it cannot be built again from the repository alone.")
    kind = run.of("build", "build_type")
    if kind is not None and kind != "Release":
        yield WARNING, f"Build type {kind or 'none'}, not Release: its times say nothing."


def of_rounds(run):
    rounds = run.of("config", "rounds")
    if run.of("config", "study") in ("speed", None) and run.of("config", "measure") and isinstance(rounds, int):
        if rounds < FEWEST_ROUNDS:
            yield WARNING, (f"Rounds: {rounds}. With fewer than {FEWEST_ROUNDS} the intervals are narrower than they "
                            "should be; differences of a few per cent mean nothing.")


def of_scenes(run):
    # Table 1 and 3 name the source in Markdown alone, so that meta.json is asked first.
    sources = [(scene["name"], scene.get("source")) for scene in run.scenes]
    sources += [(row.get("scene"), row.get("scene_source")) for rows in run.lines.values() for row in rows]
    stand_ins = sorted({name for name, source in sources if source == "stand-in"})
    if stand_ins:
        yield WARNING, (f"Stand-ins: {', '.join(stand_ins)}. They are made by a recipe and are not the paper's scenes; "
                        "nothing of them is set beside the paper's figures.")


def of_contenders(run):
    notices = [str(notice) for notice in run.of("notices") or []]
    rejected = [notice for notice in notices if ": rejected: " in notice]
    for notice in rejected:
        yield WARNING, f"Left out of every table and chart: {notice}"
    summary = run.lines.get("summary.csv", [])
    named = {verdict: sorted({f"{row.get('scene')}/{row.get('spheres')}/{row.get('strategy')}" for row in summary
                              if row.get("valid") == verdict}) for verdict in ("false", "unchecked")}
    if named["false"] and not rejected:
        yield WARNING, ("Rejected, since the hits are not the oracle's, and left out of every table and chart: "
                        f"{', '.join(named['false'])}.")
    if named["unchecked"]:
        yield WARNING, f"No oracle has checked the hits of {', '.join(named['unchecked'])}."
    for notice in notices:
        if notice not in rejected:
            yield NOTE, notice


def of_files(run):
    if "rows.csv" not in run.lines:
        yield NOTE, "There is no rows.csv: the single measurements cannot be looked up, only what was made from them."
    for table in ("table1", "table2", "table3"):
        if f"{table}.csv" in run.lines and not (run.folder / f"{table}.md").exists():
            yield NOTE, (f"There is no {table}.md, as in runs of older programs: the table is shown without the paper's "
                         "figures and without ratios.")


def warnings_of(run):
    """(kind, text) of each, the gravest first."""
    found = [one for check in (of_meta, of_contenders, of_build, of_rounds, of_scenes, of_files) for one in check(run)]
    return sorted(found, key=lambda one: one[0] != WARNING)
