-- closed.lua -- closed forms of this scene's motion as equations, in the notation of formula/read.lua.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local order = require "generator.report.order"

local closed = {}

-- Signs are those along the axes 1, 2, 3 that the report prints, for the initial state.
local function asymmetric(f)
  local top = order.motion(f)
  if not top or top.constant then return { "~omega = ~omega(0)" } end
  local places = order.of(f)
  local names = top.s > 0 and { "cn", "sn", "dn" } or { "dn", "sn", "cn" }
  local terms = {}
  for n = 1, 3 do
    local own = top.s > 0 and n or 4 - n
    local along = 0.0
    for i = 1, 3 do along = along + R.todouble(top.axis[own][i]) * f.axes[places[n]][i] end
    local minus = (along < 0) ~= (own == 2 and top.s < 0)
    terms[n] = (minus and "- " or n > 1 and "+ " or "") .. string.format("B_%d %s(u) ~e_%d", n, names[n], n)
  end
  return { "~L = " .. table.concat(terms, " "), "u = lambda ( t - t_0 )" }
end

local forms = {
  sphere = function() return { "~omega = ~omega(0)" } end,
  asymmetric = asymmetric,
  symmetric = function()
    return { "omega_1 = A cos( Omega t + psi_0 )", "omega_2 = A sin( Omega t + psi_0 )", "omega_3 = omega_3(0)",
      "phi = {L|I_1} t" }
  end,
  lagrange = function() return { "cos(theta) = u_1 + ( u_2 - u_1 ) sn^2( lambda ( t - t_0 ) )" } end,
}

-- nil for the forms that say it in words.
function closed.of(f)
  local form = forms[f.closed.kind]
  return form and form(f)
end

return closed
