"""What the words on a page of results mean, for readers who have not read the documentation."""

EXPLAINED = [
    ("Mrays/s",
     "Millions of rays that a kernel takes in a second; a median over the rounds. It depends on the machine: "
     "speeds of two machines say nothing about each other's strategies."),
    ("Ratio",
     "Speed of one contender over that of another, of the same round on the same machine: 1.10 is a tenth "
     "faster. Contenders take turns within a round, so that both meet the same load; the figure is the median "
     "of the rounds' ratios."),
    ("Interval",
     "1.10 [1.05, 1.14]: of intervals that are made in this way, by a bootstrap over the rounds, 95 % hold the "
     "true median. If it holds 1, the contenders may be equally fast. It covers what changes from round to "
     "round, not what changes from machine to machine."),
    ("The paper",
     "Zellmann and Lang, C++ Compile Time Polymorphism for Ray Tracing, 2017. It measured on two Xeon E5-2637 "
     "v2 with 16 threads together and on a GeForce GTX 1080 Ti, with editions of the meshes of which some are "
     "no longer to be had. Its speeds are shown for what its ratios are made of; compare ratios alone."),
    ("Stand-in",
     "A scene made by a recipe with as many triangles as the paper's mesh, for machines that do not have it. It "
     "is another scene: nothing of it is set beside the paper's figures."),
    ("Oracle",
     "Before a contender is timed its hits are compared with those that Embree finds; where they differ, "
     "float64 and then quadruple precision decide who is right. Who is wrong is in no table. A tie is a ray "
     "that meets two surfaces at one distance."),
    ("Yardstick",
     "A contender that is not ours and is timed in the same rounds: Embree's rtcIntersect1 with its robust flag "
     "on a CPU, a fixed kernel for triangles alone on a GPU."),
    ("relMSE",
     "The squared error of a picture's pixels relative to their squared value; 0.01 is about a tenth off."),
    ("n/a",
     "Not measured, not applicable, or not in the paper."),
]
