-- progress.lua -- how far a long command is and how long is left, on standard error while that is a terminal.
--
--     local bar = progress.of(host, command)        command: of one that takes minutes, its name; it tells without a
--                                                   terminal, too, by a line now and then
--     bar.show("compiling", 0.3)    what is done; the part of the work that is behind, 0 to 1
--     bar.clear()                   before anything else is printed
--     local seen, done = progress.along(host, finish, words)   of a motion: seen(t), as often as one likes; done() at
--                                                              its end; words(t): what is shown of a time
--     progress.left(elapsed, part) -> "12 s left", or "" while it would be a guess
-- The rest is taken to go as fast as what is behind.  Else nothing is printed, not even a byte, where there is no
-- terminal.
-- SPDX-License-Identifier: GPL-3.0-or-later

local progress = {}

local WIDE, WORDS, LEFT = 24, 30, 16 -- of the bar, of what is done, of what is left
local EARLY, SHORT = 0.05, 1 -- a part, and seconds, before which nothing is foretold
local SELDOM = 10 -- s between two lines without a terminal

function progress.left(elapsed, part)
  if part < EARLY or elapsed < SHORT or part >= 1 then return "" end
  local seconds = math.ceil(elapsed * (1 - part) / part)
  if seconds < 60 then return string.format("%d s left", seconds) end
  if seconds < 3600 then return string.format("%d min %d s left", seconds // 60, seconds % 60) end
  return string.format("%d h %d min left", seconds // 3600, seconds % 3600 // 60)
end

local function filled(text, wide) return string.sub(text .. string.rep(" ", wide), 1, wide) end

local function nothing() return { show = function() end, clear = function() end } end

-- A line of its own, now and then.
local function lines(host, command)
  local began = host.clock()
  local last = began
  return {
    show = function(what, part)
      local now = host.clock()
      if now - last < SELDOM then return end
      last = now
      local left = progress.left(now - began, part)
      host.err(string.format("polhode %s: %d %% done%s; %s\n", command, math.floor(100 * part),
        left ~= "" and ", " .. left or "", what))
    end,
    clear = function() end,
  }
end

function progress.of(host, command)
  if not host.isatty "err" then return command and lines(host, command) or nothing() end
  local began, shown = host.clock(), false
  return {
    show = function(what, part)
      shown = true
      part = math.max(0, math.min(1, part))
      local full = math.floor(WIDE * part)
      host.err("\r[" .. string.rep("#", full) .. string.rep(".", WIDE - full) .. "] " .. filled(what, WORDS) .. " " ..
        filled(progress.left(host.clock() - began, part), LEFT))
    end,
    clear = function()
      if shown then host.err("\r" .. string.rep(" ", WIDE + WORDS + LEFT + 4) .. "\r") end
      shown = false
    end,
  }
end

local OFTEN = 0.25 -- s between two lines of a motion

-- Short motions show nothing.
function progress.along(host, finish, words)
  local bar, last = progress.of(host), host.clock() + SHORT
  local function seen(t)
    local now = host.clock()
    if now - last < OFTEN then return end
    last = now
    bar.show(words(t), finish > 0 and t / finish or 1)
  end
  return host.isatty "err" and seen or nil, bar.clear
end

return progress
