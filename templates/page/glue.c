/* page.c -- ${name} for a page: the emitted functions behind plain exports, arrays in linear memory, no import.
 * template: templates/page/glue.c.  ${license} */
#include "${name}.h"

#include <stddef.h>

#if defined __wasm__
#define PAGE(symbol) __attribute__((export_name(#symbol)))
#else
#define PAGE(symbol)
#endif

typedef ${name}_real real;

enum { SLOTS = 5, NX = ${upper}_NX, NP = ${upper}_NP, NU = ${upper}_NU };

typedef void step_of(const ${name}_model *m, real t, real x[], const real u[], real h);

static ${name}_model model;
static real states[SLOTS][NX], params[NP + 1], inputs[NU + 1], out[16];
%% if has_full then
static ${name}_orbit orbit;
%% end

/* A compiler may call these for loops of its own making. */
void *memset(void *to, int value, size_t n);
void *memcpy(void *to, const void *from, size_t n);

void *memset(void *to, int value, size_t n)
{
  volatile unsigned char *p = to;

  while (n--) *p++ = (unsigned char)value;
  return to;
}

void *memcpy(void *to, const void *from, size_t n)
{
  volatile unsigned char *p = to;
  const unsigned char *q = from;

  while (n--) *p++ = *q++;
  return to;
}

PAGE(states) real *page_states(void);
PAGE(params) real *page_params(void);
PAGE(inputs) real *page_inputs(void);
PAGE(out) real *page_out(void);
PAGE(defaults) void page_defaults(void);
PAGE(init) int page_init(void);
PAGE(initial) void page_initial(int slot);
PAGE(march) void page_march(int slot, int method, double h, double from, double to);
PAGE(solve) int page_solve(int slot);
PAGE(at) void page_at(int slot, double t);
PAGE(energy) double page_energy(int slot);
PAGE(momentum) void page_momentum(int slot);
PAGE(mass) void page_mass(void);
PAGE(inertia) void page_inertia(void);
PAGE(principal) int page_principal(void);
%% if has_contact then
PAGE(contact) void page_contact(int slot, double t);
%% end
%% if has_landing then
PAGE(gap) double page_gap(int slot);
PAGE(impact) double page_impact(int slot);
%% end

real *page_states(void) { return states[0]; }
real *page_params(void) { return params; }
real *page_inputs(void) { return inputs; }
real *page_out(void) { return out; }
void page_defaults(void) { ${name}_defaults(params); }
int page_init(void) { return ${name}_init(&model, params); }
void page_initial(int slot) { ${name}_initial(&model, states[slot]); }

/* Steps number from .. to - 1 of size h: step i begins at i h. */
void page_march(int slot, int method, double h, double from, double to)
{
  static step_of *const steps[] = {
%% for _, s in ipairs(steppers) do
    ${name}_${s.step}, /* ${s.name} */
%% end
  };
  double i;

  for (i = from; i < to; i += 1.0) steps[method](&model, (real)i*(real)h, states[slot], inputs, (real)h);
}

%% if has_full then
int page_solve(int slot) { return ${name}_solve(&orbit, &model, states[slot]); }
void page_at(int slot, double t) { ${name}_at(&orbit, (real)t, states[slot]); }
%% else
int page_solve(int slot) { return slot - slot + 1; }
void page_at(int slot, double t) { states[slot][0] = (real)(t - t) + states[slot][0]; }
%% end
double page_energy(int slot) { return (double)${name}_energy(&model, states[slot]); }
%% if has_attitude then
void page_momentum(int slot) { ${name}_momentum(&model, states[slot], out); }
%% else
void page_momentum(int slot) { out[0] = out[1] = out[2] = (real)(slot - slot); }
%% end

/* out: mass, centre of mass from the origin of rotation */
void page_mass(void) { out[0] = ${name}_mass(&model, out + 1); }

/* out: xx yy zz xy xz yz */
void page_inertia(void) { ${name}_inertia(&model, out); }

/* out: three moments, then the axes, three numbers each */
int page_principal(void) { return ${name}_principal(&model, out, out + 3); }
%% if has_contact then

/* out: the reaction of the plane, centre of mass, its velocity */
void page_contact(int slot, double t)
{
  out[0] = ${name}_contact(&model, (real)t, states[slot], inputs, out + 1, out + 4);
}
%% end
%% if has_landing then

/* of the body in the air: the lowest point's distance from the plane; what meeting it makes of the state, and the impulse */
double page_gap(int slot) { return (double)${name}_gap(&model, states[slot]); }
double page_impact(int slot) { return (double)${name}_impact(&model, states[slot]); }
%% end
