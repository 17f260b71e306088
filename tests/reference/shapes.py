#!/usr/bin/env python3
"""shapes.py - measure, centroid and tensor of shapes by direct integration, as tests/reference/shapes.h.
SPDX-License-Identifier: GPL-3.0-or-later

    python3 tests/reference/shapes.py > tests/reference/shapes.h        needs mpmath; half a minute

Every number is an integral of the definition: raw moments about the origin of the frame, in 110 digits (exact
rationals for points, outlines and regions), centred by subtraction, which 110 digits bear. Inputs are doubles and
taken exactly. Slices and Green's theorem are common ground with the library; the rest differs: caps and zones are
expanded about the ball's centre, sectors, hooves and tori are integrated in angles, polyhedra are built from vertices
and faces, helix and catenary have their antiderivatives, regions are integrated symbolically, ellipsoids' shells have
Legendre's E and K.
"""
from fractions import Fraction
from itertools import combinations
import mpmath as mp

mp.mp.dps = 110
F, pi = mp.mpf, mp.pi


def quad(f, points):
    return mp.quad(f, points, method="gauss-legendre") if points[0] != points[-1] else F(0)


def body(measure, first, second):
    """measure, com, tensor of unit mass from raw integrals of 1, r, (xx yy zz xy xz yz)."""
    c = [f / measure for f in first]
    s = [second[k] / measure - c[i] * c[j] for k, (i, j) in enumerate([(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)])]
    return measure, c, [s[1] + s[2], s[0] + s[2], s[0] + s[1], -s[3], -s[4], -s[5]]


def axial(z1, z2, area, x2, y2=None, ds=None):
    """Slices of the measure area(z) with mean x^2 and y^2."""
    y2 = y2 or x2
    n = lambda f: quad(f, [z1, z2])
    return body(n(area), [0, 0, n(lambda z: z * area(z))],
                [n(lambda z: x2(z) * area(z)), n(lambda z: y2(z) * area(z)), n(lambda z: z * z * area(z)), 0, 0, 0])


def disc_stack(z1, z2, r2):
    return axial(z1, z2, lambda z: pi * r2(z), lambda z: r2(z) / 4)


def polar(r, lo, hi, wire, height=None):
    """Sector of a disc, or arc, between two angles; height: a cylinder |z| <= height/2."""
    q = (lambda k: r ** (k + 1)) if wire else (lambda k: r ** (k + 2) / (k + 2))
    t = lambda f: quad(f, [lo, (lo + hi) / 2, hi])
    h = F(1) if height is None else height
    zz = F(0) if height is None else height**3 / 12 * q(0) * (hi - lo)
    c, s = mp.cos, mp.sin
    return body(h * q(0) * (hi - lo), [h * q(1) * t(c), h * q(1) * t(s), F(0)],
                [h * q(2) * t(lambda u: c(u) ** 2), h * q(2) * t(lambda u: s(u) ** 2), zz,
                 h * q(2) * t(lambda u: s(u) * c(u)), F(0), F(0)])


def hoof(r, h):
    t = lambda f: quad(f, [-pi / 2, 0, pi / 2])
    c, s, k = mp.cos, mp.sin, h / r
    # over rho and phi; z from 0 to k rho cos(phi)
    return body(k * r**3 / 3 * t(c), [k * r**4 / 4 * t(lambda u: c(u) ** 2), F(0), k**2 / 2 * r**4 / 4 * t(lambda u: c(u) ** 2)],
                [k * r**5 / 5 * t(lambda u: c(u) ** 3), k * r**5 / 5 * t(lambda u: c(u) * s(u) ** 2),
                 k**3 / 3 * r**5 / 5 * t(lambda u: c(u) ** 3), F(0), k**2 / 2 * r**5 / 5 * t(lambda u: c(u) ** 3), F(0)])


def sector(r, h):
    top = mp.acos(1 - h / r)
    t = lambda f: quad(lambda u: f(u) * mp.sin(u), [0, top / 2, top])
    return body(2 * pi * r**3 / 3 * t(lambda u: F(1)), [F(0), F(0), 2 * pi * r**4 / 4 * t(mp.cos)],
                [pi * r**5 / 5 * t(lambda u: mp.sin(u) ** 2)] * 2 + [2 * pi * r**5 / 5 * t(lambda u: mp.cos(u) ** 2), F(0), F(0), F(0)])


def torus(R, r, solid):
    # x = (R + s cos u) cos v; integrate over u (and over s by powers)
    t = lambda f: quad(f, [0, pi / 2, pi, 3 * pi / 2, 2 * pi])
    n = lambda f: quad(lambda s: s * t(lambda u: f(R + s * mp.cos(u), s * mp.sin(u))), [0, r]) if solid else r * t(lambda u: f(R + r * mp.cos(u), r * mp.sin(u)))
    old, mp.mp.dps = mp.mp.dps, 50
    out = body(2 * pi * n(lambda x, z: x), [F(0)] * 3, [pi * n(lambda x, z: x**3)] * 2 + [2 * pi * n(lambda x, z: x * z * z), F(0), F(0), F(0)])
    mp.mp.dps = old
    return out


def helix(r, pitch, turns):
    T, c = 2 * pi * turns, pitch / (2 * pi)
    s, k = mp.sin(T), mp.cos(T)
    return body(mp.sqrt(r * r + c * c) * T, [r * s * mp.sqrt(r * r + c * c), r * (1 - k) * mp.sqrt(r * r + c * c), c * T * T / 2 * mp.sqrt(r * r + c * c)],
                [mp.sqrt(r * r + c * c) * x for x in (r * r * (T + s * k) / 2, r * r * (T - s * k) / 2, c * c * T**3 / 3, r * r * s * s / 2,
                                                     r * c * (T * s + k - 1), r * c * (s - T * k))])


def catenary(a, span):
    L = span / (2 * a)
    s, c = mp.sinh(L), mp.cosh(L)
    return body(2 * a * s, [F(0), a * a * (L + s * c), F(0)],
                [a**3 * 2 * (L * L * s - 2 * L * c + 2 * s), a**3 * 2 * (s + s**3 / 3), F(0), F(0), F(0), F(0)])


def ellipsoid_shell(a, b, c):
    """Latitude by quadrature in z, longitude by Legendre's E and K."""
    axes = sorted([a, b, c], reverse=True)
    A, B, C = axes
    old, mp.mp.dps = mp.mp.dps, 60

    def rows(t):  # t = tan of the latitude, dz = t' ...; returns integrands in u = ln t
        near = 1 / (1 + t * t)
        p, q = B * B * (C * C + t * t * A * A), A * A * (C * C + t * t * B * B)  # sqrt(p cos^2 + q sin^2), q >= p
        m = (q - p) / q
        if m < F(10) ** -25:  # the series to second order in m is exact enough
            root = mp.sqrt(q)
            E0 = pi / 2 * (1 - m / 4 - 3 * m * m / 64)
            S = pi / 4 * (1 - m / 8 - 3 * m * m / 128)  # sin^2
            ons, onc = root * S, root * (E0 - S)
        else:
            K, E = mp.ellipk(m), mp.ellipe(m)
            # D = sqrt(1 - m s^2); here s^2 belongs to cos^2(phi)
            onc = mp.sqrt(q) * ((2 * m - 1) * E + (1 - m) * K) / (3 * m)
            ons = mp.sqrt(q) * E - onc
        w = 8 * t * near * near
        return w * (onc + ons), w * near * onc, w * near * ons, w * t * t * near * (onc + ons)

    # points of subdivision: the integrand turns near t = C/A, C/B, 1
    marks = sorted({mp.log(C / A), mp.log(C / B), F(0)})
    ends = [marks[0] - 75] + marks + [40]
    total = [F(0)] * 4
    for lo, hi in zip(ends, ends[1:]):
        n = max(1, int(mp.ceil((hi - lo) / 2)))
        nodes = GL32
        for k in range(n):
            for x, w in nodes:
                u = lo + (hi - lo) * (k + x) / n
                v = rows(mp.exp(u))
                for i in range(4):
                    total[i] += w * (hi - lo) / n * v[i]
    area, x, y, z = total
    mean = {}
    second = {}
    for name, axis, v in zip("xyz", axes, (x, y, z)):
        second[name] = axis * axis * v
    order = sorted(range(3), key=lambda i: -[a, b, c][i])
    s = [F(0)] * 3
    for rank, i in enumerate(order):
        s[i] = second["xyz"[rank]]
    mp.mp.dps = old
    return body(area, [F(0)] * 3, s + [F(0)] * 3)


def legendre_nodes(n):
    out = []
    for k in range(n):
        x = mp.cos(pi * (4 * k + 3) / (4 * n + 2))
        for _ in range(9):
            p0, p1 = F(1), x
            for j in range(2, n + 1):
                p0, p1 = p1, ((2 * j - 1) * x * p1 - (j - 1) * p0) / j
            d = n * (p0 - x * p1) / (1 - x * x)
            x -= p1 / d
        out.append(((1 - x) / 2, 1 / ((1 - x * x) * d * d)))
    return out


GL32 = legendre_nodes(32)


def polyhedron(vertices):
    """Convex hull of vertices around the origin: faces found by brute force, tetrahedra from the origin."""
    eps = F(10) ** -60
    faces = {}
    for i, j, k in combinations(range(len(vertices)), 3):
        u, v, w = (vertices[n] for n in (i, j, k))
        e, f = [v[n] - u[n] for n in range(3)], [w[n] - u[n] for n in range(3)]
        normal = [e[1] * f[2] - e[2] * f[1], e[2] * f[0] - e[0] * f[2], e[0] * f[1] - e[1] * f[0]]
        size = mp.sqrt(sum(x * x for x in normal))
        height = [sum(normal[n] * (p[n] - u[n]) for n in range(3)) / size for p in vertices]
        if all(x < eps for x in height) or all(x > -eps for x in height):
            face = frozenset(n for n, x in enumerate(height) if abs(x) < eps)
            faces[face] = normal
    measure, first, second = F(0), [F(0)] * 3, [F(0)] * 6
    for face, normal in sorted(faces.items(), key=lambda f: sorted(f[0])):
        m = [sum(vertices[n][i] for n in face) / len(face) for i in range(3)]
        members = sorted(face)
        edges = [(p, q) for p, q in combinations(members, 2)
                 if sum(1 for other in faces if p in other and q in other) == 2]
        for p, q in edges:
            a, b, c = m, vertices[p], vertices[q]
            det = abs(a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0])) / 6
            measure += det
            for i in range(3):
                first[i] += det * (a[i] + b[i] + c[i]) / 4
            for n, (i, j) in enumerate([(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)]):
                t = [a[i] + b[i] + c[i], a[j] + b[j] + c[j]]
                second[n] += det * (t[0] * t[1] + a[i] * a[j] + b[i] * b[j] + c[i] * c[j]) / 20
    return body(measure, first, second)


def regular(faces, edge):
    phi = (1 + mp.sqrt(5)) / 2
    one = [-1, 1]
    if faces == 4:
        v, k = [(1, 1, 1), (1, -1, -1), (-1, 1, -1), (-1, -1, 1)], edge / (2 * mp.sqrt(2))
    elif faces == 6:
        v, k = [(x, y, z) for x in one for y in one for z in one], edge / 2
    elif faces == 8:
        v, k = [tuple(s if i == n else 0 for i in range(3)) for n in range(3) for s in one], edge / mp.sqrt(2)
    elif faces == 20:
        v, k = [w for s in one for t in one for w in ((0, s, t * phi), (s, t * phi, 0), (t * phi, 0, s))], edge / 2
    else:
        v = [(x, y, z) for x in one for y in one for z in one]
        v += [w for s in one for t in one for w in ((0, s / phi, t * phi), (s / phi, t * phi, 0), (t * phi, 0, s / phi))]
        k = edge * phi / 2
    return polyhedron([[F(c) * k for c in w] for w in v])


def shell_box(x, y, z):
    size = [x, y, z]
    measure, second = F(0), [F(0)] * 6
    for i in range(3):
        j, k = (i + 1) % 3, (i + 2) % 3
        area = 2 * size[j] * size[k]
        measure += area
        second[i] += area * size[i] ** 2 / 4
        second[j] += area * size[j] ** 2 / 12
        second[k] += area * size[k] ** 2 / 12
    return body(measure, [F(0)] * 3, second)


def shell_cylinder(r, h, ends):
    side, lid = 2 * pi * r * h, 2 * pi * r * r * ends
    xx = side * r * r / 2 + lid * r * r / 4
    return body(side + lid, [F(0)] * 3, [xx, xx, side * h * h / 12 + lid * h * h / 4, F(0), F(0), F(0)])


def capsule(r, h):
    """Outer radius at z, three pieces, raw moments."""
    e = h / 2
    pieces = [(-e - r, -e, lambda z: r * r - (z + e) ** 2), (-e, e, lambda z: r * r), (e, e + r, lambda z: r * r - (z - e) ** 2)]
    n = lambda f: sum(quad(lambda z, r2=r2: f(z, r2(z)), [lo, hi]) for lo, hi, r2 in pieces)
    xx = n(lambda z, q: pi * q * q / 4)
    return body(n(lambda z, q: pi * q), [F(0)] * 3, [xx, xx, n(lambda z, q: pi * q * z * z), F(0), F(0), F(0)])


def surface(z1, z2, rho, slope2):
    """Surface of revolution of radius rho(z), (1 + rho'^2) = slope2(z)."""
    return axial(z1, z2, lambda z: 2 * pi * rho(z) * mp.sqrt(slope2(z)), lambda z: rho(z) ** 2 / 2)


SHAPES = {
    "solid.cone": lambda r, h: disc_stack(F(0), h, lambda z: (r * (1 - z / h)) ** 2),
    "solid.frustum": lambda r, t, h: disc_stack(F(0), h, lambda z: (r + (t - r) * z / h) ** 2),
    "solid.elliptic_cone": lambda a, b, h: axial(F(0), h, lambda z: pi * a * b * (1 - z / h) ** 2,
                                                 lambda z: a * a * (1 - z / h) ** 2 / 4, lambda z: b * b * (1 - z / h) ** 2 / 4),
    "solid.capsule": capsule,
    "solid.hemisphere": lambda r: disc_stack(F(0), r, lambda z: r * r - z * z),
    "solid.cap": lambda r, h: disc_stack(F(0), h, lambda z: r * r - (z - h + r) ** 2),
    "solid.zone": lambda r, p, q: disc_stack(p, q, lambda z: r * r - z * z),
    "solid.sector": sector,
    "solid.half_cylinder": lambda r, h: polar(r, -pi / 2, pi / 2, False, h),
    "solid.quarter_cylinder": lambda r, h: polar(r, F(0), pi / 2, False, h),
    "solid.hoof": hoof,
    "solid.torus": lambda R, r: torus(R, r, True),
    "solid.tube": lambda p, q, h: axial(-h / 2, h / 2, lambda z: pi * (q * q - p * p), lambda z: (q**4 - p**4) / (q * q - p * p) / 4),
    "solid.hollow_sphere": lambda p, q: body(4 * pi / 3 * (q**3 - p**3), [F(0)] * 3, [4 * pi / 15 * (q**5 - p**5)] * 3 + [F(0)] * 3),
    "solid.paraboloid": lambda r, h: disc_stack(F(0), h, lambda z: r * r * z / h),
    "solid.pyramid": lambda x, y, h: axial(F(0), h, lambda z: x * y * (1 - z / h) ** 2, lambda z: x * x * (1 - z / h) ** 2 / 12,
                                           lambda z: y * y * (1 - z / h) ** 2 / 12),
    "solid.wedge": lambda x, y, z: body(x * y * z / 2, [x * x * y * z / 6, x * y * y * z / 6, x * y * z * z / 4],
                                        [x**3 * y * z / 12, x * y**3 * z / 12, x * y * z**3 / 6, x * x * y * y * z / 24,
                                         x * x * y * z * z / 12, x * y * y * z * z / 12]),
    "solid.bicylinder": lambda r: axial(-r, r, lambda z: 4 * (r * r - z * z), lambda z: (r * r - z * z) / 3),
    "solid.regular": regular,
    "shell.sphere": lambda r: axial(-r, r, lambda z: 2 * pi * r, lambda z: (r * r - z * z) / 2),
    "shell.hemisphere": lambda r: axial(F(0), r, lambda z: 2 * pi * r, lambda z: (r * r - z * z) / 2),
    "shell.zone": lambda r, p, q: axial(p, q, lambda z: 2 * pi * r, lambda z: (r * r - z * z) / 2),
    "shell.ellipsoid": ellipsoid_shell,
    "shell.cylinder": shell_cylinder,
    "shell.cone": lambda r, h: surface(F(0), h, lambda z: r * (1 - z / h), lambda z: 1 + (r / h) ** 2),
    "shell.torus": lambda R, r: torus(R, r, False),
    "shell.box": shell_box,
    "plate.annulus": lambda p, q: body(pi * (q * q - p * p), [F(0)] * 3, [pi * (q**4 - p**4) / 4] * 2 + [F(0)] * 4),
    "plate.sector": lambda r, u: polar(r, F(0), u, False),
    "wire.arc": lambda r, u: polar(r, F(0), u, True),
    "wire.helix": helix,
    "wire.catenary": catenary,
}

CASES = {
    "solid.cone": [(2.0, 3.0), (1e-8, 1.0), (1e8, 1.0)],
    "solid.frustum": [(2.0, 1.0, 1.5), (1.0, 1 - 2.0**-52, 3.0), (1.0, 2.0, 1e-8), (1e-3, 1e5, 1.0), (1e-30, 3e-30, 2e-30), (1e30, 3e30, 2e30)],
    "solid.elliptic_cone": [(2.0, 0.3, 5.0), (1e8, 1.0, 1e-8), (1e-30, 2e-30, 3e-30), (1e30, 2e30, 1e30)],
    "solid.capsule": [(0.5, 2.0), (1.0, 1e-20), (1e-8, 1.0), (0.1, 1e-3), (1e-30, 1e-30)],
    "solid.hemisphere": [(0.7,), (1e30,)],
    "solid.cap": [(1.0, 0.3), (1.0, 1e-8), (1.0, 1e-15), (1e8, 1e-8), (1.0, 2.0), (1.0, 2 - 2.0**-51), (0.1, 0.17), (1e-30, 1e-31), (1e30, 1e15)],
    "solid.zone": [(1.0, -0.3, 0.8), (1.0, 0.5, 0.5 + 2.0**-40), (1.0, 1 - 2.0**-50, 1.0), (1.0, -1.0, -1 + 2.0**-50), (1.0, -1.0, 1.0),
                   (1.0, -1e-20, 1e-30), (3e30, -1e30, 2e30)],
    "solid.sector": [(1.0, 0.3), (1.0, 1.0), (1.0, 1.7), (1.0, 2.0), (1.0, 1e-15), (1e-30, 1e-35)],
    "solid.half_cylinder": [(2.0, 3.0), (1e8, 1.0), (1.0, 1e8)],
    "solid.quarter_cylinder": [(2.0, 3.0), (1e-30, 1e-30)],
    "solid.hoof": [(2.0, 3.0), (1.0, 1e-8), (1e-8, 1.0), (1e30, 1e30)],
    "solid.torus": [(3.0, 1.0), (1.0, 1.0), (1.0, 1e-8)],
    "solid.tube": [(1.0, 2.0, 3.0), (1.0, 1 + 2.0**-52, 3.0), (1e-8, 1.0, 1e-8)],
    "solid.hollow_sphere": [(1.0, 2.0), (1.0, 1 + 2.0**-52), (1e-10, 1.0)],
    "solid.paraboloid": [(2.0, 3.0), (1e-8, 1.0), (1e8, 1.0), (1e-30, 1e-30)],
    "solid.pyramid": [(2.0, 2.0, 3.0), (1e8, 1.0, 1e-8), (1e-3, 0.7, 1e5)],
    "solid.wedge": [(2.0, 0.3, 1.7), (1e8, 1.0, 1e-8)],
    "solid.bicylinder": [(0.3,), (1e-30,)],
    "solid.regular": [(4.0, 0.3), (6.0, 0.3), (8.0, 0.3), (12.0, 0.3), (20.0, 0.3), (20.0, 1e30), (12.0, 1e-30)],
    "shell.sphere": [(0.3,)],
    "shell.hemisphere": [(0.3,), (1e30,)],
    "shell.zone": [(1.0, -0.3, 0.8), (1.0, 0.5, 0.5 + 2.0**-40), (1.0, 1 - 2.0**-50, 1.0), (1.0, -1e-20, 1e-30), (1e30, -1e30, 0.0)],
    "shell.ellipsoid": [(3.0, 4.0, 5.0), (1.0, 1.0, 1.0), (1.0, 1 + 2.0**-52, 1 - 2.0**-53), (1.0, 1.0, 1 + 2.0**-26), (2.0, 2.0, 1.0), (1.0, 2.0, 2.0),
                        (1.0, 1e-15, 1e-15), (1e-15, 1.0, 1.0), (1e15, 1.0, 1e-15), (1.0, 1e-3, 1e-15), (1e-15, 1.0, 1e15), (1.0, 0.999, 1e-8),
                        (1e-30, 2e-30, 3e-30), (1e30, 2e30, 1.5e30), (1e-8, 1.0, 1 - 1e-10)],
    "shell.cylinder": [(2.0, 3.0, 0.0), (2.0, 3.0, 1.0), (1e8, 1.0, 1.0), (1e-8, 1.0, 1.0)],
    "shell.cone": [(3.0, 4.0), (1e-8, 1.0), (1e8, 1.0), (1e-30, 1e-30)],
    "shell.torus": [(3.0, 1.0), (1.0, 1.0), (1.0, 1e-8)],
    "shell.box": [(1.0, 2.0, 3.0), (1e8, 1.0, 1e-8)],
    "plate.annulus": [(1.0, 2.0), (1.0, 1 + 2.0**-52)],
    "plate.sector": [(2.0, 1.0), (1.0, 1e-8), (1.0, 1e-15), (1.0, 3.141592653589793), (1.0, 6.283185307179586), (1e8, 6.0), (1e-30, 2.0)],
    "wire.arc": [(2.0, 1.0), (1.0, 1e-8), (1e9, 1e-9), (1.0, 3.141592653589793), (1.0, 6.283185307179586), (1e30, 4.0)],
    "wire.helix": [(1.0, 3.141592653589793, 2.0), (1.0, 0.3, 0.25), (1.0, -0.3, 2.6), (1.0, 1e-3, 1e6 + 0.3), (1.0, 2.0, 1e-8), (1.0, 0.0, 1.5), (1e-3, 1.0, 1e-3),
                   (0.1, 1e-9, 123456789.75), (1.0, 1e8, 0.5), (1e-30, 2e-30, 3.3), (1e30, 2e30, 3.3)],
    "wire.catenary": [(1.0, 2.0), (0.3, 1.7), (1.0, 1e-8), (1e8, 1.0), (1.0, 60.0), (1.0, 400.0), (1e-30, 5e-30), (1e30, 1e30), (1.0, 1e-15), (7.0, 13.0)],
}

# ---- points, outlines and regions in exact rationals ----

PAIRS = [(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)]


def exact(v):
    return [exact(x) for x in v] if isinstance(v, (list, tuple)) else Fraction(v)


def det3(a, b, c):
    return (a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]))


def root(x):
    return mp.sqrt(F(x.numerator) / F(x.denominator))


def simplex_raw(v):
    """Mean of r and r r^T over a simplex (raw, not centred)."""
    n = len(v)
    total = [sum(p[i] for p in v) for i in range(3)]
    return [t / n for t in total], [(total[i] * total[j] + sum(p[i] * p[j] for p in v)) / (n * (n + 1)) for i, j in PAIRS]


def area3(a, b, c):
    u, v = [b[i] - a[i] for i in range(3)], [c[i] - a[i] for i in range(3)]
    w = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]
    return root(sum(x * x for x in w)) / 2


def tetrahedron(v):
    e = [[v[k][i] - v[0][i] for i in range(3)] for k in (1, 2, 3)]
    c, s = simplex_raw(v)
    return body(abs(det3(*e)) / 6, [abs(det3(*e)) / 6 * x for x in c], [abs(det3(*e)) / 6 * x for x in s])


def triangle(v):
    c, s = simplex_raw(v)
    return (area3(*v), *body(Fraction(1), c, s)[1:])


def parallelepiped(e):
    """As the image of the unit cube, integrated term by term: <s_a s_b> = 1/4, <s_a^2> = 1/3."""
    V = abs(det3(*e))
    first = [V * sum(v[i] for v in e) / 2 for i in range(3)]
    second = [V * sum(e[a][i] * e[b][j] * (Fraction(1, 3) if a == b else Fraction(1, 4)) for a in range(3) for b in range(3)) for i, j in PAIRS]
    return body(V, first, second)


def polyline(p, closed):
    rods = list(zip(p, p[1:])) + ([(p[-1], p[0])] if closed else [])
    measure, first, second = F(0), [F(0)] * 3, [F(0)] * 6
    num = lambda x: F(x.numerator) / F(x.denominator)
    for a, b in rods:
        length = root(sum((b[i] - a[i]) ** 2 for i in range(3)))
        measure += length
        for i in range(3):
            first[i] += length * num(a[i] + b[i]) / 2
        for n, (i, j) in enumerate(PAIRS):
            second[n] += length * num(2 * a[i] * a[j] + a[i] * b[j] + b[i] * a[j] + 2 * b[i] * b[j]) / 6
    return body(measure, first, second)


def polynomial_area(outline, powers):
    """Integral of u^i v^j: the inner integral over u by trapezia under each edge, expanded in powers of the edge's parameter."""
    i, j = powers
    total = Fraction(0)
    n = len(outline)
    for k in range(n):
        (a, c), (b, d) = outline[k], outline[(k + 1) % n]
        # Green: the contour integral of u^(i+1)/(i+1) v^j dv, u = a + (b - a) s, v = c + (d - c) s
        poly = [Fraction(1)]
        for base, slope in [(a, b - a)] * (i + 1) + [(c, d - c)] * j:
            poly = [(poly[m] if m < len(poly) else 0) * base + (poly[m - 1] * slope if m else 0) for m in range(len(poly) + 1)]
        total += (d - c) * sum(x / (m + 1) for m, x in enumerate(poly)) / (i + 1)
    return total


def areas(outlines, powers):
    total = Fraction(0)
    for k, o in enumerate(outlines):
        value = polynomial_area(o, powers)
        value = value if polynomial_area(o, (0, 0)) > 0 else -value
        total += value if k == 0 else -value
    return total


def extrude(outlines, h):
    A = lambda i, j: areas(outlines, (i, j))
    return body(A(0, 0) * h, [A(1, 0) * h, A(0, 1) * h, A(0, 0) * h * h / 2],
                [A(2, 0) * h, A(0, 2) * h, A(0, 0) * h**3 / 3, A(1, 1) * h, A(1, 0) * h * h / 2, A(0, 1) * h * h / 2])


def plate(outlines):
    A = lambda i, j: areas(outlines, (i, j))
    z = Fraction(0)
    return body(A(0, 0), [A(1, 0), A(0, 1), z], [A(2, 0), A(0, 2), z, A(1, 1), z, z])


def revolve(outlines):
    A = lambda i, j: areas(outlines, (i, j))
    z = Fraction(0)
    V, c, t = body(A(1, 0), [z, z, A(1, 1)], [A(3, 0) / 2, A(3, 0) / 2, A(1, 2), z, z, z])
    return 2 * pi * F(V.numerator) / F(V.denominator), c, t


def power(p, n):
    out = {(0, 0, 0): Fraction(1)}
    for _ in range(n):
        out = product(out, p)
    return out


def product(p, q):
    out = {}
    for a, x in p.items():
        for b, y in q.items():
            key = tuple(a[i] + b[i] for i in range(3))
            out[key] = out.get(key, Fraction(0)) + x * y
    return out


def region(order, limits, density):
    """Symbolic integration, variable by variable from the innermost."""
    poly = lambda terms: {(i, j, k): Fraction(c) for c, i, j, k in terms}

    def integral(f):
        for depth in (2, 1, 0):
            v, out = order[depth], {}
            lo, hi = (poly(p) for p in limits[depth])
            for powers, c in f.items():
                n = powers[v] + 1
                rest = {tuple(0 if i == v else powers[i] for i in range(3)): c / n}
                for sign, limit in ((1, hi), (-1, lo)):
                    for key, x in product(rest, power(limit, n)).items():
                        out[key] = out.get(key, Fraction(0)) + sign * x
            f = out
        return f.get((0, 0, 0), Fraction(0))

    rho = poly(density)
    mono = lambda *axes: integral(product(rho, {tuple(sum(1 for a in axes if a == i) for i in range(3)): Fraction(1)}))
    return body(mono(), [mono(i) for i in range(3)], [mono(i, j) for i, j in PAIRS])


E = 2.0**-40
SQUARE = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)]
STAR = [(0.0, 1.0), (-0.3, 0.4), (-0.95, 0.31), (-0.4, -0.1), (-0.59, -0.81), (0.1, -0.4), (0.6, -0.8), (0.4, -0.1), (0.95, 0.3), (0.3, 0.4)]
HEXAGON = [(2.0, 0.0), (1.0, 1.75), (-1.0, 1.75), (-2.0, 0.0), (-1.0, -1.75), (1.0, -1.75)]
shift = lambda v, *d: [tuple(x + y for x, y in zip(p, d)) for p in v]
scale = lambda v, *k: [tuple(x * y for x, y in zip(p, k)) for p in v]
TETRA = [(8.3322, -11.86875, 0.93355), (0.75523, 5.0, 16.37072), (52.61236, 5.0, -5.3858), (2.0, 5.0, 3.0)]
SLIVER = [(0.1, 0.2, 0.3), (1.1, 0.2, 0.3), (0.1, 1.2, 0.3), (0.6, 0.7, 0.3 + 2.0**-50)]
SIMPLE_POINTS = {
    "tetrahedron": [TETRA, SLIVER, [(0.1, 0.2, 0.3), (0.7, 0.1, 0.8), (0.3, 1.1, 1.4), (1.3, 0.4, 1.7)],
                    shift([(0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)], 1e9, -1e9, 1e9),
                    [(0.0, 0.0, 0.0), (1e8, 0.0, 0.0), (0.0, 1.0, 0.0), (0.3, 0.4, 1e-8)], scale(TETRA, 1e-30, 1e-30, 1e-30), scale(TETRA, 1e30, 1e30, 1e30)],
    "parallelepiped": [[(1.0, 0.2, 0.3), (-0.3, 2.0, 0.1), (0.7, 0.1, 3.0)], [(0.1, 0.2, 0.3), (0.2, 0.4, 0.6 + 2.0**-50), (0.3, 0.1, 0.7)],
                       [(1e8, 1.0, 0.0), (1.0, 1.0, 0.0), (0.0, 1.0, 1e-8)], [(1e-30, 0.0, 2e-30), (0.0, 3e-30, 0.0), (1e-30, 1e-30, -1e-30)]],
    "triangle": [[(0.0, 0.0, 0.0), (3.0, 0.0, 0.0), (1.0, 2.0, 2.0)], [(0.1, 0.2, 0.3), (0.2, 0.4, 0.6), (0.3, 0.6, 0.9)],
                 shift([(0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (0.0, 0.0, 1.0)], 1e9, 1e9, -1e9), [(0.0, 0.0, 0.0), (1e30, 0.0, 1e30), (0.0, 1e30, 0.0)]],
    "polyline": [[(0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (1.0, 2.0, 0.0), (1.0, 2.0, 3.0)], [(0.0, 0.0, 0.0), (1e8, 0.0, 0.0), (1e8, 1e-8, 0.0)],
                 shift([(0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (0.0, 0.0, 1.0)], 1e9, 1e9, -1e9), [(0.1, 0.2, 0.3), (0.1, 0.2, 0.3), (0.4, 0.6, 0.3)]],
    "ring": [[(0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (1.0, 2.0, 0.0), (1.0, 2.0, 3.0)], [(1e-30, 0.0, 0.0), (0.0, 1e-30, 0.0), (0.0, 0.0, 1e-30)]],
}
OUTLINES = {  # outlines, h
    "plate": [([SQUARE], 0), ([STAR], 0), ([STAR[::-1]], 0), ([HEXAGON, scale(STAR, 0.5, 0.5)], 0),
              ([SQUARE, [(E, E), (E, 1 - E), (1 - E, 1 - E), (1 - E, E)]], 0),
              ([shift(STAR, 1e9, -1e9)], 0), ([scale(STAR, 1e8, 1e-8)], 0), ([[(0.1, 0.3), (0.2, 0.6), (0.3, 0.9)]], 0),
              ([scale(STAR, 1e-30, 1e-30)], 0), ([scale(STAR, 1e30, 1e30)], 0),
              ([HEXAGON, [(-1.0, -0.5), (-0.5, -0.5), (-0.5, 0.5)], [(0.5, 0.5), (1.0, -0.5), (0.25, -0.5)]], 0)],
    "extrude": [([STAR], 0.3), ([HEXAGON, STAR], 1e-8), ([scale(STAR, 1e-8, 1.0)], 1e8), ([scale(STAR, 1e-30, 1e-30)], 2e-30)],
    "revolve": [([[(0.0, 0.0), (2.0, 0.0), (0.0, 3.0)]], 0), ([[(1.0, 0.0), (2.0, 0.0), (2.0, 3.0), (1.0, 3.0)]], 0),
                ([[(1.0, 0.0), (1.0, 3.0), (1 + E, 3.0), (1 + E, 0.0)]], 0), ([shift(STAR, 1e8, 1e9)], 0), ([shift(HEXAGON, 2.0, 0.3), shift(STAR, 2.0, 0.3)], 0),
                ([[(0.0, 0.0), (1e-8, 0.0), (0.0, 1.0)]], 0), ([shift(scale(STAR, 1e-30, 1e-30), 2e-30, 0.0)], 0), ([shift(scale(STAR, 1e30, 1e30), 2e30, 0.0)], 0),
                ([SQUARE, [(0.25, E), (0.75, E), (0.75, 1 - E), (0.25, 1 - E)]], 0)],
}
c0 = lambda x: [(x, 0, 0, 0)]
ONE = c0(1.0)
REGIONS = [
    ((0, 1, 2), [(c0(0.0), c0(1.5)), (c0(-0.5), c0(2.0)), (c0(0.25), c0(1.0))], ONE),  # a box
    ((0, 1, 2), [(c0(0.0), ONE), (c0(0.0), [(1.0, 0, 0, 0), (-1.0, 1, 0, 0)]), (c0(0.0), [(1.0, 0, 0, 0), (-1.0, 1, 0, 0), (-1.0, 0, 1, 0)])], ONE),  # a tetrahedron
    ((0, 1, 2), [(c0(-1.0), ONE), ([(1.0, 2, 0, 0), (-1.0, 0, 0, 0)], [(1.0, 0, 0, 0), (-1.0, 2, 0, 0)]), (c0(0.0), [(1.0, 0, 0, 0), (1.0, 2, 0, 0), (0.5, 0, 3, 0)])],
     [(1.0, 0, 0, 0), (0.3, 2, 0, 0), (0.1, 0, 2, 4)]),
    ((2, 0, 1), [(c0(0.0), c0(2.0)), (c0(0.0), [(0.5, 0, 0, 2)]), ([(-1.0, 1, 0, 0)], [(1.0, 0, 0, 3), (0.2, 2, 0, 0)])], [(0.7, 0, 0, 0), (2.0, 1, 0, 1)]),
    ((1, 2, 0), [(c0(1e9), c0(1e9 + 1)), ([(1.0, 0, 1, 0)], [(1.0, 0, 1, 0), (1.0, 0, 0, 0)]), ([(1.0, 0, 0, 1)], [(2.0, 0, 0, 0), (1.0, 0, 0, 1)])], ONE),  # far and sheared
    ((0, 1, 2), [(c0(0.0), c0(1e8)), (c0(0.0), ONE), (c0(0.0), [(1e-16, 1, 0, 0)])], ONE),  # a slender wedge
    ((0, 1, 2), [(c0(0.0), c0(1e-30)), (c0(0.0), c0(2e-30)), ([(1.0, 1, 0, 0)], [(1.0, 1, 0, 0), (1.0, 0, 1, 0)])], ONE),
    ((0, 1, 2), [(c0(0.0), ONE), ([(1.0, 8, 0, 0)], ONE), (c0(0.0), [(1.0, 3, 5, 0), (1.0, 0, 0, 0)])], [(1.0, 6, 0, 6)]),  # a degree of 419 in x
]

# ---- printing ----


def real(x):
    return F(x.numerator) / F(x.denominator) if isinstance(x, Fraction) else F(x)


def text(x, scale):
    x = real(x)
    # an entry that 110 digits leave as the rest of a cancellation is zero
    return "0.0L" if abs(x) < scale * F(10) ** -45 else mp.nstr(x, 34, min_fixed=1, max_fixed=1, strip_zeros=False) + "L"


def row(result):
    measure, com, tensor = result
    size = max(abs(real(t)) for t in tensor)
    place = max(mp.sqrt(size), max(abs(real(c)) for c in com))
    return "%s, {%s},\n   {%s}" % (text(measure, abs(real(measure))), ", ".join(text(c, place) for c in com), ", ".join(text(t, size) for t in tensor))


def numbers(v):
    return "{" + ", ".join(repr(float(x)) for x in v) + "}"


def terms(p):
    return "{%d, (const ph_term[]){%s}}" % (len(p), ", ".join("{%r, {%d, %d, %d}}" % t for t in p))


print("""/* shapes.h - shapes by size, by points, by outlines and by limits: measure, centroid, tensor of unit mass
   SPDX-License-Identifier: GPL-3.0-or-later

   Made by shapes.py; provenance in README.md beside this file. */
/* clang-format off */
static const struct size_row {
  const char *name;
  int count;
  double size[3];
  long double measure, centroid[3], tensor[6];
} size_rows[] = {""")
for name in CASES:
    for case in CASES[name]:
        args = [F(x) for x in case]
        if name == "solid.regular":
            args[0] = int(case[0])
        print('  {"%s", %d, %s, %s},' % (name, len(case), numbers(case), row(SHAPES[name](*args))))
print("};\n\nstatic const struct point_row {\n  const char *kind; /* ring: a closed polyline */\n  int count;\n  double point[12];\n"
      "  long double measure, centroid[3], tensor[6];\n} point_rows[] = {")
FUNCTION = {"tetrahedron": tetrahedron, "parallelepiped": parallelepiped, "triangle": triangle,
            "polyline": lambda v: polyline(v, False), "ring": lambda v: polyline(v, True)}
for kind in SIMPLE_POINTS:
    for case in SIMPLE_POINTS[kind]:
        print('  {"%s", %d, %s, %s},' % (kind, len(case), numbers(sum(map(list, case), [])), row(FUNCTION[kind](exact(case)))))
print("};\n\nstatic const struct outline_row {\n  const char *kind;\n  double h;\n  int n, count[3];\n  double point[40];\n"
      "  long double measure, centroid[3], tensor[6];\n} outline_rows[] = {")
for kind in OUTLINES:
    for outlines, h in OUTLINES[kind]:
        o = exact(outlines)
        result = extrude(o, Fraction(h)) if kind == "extrude" else plate(o) if kind == "plate" else revolve(o)
        points = [x for outline in outlines for p in outline for x in p]
        print('  {"%s", %r, %d, {%s}, %s,\n   %s},' % (kind, float(h), len(outlines), ", ".join(str(len(x)) for x in outlines), numbers(points), row(result)))
print("};\n\nstatic const struct region_row {\n  int order[3];\n  ph_polynomial limit[6], density;\n"
      "  long double measure, centroid[3], tensor[6]; /* measure: mass */\n} region_rows[] = {")
for order, limits, density in REGIONS:
    print("  {{%d, %d, %d}, {%s}, %s,\n   %s}," % (*order, ",\n   ".join("%s, %s" % (terms(a), terms(b)) for a, b in limits), terms(density),
                                                  row(region(order, limits, density))))
print("};")
