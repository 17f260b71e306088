-- words.lua - what docs/hunt.md says around its tables.
-- SPDX-License-Identifier: GPL-3.0-or-later

local words = {}

words.head = [[
# The search for worse

`make hunt` writes this page from `tests/hunt/worst.tsv` and `tests/hunt/history.tsv`, which it also writes. The page
has no date, and the same bytes each time.

`make hunt COUNT=1e6 SEED=1 HUNTED="free_top"` looks for the states with the largest errors. A target is a piece of
code with two oracles, a fast one that measures the error and a slow one that confirms it. Each error of a target has
its own search with several *climbers*. A climber is a state that the search changes to make the error larger.

A quarter of the states is drawn at random. Sizes are even over exponents. Digits are random, few, or near a power of
two. Numbers are equal, or differ by units of the last place or by 2^-k. There are zeros, needles, plates, and states
near a separatrix. The other states are mutations of a climber: units of the last place, any digit, exponents, signs,
numbers made equal or exchanged, differences of two other climbers (differential evolution). If a climber finds
nothing larger any more, a new random state replaces it. The slow oracle, with MPFR, has confirmed the three largest
errors. The same seed and count find the same states.

The three worst states of each error are kept, with the names `hunt_TARGET[_float]_ERROR_1` to `_3`. Only worse ones
replace them. `tests/hunt/worst.t` checks all of them again in `make check-all`. It also lets the search find three
planted defects: the textbook's rate from the integrals, which cancels; an error in a corner of equal moments and
rates; an error in a narrow range.

## The worst so far

**u** is 2^-53 or, in float, 2^-24. An **ulp** is a unit of the last place of the result. The bounds are those that
the documents promise:

| what | bound | in u |
|---|---|---|
| rates (over the largest) and attitude (an angle), double | 4e-15 | 36 |
| the same, float | 4e-6 | 67; the search uses 36 |
| the library | 1e-15 | 9 |
| \|q\| = 1 | | 5 |

The bound of |q| has these parts. The sum of four squares is wrong by 3 u, and its product with 1/N^2 by one more. The
Newton step takes half of this. The root that it corrects, its sum, and the product with q are wrong by one each.

]]

words.found = [[

"states" is the sum over all runs below. `library` and `library_rates` are the errors of `ph_free_top_at` at the
confirmed states.

## What it has found

Each of these defects is mended, and `tests/hunt/worst.t` computes its state again:

]]

words.states = [[

Two limits are no defects, and stay:

- **Impossible bodies.** NAME_init accepts a body whose moments break the triangle inequality by their rounding. If A
  is below 2^-53 C, the moments B and C may then differ by many A, which is impossible for a body. The amplitudes of
  the rates grow with (C - B)/A, and the error grows with them (1e4 u for (C - B)/A = 1e8). The search keeps C - B <=
  2 A.
- **Tensors in turned axes** have principal moments that are pairs, right to some 2^-100 of the largest (float:
  2^-44). Relative to the smallest moment, to a small difference of two, or to the distance from the separatrix,
  digits are lost before the motion begins. Each turn multiplies this error. The attitude is wrong by some
  turns/distance times 2^-100. The moments of a diagonal tensor are exact, and so is the side of the separatrix. The
  search limits turns/distance to 2^40 (float: 2^17).

The free top has these other ranges:

| quantity | double | float |
|---|---|---|
| A/C | down to 2^-80 | down to 2^-25 |
| single rates, over the largest | down to 2^-200 | down to 2^-100 |
| turns | 2^40 | 2^17 |
| moments and rates | 2^-80 to 2^80 | 2^-15 to 2^15 |

The time of the heavy top goes up to 8/pace (float: 24/pace), because the fast oracle integrates. The pace is the
largest of the rates and sqrt(m g l/A). Elliptic functions have 1 - m from 2^-120 on, and arguments up to 1e15.

## The worst states

The table has the first of each. `tests/hunt/worst.tsv` has all digits. The numbers of a state are in this order:
moments or tensor, rates, attitude, then those that the target's source names. For the free top these are h, t, n, and
whether the time is n h by `NAME_at_tick` or t by `NAME_at`.

]]

words.history = [[

## History

The table has the largest confirmed error after each number of states. If this number is not round, the run was
stopped there.
]]

function words.unit(t, error)
  if t.name == "elliptic" or t.name == "libm" or error:find "moments" then return "ulp" end
  if t.name == "principal" then return t.real == "float" and not error:find "library" and "2^-23" or "2^-52" end
  return error:find "library" and "2^-53" or "u"
end

return words
