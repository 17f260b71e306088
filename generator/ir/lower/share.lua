-- share.lua: finds the parts that several sums or several products have in common.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Above the line: a product may be bracketed as one likes, and so may a sum.  Hash-consing shares what is equal as a
-- whole; this shares wy*wz between a*wy*wz and b*wx*wy*wz, and x - y between x - y + z and 2*y - 2*x + w.  Greedy: of
-- all pairs of items the most frequent one becomes an item of its own, until no pair occurs twice.  Ties go to the pair
-- that reached its count first, so the result depends on the program alone.  (The least number of operations is
-- NP-hard: ensemble computation, Garey and Johnson 1979.  Taking the pair of greatest use is Breuer's way, 1969,
-- Comm. ACM 12, 333.)
--
-- A bag is the numerator or the denominator of a product (items: forms), or a sum (items: terms).
-- A bag that is a whole form and exactly the pair IS the shared form; else a new form is made.
--
-- Laws: (x*y)*z = x*(y*z), (x + y) + z = x + (y + z) and their commuted forms: of real numbers.  Below the line none of
-- them holds, which is why all of this happens here.
--
-- Invariants.  Items of a bag are distinct at first (forms collect equal ones); a shared form may come to stand beside
-- itself, S and x + y with S = x + y, and then pairs of it are noted twice for one bag.  Counts of pairs are hints,
-- kept up to date cheaply: a replacement takes one from each pair that it breaks and notes each that it makes, and a
-- bag stays in the list of a pair that it has lost.  Before anything is replaced the bags themselves are looked at,
-- each once.  Each replacement makes its bag shorter by one, so it ends.
--
-- Cost.  A bag of k items that occur elsewhere has k(k - 1)/2 pairs; a replacement in it touches 3k of them.  Queues by
-- count give the next pair in constant time: a pair waits in the queue of the count that it had, and is put into that
-- of its present count when it is taken out too early.

local R = require "generator.algebra.rational"

local share = {}

local IDS = 1 << 26 -- more than a program has forms: two ids make one integer

-- ---- greedy pairing -----------------------------------------------------------------------------------------------

-- The state G of one run.  kind, three functions:
--     id(item)          what makes two items candidates for being common (a form)
--     key(x, y)         equal for equal pairs, whichever comes first
--     join(x, y, whole) the item that replaces x, y; its form is `whole` if given, else a new one,
--                       returned as second value together with its items
-- pairs: key -> { n =, x =, y =, bags = }; queues: count -> the pairs that reached it; top: the highest count.
local function begin(kind) return { kind = kind, pairs = {}, queues = {}, top = 1 } end

-- Counts the pair x, y, which is in the bag.
local function note(G, x, y, bag)
  local k = G.kind.key(x, y)
  local pair = G.pairs[k]
  if not pair then
    pair = { n = 0, x = x, y = y, bags = {} }
    G.pairs[k] = pair
  end
  pair.n = pair.n + 1
  pair.bags[#pair.bags + 1] = bag
  return pair
end

-- Puts a pair into the queue of its count.
local function wait(G, pair)
  if pair.n < 2 then return end
  local queue = G.queues[pair.n] or { head = 1 }
  G.queues[pair.n] = queue
  queue[#queue + 1] = pair
  G.top = math.max(G.top, pair.n)
end

-- The pair that waits longest with the highest count; nil where no count is above 1.
local function next_pair(G)
  while G.top > 1 do
    local queue = G.queues[G.top]
    local pair = queue and queue[queue.head]
    if not pair then
      G.queues[G.top] = nil
      G.top = G.top - 1
    else
      queue.head = queue.head + 1
      if pair.n == G.top then return pair end
      wait(G, pair)
    end
  end
end

-- Notes the pairs of all bags.  An item that is in one bag alone is in no pair worth counting.
local function count(G, bags)
  local id, frequency = G.kind.id, {}
  for _, bag in ipairs(bags) do
    for k = 1, #bag.items do
      local f = id(bag.items[k])
      frequency[f] = (frequency[f] or 0) + 1
    end
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
        local pair = note(G, common[a], common[b], bag)
        if pair.n == 1 then fresh[#fresh + 1] = pair end
      end
    end
  end
  for _, pair in ipairs(fresh) do wait(G, pair) end
end

-- The places of the two items of bag that make up the pair of key k; nil, for they may be gone by now.
local function find(G, bag, pair, k)
  local id, a, b = G.kind.id, nil, nil
  for at, x in ipairs(bag.items) do
    local f = id(x)
    if f == id(pair.x) then a = at elseif f == id(pair.y) then b = at end
  end
  if not a or not b or G.kind.key(bag.items[a], bag.items[b]) ~= k then return nil end
  return math.min(a, b), math.max(a, b)
end

-- item in the place of those at a < b.  Returns the pairs that this made.
local function replace(G, bag, a, b, item)
  local key = G.kind.key
  local x, y = bag.items[a], bag.items[b]
  table.remove(bag.items, b)
  table.remove(bag.items, a)
  local made = {}
  for _, z in ipairs(bag.items) do
    for _, old in ipairs { x, y } do
      local pair = G.pairs[key(old, z)]
      if pair then pair.n = pair.n - 1 end
    end
    made[#made + 1] = note(G, item, z, bag)
  end
  table.insert(bag.items, a, item)
  return made
end

-- The pair becomes one item in every bag that has it, if there are two of them.
-- A bag is looked at once, however often it was noted: a replacement moves its items.
local function extract(G, pair)
  local k = G.kind.key(pair.x, pair.y)
  local places, whole, seen = {}, nil, {}
  for _, bag in ipairs(pair.bags) do
    local a, b = find(G, bag, pair, k)
    if seen[bag] then a = nil end
    seen[bag] = true
    if a and bag.whole and #bag.items == 2 and not whole then
      whole = bag
    elseif a then
      places[#places + 1] = { bag = bag, a = a, b = b }
    end
  end
  if #places + (whole and 1 or 0) < 2 then return end
  local form = whole and whole.whole
  local made = {}
  for _, place in ipairs(places) do
    local items = place.bag.items
    local item, new = G.kind.join(items[place.a], items[place.b], form)
    form = new or form
    for _, p in ipairs(replace(G, place.bag, place.a, place.b, item)) do made[#made + 1] = p end
  end
  for _, p in ipairs(made) do wait(G, p) end
end

-- Over bags { items =, whole = form or nil }, in place.
local function greedy(bags, kind)
  local G = begin(kind)
  count(G, bags)
  for pair in next_pair, G do
    pair.n = 0
    extract(G, pair)
  end
end

-- ---- what is shared -----------------------------------------------------------------------------------------------

-- The products among the forms that have a denominator and something above it, grouped by their denominator.
local function by_denominator(forms)
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
  return order
end

-- The factor that most of the products have above the line, and these; nil where all are different.
-- Ties go to the factor that reached the number first.
local function common_factor(group)
  local places, best = {}, nil -- factor -> the products that have it
  for _, f in ipairs(group) do
    for _, x in ipairs(f.num) do
      places[x] = places[x] or {}
      table.insert(places[x], f)
      if #places[x] > 1 and (not best or #places[x] > #places[best]) then best = x end
    end
  end
  return best, places[best]
end

-- Products with one denominator and a common factor above it, M p/d and M q/d, become (M/d) p and (M/d) q: one
-- division for all of them.  Where M/d itself is one of them it is that form, else a new one.
function share.quotients(forms, B)
  for _, group in ipairs(by_denominator(forms)) do
    local best, users = common_factor(group)
    local quotient
    for _, f in ipairs(best and users or {}) do
      if #f.num == 1 then quotient = f end
    end
    if best and not quotient then
      B.count = B.count + 1
      quotient = { kind = "prod", num = { best }, den = group[1].den, id = B.count }
    end
    for _, f in ipairs(best and users or {}) do
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
  greedy(bags, {
    id = function(f) return f end,
    key = function(x, y)
      if x.id > y.id then x, y = y, x end
      return x.id * IDS + y.id
    end,
    join = function(x, y, whole)
      if whole then return whole end
      B.count = B.count + 1
      whole = { kind = "prod", num = { x, y }, den = {}, id = B.count }
      return whole, whole
    end,
  })
end

-- Shares common sums of two terms, equal up to a factor, among the sums in the list `forms`.
function share.sums(forms, B)
  local bags = {}
  for _, f in ipairs(forms) do
    if f.kind == "sum" then bags[#bags + 1] = { items = f.terms, whole = f } end
  end
  greedy(bags, {
    id = function(t) return t.f end,
    key = function(x, y) -- what is equal up to a factor: the two forms and the quotient of the coefficients
      if x.f.id > y.f.id then x, y = y, x end
      local head = x.f.id * IDS + y.f.id
      if x.c == y.c then return head end
      if x.c == -y.c then return -head end
      return head .. ":" .. tostring(y.c / x.c)
    end,
    join = function(x, y, whole)
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
    end,
  })
end

return share
