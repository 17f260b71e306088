%% -- fmu_phases.c -- what is allowed when: part of fmu_fmi2.c and fmu_fmi3.c.  SPDX-License-Identifier: MIT-0
static ${fmi}Status refuse(const instance *i, const char *function, const char *text)
{
  if (i && i->errors) put(i, ${fmi}Error, "logStatusError", function, text);
  return ${fmi}Error;
}

static ${fmi}Status event(const instance *i, const char *function, const char *text)
{
  if (i->events) put(i, ${fmi}OK, "logEvents", function, text);
  return ${fmi}OK;
}

/* The instance, if the call is allowed in its phase; else NULL. */
static instance *in(${component} c, int phases, const char *function)
{
  instance *i = (instance *)c;

  if (!i || (i->unit.s.phase & phases)) return i;
  refuse(i, function, "is not allowed in this phase");
  return NULL;
}
