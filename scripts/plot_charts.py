"""Which chart each CSV file of a run becomes: the one list that scripts/plot and scripts/report draw from."""

from plot_convergence import convergence
from plot_growth import growth
from plot_narrowing import narrowing
from plot_paper import figure4, table1, table3
from plot_pareto import pareto
from plot_peers import peers
from plot_profile import profile
from plot_stability import stability
from plot_types import types

CHARTS = {"figure4.csv": figure4, "table1.csv": table1, "table3.csv": table3, "stability.csv": stability,
          "pareto.csv": pareto, "convergence.csv": convergence, "narrowing.csv": narrowing, "types.csv": types,
          "peers.csv": peers, "growth.csv": growth, "profile.csv": profile}
