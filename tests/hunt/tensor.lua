-- tensor.lua -- a free body whose six entries of the tensor are parameters: for the hunt.
-- SPDX-License-Identifier: GPL-3.0-or-later
-- luacheck: read globals param scene tensor
local function entry(name, value) return param(name, value, "kg m^2") end
return scene {
  name    = "tensor",
  body    = tensor { mass = 1, xx = entry("xx", 1), yy = entry("yy", 2), zz = entry("zz", 2.5), xy = entry("xy", 0.1),
    xz = entry("xz", 0), yz = entry("yz", 0) },
  effects = {},
  initial = { omega = {0.1, 6, 0.2}, attitude = {1, 0, 0, 0} },
  time    = { horizon = 10 },
}
