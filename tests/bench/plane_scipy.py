"""plane_scipy.py - the peer of plane.c in Python: Newton and Euler of a rolling sphere with NumPy, solve_ivp.

    plane_scipy.py TRUTH SECONDS             (make bench-plane; Debian's python3-scipy)
DOP853 at 1e-9; prints ns for the rates, ms for the run, the error of the angular velocity at the end.
SPDX-License-Identifier: GPL-3.0-or-later
"""
import statistics
import sys
import time

import numpy
from scipy.integrate import solve_ivp

MASS, RADIUS = 1.5, 0.06
INERTIA = numpy.diag([0.0012, 0.0018, 0.0024])


def rates(_, x):
    """Of q, w and the place: (I + m (r.r 1 - r r^T)) w' = I w x w + m r x (-w x (w x r + r')), r = -R g."""
    qw, qx, qy, qz = x[:4]
    w = x[4:7]
    g = numpy.array([2 * (qx * qz - qw * qy), 2 * (qy * qz + qw * qx), 1 - 2 * (qx * qx + qy * qy)])
    r = -RADIUS * g
    change = -RADIUS * numpy.cross(g, w)
    matrix = INERTIA + MASS * (r @ r * numpy.eye(3) - numpy.outer(r, r))
    bend = numpy.cross(w, change + numpy.cross(w, r))
    weight = 9.80665 * g
    side = numpy.cross(INERTIA @ w, w) + MASS * numpy.cross(r, weight - bend)
    dw = numpy.linalg.solve(matrix, side)
    dq = 0.5 * numpy.array([-qx * w[0] - qy * w[1] - qz * w[2], qw * w[0] + qy * w[2] - qz * w[1],
                            qw * w[1] - qx * w[2] + qz * w[0], qw * w[2] + qx * w[1] - qy * w[0]])
    v = -numpy.cross(w, r)
    t = 2 * numpy.cross(x[1:4], v)
    v = v + qw * t + numpy.cross(x[1:4], t)
    return numpy.concatenate([dq, dw, v[:2]])


def main():
    truth = numpy.loadtxt(sys.argv[1])
    span = float(sys.argv[2])
    start = numpy.array([1, 0, 0, 0, 4, -3, 9, 0, 0], dtype=float)
    calls, evaluations, runs = 2000, [], []
    for _ in range(5):
        t = time.perf_counter()
        for _ in range(calls):
            rates(0, start)
        evaluations.append((time.perf_counter() - t) / calls)
        t = time.perf_counter()
        end = solve_ivp(rates, (0, span), start, method="DOP853", rtol=1e-9, atol=1e-9).y[:, -1]
        runs.append(time.perf_counter() - t)
    error = numpy.max(numpy.abs(end[4:7] - truth[4:7]))
    print("%-40s %12.4g %12.4g %12.2g" % ("scipy, DOP853", statistics.median(evaluations) * 1e9,
                                          statistics.median(runs) * 1e3, error))


main()
