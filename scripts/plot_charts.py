"""Which chart each CSV file of a run becomes, and how to read it: the one list of scripts/plot and scripts/report."""

from plot_convergence import convergence
from plot_growth import growth
from plot_narrowing import narrowing
from plot_paper import figure4, table1, table3
from plot_pareto import pareto
from plot_peers import peers
from plot_profile import profile
from plot_stability import stability
from plot_types import types

CHARTS = {
    "figure4.csv": (figure4,
        "Seconds of all bounces of a frame, stacked by kernel; shorter is faster. The second figure is "
        "shading alone, where the strategies differ."),
    "table1.csv": (table1,
        "Millions of rays a second that each kernel takes; longer is faster. Whiskers are 95 % intervals."),
    "table3.csv": (table3,
        "Millions of rays a second by the number of spheres among the triangles; taller is faster. Whiskers "
        "are 95 % intervals."),
    "stability.csv": (stability,
        "Each cell counts how often a method fails on a million rays that were made to break it. Pale blue is "
        "no failure."),
    "pareto.csv": (pareto,
        "Above: to the right is faster, down is more accurate; nobody lies below the dashed line. Below: the "
        "error of the distance where nothing failed."),
    "convergence.csv": (convergence,
        "The error of a picture against the time spent on it, on logarithmic axes. Without bias a curve falls "
        "like the dotted line; a dashed line is where it stops."),
    "narrowing.csv": (narrowing,
        "Right of the dashed line the kernels for the scene's own types are faster than those for all types."),
    "types.csv": (types,
        "Speed by the number of types in the list, relative to ctp with one type; higher is faster."),
    "peers.csv": (peers,
        "Speed on the same rays relative to Embree's rtcIntersect1 with as many threads; above the dashed "
        "line is faster."),
    "growth.csv": (growth,
        "Nanoseconds that a ray takes against the number of triangles, on logarithmic axes; lower is faster."),
    "profile.csv": (profile,
        "Cycles that a ray takes in each phase of the traversal of many rays at once; shorter is faster."),
}
