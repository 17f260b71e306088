-- tier.lua - what a long test leaves out when it runs with all others.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
--     tier.quick                    is this the quick tier (make check)?
--     tier.some                     is this one of the tiers, not a test that is called by hand?
--     tier.every(6, list)           the list; in the quick tier its first element and each sixth after that
--     tier.every(6, list, 2)        in make check-all its first element and each second after that
--
-- A test that is called by hand runs in full.  tests/tiers.lua sets the variable.  The 2 divides the 6, so that what is
-- quick is in the other, too.

local named = os.getenv "POLHODE_TIER"
local tier = { quick = named == "quick", some = named ~= nil }

function tier.every(n, list, all)
  local step = tier.quick and n or tier.some and all or 1
  assert(n % (all or 1) == 0)
  if step == 1 then return list end
  local some = {}
  for i = 1, #list, step do some[#some + 1] = list[i] end
  return some
end

return tier
