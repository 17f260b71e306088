-- messages_plane.lua: the messages about the start of a body on a plane, for errors.t; rows as in messages_scenes.lua.
-- SPDX-License-Identifier: GPL-3.0-or-later

-- Of a body on a plane: its height follows from the attitude, and of one that rolls the velocity from the rates.
local function ball(law, initial)
  return 'return scene { name = "s", body = solid.sphere { r = 0.03, mass = 0.2 },\n' ..
    'effects = { effect.plane { surface = contact.sphere { r = 0.03 }, law = "' .. law .. '" } },\ninitial = { ' ..
    initial .. " } }"
end
local ROLLS = "initial: velocity must be that of rolling, V = U - w x r of effect.plane (line 2): omega and " ..
  "attitude give %s m/s (leave velocity out, or give the omega that rolls so), got %s m/s"
local HIGH = "initial: position must have the centre of mass as high as the attitude puts it where the body touches " ..
  "the plane (line 2): 0.03 m above, or 0, which leaves it to the attitude (a body that starts in the air needs " ..
  "effect.translation, and impact of effect.plane), got %s m"
local on_plane = { about = "the start on a plane",
  { ball("rolling", "velocity = { 0.5, 0, 0 }"), 3, string.format(ROLLS, "{0, 0, 0}", "{0.5, 0, 0}") },
  -- w x r of w = 10 about y and r = -0.03 z is -0.3 along x, so the centre has +0.3; half a percent is beyond rounding
  { ball("rolling", "omega = { 0, 10, 0 }, velocity = { 0.3015, 0, 0 }"), 3,
    string.format(ROLLS, "{0.3, 0, 0}", "{0.3015, 0, 0}") },
  { ball("rolling", "omega = { 0, 10, 0 },\nvelocity = { -0.3, 0, 0 },\nposition = { 0, 0, -0.03 }"),
    { 4, string.format(ROLLS, "{0.3, 0, 0}", "{-0.3, 0, 0}") }, { 5, string.format(HIGH, "-0.03") } },
  { ball("smooth", "position = { 1, 2, 0.5 }"), 3, string.format(HIGH, "0.5") },
  { ball("smooth", "velocity = { 1, 0, 1e-2 }"), 3, "initial: velocity must keep the body on the plane (line 2): " ..
    "omega and attitude give 0 m/s along its normal, or 0, which leaves it to them, got 0.01 m/s" },
}

return { on_plane }
