%% -- norm.c -- the error of a step, from the estimates of its states: part of scene.c.  SPDX-License-Identifier: MIT-0
%% if has_floors then
/* The error of one kind of state, numbers first to last - 1, in units of its size at the start or at the end of the step and
 * at least of `least`, or `worst` if that is larger. */
%% else
/* The error of one kind of state, numbers first to last - 1, in units of its size at the start or at the end of the step, or
 * `worst` if that is larger. */
%% end
static ${name}_real ${name}_${method}_worse(const ${name}_real x[], const ${name}_real y[], const ${name}_real error[], int first, int last,
                           ${least_arg}${name}_real worst)
{
  ${name}_real size = ${least_first}, e = ${zero};

  for (int k = first; k < last; k++) {
    const ${name}_real a = ${fabs}(x[${name}_${method}_moving[k]]), b = ${fabs}(y[${place}]), c = ${fabs}(error[k]);

    size = a > size ? a : size;
    size = b > size ? b : size;
    e = c > e ? c : e;
    if (!(b - b == ${zero}) || !(c - c == ${zero})) return ${huge};
  }
  return e > ${zero} && !(e <= worst*size) ? e/size : worst;
}

/* the largest error of all kinds */
static ${name}_real ${name}_${method}_norm(${norm_args}const ${name}_real x[], const ${name}_real y[], const ${name}_real error[])
{
  ${name}_real worst = ${zero};
%% if has_floors then
  ${name}_real least[${floors_count}];

  ${name}_floors(${floors_pass}, least);
%% else

%% end
%% for _, k in ipairs(kinds) do
  worst = ${name}_${method}_worse(x, y, error, ${k.first}, ${k.last}, ${k.least}worst); /* ${k.about} */
%% end
  return worst;
}
