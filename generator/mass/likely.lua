-- likely.lua -- a tensor that a body can have, and that is all the same unlikely to be meant: warnings about units.
--
-- A number without a unit is in SI units.  Where the density that follows from a mass and its moments is no solid's,
-- and another unit makes it an ordinary one, the number was probably meant so.  The density decides, not the size:
-- planets, dust and molecules are as good as bricks.
-- SPDX-License-Identifier: GPL-3.0-or-later

local diag = require "generator.diag"
local jacobi = require "generator.mass.jacobi"

local likely = {}

-- The largest principal moment of a body of volume V is smallest for a ball, where M/k^3 = (5/2)^1.5 M/r^3 = 16.6 times
-- the density (k: the radius of gyration that belongs to the largest moment).  Nothing on Earth is denser than osmium,
-- 22590 kg/m^3: above 16.6*22590 the tensor is too small for its mass.  There is no such bound below; thin structures
-- (booms, sails of 100 m and 10 kg) have some 1e-3 kg/m^3, and 1e-4 leaves them in peace.
local heaviest, lightest = 3.75e5, 1e-4

local others = { { 1e-6, "kg mm^2" }, { 1e-9, "g mm^2" }, { 1e-4, "kg cm^2" }, { 1e-7, "g cm^2" }, { 1e-3, "g m^2" } }

-- The mass of a molecule is in its nuclei, and the bound above is none for it: the heaviest have some 1e-17 kg, and
-- would be 3e-8 m as a ball of osmium.
local molecule = { size = 1e-8, mass = 1e-17 }

-- One tensor: its mass, centre and central tensor in doubles.  warn(text) says what is unlikely.
function likely.tensor(warn, mass, com, I)
  local moment = jacobi.run(I)[3]
  if not (moment > 0 and mass > 0) then return end
  local k = math.sqrt(moment / mass)
  local density = mass / k / k / k
  local about = "the radius of gyration sqrt(I/mass) is " .. diag.rough(k) .. " m"
  if density < lightest then
    local guess = ""
    for _, o in ipairs(others) do -- the first unit that gives a body of ordinary density
      local r = math.sqrt(moment * o[1] / mass)
      local then_density = mass / r / r / r
      if guess == "" and then_density > 1 and then_density < heaviest then
        guess = " (in " .. o[2] .. " it would be " .. diag.rough(r) .. " m)"
      end
    end
    warn("the moments look too large for the mass: " .. about .. guess)
  elseif density > heaviest and (k > molecule.size or mass > molecule.mass) then
    local grams = math.sqrt(moment / mass * 1e3)
    local fits = mass * 1e-3 / grams ^ 3 < heaviest and mass * 1e-3 / grams ^ 3 > 1
    warn("the moments look too small for the mass, denser than any metal: " .. about ..
      (fits and " (with the mass in g it would be " .. diag.rough(grams) .. " m)" or ""))
  end
  local far = math.sqrt(com[1] ^ 2 + com[2] ^ 2 + com[3] ^ 2)
  if far > 1e3 * k then -- 300 mm typed as 300 m beside a body of 10 cm
    warn("com is " .. diag.rough(far) .. " m from the origin, " .. diag.rough(far / k) ..
      " radii of gyration: is it in metres?")
  end
end

return likely
