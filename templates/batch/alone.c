%% -- alone.c -- many bodies, one by one: part of scene.c.  SPDX-License-Identifier: MIT-0
/* One body after the other: these steppers' ways differ from body to body, or call functions. */

static void ${name}_pick(${name}_real one[], const ${name}_real all[], int rows, int n, int k)
{
  for (int i = 0; i < rows; i++) one[i] = all[(size_t)i*(size_t)n + (size_t)k];
}

static void ${name}_put_alone(const ${name}_real one[], ${name}_real all[], int n, int k)
{
  for (int i = 0; i < ${upper}_NX; i++) all[(size_t)i*(size_t)n + (size_t)k] = one[i];
}
%% if own_model then

/* the model of body k */
static void ${name}_own(${name}_model *m, const ${name}_real c[], size_t n, size_t k)
{
%% for _, member in ipairs(constants) do
  m->${member.name} = c[${member.index}*n + k];
%% end
%% if order then
  m->order[0] = m->order[1] = m->order[2] = 0; /* which spins are stable: no stepper reads it */
%% end
}
%% end
%% for _, f in ipairs(functions) do

void ${name}_${f.name}(${f.owner}, ${f.before}, ${name}_real x[], const ${name}_real u[], ${f.after}, int n)
{
  int k${f.counter};

%% if not has_inputs then
  (void)u;
%% end
  for (k = 0; k < n; k++) {
    ${name}_real y[${upper}_NX];
%% if has_inputs then
    ${name}_real v[${upper}_NU];
%% end
%% if f.each then
    ${name}_model m;

    ${name}_own(&m, c, (size_t)n, (size_t)k);
%% else

%% end
    ${name}_pick(y, x, ${upper}_NX, n, k);
%% if has_inputs then
    ${name}_pick(v, u, ${upper}_NU, n, k);
%% end
    ${f.call};
    ${name}_put_alone(y, x, n, k);
  }
}
%%   if f.single then

void ${name}_${f.single}(${f.owner}, ${name}_real t, ${name}_real x[], const ${name}_real u[], ${name}_real h, int n)
{
  ${name}_${f.name}(${f.model}, t, x, u, h, 1, n);
}
%%   end
%% end
