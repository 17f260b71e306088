-- happenings.lua -- what can befall a motion, in words: each command says it so (docs/happenings.md).
--
-- The library knows no words of these: it has statuses (src/runtime/status.c), which motion.lua passes on.
-- SPDX-License-Identifier: GPL-3.0-or-later

local happenings = {
  contact_lost = "contact is lost: the plane would have to pull",
  settled = "the disc has settled flat: it would not rise again by what it falls in one time.step",
  fallen = "the disc has fallen flat, and touches the plane in a line",
  no_point = "the body touches the plane in no single point",
  no_body = "I + D(t) is no body's tensor: a principal moment is more than the other two together",
  infinite = "the state is not finite",
  no_steps = "no steps lead on",
  long_step = "the step is too long: |q| is not 1",
}

-- What becomes of a member of a sweep, in the order of `enum sweep_status` (templates/sweep/sweep.h); the checks of
-- NAME_init follow.
happenings.members = { "ok", "accuracy missed", happenings.infinite, happenings.long_step, happenings.contact_lost,
  happenings.settled, happenings.fallen, happenings.no_body, "initial state is none" }

-- The words with a time, as text: "contact is lost at t = 0.5 s: the plane would have to pull".
function happenings.at(said, t)
  return (string.gsub(said, "^[^:]*", function(what) return what .. " at t = " .. t .. " s" end))
end

-- A failure of a motion (motion.lua) as messages have it.
function happenings.said(failure)
  return (failure.t and string.format("at t = %.6g s: ", failure.t) or "") .. failure.text
end

return happenings
