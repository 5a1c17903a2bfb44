"""Do two renderers agree? Each gives several independent images of one scene; their scatter says how far apart the
means may lie by chance."""

import statistics

import numpy

BLOCK = 8  # pixels along the side of a block: the mean over so many is close to normal
MOST_SIGMAS = 3  # of the mean over the whole image, each channel
WORST_BLOCK = 5  # sigmas; some 800 values leave this once in 2,000 comparisons by chance
MOST_OUTLIERS = 0.02  # share of the blocks beyond 3 sigmas; chance makes it 0.003


def two_sided_tail(t, freedom, steps=2000):
    """P(|T| > t) of Student's T. In atan(t / sqrt(freedom)) its density is cos to the power freedom - 1."""
    def integral(start):
        width = (numpy.pi / 2 - start) / steps
        angles = start + width * (numpy.arange(steps) + 0.5)
        return width * numpy.sum(numpy.cos(angles) ** (freedom - 1))
    return integral(numpy.arctan(t / numpy.sqrt(freedom))) / integral(0.0)


def sigmas(ours, theirs):
    """Welch's t for each figure, as the deviation of a normal variable that is as improbable. Axis 0: images."""
    errors = [samples.var(axis=0, ddof=1) / len(samples) for samples in (ours, theirs)]
    difference = ours.mean(axis=0) - theirs.mean(axis=0)
    z = numpy.zeros(difference.shape)
    for at in numpy.ndindex(difference.shape):
        a, b = errors[0][at], errors[1][at]
        if difference[at] == 0:
            continue
        if a + b == 0:
            z[at] = numpy.copysign(numpy.inf, difference[at])
            continue
        freedom = (a + b) ** 2 / (a ** 2 / (len(ours) - 1) + b ** 2 / (len(theirs) - 1))
        tail = two_sided_tail(abs(difference[at]) / numpy.sqrt(a + b), freedom)
        z[at] = numpy.copysign(-statistics.NormalDist().inv_cdf(max(tail / 2, 1e-300)), difference[at])
    return z


def blocks(images):
    count, height, width, channels = images.shape
    height, width = height // BLOCK, width // BLOCK
    cut = images[:, :height * BLOCK, :width * BLOCK]
    return cut.reshape(count, height, BLOCK, width, BLOCK, channels).mean(axis=(2, 4))


def agree(ours, theirs):
    """Prints the verdict on two stacks of images, (image, row, column, channel), and returns it."""
    if not (numpy.isfinite(ours).all() and numpy.isfinite(theirs).all()):
        print("an image holds values that are not finite")
        return False
    our_means, their_means = ours.mean(axis=(1, 2)), theirs.mean(axis=(1, 2))
    z = sigmas(our_means, their_means)
    for channel, name in enumerate(("red", "green", "blue")):
        a, b = our_means[:, channel], their_means[:, channel]
        error = numpy.sqrt(a.var(ddof=1) / len(a) + b.var(ddof=1) / len(b)) / b.mean()
        print(f"{name:5}  ours {a.mean():.5f}  theirs {b.mean():.5f}  difference {a.mean() / b.mean() - 1:+.3%} "
              f"+- {error:.3%}  ({z[channel]:+.2f} sigmas)")
    block_z = sigmas(blocks(ours), blocks(theirs))
    worst = numpy.unravel_index(numpy.argmax(abs(block_z)), block_z.shape)
    outliers = numpy.mean(abs(block_z) > 3)
    print(f"blocks of {BLOCK}x{BLOCK} pixels: {outliers:.2%} beyond 3 sigmas (chance: 0.27 %), worst "
          f"{block_z[worst]:+.2f} at row {worst[0] * BLOCK}, column {worst[1] * BLOCK}")
    return bool((abs(z) < MOST_SIGMAS).all() and abs(block_z[worst]) < WORST_BLOCK and outliers <= MOST_OUTLIERS)
