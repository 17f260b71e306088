-- words.lua - what docs/hunt.md says around its tables.
-- SPDX-License-Identifier: GPL-3.0-or-later

local words = {}

words.head = [[
# The search for worse

Made by `make hunt`, from `tests/hunt/worst.tsv` and `tests/hunt/history.tsv`, which it writes: no date, the same
bytes each time.

`make hunt COUNT=1e6 SEED=1 HUNTED="free_top"` looks for states that the code computes worst. A target is a piece of
code with a fast oracle that measures and a slow one that judges; each of its errors is an objective with climbers of
its own. A quarter of the states is drawn: sizes evenly over exponents, digits at random or few or next to a power of
two, numbers equal or apart by units of the last place or by 2^-k, zeros, needles, plates, states next to a
separatrix. The others are mutations of a climber: units of the last place, any digit, exponents, signs, numbers made
equal or exchanged, differences of two other climbers (differential evolution). A climber that no longer climbs gives
its place to a stranger. What is among the three worst has been judged by the slow oracle, with MPFR. The same seed
and count find the same states.

The three worst of each error are kept, named `hunt_TARGET[_float]_ERROR_1` to `_3`, and replaced only by worse ones;
`tests/hunt/worst.t` judges all of them anew in `make check-all`, and lets the search find three planted defects: the
textbook's rate from the integrals, which cancels; an error in a corner of equal moments and rates; a narrow hill.

## The worst so far

**u** is 2^-53 or, in float, 2^-24; an **ulp** is a unit of the last place of the result. Bounds are what the
documents promise: 4e-15 and 4e-6 for rates (over the largest) and attitude (an angle), which is 36 u (67 for float,
where the search asks for 36 all the same); 1e-15, 9 u, of the library. |q| = 1 to 5 u: the sum of four squares is off
by 3 u, its product with 1/N^2 by one more, of which the Newton step takes half; the root that it corrects, its sum
and the product with q are off by one each.

]]

words.found = [[

"states" is the sum over all runs below. `library` and `library_rates` are the errors of `ph_free_top_at` at the
states judged.

## What it has found

Each is mended, and its state is replayed by `tests/hunt/worst.t`:

]]

words.states = [[

Two limits are no defects and stay:

- **Impossible bodies.** NAME_init lets a body pass whose moments break the triangle inequality by their rounding.
  With A below 2^-53 C the moments B and C may then differ by many A, which no body's do; the rates' amplitudes grow
  with their quotient, and the error with it (1e4 u where (C - B)/A = 1e8). The search asks for C - B <= 2 A.
- **Tensors in turned axes** have principal moments that are pairs, right to some 2^-100 of the largest (float:
  2^-44). Relative to the smallest moment, to a small difference of two, and to the distance from the separatrix,
  digits are gone before the motion begins, and each turn multiplies what is left: the attitude is off by some
  turns/distance times 2^-100. A diagonal tensor's moments are exact, and so is the side of the separatrix. The search
  bounds that product to 2^40 (float: 2^17).

The free top's other ranges: A/C down to 2^-80 (float 2^-25), single rates down to 2^-200 (2^-100) of the largest,
2^40 turns (2^17), moments and rates of 2^-80 to 2^80 (2^-15 to 2^15). The heavy top is searched over 8 times 1/pace
(float: 24), the pace being the largest of the rates and sqrt(m g l/A), as the fast oracle integrates; elliptic
functions with 1 - m from 2^-120 on and arguments up to 1e15.

## The worst states

The first of each; `tests/hunt/worst.tsv` has all digits. Genes in their order: moments or tensor, rates, attitude,
then what is named in the target's source (free top: h, t, n, and whether time is n h by `NAME_at_tick` or t by
`NAME_at`).

]]

words.history = [[

## History

Worst judged error after so many states. A run whose count is no round number was cut off there.
]]

function words.unit(t, error)
  if t.name == "elliptic" or t.name == "libm" or error:find "moments" then return "ulp" end
  if t.name == "principal" then return t.real == "float" and not error:find "library" and "2^-23" or "2^-52" end
  return error:find "library" and "2^-53" or "u"
end

return words
