-- keep.lua -- what a sweep keeps of each member: --keep KIND or KIND: [NAME =] EXPRESSION.
--
--     keep.read(host, job, list, wrong) -> keeps (emit/members.lua), the times of `states`
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local diag = require "generator.diag"
local expression = require "generator.dsl.expression"
local options = require "generator.commands.options"

local keep = {}

keep.kinds = { "final", "max", "min", "first", "rise", "fall", "states", "drift" }

local ABOUT = { final = "at the end", max = "greatest value on the way", min = "least value on the way",
  first = "time of the first passage through zero", rise = "time of the first upward passage through zero",
  fall = "time of the first downward passage through zero" }

local function words_of(job)
  local words = { { "t", "s" } }
  for _, s in ipairs(job.states) do words[#words + 1] = { s.name, s.unit } end
  return words
end

-- The times of states: FROM:TO:COUNT.
local function times(text, finish)
  local a, b, n = string.match(text, "^%s*([^:]+):([^:]+):([^:]+)%s*$")
  a, b, n = a and R.parse(a), b and R.parse(b), n and R.parse(n)
  if not (a and b and n) then return nil, "must be FROM:TO:COUNT" end
  local from, to = R.todouble(a), R.todouble(b)
  if not R.isint(n) or n < R.new(2) or n > R.new(100000) then return nil, "must have a count from 2 to 100000" end
  if from < 0 or to <= from then return nil, "must have times that ascend from 0 on" end
  if to > finish * (1 + 1e-12) then
    return nil, "must end at the motion's end of " .. diag.show(finish) .. " s at the latest (--until)"
  end
  local list, count = {}, R.toint(n)
  for i = 0, count - 1 do list[i + 1] = i == count - 1 and to or from + (to - from) * (i / (count - 1)) end
  return list
end

local function expression_of(host, job, kind, text, given, wrong)
  local name, rest = string.match(text, "^%s*([%a_][%w_]*)%s*=%s*([^=].*)$")
  local d = diag.new("--keep", rest or text)
  local read = expression.read(host, d, rest or text, words_of(job), job.model.params)
  if not read then
    wrong[#wrong + 1] = "--keep \"" .. given .. "\": " .. string.gsub(d.errors[1].message, "^expression: ", "")
    return nil
  end
  local passage = ABOUT[kind] and string.find(ABOUT[kind], "^time") ~= nil
  return { kind = kind, name = name, e = read.e, unit = passage and "s" or read.unit,
    about = string.match(rest or text, "^%s*(.-)%s*$") .. ", " .. ABOUT[kind] }
end

-- Names of the columns that have none, and none twice.
local function name_all(list, taken, wrong)
  local counts = {}
  for _, k in ipairs(list) do
    counts[k.kind] = (counts[k.kind] or 0) + 1
    if k.kind ~= "state" and k.kind ~= "states" then
      k.name = k.name or (k.kind == "drift" and "drift" or k.kind .. "_" .. string.format("%d", counts[k.kind]))
      if taken[k.name] then wrong[#wrong + 1] = "--keep: the column " .. k.name .. " is there twice" end
      taken[k.name] = true
    elseif counts[k.kind] > 1 then
      wrong[#wrong + 1] = "--keep " .. (k.kind == "state" and "final" or k.kind) .. " stands there twice"
    end
  end
end

function keep.read(host, job, list, finish, taken, wrong)
  local out, course = {}, {}
  for _, given in ipairs(list or { "final" }) do
    local kind, rest = string.match(given, "^%s*(%a+)%s*:?(.*)$")
    local known = false
    for _, word in ipairs(keep.kinds) do known = known or word == kind end
    local empty = not rest or not string.find(rest, "%S")
    local function say(rule) wrong[#wrong + 1] = "--keep " .. rule .. ", got " .. given end
    if not known then
      say("must be one of " .. table.concat(keep.kinds, ", ") .. " with an expression behind a colon")
      if kind then wrong[#wrong] = wrong[#wrong] .. options.meant(kind, keep.kinds) end
    elseif kind == "final" and empty then
      out[#out + 1] = { kind = "state" }
    elseif kind == "drift" then
      if not empty then say "drift takes nothing" end
      out[#out + 1] = { kind = "drift", unit = "J", about = job.conserved.rate and "change of Jacobi's integral" or
        "change of the energy" }
    elseif kind == "states" then
      local t, rule = times(rest, finish)
      if not t then say("states: " .. rule) end
      if t then
        course = t
        out[#out + 1] = { kind = "states" }
      end
    elseif empty then
      say(kind .. ": needs an expression behind a colon")
    else
      out[#out + 1] = expression_of(host, job, kind, rest, given, wrong)
    end
  end
  for _, s in ipairs(job.states) do
    for _, name in ipairs { "final_" .. s.name, s.name .. "_at" } do taken[name] = true end
  end
  for _, name in ipairs { "member", "time", "status", "error" } do taken[name] = true end
  name_all(out, taken, wrong)
  return out, course
end

return keep
