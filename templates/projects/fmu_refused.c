%% -- fmu_refused.c -- what the unit does not have: part of fmu_fmi2.c and fmu_fmi3.c.  SPDX-License-Identifier: MIT-0
/* ---- what the unit does not have ---- */
%% for _, f in ipairs(refused) do

%%   for _, line in ipairs(f.definition) do
${line}
%%   end
{
%%   for _, a in ipairs(f.unused) do
  (void)${a};
%%   end
%%   if f.empty then
  if (n == 0) return ${fmi}OK;
%%   end
  return refuse((instance *)c, "${f.name}", "${f.reason}");
}
%% end
