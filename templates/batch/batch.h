%% -- batch.h -- many bodies at once: part of scene.h.  SPDX-License-Identifier: MIT-0
/* ---- many bodies at once ----
 * Of n bodies, component i of body k stands at [i*n + k]: x[${upper}_NX*n]${inputs_text}.
 * Each body gets the bits that the function of one body gives it, whatever n is and however wide
 * the processor's vectors are (compiled with -ffp-contract=off).  The loops are over ${upper}_LANES
 * bodies, without calls or branches: gcc and clang make vector instructions of them
 * (-O2 -fno-math-errno and the processor, such as -march=native -mprefer-vector-width=512). */
enum { ${upper}_LANES = ${lanes} };

%% for _, s in ipairs(steppers) do
/* ${name}_${s.step} for n bodies. */
void ${name}_${s.step}_many(const ${name}_model *m, ${name}_real t, ${name}_real x[], const ${name}_real u[], ${name}_real h, int n);

/* As many steps h for n bodies; step j begins at the time t + j*h. */
void ${name}_${s.advance}_many(const ${name}_model *m, ${name}_real t, ${name}_real x[], const ${name}_real u[], ${name}_real h, int steps, int n);

%%   if s.run then
/* ${name}_taylor_run for n bodies, each at its own pace: steps[k] is what that returns for body k.${refilled} */
void ${name}_taylor_run_many(const ${name}_model *m, ${name}_real t0, ${name}_real x[], const ${name}_real u[], ${name}_real t1, ${name}_real tolerance, int most, int steps[], int n);

%%   end
%% end
%% if rhs then
/* ${name}_rhs for n bodies; dx must not overlap x. */
void ${name}_rhs_many(const ${name}_model *m, ${name}_real t, const ${name}_real x[], const ${name}_real u[], ${name}_real dx[], int n);

%% end
%% if each then
/* Bodies that differ in their parameters: what ${name}_model keeps of body k, at c[i*n + k]. */
enum {
%% for _, line in ipairs(constant_enum) do
  ${line}
%% end
};

/* ${name}_init for n bodies: p[${upper}_NP*n], c[${upper}_NC*n].  status[k] is what ${name}_init returns for body k;
 * a body that it refuses gets the scene's own constants.  Returns how many it refuses. */
int ${name}_init_many(${name}_real c[], const ${name}_real p[], int status[], int n);

%% for _, s in ipairs(steppers) do
%%   if s.each then
/* ${name}_${s.step}_many and ${name}_${s.advance}_many, each body with its own constants. */
void ${name}_${s.step}_each(const ${name}_real c[], ${name}_real t, ${name}_real x[], const ${name}_real u[], ${name}_real h, int n);
void ${name}_${s.advance}_each(const ${name}_real c[], ${name}_real t, ${name}_real x[], const ${name}_real u[], ${name}_real h, int steps, int n);

%%     if s.run then
void ${name}_taylor_run_each(const ${name}_real c[], ${name}_real t0, ${name}_real x[], const ${name}_real u[], ${name}_real t1, ${name}_real tolerance, int most, int steps[], int n);

%%     end
%%   end
%% end
%% if rhs_each then
/* ${name}_rhs_many, each body with its own constants. */
void ${name}_rhs_each(const ${name}_real c[], ${name}_real t, const ${name}_real x[], const ${name}_real u[], ${name}_real dx[], int n);

%% end
%% end
