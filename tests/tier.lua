-- tier.lua - what a long test leaves out when it runs as one of the quick ones (make check).
-- SPDX-License-Identifier: GPL-3.0-or-later
--
--     tier.quick                 is this the quick tier?
--     tier.every(5, list)        the list; in the quick tier its first element and each fifth after that
--
-- A test that is called by hand, or by make check-all, runs in full.  tests/tiers.lua sets the variable.

local tier = { quick = os.getenv "POLHODE_TIER" == "quick" }

function tier.every(n, list)
  if not tier.quick then return list end
  local some = {}
  for i = 1, #list, n do some[#some + 1] = list[i] end
  return some
end

return tier
