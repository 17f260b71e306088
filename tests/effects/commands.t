#!/usr/bin/env lua5.4
-- commands.t - random scenes with parameters everywhere: gen by any method, explain and run do them or say why not.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Two to five effects, three of four numbers parameters (scenes.lua).  gen writes C that gcc and clang compile without
-- a warning in either type of numbers and whose self-test passes, or refuses the method on a line of the scene; explain
-- says what it has to say; both roads run, to numbers; a body on a plane may lose contact, or be refused as the plane
-- would have to pull it, or told that fixed steps are too long for it.  No other status, no warning.  One scene in
-- fifty may be too large for the bound on a scene's algebra, which keeps a hostile scene to some seconds.
-- POLHODE_SCENES=2000 POLHODE_SEED=7: so many, from that seed; finds are printed whole.  `polhode check` of such scenes
-- is product.t's.

package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local tier = require "tests.tier"
local program = require "tests.cli.program"
local scenes = require "tests.effects.scenes"

local dir = program.directory()
local binary = os.getenv "POLHODE" or "build/polhode"
local count = tonumber(os.getenv "POLHODE_SCENES") or tier.quick and 5 or tier.some and 30 or 60
local seed = tonumber(os.getenv "POLHODE_SEED") or 23
local STRICT = "-std=c99 -pedantic -Wall -Wextra -Wconversion -Wdouble-promotion -Wshadow -Werror"
local METHODS = { "rk4", "adaptive", "taylor", "semi", "midpoint", "split2", "split4", "split6" }
local MORE = { "", " --with jacobians", " --with compensated", " --bake", " --libm own", " --with analysis",
  " --with batch", " --layout header", " --only step,energy" }

local function shell(...)
  local command = string.format(...)
  -- processor time: a busy machine finds nothing
  return program.output(string.format("(cd %s && ulimit -t 60 && %s)", dir, command))
end

-- What is wrong with the scene, or nil.
local refused, written, large = 0, 0, 0
local function fault(random, touches)
  local function any(list) return list[random:random(#list)] end
  local path = binary:find "^/" and binary or os.getenv "PWD" .. "/" .. binary
  local method, real = any(METHODS), any { "double", "float" }
  if touches and random:random(2) == 1 then method = METHODS[random:random(3)] end -- those that step on a plane
  local function too_large(status, err)
    local bound = status == 1 and err:find "^s%.lua:%d+: scene: the scene's algebra makes more than %d+ MiB of terms"
    if bound then large = large + 1 end
    return bound
  end
  local gen = string.format("%s gen s.lua -o o --method %s --real %s%s", path, method, real, any(MORE))
  local status, _, err = shell("rm -rf o; %s", gen)
  if too_large(status, err) then return nil end
  if status == 1 and err:find "^s%.lua:%d+: " then
    refused = refused + 1
  elseif status ~= 0 or err ~= "" then
    return gen .. "\n" .. status .. " " .. err
  else
    written = written + 1
    local said
    status, said, err = shell("gcc %s -O1 -o t o/s*.c -lm && clang %s -fsyntax-only o/s*.c && ./t",
      STRICT .. (gen:find "header" and " -DS_IMPLEMENTATION" or ""), STRICT)
    if status ~= 0 or err ~= "" or not said:find "\n1%.%.%d+\n$" then
      return gen .. "\n" .. err .. said:gsub("\nok[^\n]*", "")
    end
  end
  local explain = string.format("%s explain s.lua --format %s", path, any { "text", "json", "latex" })
  local out
  status, out, err = shell("%s", explain)
  if too_large(status, err) then return nil end
  if status ~= 0 or err ~= "" or #out < 200 then return explain .. "\n" .. status .. " " .. err end
  local run = string.format("%s run s.lua --until 1 --every 0.5 %s", path, any { "--engine general",
    "--engine general --method rk4 --step 0.01", "--engine generated", "--engine generated --method adaptive" })
  status, out, err = shell("%s", run)
  local lost = touches and (err:find "event contact_lost at" or err:find "event lies_flat at")
  err = err:gsub("event %S+ at t = %S+ s\n", "")
  local long = touches and run:find "rk4 " and err:find "^polhode run: at t = " and err:find "what helps: %-%-step"
  if touches and status == 3 and (long or err:find "the plane would have to pull") then return nil end
  if touches and (err:find "^warning: rk4 with steps of [%d.]+ s: its error is estimated" or
    err:find "^warning: rk4 with steps of [%d.]+ s: no digit is known") then err = "" end
  local rows = select(2, out:gsub("\n", ""))
  err = err:gsub("warning: the disc has [^\n]*; the run ends there\n", "")
  err = err:gsub("^warning: without %-%-input FILE%.csv these inputs are 0: ux, uy, uz\n", "")
  if status ~= 0 or err ~= "" or (rows ~= 4 and not (lost and rows > 1 and rows < 4)) or out:find "nan" or
    out:find "inf" then
    return run .. "\n" .. status .. " " .. err .. out
  end
end

local random = scenes.new(seed, 0)
local done, bad = 0, 0
while done < count do
  local list, n = {}, 1 + random:random(4)
  for i = 1, n do list[i] = scenes.draw(random) end
  if select(2, scenes.fits(list)) then
    done = done + 1
    local body = ({ "diagonal", "symmetric", "full" })[random:random(3)]
    local text = scenes.text(scenes.new(seed + 7919*done, 0.75), "s", body, list)
    program.write(dir .. "/s.lua", text)
    local why = fault(random, text:find("effect.plane", 1, true))
    if why then
      bad = bad + 1
      tap.ok(false, "scene " .. done, why .. "\n" .. text)
    end
  end
end
tap.is(bad, 0, done .. " scenes: " .. written .. " written and compiled, " .. refused .. " methods refused")
tap.ok(2*written > refused, "more than a third are taken")
tap.ok(large <= count/50, large .. " are too large")
tap.done(program.finish())
