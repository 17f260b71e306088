%% -- fmu_modes.c -- start, end and return: part of fmu_fmi2.c and fmu_fmi3.c.  SPDX-License-Identifier: MIT-0
${fmi}Status ${fmi}ExitInitializationMode(${component} c)
{
  instance *i = in(c, STARTING, "${fmi}ExitInitializationMode");

  if (!i) return ${fmi}Error;
  if (${name}_unit_start(&i->unit)) return refuse(i, "${fmi}ExitInitializationMode", i->unit.message);
  return event(i, "${fmi}ExitInitializationMode", "initialized");
}

${fmi}Status ${fmi}Terminate(${component} c)
{
  instance *i = in(c, RUNNING | FAILED, "${fmi}Terminate");

  if (!i) return ${fmi}Error;
  i->unit.s.phase = ENDED;
  return event(i, "${fmi}Terminate", "terminated");
}

${fmi}Status ${fmi}Reset(${component} c)
{
  instance *i = in(c, ANY, "${fmi}Reset");

  if (!i) return ${fmi}Error;
  ${name}_unit_reset(&i->unit);
  return event(i, "${fmi}Reset", "as it was created");
}
