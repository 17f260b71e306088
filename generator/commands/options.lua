-- options.lua -- reads a command's options and operands against its declaration.
--
-- A declaration is {["--real"] = {"double", "float"}, ["--bake"] = false, ["--step"] = "number", ["--set"] = "pair"}:
-- a list of words (with several = true: any of them, commas between; the result is also a set), a flag, or the kind of
-- value: text, number, numbers (comma list), words (comma list), pair (name=value, repeatable).  -o DIR and
-- --name=value are understood.  The result maps names without dashes.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"

local options = {}

local function split(s)
  local list = {}
  for word in string.gmatch(s .. ",", "([^,]*),") do list[#list + 1] = word end
  return list
end

local function number(s)
  local q = R.parse(s)
  return q and R.todouble(q) or nil
end

local kinds = {
  text = function(s) return s end,
  number = function(s) return number(s), "must be a number" end,
  numbers = function(s)
    local list = {}
    for i, word in ipairs(split(s)) do
      list[i] = number(word)
      if not list[i] then return nil, "must be numbers with commas between" end
    end
    return list
  end,
  words = function(s) return split(s) end,
}

-- Returns {options..., [1..n] = operands} or nil and what is wrong.  operands: {least, most}.
function options.parse(declared, operands, args)
  local out = {}
  local i = 2
  while i <= #args do
    local a = args[i]
    if string.sub(a, 1, 1) ~= "-" or a == "-" then
      out[#out + 1] = a
    else
      local name, value = string.match(a, "^(%-%-[%w-]+)=(.*)$")
      name = name or a
      local kind = declared[name]
      if kind == nil then return nil, "no option " .. name end
      local key = string.gsub(string.gsub(name, "^%-+", ""), "%-", "_")
      if kind == false then
        if value then return nil, name .. " takes no value" end
        out[key] = true
      else
        if not value then
          i = i + 1
          value = args[i]
          if not value then return nil, name .. " needs a value" end
        end
        if type(kind) == "table" then
          local chosen = kind.several and split(value) or { value }
          for _, word in ipairs(chosen) do
            local known = false
            for _, w in ipairs(kind) do known = known or w == word end
            if not known then return nil, name .. " must be " .. table.concat(kind, " or ") .. ", got " .. word end
            chosen[word] = true
          end
          out[key] = kind.several and chosen or value
        elseif kind == "pair" then
          local k, v = string.match(value, "^(%a[%w_]*)=(.+)$")
          if not k or not R.parse(v) then return nil, name .. " must be NAME=NUMBER, got " .. value end
          out[key] = out[key] or {}
          out[key][k] = v
        else
          local v, rule = kinds[kind](value)
          if v == nil then return nil, name .. " " .. rule .. ", got " .. value end
          out[key] = v
        end
      end
    end
    i = i + 1
  end
  if #out < operands[1] then return nil, "a scene file or name is missing" end
  if #out > operands[2] then return nil, "too many operands: " .. out[operands[2] + 1] end
  return out
end

-- Prints what is wrong with a scene, or why it could not be read, and returns the exit status.
function options.refuse(host, file, d, why)
  if why then
    host.err("polhode: " .. (d and "" or file .. ": ") .. why .. "\n")
    return 2
  end
  host.err(d:report())
  return 1
end

-- Warnings do not stop anything.
function options.warn(host, d)
  for _, w in ipairs(d.warnings) do host.err("warning: " .. w.text .. "\n") end
end

return options
