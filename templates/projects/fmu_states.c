%% -- fmu_states.c -- the whole state, taken, put back and as bytes: part of fmu_fmi2.c and fmu_fmi3.c.  SPDX-License-Identifier: MIT-0
${fmi}Status ${fmi}Get${whole}(${component} c, ${fmi}${whole} *state)
{
  instance *i = in(c, ANY, "${fmi}Get${whole}");

  if (!i) return ${fmi}Error;
  if (!*state) *state = malloc(sizeof i->unit.s);
  if (!*state) return refuse(i, "${fmi}Get${whole}", "there is no memory");
  memcpy(*state, &i->unit.s, sizeof i->unit.s);
  return ${fmi}OK;
}

${fmi}Status ${fmi}Set${whole}(${component} c, ${fmi}${whole} state)
{
  instance *i = in(c, ANY, "${fmi}Set${whole}");

  if (!i) return ${fmi}Error;
  if (!state) return refuse(i, "${fmi}Set${whole}", "the state must not be NULL");
  memcpy(&i->unit.s, state, sizeof i->unit.s);
  return ${fmi}OK;
}

${fmi}Status ${fmi}Free${whole}(${component} c, ${fmi}${whole} *state)
{
  (void)c;
  if (!state) return ${fmi}OK;
  free(*state);
  *state = NULL;
  return ${fmi}OK;
}

${fmi}Status ${fmi}Serialized${whole}Size(${component} c, ${fmi}${whole} state, size_t *size)
{
  (void)c;
  (void)state;
  *size = ${name}_unit_bytes();
  return ${fmi}OK;
}

${fmi}Status ${fmi}Serialize${whole}(${component} c, ${fmi}${whole} state, ${fmi}Byte bytes[], size_t size)
{
  instance *i = in(c, ANY, "${fmi}Serialize${whole}");

  if (!i) return ${fmi}Error;
  if (!state || size < ${name}_unit_bytes())
    return refuse(i, "${fmi}Serialize${whole}", "needs a state and ${fmi}Serialized${whole}Size bytes");
  ${name}_unit_write((const ${name}_unit_state *)state, bytes);
  return ${fmi}OK;
}

${fmi}Status ${fmi}${de}${whole}(${component} c, const ${fmi}Byte bytes[], size_t size, ${fmi}${whole} *state)
{
  instance *i = in(c, ANY, "${fmi}${de}${whole}");
  ${name}_unit_state s;

  if (!i) return ${fmi}Error;
  if (${name}_unit_read(&i->unit, bytes, size, &s)) return refuse(i, "${fmi}${de}${whole}", i->unit.message);
  if (!*state) *state = malloc(sizeof s);
  if (!*state) return refuse(i, "${fmi}${de}${whole}", "there is no memory");
  memcpy(*state, &s, sizeof s);
  return ${fmi}OK;
}
