%% -- centre.c -- the centre and the spin of a rolling ball: part of scene.c.  SPDX-License-Identifier: MIT-0
/* ---- closed form: ${theorem} ---- */

int ${name}_solve(${name}_orbit *o, const ${name}_model *m, const ${name}_real x0[])
{
  const ${name}_real e[3][3] = {{${a1}, ${a2}, ${a3}}, {${b1}, ${b2}, ${b3}}, {${n1}, ${n2}, ${n3}}};
%% if turning then
  const ${name}_real Omega = ${Omega};
%% end
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

  /* V = Omega n x p + R W x n, W x n = (W.e2) e1 - (W.e1) e2 */
  for (int i = 0; i < 2; i++) {
    p.p[i] = x0[${upper}_P1 + i];
    p.W[i] = along[i];
  }
%% if turning then
  p.v[0] = R*along[1] - Omega*p.p[1];
  p.v[1] = Omega*p.p[0] - R*along[0];
  p.rate = ${turn};
  p.share = ${share};
  ${name}_half_turns(${name}_pair_of(p.rate), p.turns);
  if (!(p.turns[3] - p.turns[3] == ${zero})) return 1; /* k Omega is beyond the range of the type */
  p.last = ${fabs}(p.turns[0])*${last_time} > ${last_turn} ? ${last_turn}/${fabs}(p.turns[0]) : ${last_time};
%% else
  p.v[0] = R*along[1];
  p.v[1] = -R*along[0];
%% end
%% if tilted then
  p.pull[0] = ${pull1};
  p.pull[1] = ${pull2};
  p.spin[0] = ${spin1};
  p.spin[1] = ${spin2};
%% end
  if (!(p.v[0] - p.v[0] == ${zero} && p.v[1] - p.v[1] == ${zero}) || !${name}_starts(&p)) return 1;
  ${name}_copy(o, &p, (unsigned int)sizeof(p));
  return 0;
}
%% if turning then

/* With y = rate t and E(y) = (exp(i y) - 1)/(i y), the means of exp(i y): t E and t^2 (exp(i y) - 1 - i y)/(i y)^2, as
 * real and imaginary parts, and exp(i y) itself.  By their power series for |y| < 1, whose 10th term is below 1/22!;
 * beyond it nothing cancels in their definition by more than a factor of 6. */
static void ${name}_arcs(const ${name}_orbit *o, ${name}_real t, ${name}_real turn[2], ${name}_real first[2], ${name}_real second[2])
{
  const ${name}_real y = o->rate*t;

  if (${fabs}(y) < ${one}) {
    const ${name}_real sixth = ${one}/${n[6]};
    ${name}_real a = ${one}, b = ${half}, c = sixth, power = ${one};
    ${name}_real sine = ${one}, cosine = ${half}, rest = sixth;

    for (int k = 1; k < 10; k++) {
      const ${name}_real two_k = ${two}*(${name}_real)k;

      power *= -(y*y);
      a /= two_k*(two_k + ${one});
      b /= (two_k + ${one})*(two_k + ${two});
      c /= (two_k + ${two})*(two_k + ${three});
      sine += power*a;   /* sin(y)/y */
      cosine += power*b; /* (1 - cos y)/y^2 */
      rest += power*c;   /* (y - sin y)/y^3 */
    }
    turn[0] = ${one} - y*y*cosine;
    turn[1] = y*sine;
    first[0] = t*sine;
    first[1] = t*y*cosine;
    second[0] = t*t*cosine;
    second[1] = t*t*y*rest;
  } else {
    ${name}_real s, c;

    ${name}_circle(${name}_phase(o, o->turns, t), &s, &c); /* of the half angle */
    turn[0] = (c - s)*(c + s);
    turn[1] = ${two}*s*c;
    first[0] = turn[1]/o->rate;
    first[1] = ${two}*s*s/o->rate;
    second[0] = first[1]/o->rate;
    second[1] = (t - first[0])/o->rate;
  }
}
%% end

void ${name}_at_centre(const ${name}_orbit *o, ${name}_real t, ${name}_real p[], ${name}_real v[], ${name}_real W[])
{
%% if turning then
  ${name}_real turn[2], first[2], second[2], moved[2], along[2];
  int i;

  /* z' = i rate z' + pull from z0, V0 */
  ${name}_arcs(o, t, turn, first, second);
  v[0] = turn[0]*o->v[0] - turn[1]*o->v[1];
  v[1] = turn[0]*o->v[1] + turn[1]*o->v[0];
  moved[0] = first[0]*o->v[0] - first[1]*o->v[1];
  moved[1] = first[0]*o->v[1] + first[1]*o->v[0];
%% if tilted then
  v[0] += first[0]*o->pull[0] - first[1]*o->pull[1];
  v[1] += first[0]*o->pull[1] + first[1]*o->pull[0];
  moved[0] += second[0]*o->pull[0] - second[1]*o->pull[1];
  moved[1] += second[0]*o->pull[1] + second[1]*o->pull[0];
%% end
  for (i = 0; i < 2; i++) {
    p[i] = o->p[i] + moved[i];
    along[i] = o->W[i] + o->share*moved[i];
  }
%% if tilted then
  along[0] -= o->spin[1]*t;
  along[1] += o->spin[0]*t;
%% end
%% else
  ${name}_real along[2];
  int i;

  for (i = 0; i < 2; i++) {
    p[i] = o->p[i] + t*(o->v[i] + ${half}*t*o->pull[i]);
    v[i] = o->v[i] + t*o->pull[i];
  }
  along[0] = o->W[0] - o->spin[1]*t;
  along[1] = o->W[1] + o->spin[0]*t;
%% end
  for (i = 0; i < 3; i++) W[i] = along[0]*o->e[0][i] + along[1]*o->e[1][i] + o->up*o->e[2][i];
}
