-- radical.lua -- roots of rational numbers in one canonical form.
--
-- (p/q)^e with a rational exponent is written as  c * prod n_i^(f_i)  with c rational, n_i integers
-- greater than one and 0 < f_i < 1: sqrt(8) ==> 2*2^(1/2), sqrt(1/2) ==> 2^(1/2)/2.  Primes up to 1000 are
-- taken out by trial division; what is left is kept as one integer (and opened if it is a perfect power).
-- ABOVE the line: exact.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"

local radical = {}

local primes = {}
for n = 2, 1000 do
  local prime = true
  for _, p in ipairs(primes) do
    if p * p > n then break end
    if n % p == 0 then prime = false break end
  end
  if prime then primes[#primes + 1] = n end
end

-- value > 0 to the rational power e: returns c and a list of {integer > 1, exponent in (0, 1)}.
function radical.open(value, e)
  local c, roots = R.one, {}
  local function put(n, x) -- n^x for an integer n > 1
    local whole = R.floor(x)
    c = c * n ^ R.toint(whole)
    local part = x - whole
    if R.sign(part) ~= 0 then roots[#roots + 1] = { n, part } end
  end
  -- n^x for an integer n >= 1: by its small primes, the rest as one. 12^(1/2) ==> 2 * 3^(1/2)
  local function integer(n, x)
    for _, p in ipairs(primes) do
      if n == R.one then return end
      local prime, k = R.new(p), 0
      while R.isint(n / prime) do n, k = n / prime, k + 1 end
      if k > 0 then put(prime, x * R.new(k)) end
    end
    if n == R.one then return end
    local q = R.toint(R.den(x))
    local root = q and q > 1 and q < 64 and R.root(n, q)
    if root then
      put(root, x * R.new(q))
    else
      put(n, x)
    end
  end
  integer(R.num(value), e)
  integer(R.den(value), -e)
  return c, roots
end

return radical
