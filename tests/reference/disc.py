# disc.py -- swings of sharp rolling discs with many digits, for tests/effects/disc.t: writes disc.lua.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# A disc of m = 1, R = 1 at the tilt theta: the spin w and a = phi' sin theta are Legendre functions,
#     w = C1 F(u) + C2 F(1 - u),  F = 2F1(p, q; 1; u),  p, q = 1/2 +- i tau,  u = sin^2(theta/2),
#     a = (1 + I3) dw/dtheta,  kappa = 1/4 + tau^2 = I3/(I1 (1 + I3))                    (Appell, Korteweg 1899)
# with F(u) = sum t_k, t_(k+1) = t_k (k (k + 1) + kappa)/(k + 1)^2 u, and F(1 - u) = cosh(pi tau)/pi sum t_k (2 psi(k + 1)
# - psi(p + k) - psi(q + k) - ln u) (DLMF 15.8.10), for u <= 1/2, checked against mpmath's hyp2f1.  Roots of the energy
# by mpmath's findroot, the quadratures by Gauss and Legendre between cuts at ends 2^k.  polhode has none of this: it has
# series in ln tan(theta/2).  Run with mpmath 1.3:
#     python3 tests/reference/disc.py > tests/reference/disc.lua
from mpmath import mp, mpf, mpc, hyp2f1, psi, sin, cos, sqrt, quad, pi, log, exp, atan, acos, cosh, findroot, nstr

mp.dps = 50


class Disc:
    def __init__(self, I1, I3, G):
        self.I1, self.I3, self.G = mpf(I1), mpf(I3), mpf(G)
        self.kappa = self.I3/(self.I1*(1 + self.I3))
        tau = sqrt(mpc(self.kappa - mpf(1)/4))
        self.p, self.q = mpf(1)/2 + mpc(0, 1)*tau, mpf(1)/2 - mpc(0, 1)*tau
        self.factor = (cosh(pi*tau)/pi).real
        self.first = (2*psi(0, 1) - psi(0, self.p) - psi(0, self.q)).real
        for u in (mpf('0.3'), mpf('0.01')):
            got = self.legendre(u)
            assert abs(got[0] - hyp2f1(self.p, self.q, 1, u).real) < mpf(10)**-40
            assert abs(got[1] - hyp2f1(self.p, self.q, 1, 1 - u).real) < mpf(10)**-40

    def legendre(self, u):
        """F(u), F(1 - u) and their derivatives by u, u <= 1/2."""
        t, d, L = mpf(1), self.first, log(u)
        f = g = df = dg = mpf(0)
        k, tiny = 0, mpf(10)**-(mp.dps + 2)
        while t > tiny or k < 4:
            f += t
            g += t*(d - L)
            df += k*t
            dg += t*(k*(d - L) - 1)
            m = k*(k + 1) + self.kappa
            d += mpf(2)/(k + 1) - (2*k + 1)/m
            t *= m/(k + 1)**2*u
            k += 1
        return f, self.factor*g, df/u, self.factor*dg/u

    def basis(self, x):
        """The two solutions and their derivatives by theta at x = ln tan(theta/2)."""
        e = exp(-2*abs(x))
        u, s = e/(1 + e), 2*exp(-abs(x))/(1 + e)
        f, g, df, dg = self.legendre(u)
        if x <= 0:
            return f, g, s/2*df, s/2*dg
        return g, f, -s/2*dg, -s/2*df

    def swing(self, theta0, rate, a0, w0):
        theta0, rate, a0, w0 = mpf(theta0), mpf(rate), mpf(a0), mpf(w0)
        I1, I3 = self.I1, self.I3
        x0 = log(sin(theta0/2)/cos(theta0/2))
        f, g, df, dg = self.basis(x0)
        det = f*dg - g*df
        c1, c2 = (w0*dg - g*a0/(1 + I3))/det, (f*a0/(1 + I3) - w0*df)/det

        def state(x):
            f, g, df, dg = self.basis(x)
            return c1*f + c2*g, (1 + I3)*(c1*df + c2*dg)

        def U(x):
            w, a = state(x)
            return self.G/cosh(x) + (I1*a*a + (1 + I3)*w*w)/2
        E = U(x0) + (I1 + 1)*rate**2/2

        def root(direction):
            step, x = mpf(10)**-20, x0
            while E - U(x + direction*step) > 0:
                x, step = x + direction*step, min(step*2, mpf(1)/8)
            return findroot(lambda z: E - U(z), (x, x + direction*step), solver='anderson', tol=mpf(10)**-85,
                            maxsteps=400)
        h = mpf(10)**-20
        slope = U(x0 - h) - U(x0 + h)
        low = x0 if rate == 0 and slope > 0 else root(-1)
        high = x0 if rate == 0 and slope < 0 else root(1)
        mid, half = (low + high)/2, (high - low)/2

        def both(chi):
            x = mid - half*cos(chi)
            w, a = state(x)
            r = half*sin(chi)*sqrt((I1 + 1)/(2*(E - U(x))))
            return mpc(r/cosh(x), r*a)
        cuts = {mpf(0), pi}
        for k in range(self.finest, 8):
            if mpf(2)**k < half:
                cuts |= {acos(1 - mpf(2)**k/half), pi - acos(1 - mpf(2)**k/half)}
        total = 2*quad(both, sorted(cuts), method='gauss-legendre', maxdegree=5)
        w, a = state(mpf(0))
        return [2*atan(exp(low)), 2*atan(exp(high)), total.real, total.imag, w, a]


UNIFORM, HOOP, FAT, RIM = (0.25, 0.5), (0.5, 1), (2, 0.75), (0.5625, 1)
rows = []
for body in (UNIFORM, HOOP):  # dropped from 0.5 ever nearer to flat
    for k in (2, 5, 8, 11, 14):
        rows.append((body, 50, 0.5, 0, 10.0**-k, 5*10.0**-k/16, 0))
for k in (1, 5, 9):  # small swings about a steady roll, G R c = I1 p^2 s c - (I3 + 1) w p s for p = 2
    rows.append((UNIFORM, 48, 0.9, 10.0**-k, 1.5, -15.0, 0))
for k in (2, 6, 10):  # near the separatrix of the upright one
    rows.append((UNIFORM, 10, 1.5707963267948966, 0, 2*10.0**-k, 10.0**-k, k))
rows += [(UNIFORM, 10, 1.0, 3.5, 0.2, 0.1, 0), (FAT, 10, 2.5, 1.0, 2.0, -1.0, 0), (RIM, 0, 1.2, 1.0, 3.0, 2.0, 0),
         (FAT, 3, 0.01, -2.0, 4.0, 0.5, 0), (HOOP, 9.81, 2.0, 0, 5.0, 6.0, 0)]

if __name__ == "__main__":
    print("-- disc.lua -- written by disc.py, which says what these are.")
    print("-- SPDX-License-Identifier: GPL-3.0-or-later")
    print("-- I1, I3, G; theta, theta', a, w at the start; least and greatest tilt, period, turn, w and a upright")
    print("-- luacheck: ignore 631")
    print("return {")
    for body, G, theta, rate, a, w, near in rows:
        d = Disc(body[0], body[1], G)
        d.finest = -6 - 6*near
        given = ", ".join(repr(float(v)) for v in (body[0], body[1], G, theta, rate, a, w))
        print("  { %s,\n    %s }," % (given, ", ".join(nstr(v, 25, strip_zeros=False) for v in d.swing(theta, rate, a, w))),
              flush=True)
    print("}")
