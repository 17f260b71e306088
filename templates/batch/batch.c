%% -- batch.c -- many bodies at once: part of scene.c.  SPDX-License-Identifier: MIT-0
/* ---- many bodies at once ----
 * A block of ${upper}_LANES bodies stands in local arrays, row i for state i.  Its loops have a fixed count and no call,
 * and nothing else can point into it: that is what compilers want to make vector instructions of them, at -O2 too. */

/* Rows of the block that begins with body `first` of n; its last body stands in for those that are missing. */
static void ${name}_take(${name}_real to[][${upper}_LANES], const ${name}_real from[], int rows, size_t n, size_t first)
{
  const size_t lanes = ${upper}_LANES, last = n - first < lanes ? n - first - 1 : lanes - 1;

  for (int i = 0; i < rows; i++) {
    const ${name}_real *row = from + (size_t)i*n + first;

    if (last == lanes - 1) {
      for (size_t k = 0; k < ${upper}_LANES; k++) to[i][k] = row[k];
    } else {
      for (size_t k = 0; k < ${upper}_LANES; k++) to[i][k] = row[k < last ? k : last];
    }
  }
}

static void ${name}_give(${name}_real from[][${upper}_LANES], ${name}_real to[], int rows, size_t n, size_t first)
{
  const size_t lanes = ${upper}_LANES, count = n - first < lanes ? n - first : lanes;

  for (int i = 0; i < rows; i++) {
    ${name}_real *row = to + (size_t)i*n + first;

    if (count == lanes) {
      for (size_t k = 0; k < ${upper}_LANES; k++) row[k] = from[i][k];
    } else {
      for (size_t k = 0; k < count; k++) row[k] = from[i][k];
    }
  }
}
%% for _, f in ipairs(blocks) do

/* ${name}_${f.name} for each body of a block${f.whose} */
static void ${name}_${f.name}_${f.tail}(${f.owner}, ${name}_real t, ${name}_real x[][${upper}_LANES], ${f.u}${f.last})
{
%% for _, line in ipairs(f.common) do
  ${line}
%% end

  for (int lane = 0; lane < ${upper}_LANES; lane++) {
%% for _, line in ipairs(f.lines) do
    ${line}
%% end
  }
}
%% end
%% for _, s in ipairs(steps) do

void ${name}_${s.advance}_${s.way}(${s.owner}, ${name}_real t, ${name}_real x[], const ${name}_real u[], ${name}_real h, int steps, int n)
{
  ${name}_real y[${upper}_NX][${upper}_LANES];
%% if has_inputs then
  ${name}_real v[${upper}_NU][${upper}_LANES];
%% end
%% if s.each then
  ${name}_real k[${upper}_NC][${upper}_LANES];
%% end

%% if not has_inputs then
  (void)u;
%% end
%% if s.guard then
  if (h > -${tiny} && h < ${tiny}) return; /* no time passes */
%% end
  for (size_t first = 0; n > 0 && first < (size_t)n; first += ${upper}_LANES) {
    ${name}_take(y, x, ${upper}_NX, (size_t)n, first);
%% if has_inputs then
    ${name}_take(v, u, ${upper}_NU, (size_t)n, first);
%% end
%% if s.each then
    ${name}_take(k, c, ${upper}_NC, (size_t)n, first);
%% end
    for (int j = 0; j < steps; j++) ${name}_${s.step}_${s.tail}(${s.whose}, t + (${name}_real)j*h, y, ${s.v}h);
    ${name}_give(y, x, ${upper}_NX, (size_t)n, first);
  }
}

void ${name}_${s.step}_${s.way}(${s.owner}, ${name}_real t, ${name}_real x[], const ${name}_real u[], ${name}_real h, int n)
{
  ${name}_${s.advance}_${s.way}(${s.call}, t, x, u, h, 1, n);
}
%% end
%% for _, text in ipairs(wide) do

${text}
%% end
%% if alone then

${alone}
%% end
%% for _, s in ipairs(rates) do

void ${name}_rhs_${s.way}(${s.owner}, ${name}_real t, const ${name}_real x[], const ${name}_real u[], ${name}_real dx[], int n)
{
  ${name}_real y[${upper}_NX][${upper}_LANES], d[${upper}_NX][${upper}_LANES];
%% if has_inputs then
  ${name}_real v[${upper}_NU][${upper}_LANES];
%% end
%% if s.each then
  ${name}_real k[${upper}_NC][${upper}_LANES];
%% end

%% if not has_inputs then
  (void)u;
%% end
  for (size_t first = 0; n > 0 && first < (size_t)n; first += ${upper}_LANES) {
    ${name}_take(y, x, ${upper}_NX, (size_t)n, first);
%% if has_inputs then
    ${name}_take(v, u, ${upper}_NU, (size_t)n, first);
%% end
%% if s.each then
    ${name}_take(k, c, ${upper}_NC, (size_t)n, first);
%% end
    ${name}_rhs_${s.tail}(${s.whose}, t, y, ${s.v}d);
    ${name}_give(d, dx, ${upper}_NX, (size_t)n, first);
  }
}
%% end
%% if each then

int ${name}_init_many(${name}_real c[], const ${name}_real p[], int status[], int n)
{
  int refused = 0;

  for (int k = 0; k < n; k++) {
    ${name}_real own[${upper}_NP];
    ${name}_model m;

    for (int i = 0; i < ${upper}_NP; i++) own[i] = p[(size_t)i*(size_t)n + (size_t)k];
    status[k] = ${name}_init(&m, own);
    if (status[k] != 0) {
      refused++;
      ${name}_init(&m, 0);
    }
%% for _, member in ipairs(constants) do
    c[${member.index}*(size_t)n + (size_t)k] = m.${member.name};
%% end
  }
  return refused;
}
%% end
