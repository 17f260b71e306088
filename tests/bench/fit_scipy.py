"""fit_scipy.py - the peer of `polhode fit`: scipy's least_squares on solve_ivp, case 01 of tests/reference/fit.

    fit_scipy.py LOG.csv RUNS                (make bench-fit; Debian's python3-scipy)
prints seconds (the least of RUNS), integrations and the five estimates.  As case.json has it: trf, differences,
DOP853 at 1e-10; the rows of the log are its t_eval.
SPDX-License-Identifier: GPL-3.0-or-later
"""
import sys
import time

import numpy
from scipy.integrate import solve_ivp
from scipy.optimize import least_squares

GUESS = [1.44, 1.80, 0.91, 1.09, -0.41]
SIGMA = 0.004


def main():
    log = numpy.loadtxt(sys.argv[1], delimiter=",", comments="#", skiprows=2)
    times, rates = log[:, 0], log[:, 1:4].T
    count = 0

    def residuals(p):
        nonlocal count
        count += 1
        a, b, c = p[0] - p[1], p[1] - 1, 1 - p[0]

        def slope(_, w):
            return [a * w[1] * w[2], (p[1] - 1) / p[0] * w[2] * w[0], c / p[1] * w[0] * w[1]]

        made = solve_ivp(slope, (times[0], times[-1]), p[2:5], method="DOP853", t_eval=times, rtol=1e-10, atol=1e-12)
        return ((rates - made.y) / SIGMA).ravel()

    least = float("inf")
    for _ in range(int(sys.argv[2])):
        count = 0
        begun = time.perf_counter()
        found = least_squares(residuals, GUESS, x_scale="jac")
        least = min(least, time.perf_counter() - begun)
    print(repr(float(least)), count, *(repr(float(x)) for x in found.x))


main()
