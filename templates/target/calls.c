%% -- calls.c -- a program that calls each function of a scene, for an emulator: not emitted.
%% -- SPDX-License-Identifier: GPL-3.0-or-later
%% -- All are called twice, so that each finds what an earlier one has made; the second time counts. First nothing.
%% for _, stem in ipairs(stems) do
#include "${stem}.h"
%% end
#include "marks.h"

typedef ${name}_real real;
enum { NX = ${upper}_NX };

static volatile real given[4] = {${when}, ${step}, (real)1e-6, (real)1.1};
static ${name}_model model;
%% if has_orbit then
static ${name}_orbit orbit;
%% end
%% if has_params then
static real parameters[${upper}_NP];
%% end
%% if has_inputs then
static real input[${upper}_NU];
%% end
%% if has_whole then
static int32_t whole_start[${upper}_Q31_NX], whole[${upper}_Q31_NX], whole_input[3] = {123456, -234567, 345678};
%% end
%% if has_estimator then
static ${name}_estimator estimator, complete, ready;
static const real errors[6] = {(real)0.1, (real)0.2, (real)0.3, (real)0.1, (real)0.1, (real)0.1};
%% end
%% if has_series then
static real series[${upper}_ORDER + 1][${upper}_ROW];
%% end
static real start[NX], state[2*NX], times[2], tensor[6], moments[3], out[${out}], vectors[${vectors}][3];

static int all(void)
{
  const real when = given[0], step = given[1], tolerance = given[2], spin = given[3];
  int bad = 0;
  times[0] = when;
  times[1] = when + step;
  begin(), end();
%% for _, c in ipairs(calls) do
  for (int i = 0; i < NX; i++) state[i] = start[i];
%%   if has_estimator then
  complete = ready;
%%   end
%%   if has_whole then
  for (int i = 0; i < ${upper}_Q31_NX; i++) whole[i] = whole_start[i];
%%   end
  begin(), ${c.text}, end();
%% end
  (void)tolerance, (void)spin;
  return bad;
}

int main(void)
{
  int bad;
  for (int i = 0; i < ${vectors}; i++)
    for (int k = 0; k < 3; k++) vectors[i][k] = (real)(0.31 + 0.137*i - 0.413*k);
%% if has_inputs then
  for (int i = 0; i < ${upper}_NU; i++) input[i] = (real)(0.00137*(i + 1));
%% end
%% if has_defaults then
  ${name}_defaults(parameters);
  bad = ${name}_init(&model, parameters);
%% else
  bad = ${name}_init(&model, 0);
%% end
  ${name}_initial(&model, start);
%% if has_whole then
  ${name}_q31_initial(whole_start);
%% end
%% if has_inertia then
  ${name}_inertia(&model, tensor);
%% end
%% if has_principal then
  bad |= ${name}_principal(&model, moments, out);
%% end
%% if has_estimator then
  bad |= ${name}_estimator_open(&ready, &model, given[1], 64, errors, errors);
  estimator = ready;
  for (int i = 0; i < 64; i++)
    (void)${name}_estimator_add(&ready, vectors[i%${vectors}], 0, 0);
%% end
  bad |= all();
  return FINISH(all() || bad ? 9 : 0); /* 9: an initial state that is refused */
}
