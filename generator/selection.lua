-- selection.lua -- which functions of a scene are called for: gen --only, --with analysis, orbit, jacobians, attitude.
--
--     local s = selection.new({ only = {names} | nil, analysis = bool | nil, orbit = bool | nil,
--                               jacobians = bool | "transition" | nil, attitude = bool | nil,
--                               also = {names} | nil }, full)
--     full: does the closed form give the whole state, so that its halves need not stand there?
--     s.asked(name) -> bool       is the function emitted for the user?  Names without the scene's prefix
--     s.made(name) -> bool        must its equations be made: it is asked for, or another function may need it
--     s.only                      are functions named, as by --only?
--     s.orbit                     may a function of the closed form be asked for?
--     s.estimator                 is a function of the estimator among those of --only?
--     selection.room(name, of) -> "motion" | "batch" | "orbit" | "estimator" | "analysis": the file that it belongs to
--                                 of: the room of the text that it stands in
--     selection.attitude(asked) -> bool    is one of the functions asked for that give the attitude in other numbers?
--     selection.tails             what these files' names end in
-- Nothing given: everything but the attitude in other numbers, as the program needs it that compares its own functions.
-- SPDX-License-Identifier: GPL-3.0-or-later

local selection = {}

local function set(words)
  local out = {}
  for word in string.gmatch(words, "%S+") do out[word] = true end
  return out
end

-- What studies a body or a state, and moves none.
local ANALYSIS = set [[inertia_at particle_energy torque rate acceleration jacobian jacobian_p jacobian_u initial_p
  energy_gradient integral_gradient momentum_gradient stable_up stable_down stable_straight
  stable_edge steady_spin steady_nod disc_tilt disc_integrals disc_rates disc_swing principal_of principal stability
  linearised spin_stable]]

-- The derivatives among them: these are asked for by --with jacobians.
local DERIVATIVES = set "jacobian jacobian_p jacobian_u initial_p energy_gradient integral_gradient momentum_gradient"

-- What asks a closed form for more than the state at a time: --with orbit.  The halves of the state belong to it where
-- NAME_at gives the whole.
local ORBIT = set [[at_many set_tick at_tick polhode_period precession_rate precession_period rotation_number next_flip
  nutation_period nutation_range]]
local HALVES = set "at_rates at_attitude"

-- The attitude in other numbers: these are asked for by --with attitude.
local ATTITUDE = { "matrix", "rotate", "unrotate", "rotation_vector", "euler", "set_euler" }
local ATTITUDES = set(table.concat(ATTITUDE, " "))

-- What else moves no closed form.
local MOTION = set [[init defaults initial mass inertia inertia_now energy jacobi_integral momentum_body momentum rhs
  normalise within advance contact gap impact matrix rotate unrotate rotation_vector euler set_euler]]

-- Functions of templates that call functions made of equations.
local NEEDS = { principal = "inertia", spin_stable = "inertia", solve = "inertia", step = "rhs inertia initial",
  estimator_open = "inertia", disc_integrals = "disc_tilt", disc_swing = "disc_tilt" }

-- The function of one body that a function of many is made of, or nil.
local function batched(name)
  local one = name ~= "at_many" and (string.match(name, "^(.*)_many$") or string.match(name, "^(.*)_each$"))
  return one and (string.gsub(one, "advance$", "step"))
end

-- What the names of the files end in.
selection.tails = { motion = "", batch = "_batch", orbit = "_orbit", analysis = "_analysis",
  estimator = "_estimator" }

function selection.room(name, of)
  if ANALYSIS[name] then return "analysis" end
  return (of == "orbit" or of == "batch" or of == "estimator") and of or "motion"
end

function selection.attitude(asked)
  for _, name in ipairs(ATTITUDE) do
    if asked(name) then return true end
  end
  return false
end

function selection.new(options, full)
  local only = options.only and {}
  for _, name in ipairs(options.only or {}) do only[name] = true end
  local also = {}
  for _, name in ipairs(options.also or {}) do also[name] = true end
  local whole = not only and options.analysis == nil

  local s = { only = only ~= nil, orbit = not only, estimator = false }
  for _, name in ipairs(options.only or {}) do
    local estimator = string.find(name, "^estimator_") ~= nil
    s.estimator = s.estimator or estimator
    local stepper = string.find(name, "step") or string.find(name, "_run$")
    s.orbit = s.orbit or not (ANALYSIS[name] or MOTION[name] or stepper or estimator or batched(name))
  end

  function s.asked(name)
    if only then return only[name] or false end
    if ATTITUDES[name] then return options.attitude or false end
    if whole then return true end
    local derivative = options.jacobians == true and DERIVATIVES[name]
    if ORBIT[name] or full and HALVES[name] then return options.orbit or false end
    return not ANALYSIS[name] or also[name] or options.analysis or derivative or false
  end

  -- With a list of names a step may need what its template calls.
  function s.made(name)
    if s.asked(name) then return true end
    if not only then return (name == "jacobian" and options.jacobians) and true or false end
    for _, asked in ipairs(options.only) do
      asked = batched(asked) or asked
      if asked == name then return true end
      local needs = NEEDS[asked] or string.find(asked, "step") and NEEDS.step or string.find(asked, "_run$") and
        NEEDS.step or string.find(asked, "^at") and NEEDS.solve
      if needs and string.find(" " .. needs .. " ", " " .. name .. " ", 1, true) then return true end
    end
    return false
  end

  return s
end

return selection
