%% -- init.c -- the set-up: part of scene.c.  SPDX-License-Identifier: MIT-0
%% if has_params then
/* the scene's own parameters */
static const ${name}_real ${name}_own_parameters[${upper}_NP] = {
%%   for _, p in ipairs(params) do
  ${p.value}, /* ${p.name} */
%%   end
};

void ${name}_defaults(${name}_real p[])
{
%%   for _, p in ipairs(params) do
  p[${upper}_${p.upper}] = ${name}_own_parameters[${upper}_${p.upper}];
%%   end
}
%% else
void ${name}_defaults(${name}_real p[])
{
  (void)p;
}
%% end

%% if split_setup then
static int ${name}_split_setup(${name}_model *m);

%% end
%% if first_step then
/* Does the first step of ${step_text} s lead from the initial state to what is no number? */
static int ${name}_overflows(const ${name}_model *m)
{
  ${name}_real x[${upper}_NX], sum = ${zero};
%%   if has_inputs then
  static const ${name}_real u[${upper}_NU] = {${zero}}; /* no input; static: no call of memset clears it */
%%   end

  ${name}_initial(m, x);
%%   if has_inputs then
  ${name}_step(m, ${zero}, x, u, ${step_literal});
%%   else
  ${name}_step(m, ${zero}, x, 0, ${step_literal});
%%   end
  for (int i = 0; i < ${upper}_NX; i++) sum += x[i] - x[i]; /* each 0, or no number */
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
  if (!p) p = ${name}_own_parameters;
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
  ${name}_sort_moments(p, k.order);
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
