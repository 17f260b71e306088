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

-- The coin, in the axes t = (g1, g2)/rho, s = z x t, z of its lowest point: r = (r_t, 0, r_z), the centre of the edge
-- at -R t, h = rho/2.  The force along s is the first unknown, w_s' the second.
local coin = { attitude,
  { "qw^2 + qz^2, qx^2 + qy^2; g3 their difference, h^2 their product", 5, 3, 0, 0 },
  { "h, 1/h", 0, 0, 1, 1 },
  { "g1/2, g2/2 and the same of the axis in space", 4, 4, 0, 0 },
  { "t, and s in space", 4, 0, 0, 0 },
  { "r_t = -(R + 2 e h), r_z = -e g3", 2, 1, 0, 0 },
  { "w_t, w_s", 4, 2, 0, 0 },
  { "k_s = -R/2 g3/h w_t, k_z = R w_s", 4, 0, 0, 0 },
  { "m/I1 r_z, m/I1 r_t, m/I3 r_t", 3, 0, 0, 0 },
  { "1 + m/I1 r^2, 1 + m/I1 r_z^2 + m/I3 r_t^2", 3, 3, 0, 0 },
  { "Omega = (I3 - I1)/I1 w3, Omega w_s", 2, 0, 0, 0 },
  { "F_s = (k_z w_t - r_z Omega w_s)/(1 + ..)", 2, 1, 1, 0 },
  { "w_t', w_3'", 2, 1, 0, 0 },
  { "w_s' = (w_t (Omega + m/I1 r_t k_s) + m/I1 r_z (w3 k_s - w_s k_z) + m/I1 G R g3)/(1 + ..)", 6, 4, 1, 0 },
  { "w1', w2'", 4, 2, 0, 0 },
  { "the centre's velocity along s and across: r_t w3 - r_z w_t, w_s (e + 2 R h)", 4, 2, 0, 0 },
  { "p1', p2'", 4, 2, 0, 0 },
}

local function by_hand(rows)
  local sum = 0
  for _, row in ipairs(rows) do
    for i = 2, 5 do sum = sum + row[i] end
  end
  return sum
end

local function emitted(name, option)
  local path = program.directory() .. "/list"
  assert(program.shell(string.format("%s gen bodies/%s.lua --list %s >%s", binary, name, option, path)) == 0)
  local row, sum = assert(program.read(path):match "\n(rhs [^\n]*)"), 0
  for n in row:gmatch "(%d+) [-+*/s]" do sum = sum + tonumber(n) end
  return sum, row
end

for _, case in ipairs { { "turntable_ball", ball }, { "rattleback", rattleback },
  { "rolling_coin", coin } } do
  local hand = by_hand(case[2])
  for _, option in ipairs { "", "--bake" } do
    local sum, row = emitted(case[1], option)
    local said = string.format("%s %s: %d operations, %d by hand", case[1], option, sum, hand)
    tap.ok(sum > 0.5 * hand and sum <= 1.05 * hand, said, row)
  end
end

tap.done(program.finish())
