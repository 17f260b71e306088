-- messages_names.lua: the messages about names that nobody made, for errors.t.  Each row's list is all that may be
-- said: one slip, one message, whatever the scene goes on to do with what the name stands for.
-- SPDX-License-Identifier: GPL-3.0-or-later

local forms = require "tests.dsl.forms"
local BOX, body, with, after, box = forms.BOX, forms.body, forms.with, forms.after, forms.box

local function unknown(name, hint)
  return "script: unknown name \"" .. name .. "\"" .. (hint and " (" .. hint .. ")" or "")
end

-- In a place where what is nil would be a default, or a hole.
local silent = { about = "names that are nothing",
  { box "leng", 2, unknown "leng" },
  { body "solid.box { x = 1, y = 2, z = 3, mass = 1, density = rho }", { 2, unknown "rho" },
    { 2, "box: give mass or density, not both" } },
  { with "effects = { effect.gravity { g = gee } }", 3, unknown "gee" },
  { with "effects = { effect.wheel { axis = {0, 0, 1}, inertia = 1, torque = TW, included = true } }", 3,
    unknown "TW" },
  { with "effects = { effect.control {}, brake, effect.control {} }", 3, unknown "brake" },
  { with "effects = { effect.control {}, brake }", 3, unknown "brake", name = "the last entry of a list" },
  { with "effects = brake", 3, unknown "brake", name = "the whole list" },
  { with "effects = { effect.translation { drag = Cd } }", 3, unknown "Cd" },
  { with "effects = { effect.damping { c = { 1, Cd, 1 } } }", 3, unknown "Cd", name = "inside a vector" },
  { with "effects = { effect.spring { stiffness = 1, rest = Rest } }", 3, unknown "Rest" },
  { with "effects = { effect.custom { torque = pull } }", 3, unknown "pull" },
  { with "effects = { effect.custom { torque = function(s) return { 0, 0, Tz } end } }", 3, unknown "Tz" },
  { with "effects = { effect.custom { params = { gain = Kp }, torque = function(s) return {0, 0, s.gain*s.t} end } }",
    3, unknown "Kp" },
  { with "effects = { effect.custom { states = { heat = { initial = T0, rate = function(s) return 0 end } } } }", 3,
    unknown "T0" },
  { with "origin = middle", 3, unknown "middle" }, { with "initial = start", 3, unknown "start" },
  { with "initial = { omega = {0, w0, 1} }", 3, unknown("w0", "nearest: wx, wy, wz") },
  { with "initial = { omega = rates0, attitude = lean }", { 3, unknown "rates0" }, { 3, unknown "lean" } },
  { with "initial = { attitude = { axis = \"x\", angle = tilt } }", 3,
    unknown("tilt", "tilt is a word of `when` of events alone") },
  { with 'effects = { effect.torque { body = { N, v1*0.1, 0 } } }, measure = { a = wx, b = slip }',
    { 3, unknown("N", "N is a word of `when` of events alone") },
    { 3, unknown("v1", "v1 is a word of `when` of events alone") },
    { 3, unknown("slip", "slip is a word of `when` of events alone") } },
  { after 'local height_2 = height', 1, unknown("height", "height is a word of `when` of events alone") },
  { with "time = { horizon = T1, step = {} }", { 3, unknown "T1" }, { 3, "time: step must be a number, got a table" } },
  { with "accuracy = eps", 3, unknown "eps" }, { with "outputs = { attitude }", 3, unknown "attitude" },
  { with "budget = { ops = n_ops, real = float }", { 3, unknown "n_ops" }, { 3, unknown("float") } },
  { with "ranges = { omega = rates0, attitude = any, wx = { lowest, 1 } }", { 3, unknown "rates0" },
    { 3, unknown "any" }, { 3, unknown "lowest" } },
  { with "events = { { name = \"up\", when = heigt, stop = yes } }", { 3, unknown "heigt" },
    { 3, unknown "yes" } },
  { with "events = { ground }", 3, unknown "ground" },
  { body "points{{1, x0, 0, 0}, {1, 1, 0, 0}, row3}", { 2, unknown "x0" }, { 2, unknown "row3" } },
  { body "tensor { xx = Ixx, yy = 1, zz = 1, mass = 1 }", 2, unknown "Ixx" },
  { body "mesh { file = part, mass = 1 }", 2, unknown "part" },
  { body "part", 2, unknown "part" },
}

-- What the script does with it says nothing more.
local consequences = { about = "consequences",
  { after "local a = nix.x.y.z", 1, unknown "nix" }, { after "local a = nix(1)(2){}:at{1, 2, 3}", 1, unknown "nix" },
  { after "if nix then local a = 1 end", 1, unknown "nix" },
  { after "local a = -nix + 1 - 2*nix/3 % 4 .. \"x\" .. nix", 1, unknown "nix" },
  { after "local a = nix < 1 or 1 <= nix or nix == 1 or #nix > 0", 1, unknown "nix" },
  { after "for i = 1, nix do end", 1, unknown "nix" }, { after "for _, e in ipairs(nix) do end", 1, unknown "nix" },
  { after "for k, e in pairs(nix) do end", 1, unknown "nix" },
  { after "for k, e in pair({1, 2}) do local b = e*2 end", 1, unknown("pair", "nearest: pairs") },
  { after "while nix do end", 1, unknown "nix", name = "a loop that does not end" },
  { after "local b = math.floor(nix)", 1, unknown "nix" },
  { after "nix.a = 1 nix.b.c = 2", 1, unknown "nix" },
  { 'local a = param("a", 1, "m")\nlocal b = (a + nix*a)^2/nix - sqrt(nix) + sin(nix)\n' .. box "b", 2,
    unknown "nix" },
  { 'local a = param("a", 1, "m")\nif a < nix then a = nix end\n' .. box "a", { 2, unknown "nix" } },
  { after("local b = (" .. BOX .. " + nix):at{1, 2, nix}"), 1, unknown "nix" },
  { after 'param("a", nix, "m") quantity(nix, "m") exact(nix)', 1, unknown "nix" },
  { after 'param(nix, 1, "m")', 1, unknown "nix" },
  { "return nix\n", 1, unknown "nix" },
  { "local x = nix\nlocal t\nt.a = 1\n", { 1, unknown "nix" },
    { 3, "script: attempt to index a nil value (local 't')" }, name = "what is wrong beside it is told" },
}

local hints = { about = "what was meant",
  { 'local Cw = param("Cw", 1, "m")\n' .. box "Cd*Cw", { 3, unknown("Cd", "nearest: Cw") } },
  { 'local length = 1\n' .. box "lenght", { 3, unknown("lenght", "nearest: length") } },
  { 'length = 1\n' .. box "Length", { 3, unknown("Length", "nearest: length") } },
  { 'local function f(width) return with*2 end\n' .. box "f(1)", { 1, unknown("with", "nearest: width") } },
  { 'local width = 1\nlocal function f() local w = width return wdth end\n' .. box "f(1)",
    { 2, unknown("wdth", "nearest: width") } },
  { 'do local alpha, gamma = 1, 2 end\n' .. box "gamma", 3,
    unknown("gamma", "the local of line 1 is not visible here") },
  { 'param("TW", 1, "m")\n' .. box "TW",
    { 3, unknown("TW", "to use the parameter, write local TW = param(\"TW\", ...)") } },
  { after 'param("a", 20, mm)', 1, unknown("mm", "a unit is written as text: \"mm\"") },
  { with 'initial = { attitude = euler { "zxz", 0, 1, 0 } }', 3, unknown("euler", "a rotation is a table: " ..
    "{ euler = \"zxz\", angles = {a, b, c} }; degrees are quantity(30, \"deg\")") },
  { "local a = (30 deg)\n", 1, "syntax: ')' expected near 'deg' (a unit is given by quantity(30, \"deg\"))" },
  { body "box { x = 1 }", 2, unknown("box", "there is shell.box, solid.box") },
  { body "spher { r = 1 }", 2, unknown("spher", "nearest: contact.sphere, shell.sphere, solid.sphere") },
  { body "solids.box { x = 1 }", 2, unknown("solids", "nearest: solid") },
  { with "effects = { effects.gravity {} }", 3, unknown("effects", "nearest: effect") },
  { with "effects = { effect.gravty {} }", 3, "effect: has no \"gravty\" (nearest: gravity)" },
  { box "math.PI", 2, "math: has no \"PI\" (nearest: pi)" },
  { after "string.find('a', 'b')", 1, "string: has no \"find\"" },
  { box "_ENV.leng", 2, unknown "leng", name = "through _ENV" },
}
for _, code in ipairs { "require 'os'", "io.write 'x'", "os.exit(0)", "local a = _G.x", "print(1)" } do
  local name = string.match(code, "_G") or string.match(code, "%l+")
  hints[#hints + 1] = { after(code), 1,
    unknown(name, "Lua has it, a scene has not: it sees only a part of Lua's library") }
end

-- What a scene leaves to the command line, and what a function of the scene receives.
local OPTION = "; this is an option of the command line: "
local TIME = "time: unknown argument \"%s\" (it has horizon, step" .. OPTION .. "--%s)"
local ONE = "effect.custom%s: %s must be a function of one argument, function(s): a name of params or states is " ..
  "read as s.NAME, got %d arguments"
local others = { about = "what is said elsewhere",
  { with "time = { method = \"rk4\" }", 3, TIME:format("method", "method") },
  { with "time = { step = 1, tolerance = 1e-9 }", 3, TIME:format("tolerance", "tolerance") },
  { with "integrator = \"rk4\"", 3, "scene: unknown argument \"integrator\" (it has name, body, origin, effects, " ..
    "initial, time, accuracy, budget, ranges, outputs, events, measure" .. OPTION .. "--method)" },
  { with "effects = { effect.custom { params = { gain = 2 }, torque = function(s, p) return {0, 0, p.gain} end } }",
    3, ONE:format("", "torque", 2) },
  { with "effects = { effect.custom { potential = function(s, p, q) return p.gain end } }", 3,
    ONE:format("", "potential", 3) },
  { with "effects = { effect.custom { states = { heat = { rate = function(s, p) return p.gain end } } } }", 3,
    ONE:format(", state heat", "rate", 2) },
  { "local function pull(s, p)\n  return {0, 0, p.gain}\nend\n" .. with "effects = { effect.custom { torque = pull } }",
    1, ONE:format("", "torque", 2), name = "the line of the function" },
}

local many = { about = "many names", {} }
do
  local lines, faults = {}, {}
  for i = 1, 15 do
    lines[i] = "local v" .. i .. " = missing_value_" .. i
    faults[i] = { i, unknown("missing_value_" .. i) }
  end
  many[1] = { table.concat(lines, "\n") .. "\n" .. body(BOX), table.unpack(faults) }
  many[1].name = "each is reported"
end

return { silent, consequences, hints, others, many }
