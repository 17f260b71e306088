%% -- midpoint.c -- the midpoint rule on the rotation group: part of scene.c.  SPDX-License-Identifier: MIT-0
/* ---- Austin, Krishnaprasad, Wang 1993, J. Comput. Phys. 107, 105; Hairer, Lubich, Wanner, Geometric Numerical
 * Integration, VII.5: w the rate at the middle of the step, Cayley's map of h w the step's rotation ---- */

/* Newton: from w = mid to `next`. */
static ${newton_head}
{
%% for _, line in ipairs(newton_lines) do
  ${line}
%% end
}

/* The step that the rate in the middle, w = mid, makes. */
static ${finish_head}
{
%% for _, line in ipairs(finish_lines) do
  ${line}
%% end
}

/* The rate in the middle of the step, by Newton's method from that at its start. */
static void ${name}_midpoint_solve(const ${name}_model *m, ${name}_real t, const ${name}_real x[], const ${name}_real u[], ${name}_real h, ${name}_real mid[3])
{
  ${name}_real next[3];

  mid[0] = x[${upper}_WX];
  mid[1] = x[${upper}_WY];
  mid[2] = x[${upper}_WZ];
  for (int k = 0; k < ${count}; k++) {
    ${name}_midpoint_newton(m, t, x, u, h, mid, next);
    /* a singular Jacobian, h far too large: x - x is not 0 for what is not finite */
    if (!((next[0] - next[0]) + (next[1] - next[1]) + (next[2] - next[2]) == ${zero})) break;
    mid[0] = next[0];
    mid[1] = next[1];
    mid[2] = next[2];
  }
}

void ${name}_midpoint_step(const ${name}_model *m, ${name}_real t, ${name}_real x[], const ${name}_real u[], ${name}_real h)
{
  ${name}_real mid[3];

  ${name}_midpoint_solve(m, t, x, u, h, mid);
  ${name}_midpoint_finish(m, t, x, u, h, mid);
}
%% if transition then

/* The transition matrix of the step whose rate in the middle is w = mid, by the theorem on implicit functions. */
static ${tangent_head}
{
%%   for _, line in ipairs(tangent_lines) do
  ${line}
%%   end
}

void ${name}_midpoint_step_transition(const ${name}_model *m, ${name}_real t, ${name}_real x[], const ${name}_real u[], ${name}_real h, ${name}_real F[])
{
  ${name}_real mid[3];

  ${name}_midpoint_solve(m, t, x, u, h, mid);
  ${name}_midpoint_tangent(m, t, x, u, h, mid, F);
  ${name}_midpoint_finish(m, t, x, u, h, mid);
}
%% end
%% if transition_u then

/* How the step depends on the input, its rate in the middle w = mid. */
static ${tangent_u_head}
{
%%   for _, line in ipairs(tangent_u_lines) do
  ${line}
%%   end
}

void ${name}_midpoint_step_transition_u(const ${name}_model *m, ${name}_real t, const ${name}_real x[], const ${name}_real u[], ${name}_real h, ${name}_real G[])
{
  ${name}_real mid[3];

  ${name}_midpoint_solve(m, t, x, u, h, mid);
  ${name}_midpoint_tangent_u(m, t, x, u, h, mid, G);
}
%% end
%% if first then

void ${name}_step(const ${name}_model *m, ${name}_real t, ${name}_real x[], const ${name}_real u[], ${name}_real h)
{
  ${name}_midpoint_step(m, t, x, u, h);
}
%%   if transition then

void ${name}_step_transition(const ${name}_model *m, ${name}_real t, ${name}_real x[], const ${name}_real u[], ${name}_real h, ${name}_real F[])
{
  ${name}_midpoint_step_transition(m, t, x, u, h, F);
}
%%   end
%%   if transition_u then

void ${name}_step_transition_u(const ${name}_model *m, ${name}_real t, const ${name}_real x[], const ${name}_real u[], ${name}_real h, ${name}_real G[])
{
  ${name}_midpoint_step_transition_u(m, t, x, u, h, G);
}
%%   end
%% end
