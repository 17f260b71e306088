-- sampling.lua -- the times at which a motion is looked at: close together where it bends.
--
-- Intervals are halved until in their middle every component of the state is where a straight line would have it, to a
-- share `bend` of the component's range.  A motion by fixed steps is looked at after whole steps only: rows in between
-- would cut them.
-- SPDX-License-Identifier: GPL-3.0-or-later

local sampling = {}

local first, most, rounds = 256, 30000, 12 -- intervals of the first round, states at most, rounds
local bend = 1 / 1000
local whole = 6000 -- states of a motion by fixed steps, at most

-- The components that are watched: what a sample has that is drawn.  Second result: of each component the place of the
-- first one of its vector, for a vector's size says what of its components is rounding.
local function components(s)
  local list, first_of = {}, {}
  for _, part in ipairs { s.q or {}, s.w or {}, s.space or {}, s.r or {}, s.v or {}, s.point or {}, { s.N } } do
    for k, x in ipairs(part) do
      first_of[#list + 1] = #list + 2 - k
      list[#list + 1] = x
    end
  end
  for _, single in ipairs { s.own or {}, s.asked or {} } do
    for _, x in ipairs(single) do
      first_of[#list + 1] = #list + 1
      list[#list + 1] = x
    end
  end
  return list, first_of
end

-- Greatest less least of each component; infinite where that is rounding of the vector it belongs to.
local function ranges(samples)
  local low, high, largest = {}, {}, {}
  for _, s in ipairs(samples) do
    for k, x in ipairs(s.all) do
      low[k], high[k] = math.min(low[k] or x, x), math.max(high[k] or x, x)
    end
  end
  for k, x in ipairs(high) do
    local i = samples[1].first_of[k]
    largest[i] = math.max(largest[i] or 0.0, math.abs(x), math.abs(low[k]))
  end
  local size = {}
  for k, x in ipairs(high) do -- a constant but for rounding does not bend
    local most_of = largest[samples[1].first_of[k]]
    size[k] = x - low[k] > 1e-9 * most_of and x - low[k] or math.huge
  end
  return size
end

-- Is m off the chord from a to b in any component?
local function bent(a, m, b, size)
  local s = (m.t - a.t) / (b.t - a.t)
  for k, x in ipairs(m.all) do
    if math.abs(x - a.all[k] - s * (b.all[k] - a.all[k])) > bend * size[k] then return true end
  end
  return false
end

local function read(look, times)
  local samples, failure = look(times)
  if not samples then return nil, failure end
  for _, s in ipairs(samples) do s.all, s.first_of = components(s) end
  return samples
end

-- Samples from 0 to `finish`, look(times) -> samples in their order; or nil and a failure.  A motion that bends more
-- often than the most samples tell ends earlier: the last sample says when.
function sampling.adaptive(look, finish)
  local times = {}
  for i = 0, first do times[i + 1] = finish * (i / first) end
  local list, failure = read(look, times)
  if not list then return nil, failure end
  local open = {} -- sample -> the interval behind it is still looked at; asked by place, never walked through
  for _, s in ipairs(list) do open[s] = true end
  for _ = 1, rounds do
    local middles, size = {}, ranges(list)
    for i = 1, #list - 1 do
      if open[list[i]] then middles[#middles + 1] = list[i].t + (list[i + 1].t - list[i].t) / 2 end
    end
    if #middles == 0 then return list end
    if #list + #middles > most then -- the first half of the time alone
      local half = list[#list].t / 2
      while list[#list].t > half do list[#list] = nil end
      while middles[#middles] and middles[#middles] > list[#list].t do middles[#middles] = nil end
    end
    local new
    new, failure = read(look, middles)
    if not new then return nil, failure end
    local merged, n = {}, 0
    for i, s in ipairs(list) do
      merged[#merged + 1] = s
      if open[s] and list[i + 1] then
        n = n + 1
        local m, still = new[n], bent(s, new[n], list[i + 1], size)
        merged[#merged + 1] = m
        open[s], open[m] = still, still
      end
    end
    list = merged
  end
  return list
end

-- The times of a motion by steps h: whole numbers of them, and the end.
function sampling.steps(finish, h)
  local n = math.max(1, math.floor(finish / h * (1 + 1e-12)))
  local stride, list = math.max(1, math.ceil(n / whole)), {}
  for i = 0, n, stride do list[#list + 1] = i * h end
  if list[#list] < finish * (1 - 1e-12) then list[#list + 1] = finish end
  return list
end

return sampling
