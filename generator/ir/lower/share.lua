-- share.lua: finds the parts that several sums or several products have in common.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Above the line: a product may be bracketed as one likes, and so may a sum.  Hash-consing shares
-- what is equal as a whole; this shares wy*wz between a*wy*wz and b*wx*wy*wz, and x - y between
-- x - y + z and 2*y - 2*x + w.  Greedy: of all pairs of items the most frequent one becomes an item
-- of its own, until no pair occurs twice.  Ties go to the pair that reached its count first, so the
-- result depends on the program alone.  Counts are hints kept up to date cheaply; before anything is
-- replaced the bags themselves are looked at.
--
-- A bag is the numerator or the denominator of a product (items: forms), or a sum (items: terms).
-- A bag that is a whole form and exactly the pair IS the shared form; else a new form is made.

local R = require "generator.algebra.rational"

local share = {}

-- Greedy pairing over bags { items =, whole = form or nil }.  The kind of bag comes as three functions:
--     id(item)          what makes two items candidates for being common (a form)
--     key(x, y)         equal for equal pairs, whichever comes first
--     join(x, y, whole) the item that replaces x, y; its form is `whole` if given, else a new one,
--                       returned as second value together with its items
local function greedy(bags, id, key, join)
  local frequency = {}
  for _, bag in ipairs(bags) do
    for k = 1, #bag.items do
      local f = id(bag.items[k])
      frequency[f] = (frequency[f] or 0) + 1
    end
  end

  local pairs_of = {}
  local queues, top = {}, 1 -- count -> queue of the pairs that reached it; the highest count

  local function note(x, y, bag)
    local k = key(x, y)
    local pair = pairs_of[k]
    if not pair then
      pair = { n = 0, x = x, y = y, bags = {} }
      pairs_of[k] = pair
    end
    pair.n = pair.n + 1
    pair.bags[#pair.bags + 1] = bag
    return pair
  end

  local function wait(pair)
    if pair.n < 2 then return end
    local queue = queues[pair.n] or { head = 1 }
    queues[pair.n] = queue
    queue[#queue + 1] = pair
    top = math.max(top, pair.n)
  end

  local fresh = {}
  for _, bag in ipairs(bags) do
    local common = {}
    for k = 1, #bag.items do
      local x = bag.items[k]
      if frequency[id(x)] > 1 then common[#common + 1] = x end
    end
    for a = 1, #common do
      for b = a + 1, #common do
        local pair = note(common[a], common[b], bag)
        if pair.n == 1 then fresh[#fresh + 1] = pair end
      end
    end
  end
  for _, pair in ipairs(fresh) do wait(pair) end

  -- The two items of bag that make up the pair k; they may be gone by now.
  local function find(bag, pair, k)
    local a, b
    for at, x in ipairs(bag.items) do
      local f = id(x)
      if f == id(pair.x) then a = at elseif f == id(pair.y) then b = at end
    end
    if not a or not b or key(bag.items[a], bag.items[b]) ~= k then return nil end
    return math.min(a, b), math.max(a, b)
  end

  local function replace(bag, a, b, item)
    local x, y = bag.items[a], bag.items[b]
    table.remove(bag.items, b)
    table.remove(bag.items, a)
    local touched = {}
    for _, z in ipairs(bag.items) do
      for _, old in ipairs { x, y } do
        local pair = pairs_of[key(old, z)]
        if pair then pair.n = pair.n - 1 end
      end
      touched[#touched + 1] = note(item, z, bag)
    end
    table.insert(bag.items, a, item)
    return touched
  end

  local function extract(pair)
    local k = key(pair.x, pair.y)
    local places, whole = {}, nil
    for _, bag in ipairs(pair.bags) do
      local a, b = find(bag, pair, k)
      if a and bag.whole and #bag.items == 2 and not whole then
        whole = bag
      elseif a then
        places[#places + 1] = { bag = bag, a = a, b = b }
      end
    end
    if #places + (whole and 1 or 0) < 2 then return end
    local form = whole and whole.whole
    local touched = {}
    for _, place in ipairs(places) do
      local items = place.bag.items
      local item, made = join(items[place.a], items[place.b], form)
      form = made or form
      for _, p in ipairs(replace(place.bag, place.a, place.b, item)) do touched[#touched + 1] = p end
    end
    for _, p in ipairs(touched) do wait(p) end
  end

  while top > 1 do
    local queue = queues[top]
    local pair = queue and queue[queue.head]
    if not pair then
      queues[top] = nil
      top = top - 1
    else
      queue.head = queue.head + 1
      if pair.n == top then
        pair.n = 0
        extract(pair)
      else
        wait(pair)
      end
    end
  end
end

-- Products with one denominator and a common factor above it, M p/d and M q/d, become (M/d) p and (M/d) q: one
-- division.
function share.quotients(forms, B)
  local groups, order = {}, {}
  for _, f in ipairs(forms) do
    if f.kind == "prod" and #f.den > 0 and #f.num > 0 then
      local ids = {}
      for k, d in ipairs(f.den) do ids[k] = d.id end
      table.sort(ids)
      local key = table.concat(ids, " ")
      if not groups[key] then
        groups[key] = {}
        order[#order + 1] = groups[key]
      end
      table.insert(groups[key], f)
    end
  end
  for _, group in ipairs(order) do
    local places, best = {}, nil -- factor -> the products that have it
    for _, f in ipairs(group) do
      for _, x in ipairs(f.num) do
        places[x] = places[x] or {}
        table.insert(places[x], f)
        if #places[x] > 1 and (not best or #places[x] > #places[best]) then best = x end
      end
    end
    if best then
      local quotient
      for _, f in ipairs(places[best]) do
        if #f.num == 1 then quotient = f end
      end
      if not quotient then
        B.count = B.count + 1
        quotient = { kind = "prod", num = { best }, den = group[1].den, id = B.count }
      end
      for _, f in ipairs(places[best]) do
        if f ~= quotient then
          for k, x in ipairs(f.num) do
            if x == best then
              f.num[k] = quotient
              break
            end
          end
          f.den = {}
        end
      end
    end
  end
end

-- Shares common products among the products in the list `forms`.  B is their builder: new forms take
-- their ids from it.
function share.products(forms, B)
  local bags = {}
  for _, f in ipairs(forms) do
    if f.kind == "prod" then
      bags[#bags + 1] = { items = f.num, whole = #f.den == 0 and f or nil }
      if #f.den > 1 then bags[#bags + 1] = { items = f.den } end
    end
  end
  greedy(bags, function(f) return f end,
    function(x, y)
      if x.id > y.id then x, y = y, x end
      return x.id * 0x4000000 + y.id
    end,
    function(x, y, whole)
      if whole then return whole end
      B.count = B.count + 1
      whole = { kind = "prod", num = { x, y }, den = {}, id = B.count }
      return whole, whole
    end)
end

-- Shares common sums of two terms, equal up to a factor, among the sums in the list `forms`.
function share.sums(forms, B)
  local bags = {}
  for _, f in ipairs(forms) do
    if f.kind == "sum" then bags[#bags + 1] = { items = f.terms, whole = f } end
  end
  greedy(bags, function(t) return t.f end,
    function(x, y)
      if x.f.id > y.f.id then x, y = y, x end
      local head = x.f.id * 0x4000000 + y.f.id
      if x.c == y.c then return head end
      if x.c == -y.c then return -head end
      return head .. ":" .. tostring(y.c / x.c)
    end,
    function(x, y, whole)
      local made
      if not whole then
        local c = R.gcd(x.c, y.c) -- 2*x - 6*y is shared as x - 3*y
        if R.log2(R.num(c)) > 64 or R.log2(R.den(c)) > 64 then c = R.abs(x.c) end -- rounded ones keep their size
        if R.sign(x.c) < 0 then c = -c end
        B.count = B.count + 1
        whole = { kind = "sum", id = B.count,
          terms = { { c = x.c / c, f = x.f }, { c = y.c / c, f = y.f } } }
        made = whole
      end
      local mine = whole.terms[1].f == x.f and x or y
      return { c = mine.c / whole.terms[1].c, f = whole }, made
    end)
end

return share
