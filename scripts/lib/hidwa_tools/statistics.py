# SPDX-License-Identifier: BSD-3-Clause
"""The tests of Kalliokoski et al. (2022), section V, computed from the distributions themselves: the same figures with any scipy."""
from dataclasses import dataclass
import math

import numpy as np
from scipy import stats


@dataclass
class SignedRanks:
    """A Wilcoxon signed-rank test of pairs (a, b)."""
    pairs: int         # all of them
    changed: int       # those that differ; the others are left out
    above: float       # sum of the ranks of |a - b| where a > b
    z: float           # of that sum, by its mean and variance with ties; nan where nothing differs
    p: float           # exact: over all ways to give the ranks their signs
    r: float           # |z| / sqrt(pairs), the effect size the paper gives


def signed_ranks(a, b, alternative='two-sided'):
    """Wilcoxon's test of paired values; alternative: two-sided, less (a below b) or greater. ValueError for unequal lengths."""
    if len(a) != len(b):
        raise ValueError(f'{len(a)} values against {len(b)}: pairs need as many of both')
    difference = np.asarray(a, float) - np.asarray(b, float)
    changed = difference[difference != 0.0]
    n = len(changed)
    if n == 0:
        return SignedRanks(len(difference), 0, 0.0, math.nan, 1.0, 0.0)
    ranks = stats.rankdata(np.abs(changed))
    above = float(ranks[changed > 0.0].sum())
    _, ties = np.unique(ranks, return_counts=True)
    variance = n * (n + 1) * (2 * n + 1) / 24.0 - (ties ** 3 - ties).sum() / 48.0
    z = (above - n * (n + 1) / 4.0) / math.sqrt(variance)
    return SignedRanks(len(difference), n, above, z, _exact(ranks, above, alternative), abs(z) / math.sqrt(len(difference)))


def _exact(ranks, above, alternative):
    """The share of all 2^n signs for which the sum is as extreme."""
    doubled = np.rint(2.0 * ranks).astype(int)  # tied ranks end in halves
    ways = np.zeros(doubled.sum() + 1)
    ways[0] = 1.0
    for rank in doubled:
        ways[rank:] += ways[:-rank].copy()
    share = ways / ways.sum()
    at = int(round(2.0 * above))
    less, greater = share[:at + 1].sum(), share[at:].sum()
    if alternative == 'less':
        return float(less)
    if alternative == 'greater':
        return float(greater)
    return float(min(1.0, 2.0 * min(less, greater)))


@dataclass
class Proportion:
    """An exact binomial test with its Clopper-Pearson interval."""
    share: float
    p_one_sided: float   # that so many or more come by chance
    p_two_sided: float
    low: float           # of the 95 % interval
    high: float


def proportion(successes, trials, chance=0.5, confidence=0.95):
    """successes of trials against chance. ValueError where there are more of them, or none at all."""
    if not 0 <= successes <= trials or trials == 0:
        raise ValueError(f'{successes} of {trials} is no proportion')
    masses = stats.binom.pmf(np.arange(trials + 1), trials, chance)
    own = masses[successes]
    tail = (1.0 - confidence) / 2.0
    low = stats.beta.ppf(tail, successes, trials - successes + 1) if successes > 0 else 0.0
    high = stats.beta.ppf(1.0 - tail, successes + 1, trials - successes) if successes < trials else 1.0
    return Proportion(successes / trials, float(masses[successes:].sum()),
                      float(min(1.0, masses[masses <= own * (1.0 + 1e-7)].sum())), float(low), float(high))


def normality(values):
    """(W, p) of Shapiro and Wilk's test; nan where it has nothing to go by (fewer than 3 values, or all equal)."""
    values = np.asarray(values, float)
    if len(values) < 3 or np.ptp(values) == 0.0:
        return math.nan, math.nan
    w, p = stats.shapiro(values)
    return float(w), float(p)
