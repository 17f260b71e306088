# heavy.py -- nutation and precession of heavy symmetric tops with many digits, for tests/report/heavy.t: writes heavy.lua.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# The cosine u of the tilt obeys u'^2 = P(u) = 2 (1 - u^2)(h - c u) - (l - s u)^2.  Its roots by mpmath's polyroots, the
# period 2 int du/sqrt(P) and the turn 2 int (l - s u)/((1 - u^2) sqrt(P)) du by Gauss and Legendre in the amplitude
# between cuts that come geometrically closer to both ends, where the turn is steep beside the vertical.  polhode has
# none of this: it has theta series (the emitted code) and arithmetic-geometric means (explain).
#     python3 tests/reference/heavy.py > tests/reference/heavy.lua          (mpmath 1.3)
from mpmath import mp, mpf, polyroots, sin, cos, sqrt, pi, acos, nstr
from mpmath.calculus.quadrature import GaussLegendre

mp.dps = 120  # roots come as close as 1e-18 to each other and to 1
RULE = GaussLegendre(mp).calc_nodes(4, 200)  # 24 nodes; the nearest singularity is a piece away: 3.7^-48


def quad(f, cuts):
    total = mpf(0)
    for a, b in zip(cuts, cuts[1:]):
        middle, half = (a + b)/2, (b - a)/2
        total += half*sum(w*f(middle + half*x) for x, w in RULE)
    return total


A, C, mgl = mpf('0.0045'), mpf('0.0007'), mpf('9.81')*mpf('0.05')


def values(q, w):
    q, w = [mpf(x) if isinstance(x, float) else x for x in q], [mpf(x) for x in w]
    n = sum(x*x for x in q)
    up = [2*(q[1]*q[3] - q[0]*q[2])/n, 2*(q[2]*q[3] + q[0]*q[1])/n, (q[0]**2 - q[1]**2 - q[2]**2 + q[3]**2)/n]
    c, s, u0 = mgl/A, C*w[2]/A, up[2]
    l = up[0]*w[0] + up[1]*w[1] + s*u0
    W = w[0]**2 + w[1]**2
    h = W/2 + c*u0
    # 2 c u^3 - (2 h + s^2) u^2 - (2 c - 2 l s) u + (2 h - l^2)
    r = sorted(polyroots([2*c, -(2*h + s*s), 2*l*s - 2*c, 2*h - l*l], maxsteps=2000, extraprec=2000), key=lambda x: x.real)
    u1, u2, u3 = [x.real for x in r]
    if l == s and abs(u2 - 1) < mpf(10)**-30:
        u2 = mpf(1)
    if l == -s and abs(u1 + 1) < mpf(10)**-30:
        u1 = mpf(-1)
    over, under, gap, span = 1 + u1, 1 - u2, u3 - u2, u2 - u1
    top, bottom = l == s, l == -s
    mp.dps = 40
    cuts = [mpf(0)] + [pi/4*mpf(3)**-k for k in range(32, -1, -1)]
    cuts = cuts + [pi/2 - x for x in reversed(cuts[:-1])]

    def weight(f):
        return 1/sqrt(2*c*(gap + span*cos(f)**2))

    def turn(f):
        sine, cosine = sin(f)**2, cos(f)**2
        above, below = over + span*sine, under + span*cosine
        return (l - s*(u1 + span*sine))/(above*below)*weight(f)

    def passing(f):  # through the vertical: l = s or l = -s cancels
        u = u1 + span*sin(f)**2
        return (s/(1 + u) if top else -s/(1 - u))*weight(f)

    period = 4*quad(weight, cuts)
    rate = 4*quad(passing if top or bottom else turn, cuts)/period
    mp.dps = 120
    return acos(min(u2, mpf(1))), acos(max(u1, mpf(-1))), period, rate


def about_x(angle):
    a = mpf(angle)/2
    return [cos(a), sin(a), mpf(0), mpf(0)], '{ axis = "x", angle = %s }' % angle


cases = []
for k in range(1, 10):
    for w in (['0', '0', '100'], ['0', '0', '300'], ['0.3', '0.2', '100']):
        cases.append((about_x('1e-%d' % k), w))
up, down = ([1.0, 0.0, 0.0, 0.0], '{1, 0, 0, 0}'), ([0.0, 1.0, 0.0, 0.0], '{0, 1, 0, 0}')
for w in (['1e-3', '0', '300'], ['1', '0', '50'], ['1e-6', '0', '100'], ['5', '3', '1000']):
    cases.append((up, w))
for w in (['1', '0', '30'], ['1e-4', '0', '30'], ['3', '1', '0'], ['0.5', '0.2', '2000']):
    cases.append((down, w))
for k in range(2, 7):
    cases.append((about_x('0.5'), ['0.3', '0.2', '1e%d' % k]))
    cases.append((about_x('0.5'), ['0', '0', '1e%d' % k]))
# from the bottom beside the rate that ends upright: sqrt(4 c) = 20.8806130178211...
for w in (20.88, 20.8806, 20.8806130178, 20.880613017821094, 20.880613017821098, 20.8807, 21.0):
    cases.append((down, [repr(w), '0', '0']))
# spinning, beside the separatrix through the upright: angle 1e-1 .. from upright with l = s and s^2 < 4 c
for w in (['1e-8', '0', '100'], ['1e-12', '0', '100']):
    cases.append((up, w))
# beside steady precession at 1 rad: C w3 p - A p^2 cos(1) = m g l
for off in ('1e-3', '1e-6', '1e-8'):
    w3 = mpf(200)
    B = C*w3
    p = (B - sqrt(B*B - 4*A*cos(mpf(1))*mgl))/(2*A*cos(mpf(1)))
    along = p*sin(mpf(1)) + mpf(off)
    cases.append((about_x('1'), ['0', repr(float(along)), '200']))
print('''-- heavy.lua -- written by heavy.py, which says what these are.
-- SPDX-License-Identifier: GPL-3.0-or-later
-- attitude, rates; least and greatest tilt, rad, period of the nutation, s, mean precession, rad/s
-- luacheck: ignore 631
return {''')
for (q, said), w in cases:
    v = values(q, w)
    print('  { "%s", "{ %s }", %s },' % (said.replace('"', "'"), ', '.join(w), ', '.join(nstr(x, 22, min_fixed=-5, max_fixed=30) for x in v)), flush=True)
print('}')
