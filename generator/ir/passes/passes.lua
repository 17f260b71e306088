-- passes.lua: the order of the passes, as one list.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Below the line.  Every pass is run(ir) -> ir, leaves its argument as it was and preserves every
-- value to the bit, so any prefix of the list is a correct compiler:
--   power  before fold and cse, which see only its multiplications
--   fold   before cse: the forms it leaves are fewer; its rules look at one operation and its
--          operands and never at equality, so merging cannot wake them again
--   cse    before dce, which drops what merging left unread
--   order  last

local passes = {}

passes.list = {
  { name = "power", run = require("generator.ir.passes.power").run },
  { name = "fold", run = require("generator.ir.passes.fold").run },
  { name = "cse", run = require("generator.ir.passes.cse").run },
  { name = "dce", run = require("generator.ir.passes.dce").run },
  { name = "order", run = require("generator.ir.passes.order").run },
}

-- All passes, or those up to and including stop_after; "lower" stops before the first.
function passes.run(ir, stop_after)
  if stop_after == "lower" then return ir end
  for _, pass in ipairs(passes.list) do
    ir = pass.run(ir)
    if pass.name == stop_after then return ir end
  end
  if stop_after then error("passes: there is no pass '" .. tostring(stop_after) .. "'", 2) end
  return ir
end

return passes
