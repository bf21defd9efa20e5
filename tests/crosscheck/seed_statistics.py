"""Whether two estimators have the same mean, from one number of each of K independent seeds."""

import dataclasses
import math

import numpy as np

COLUMNS, ROWS = 4, 3


def region_means(picture):
    """Means of the picture and of its blocks, row by row: (1 + ROWS * COLUMNS, channels)."""
    blocks = [block for row in np.array_split(picture, ROWS, axis=0) for block in np.array_split(row, COLUMNS, axis=1)]
    return np.array([region.mean(axis=(0, 1)) for region in [picture] + blocks])


def region_names():
    return ["picture"] + [f"block {row + 1},{column + 1}" for row in range(ROWS) for column in range(COLUMNS)]


def two_sided_p(t, freedom):
    """Student's t beyond |t|, on the angle whose tangent is t / sqrt(freedom), where the density is a power of cos."""
    nodes, weights = np.polynomial.legendre.leggauss(200)

    def integral(low):
        angles = low + (math.pi / 2 - low) * (nodes + 1) / 2
        return (math.pi / 2 - low) / 2 * float(np.sum(weights * np.cos(angles) ** (freedom - 1)))

    return integral(math.atan(abs(t) / math.sqrt(freedom))) / integral(0.0)


def sidak(family_level, count):
    """The level of one of `count` tests, all of which together are wrong with the probability `family_level`."""
    return -math.expm1(math.log1p(-family_level) / count)


@dataclasses.dataclass
class Comparison:
    ratio: float
    ratio_error: float  # standard error
    t: float
    p: float


def equal_or_not(a, b):
    """Two numbers without noise, such as black regions: equal up to rounding."""
    equal = abs(a - b) <= 1e-5 * max(abs(a), abs(b))
    if equal:
        return Comparison(a / b if b else 1.0, 0.0, 0.0, 1.0)
    return Comparison(a / b if b else math.inf, 0.0, math.copysign(math.inf, a - b), 0.0)


def welch(a, b):
    """Welch's test of the mean of `a` against that of `b`, and the ratio of the means by the delta method."""
    mean_a, mean_b = float(np.mean(a)), float(np.mean(b))
    error_a, error_b = (float(np.var(values, ddof=1)) / len(values) for values in (a, b))
    if error_a + error_b <= (1e-7 * max(abs(mean_a), abs(mean_b))) ** 2:
        return equal_or_not(mean_a, mean_b)
    t = (mean_a - mean_b) / math.sqrt(error_a + error_b)
    freedom = (error_a + error_b) ** 2 / (error_a**2 / (len(a) - 1) + error_b**2 / (len(b) - 1))
    p = two_sided_p(t, freedom)
    if not (mean_a > 0 and mean_b > 0):
        return Comparison(math.nan, math.nan, t, p)
    ratio = mean_a / mean_b
    return Comparison(ratio, ratio * math.sqrt(error_a / mean_a**2 + error_b / mean_b**2), t, p)
