-- broken.lua -- what a name that does not exist stands for, so that the script can go on.
--
-- Everything that can be done with it gives the same object again and says nothing: the slip has been reported where
-- the name was read.  A message that quotes it is a consequence of that slip; diag.lua knows such messages by the mark,
-- which is the object's text and, in Lua's own messages, the name of its type.  A leaf.
-- SPDX-License-Identifier: GPL-3.0-or-later

local broken = {}

broken.mark = "\1nothing\1"

local meta = { __name = broken.mark }
local object = setmetatable({}, meta)
broken.object = object

function broken.is(x) return rawequal(x, object) end

local function itself() return object end

for _, event in ipairs { "add", "sub", "mul", "div", "mod", "pow", "unm", "idiv", "band", "bor", "bxor", "shl", "shr",
  "bnot", "concat" } do
  meta["__" .. event] = itself
end

local most_entries = 16 -- ipairs of it must end

function meta.__index(_, k)
  if math.type(k) == "integer" and (k < 1 or k > most_entries) then return nil end
  return object
end

-- Three values, as many as anybody takes.  They are also what a generic for needs, which then calls the first of them
-- with the other two, and must end.
function meta.__call(_, ...)
  if select("#", ...) == 2 and broken.is((...)) and broken.is((select(2, ...))) then return nil end
  return object, object, object
end

function meta.__newindex() end
function meta.__len() return 0 end
function meta.__lt() return false end
function meta.__le() return false end
function meta.__tostring() return broken.mark end

return broken
