-- plausible.lua -- what is possible and all the same unlikely: warnings about units.
--
-- A number without a unit is in SI units.  Where the density that follows from it is no solid's, and another unit makes
-- it an ordinary one, the number was probably meant so.  The density decides, not the size: planets, dust and molecules
-- are as good as bricks.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local vec = require "generator.algebra.vec"
local catalogue = require "generator.mass.catalogue"
local jacobi = require "generator.mass.jacobi"
local diag = require "generator.diag"

local plausible = {}

-- Parts of one body whose sizes differ by more than six orders: one of them is probably in another unit.  A part's size
-- is its largest spread about its own centre, so needles and plates have the size of their length.
function plausible.sizes(d, m)
  local least, largest
  for _, p in ipairs(m.body.pieces) do
    local s = p.sigma and p.name ~= "tensor" and 0 or nil
    for i = 1, s and 3 or 0 do s = math.max(s, math.abs(m:double(p.sigma[i]))) end
    if s and s > 0 then
      local part = { size = math.sqrt(s), p = p }
      if not least or part.size < least.size then least = part end
      if not largest or part.size > largest.size then largest = part end
    end
  end
  if least and largest.size > 1e6 * least.size then
    d:warn(least.p.line, least.p.name, "is " .. diag.rough(largest.size / least.size) .. " times smaller than the " ..
      largest.p.name .. " of line " .. largest.p.line .. " in the same body: are both in one unit?")
  end
end

-- ---- density, in kg/m^3 ----

-- No solid is lighter than aerographene, 0.16 (Sun, Xu, Gao, Adv. Mater. 25 (2013) 2554), or denser than osmium, 22590
-- (Arblaster, Platinum Metals Rev. 57 (2013) 177); a shape that stands for something hollow is as light as a foam.
local thinnest, densest = 0.1, 30000
-- What another unit must make of it to be worth a word: from balsa and the hulls of satellites to lead.
local ordinary = { 100, 12000 }
-- A plain density below this, times 1000, is that of a material (g/cm^3: lithium 0.53 to tungsten 19.3).  As it stands
-- it would be a gas or the lightest of foams.
local grams_per_cm3 = { 0.1, 20 }
local small = 0.3 -- m: who tries formulas with whole numbers has bodies of a metre and more

local slips = { { 1e9, "its lengths in mm", "mm", "length" }, { 1e6, "its lengths in cm", "cm", "length" },
  { 1e-3, "its mass in g", "g", "mass" },
  { 1e6, "its lengths in mm and its mass in g", "mm", "both" } }

-- Was what the slip is about written without a unit?
local function possible(bare, kind)
  if kind == "both" then return bare.length and bare.mass end
  return bare[kind]
end

-- The volume of a shape as it is written, in doubles; nil if it has none that is a number.
-- (as the scene has it: `growth` is applied outside)
local function volume(m, node)
  if node.shape == "mesh" then return m:double(node.a.measure) end
  local spec = catalogue.by_name[node.shape]
  if not spec or not spec.build then return nil end
  return m:double(spec.build(node.a).measure)
end

-- 2400, not 2.4e+03.
local function plain(x)
  local rough = diag.rough(x)
  return x >= 1000 and x < 1e9 and diag.show(math.tointeger(tonumber(rough))) or rough
end

-- Mass over volume with the lengths as they are.
local function by_mass(d, m, node, growth, name)
  local mass = m:double(node.mass)
  local density = mass / (volume(m, node) * growth)
  if not (density < thinnest or density > densest) or density == math.huge then return end
  local guesses, unit = {}, {}
  for _, s in ipairs(slips) do
    local guess = density * s[1]
    if possible(node.bare, s[4]) and not unit[s[4]] and guess > ordinary[1] and guess < ordinary[2] then
      guesses[#guesses + 1] = "with " .. s[2] .. " it would be " .. plain(guess)
      unit[s[4]], unit[1] = true, unit[1] or s[3]
    end
  end
  if #guesses == 0 then return end
  local write = node.shape == "mesh" and unit[1] == "mm" and "units = \"mm\"" or "quantity(number, \"" .. unit[1] ..
    "\")"
  d:warn(node.line, name, "numbers without a unit are in m and kg; its density is then " .. plain(density) ..
    " kg/m^3, which no solid has; " .. table.concat(guesses, ", or ") .. " (write " .. write .. ")")
end

-- A mesh file has no unit, and most of them are in mm.  Nobody sees its numbers in the scene, so more is said of it
-- than of a shape whose lengths are written there: without `units`, and from 3 m and 10 t on, which few parts have that
-- are drawn in metres, and all solid parts in mm from 3 mm on.  `units = "m"` says that it is meant.
local large, heavy = 3, 1e4
local power = { volume = 3, area = 2, length = 1 }

local function by_size(d, m, node, growth, name)
  local k = growth ^ (1 / 3) -- of lengths, by what was scaled
  local size, p = node.longest * k, power[node.measure]
  local mass = m:double(node.density) * m:double(node.a.measure) * k ^ p
  if size < large or mass < heavy then return end
  d:warn(d:locate(node.line, "file"), name, "without units its coordinates are in m: it is " .. diag.rough(size) ..
    " m long and has " .. diag.rough(mass) .. " kg; in mm it would be " .. diag.rough(size * 1e-3) .. " m and " ..
    diag.rough(mass * 1e-3 ^ p) .. " kg (write units = \"mm\", or units = \"m\" if it is so large)")
end

-- A plain density.
local function by_density(d, m, node, size, name)
  local q = m:number(node.density)
  local density = R.todouble(q)
  if density < grams_per_cm3[1] or density >= grams_per_cm3[2] or R.isint(q) and size >= small then return end
  local x = diag.show(density)
  d:warn(d:locate(node.line, "density"), name, "a density without a unit is in kg/m^3, and " .. x ..
    " is lighter than any common solid; in g/cm^3 it would be one: write quantity(" .. x ..
    ", \"g/cm^3\"), or quantity(" .. x .. ", \"kg/m^3\")")
end

-- Shapes below node whose numbers have no unit (node.bare, see dsl/shapes.lua); growth: of volume by what was scaled.
-- Holes are not looked at: they are of the body's material.
function plausible.densities(d, m)
  local moment = jacobi.run(vec.map(m.centroidal, function(e) return m:double(e) end))[3]
  local size = math.sqrt(moment / m:double(m.mass))
  local function look(node, growth)
    if node.shape then
      local name = string.gsub(node.shape, "^solid%.", "")
      if node.longest and node.bare.length and node.density then by_size(d, m, node, growth, name) end
      if not node.bare or node.measure ~= "volume" then return end
      if node.density and node.bare.density then by_density(d, m, node, size, name) end
      if node.mass and (node.bare.length or node.bare.mass) then by_mass(d, m, node, growth, name) end
      return
    end
    if node.op == "scaled" then
      for i = 1, 3 do growth = growth * math.abs(m:double(node.k[i])) end
    end
    look(node.of or node[1], growth)
    if node.op == "sum" then look(node[2], growth) end
  end
  look(m.symbolic.body, 1)
end

return plausible
