%% -- taylor.h -- the contract of the Taylor series stepper: part of scene.h.  SPDX-License-Identifier: MIT-0
/* ---- Taylor series: automatic recurrences, ${lanes} products an order ---- */

/* states that move, in the order of x[]; numbers of a row of coefficients, those beyond the states for its own use */
enum { ${upper}_ORDER = ${order}, ${upper}_MOVING = ${count}, ${upper}_ROW = ${row} };

%% if axis or shift or top then
/* Coefficients of the solution through x at time t, in the turning frame of the source; taylor_at makes states of them. */
%% else
/* Coefficients c[n][k] of the solution through x at time t: state k is the sum of c[n][k] s^n at time t + s. */
%% end
void ${name}_taylor_series(const ${name}_model *m, ${name}_real t, const ${name}_real x[], const ${name}_real u[],
                  ${name}_real c[][${upper}_ROW]);

/* The state at time t + s from the coefficients: dense output.  Entries of x that do not move are left alone. */
void ${name}_taylor_at(const ${name}_model *m, ${name}_real c[][${upper}_ROW], ${name}_real s, ${name}_real x[]);

%% if has_knots then
/* The tables have corners: the series is that of the time after t, until the next corner; the steps stop at corners, and
 * ${name}_taylor_step and _run go on from there. */

%% end
%% if has_switches then
/* The equations have corners: the series is that of the sides at t.  Steps have parts that end at the corners; where no motion
 * leads on from one, as both sides push back to it, ${name}_taylor_step makes x no number, _adapt stops and _run returns -1. */

%% end
/* One step of size h, order ${upper}_ORDER: x goes from time t to t + h, the input u held. */
void ${name}_taylor_step(const ${name}_model *m, ${name}_real t, ${name}_real x[], const ${name}_real u[], ${name}_real h);

%% if transition then
/* The same step and its transition matrix, row major, NX x NX: F[i*NX + k] = d x[i](t + h)/d x[k](t), by the series of the
 * variational equations of the same order; what keeps |q| = 1 is included.  It takes about 3 NX times as long as the step. */
void ${name}_taylor_step_transition(const ${name}_model *m, ${name}_real t, ${name}_real x[], const ${name}_real u[], ${name}_real h, ${name}_real F[]);
%%   if has_inputs then

/* How the same step depends on the input, row major, NX x NU: G[i*NU + k] = d x[i](t + h)/d u[k], u held during the step; 0
 * where u[k] is beyond its limits.  x stays as it is. */
void ${name}_taylor_step_transition_u(const ${name}_model *m, ${name}_real t, const ${name}_real x[], const ${name}_real u[], ${name}_real h, ${name}_real G[]);
%%   end

%% end
%% if has_compensated then
/* The same step with compensated sums: the state is x + low, low[NX] 0 at the start and afterwards what x[i] lost. */
void ${name}_taylor_step_compensated(const ${name}_model *m, ${name}_real t, ${name}_real x[], const ${name}_real u[], ${name}_real h, ${name}_real low[${upper}_NX]);

%% end
/* One step of the size that the tolerance asks for, in the direction of h and not beyond it; returns that size.  The
 * last two terms are at most the tolerance times the size of their kind of state (Jorba, Zou 2005, section 3.2). */
${name}_real ${name}_taylor_adapt(const ${name}_model *m, ${name}_real t, ${name}_real x[], const ${name}_real u[], ${name}_real h, ${name}_real tolerance);

/* From time t0 to t1, the tolerance for the whole way: each step gets its share of it by its length, the order (at most
 * ${upper}_ORDER) follows it.  At most `most` steps, their sum compensated; returns how many, or -1 if they did not suffice or
 * the state became infinite (x is then where it stopped). */
int ${name}_taylor_run(const ${name}_model *m, ${name}_real t0, ${name}_real x[], const ${name}_real u[], ${name}_real t1, ${name}_real tolerance, int most);
%% if first then

/* One step of size h by the series: the scene's own stepper. */
void ${name}_step(const ${name}_model *m, ${name}_real t, ${name}_real x[], const ${name}_real u[], ${name}_real h);
%%   if has_compensated then
void ${name}_step_compensated(const ${name}_model *m, ${name}_real t, ${name}_real x[], const ${name}_real u[], ${name}_real h, ${name}_real low[${upper}_NX]);
%%   end
%%   if transition then
void ${name}_step_transition(const ${name}_model *m, ${name}_real t, ${name}_real x[], const ${name}_real u[], ${name}_real h, ${name}_real F[]);
%%     if has_inputs then
void ${name}_step_transition_u(const ${name}_model *m, ${name}_real t, const ${name}_real x[], const ${name}_real u[], ${name}_real h, ${name}_real G[]);
%%     end
%%   end
%% end
