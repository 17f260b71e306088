-- symbols.lua -- how each name of a scene is set, once for the whole hand-out, and which names had to give way.
--
-- Parameters and inputs come first: they keep the names that the scene gives them.  The hand-out's own symbols (mass,
-- moments, angular momentum, ...) take the first of their candidates that is still free, and `said` tells where that is
-- not the usual one.  Constants and intermediate values of the equations come last.
-- SPDX-License-Identifier: GPL-3.0-or-later

local math_ = require "generator.report.handout.math"

local symbols = {}
symbols.__index = symbols

local own = {
  mass = { "M", "m", "M_t" }, moment = { "I", "A", "P" }, kinetic = { "T", "K", "E_k" }, tensor = { "I", "Theta" },
  momentum = { "L", "H", "Lambda" }, torque = { "N", "D", "tau" }, rate = { "omega", "w", "nu" },
  time = { "t", "tau" }, position = { "r", "s" }, arm = { "R", "d" }, velocity = { "v", "u" },
  attitude = { "q", "p" }, turn = { "S", "Q", "U" }, integrand = { "x", "xi" },
}
local meaning = { mass = "the mass", moment = "principal moments", kinetic = "the kinetic energy",
  tensor = "the tensor of inertia", momentum = "the angular momentum", torque = "the torque",
  rate = "the angular velocity", time = "time", position = "the position", arm = "the arm of the centre of mass",
  velocity = "the velocity", attitude = "the attitude", turn = "the rotation matrix",
  integrand = "coordinates of the body" }
local order = { "mass", "moment", "kinetic", "tensor", "momentum", "torque", "rate", "time", "position", "arm",
  "velocity", "attitude", "turn", "integrand" }

local function key(node) return node[1] .. "_" .. (node.sub or "") .. (node.vector and "~" or "") end

-- A name as a letter with an index, if it is one: I1, m_2, omega0, Ixx, Nx_1.
local function split(name)
  local base, axes, number = string.match(name, "^(%a)([xyz]+)_?(%d*)$")
  if base then return base, number ~= "" and axes .. "," .. number or axes end
  base, number = string.match(name, "^(%a+)_?(%d+)$")
  if base then return base, number end
  base, number = string.match(name, "^(%a+)_(%w+)$")
  return base or name, number
end

function symbols:take(name, node)
  if self.used[key(node)] then return false end
  self.used[key(node)] = name
  self.of_name[name] = node
  return true
end

-- The symbol of a name; the same whenever it is asked.
function symbols:of(name)
  if self.of_name[name] then return self.of_name[name] end
  local base, sub = split((string.gsub(name, "_+$", ""))) -- slide_: a state of the code that keeps off a parameter
  if not self:take(name, math_.sym(base, sub)) then
    local n = 1
    repeat
      n = n + 1
      local node = math_.sym(base, sub and sub .. "," .. n or tostring(n))
    until self:take(name, node)
  end
  return self.of_name[name]
end

-- A symbol of the hand-out with an index, as a vector or with dots.
function symbols:own(what, sub, more) return math_.sym(self.letter[what], sub, more) end

-- Does a letter stand for something else, alone or with the index 1, 2, 3?
local function taken(self, what, letter)
  if what == "moment" then
    for _, sub in ipairs { "1", "2", "3" } do
      if self.used[letter .. "_" .. sub] then return self.used[letter .. "_" .. sub] end
    end
    return nil
  end
  if what == "tensor" or what == "torque" or what == "arm" or what == "velocity" or what == "position" or
    what == "momentum" or what == "rate" or what == "attitude" then
    for _, sub in ipairs { "x", "y", "z", "xx", "yy", "zz", "xy", "xz", "yz" } do
      if self.used[letter .. "_" .. sub] then return self.used[letter .. "_" .. sub] end
    end
  end
  return self.used[letter .. "_"]
end

local states = { wx = { "rate", "x" }, wy = { "rate", "y" }, wz = { "rate", "z" }, rx = { "position", "x" },
  ry = { "position", "y" }, rz = { "position", "z" }, vx = { "velocity", "x" }, vy = { "velocity", "y" },
  vz = { "velocity", "z" }, qw = { "attitude", "w" }, qx = { "attitude", "x" }, qy = { "attitude", "y" },
  qz = { "attitude", "z" }, t = { "time" }, clock = { "time" }, Lx = { "momentum", "x" }, Ly = { "momentum", "y" },
  Lz = { "momentum", "z" } }

-- names: of parameters and inputs; mass: the name of the parameter that is the whole mass, or nil.
function symbols.new(names, mass)
  local self = setmetatable({ used = {}, of_name = {}, letter = {}, said = {} }, symbols)
  for _, name in ipairs(names) do self:of(name) end
  for _, what in ipairs(order) do
    local first
    for _, candidate in ipairs(own[what]) do
      local base, sub = split(candidate)
      local by = what == "mass" and mass and self.of_name[mass] and nil or taken(self, what, base)
      if not by or sub then
        self.letter[what] = base
        if what == "mass" then self.mass_sub = sub end
        break
      end
      first = first or by
    end
    if first and not (what == "mass" and mass) then
      self.said[#self.said + 1] = { what = meaning[what], name = first, letter = self.letter[what] }
    end
  end
  self.mass = mass and self:of(mass) or math_.sym(self.letter.mass, self.mass_sub)
  self.used[key(self.mass)] = "mass"
  for name, s in pairs(states) do -- a map to a map: order is lost anyway
    if not self.of_name[name] then
      self.of_name[name] = math_.sym(self.letter[s[1]], s[2])
      self.used[key(self.of_name[name])] = name
    end
  end
  for _, sub in ipairs { "xx", "yy", "zz", "xy", "xz", "yz" } do
    self.of_name["I" .. sub] = self.of_name["I" .. sub] or math_.sym(self.letter.tensor, sub)
    self.used[self.letter.tensor .. "_" .. sub] = "I" .. sub
  end
  return self
end

-- The usual letters of the formulas that are the same for every body (math.read), as they are set here.
local usual = { M = "mass", T = "kinetic", L = "momentum", N = "torque", omega = "rate", t = "time", r = "position",
  R = "arm", v = "velocity", q = "attitude", S = "turn", x = "integrand" }
function symbols:reader()
  return function(letter, sub)
    if letter == "I" then return self.letter[sub and #sub == 1 and "moment" or "tensor"] end
    if letter == "M" then return self.mass[1] end
    return usual[letter] and self.letter[usual[letter]] or letter
  end
end

return symbols
