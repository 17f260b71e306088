-- throw.lua -- the two logs of docs/throw.md: a book in the air, and the same book swinging, as a phone in it says.
--
--     lua5.4 docs/tools/throw.lua DIRECTORY     writes phone.csv and swing.csv
-- They are simulated: classical Runge-Kutta with short steps, no code of the generator; normal noise (Box and Muller)
-- from a generator with a fixed seed.  The truth is TRUTH; tests/docs/throw.t compares what the page finds with it.
-- SPDX-License-Identifier: GPL-3.0-or-later

local throw = {}

throw.TRUTH = { I1 = 1.2e-3, I2 = 2.31 * 1.2e-3, I3 = 3.12 * 1.2e-3, bias = { 0.021, -0.034, 0.012 },
  rates = { 0.9, 11.6, -0.6 }, noise = 0.01, mass = 0.81, arm = 0.105, gravity = 9.81, friction = 2.5e-4,
  angle = 0.6, hinge = 2.31 * 1.2e-3 + 0.81 * 0.105 ^ 2 }

local seed = 20261123

-- Knuth's MMIX generator, its upper 53 bits, in (0, 1).
local function uniform()
  seed = seed * 6364136223846793005 + 1442695040888963407
  return ((seed >> 11) + 0.5) / (1 << 53)
end

local function normal() return math.sqrt(-2 * math.log(uniform())) * math.cos(2 * math.pi * uniform()) end

local function moved(x, k, h)
  local y = {}
  for i = 1, #x do y[i] = x[i] + h * k[i] end
  return y
end

-- x after the time T, in n steps.
local function after(f, x, T, n)
  local h = T / n
  for _ = 1, n do
    local k1 = f(x)
    local k2 = f(moved(x, k1, h / 2))
    local k3 = f(moved(x, k2, h / 2))
    local k4 = f(moved(x, k3, h))
    for i = 1, #x do x[i] = x[i] + h / 6 * (k1[i] + 2 * k2[i] + 2 * k3[i] + k4[i]) end
  end
  return x
end

local function euler(w)
  local t = throw.TRUTH
  return { (t.I2 - t.I3) / t.I1 * w[2] * w[3], (t.I3 - t.I1) / t.I2 * w[3] * w[1], (t.I1 - t.I2) / t.I3 * w[1] * w[2] }
end

local function pendulum(x)
  local t = throw.TRUTH
  return { x[2], (-t.mass * t.gravity * t.arm * math.sin(x[1]) - t.friction * x[2]) / t.hinge }
end

local function phone()
  local lines, w, t = { "t [s],gx [rad/s],gy [rad/s],gz [rad/s]" }, { table.unpack(throw.TRUTH.rates) }, throw.TRUTH
  for i = 0, 200 do
    local cells = { string.format("%.3f", i * 0.005) }
    for k = 1, 3 do cells[k + 1] = string.format("%.4f", w[k] + t.bias[k] + t.noise * normal()) end
    lines[#lines + 1] = table.concat(cells, ",")
    w = after(euler, w, 0.005, 50)
  end
  return table.concat(lines, "\n") .. "\n"
end

local function swing()
  local lines, x, t = { "t [s],gy [rad/s]" }, { throw.TRUTH.angle, 0 }, throw.TRUTH
  for i = 0, 500 do
    lines[#lines + 1] = string.format("%.2f,%.4f", i * 0.02, x[2] + t.bias[2] + t.noise * normal())
    x = after(pendulum, x, 0.02, 50)
  end
  return table.concat(lines, "\n") .. "\n"
end

function throw.logs()
  seed = 20261123
  local first = phone()
  return { ["phone.csv"] = first, ["swing.csv"] = swing() }
end

if arg and arg[0] and arg[0]:find "throw%.lua$" then
  for name, text in pairs(throw.logs()) do
    local file = assert(io.open(arg[1] .. "/" .. name, "w"))
    file:write(text)
    file:close()
  end
end

return throw
