#!/usr/bin/env lua5.4
-- hand.t - what the rates of a rolling body cost, beside the same equations written by hand: at most 5 % more.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- The hand counts are those of docs/plane.md: each row is one step of a derivation on paper, {what, *, +, /, sqrt}.
-- They are for the same states (q, w in body axes, the two coordinates) and share what a person would share.

package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local program = require "tests.cli.program"

local binary = os.getenv "POLHODE" or "build/polhode"

local attitude = { "q' = q (0, w)/2", 15, 8, 0, 0 }

-- A homogeneous ball on a turntable: X' = R (W2, -W1) + Omega (-p2, p1), W = A w; w' = K A^T (X', 0),
-- K = R Omega/(I/m + R^2).
local ball = { attitude,
  { "ten products of q", 10, 0, 0, 0 },
  { "six entries of A's first two rows, halved off the diagonal", 0, 8, 0, 0 },
  { "W1, W2", 8, 4, 0, 0 },
  { "X1', X2'", 4, 2, 0, 0 },
  { "K X'", 2, 0, 0, 0 },
  { "w'", 9, 3, 0, 0 },
}

-- The rattleback: full tensor in xy, ellipsoid of three axes, centre above the centre of mass.
local rattleback = { attitude,
  { "g = third row of A", 10, 5, 0, 0 },
  { "B g, root of g.B g", 6, 2, 0, 1 },
  { "y = B g/root, centre - y", 0, 1, 3, 0 },
  { "g' = g x w", 6, 3, 0, 0 },
  { "y' = (B g' - (y.g') y)/root", 9, 5, 3, 0 },
  { "k = w x (centre - y) - y'", 6, 6, 0, 0 },
  { "f = -G - w x k", 9, 6, 0, 0 },
  { "I w", 5, 2, 0, 0 },
  { "I + m (r.r 1 - r r^T)", 6, 7, 0, 0 },
  { "(I w) x w + r x f", 12, 9, 0, 0 },
  { "three unknowns, symmetric", 15, 10, 3, 0 },
  { "the centre's velocity along the plane", 12, 12, 0, 0 },
}

local function by_hand(rows)
  local sum = 0
  for _, row in ipairs(rows) do
    for i = 2, 5 do sum = sum + row[i] end
  end
  return sum
end

local function emitted(name)
  local path = program.directory() .. "/list"
  assert(program.shell(string.format("%s gen bodies/%s.lua --list >%s", binary, name, path)) == 0)
  local row, sum = assert(program.read(path):match "\n(rhs [^\n]*)"), 0
  for n in row:gmatch "(%d+) [-+*/s]" do sum = sum + tonumber(n) end
  return sum, row
end

for _, case in ipairs { { "turntable_ball", ball }, { "rattleback", rattleback } } do
  local sum, row = emitted(case[1])
  local hand = by_hand(case[2])
  local said = string.format("%s: %d operations, %d by hand", case[1], sum, hand)
  tap.ok(sum > 0.5 * hand and sum <= 1.05 * hand, said, row)
end

tap.done(program.finish())
