%% -- init.c -- the set-up: part of scene.c.  SPDX-License-Identifier: MIT-0
void ${name}_defaults(${name}_real p[])
{
%% if has_params then
%%   for _, p in ipairs(params) do
  p[${upper}_${p.upper}] = ${p.value};
%%   end
%% else
  (void)p;
%% end
}

%% if split_setup then
static int ${name}_split_setup(${name}_model *m);

%% end
%% if first_step then
/* Does the first step of ${step_text} s lead from the initial state to what is no number? */
static int ${name}_overflows(const ${name}_model *m)
{
  ${name}_real x[${upper}_NX], sum = ${zero};
%%   if has_inputs then
  const ${name}_real u[${upper}_NU] = {${zero}}; /* no input */
%%   end
  int i;

  ${name}_initial(m, x);
%%   if has_inputs then
  ${name}_step(m, ${zero}, x, u, ${step_literal});
%%   else
  ${name}_step(m, ${zero}, x, 0, ${step_literal});
%%   end
  for (i = 0; i < ${upper}_NX; i++) sum += x[i] - x[i]; /* each 0, or no number */
  return !(sum == ${zero});
}

%% end
int ${name}_init(${name}_model *m, const ${name}_real p[])
{
%% if no_members then
%% else
  ${name}_model k;
%% end
%% if has_params then
  ${name}_real own[${upper}_NP];

  if (!p) {
    ${name}_defaults(own);
    p = own;
  }
%%   for _, line in ipairs(loads) do
  ${line}
%%   end
%% else
  (void)p;
%% end
%% for _, g in ipairs(groups) do

%%   for _, line in ipairs(g.lines) do
  ${line}
%%   end
%% end
%% if has_finite then

  /* x - x is 0 unless x is infinite or not a number */
%%   for _, line in ipairs(finite) do
  ${line}
%%   end
%% end
%% if order then
  ${name}_order(p, k.order);
%% end
%% if split_setup then
  if (${name}_split_setup(&k)) return ${setup_code};
%% end
%% if first_step then
  if (${name}_overflows(&k)) return ${step_code};
%% end
%% if no_members then
  m->empty = 0;
%% else
%%   for _, line in ipairs(copies) do
  ${line}
%%   end
%% end
  return 0;
}
