%% -- slide.c -- the centre and the spin of a sliding ball: part of scene.c.  SPDX-License-Identifier: MIT-0
/* ---- closed form: ${theorem} ---- */

int ${name}_solve(${name}_orbit *o, const ${name}_model *m, const ${name}_real x0[])
{
  const ${name}_real e[3][3] = {{${a1}, ${a2}, ${a3}}, {${b1}, ${b2}, ${b3}}, {${n1}, ${n2}, ${n3}}};
  const ${name}_real R = ${R};
  ${name}_real q[4], along[3];
  ${name}_orbit p;

%% if uses_model then
%% else
  (void)m; /* every constant is in the code */
%% end
  if (!${name}_numbers(x0, ${upper}_NX)) return 1;
  if (${name}_spin(x0, e, q, along) == ${zero}) return 1;
  for (int i = 0; i < 9; i++) p.e[i/3][i%3] = e[i/3][i%3];
  p.up = along[2];
  for (int i = 0; i < 2; i++) {
    p.p[i] = x0[${upper}_P1 + i];
    p.v[i] = x0[${upper}_V1 + i];
    p.W[i] = along[i];
  }

  /* slip V - R W x n, W x n = (W.e2) e1 - (W.e1) e2 */
  p.slip[0] = p.v[0] - R*along[1];
  p.slip[1] = p.v[1] + R*along[0];
  p.decay = ${decay};
  p.share = ${share};
  p.rest = ${rest};
  if (!${name}_starts(&p)) return 1;
  ${name}_copy(o, &p, (unsigned int)sizeof(p));
  return 0;
}

/* (1 - exp(-y))/y and (exp(-y) - 1 + y)/y^2: by their power series for |y| < 1, whose 20th term is below 1/21!; beyond it
 * nothing cancels in their definition by more than a factor of 3. */
static void ${name}_fadings(${name}_real y, ${name}_real *first, ${name}_real *second)
{
  if (${fabs}(y) < ${one}) {
    ${name}_real a = ${one}, b = ${half};

    *first = a;
    *second = b;
    for (int k = 1; k < 20; k++) {
      a *= -y/(${name}_real)(k + 1);
      b *= -y/(${name}_real)(k + 2);
      *first += a;
      *second += b;
    }
  } else {
    *first = (${one} - ${exp}(-y))/y;
    *second = (${one} - *first)/y;
  }
}

void ${name}_at_centre(const ${name}_orbit *o, ${name}_real t, ${name}_real p[], ${name}_real v[], ${name}_real W[])
{
  const ${name}_real y = o->decay*t;
  ${name}_real first, second, along[2];

  /* v' = -decay v, V - V0 = k (v - v0), R (W - W0) x n = -(1 - k) (v - v0) */
  ${name}_fadings(y, &first, &second);
  for (int i = 0; i < 2; i++) {
    const ${name}_real lost = y*first*o->slip[i]; /* v0 - v */

    v[i] = o->v[i] - o->share*lost;
    p[i] = o->p[i] + t*(o->v[i] - o->share*(y*second*o->slip[i]));
    along[i] = o->rest*lost;
  }
  for (int i = 0; i < 3; i++) {
    W[i] = (o->W[0] - along[1])*o->e[0][i] + (o->W[1] + along[0])*o->e[1][i] + o->up*o->e[2][i];
  }
}
