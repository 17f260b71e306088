-- found.lua - states at which the hunt found a defect, since mended: replayed by worst.t for ever.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- was: the error found, in the target's units; the bound is that of the target's error.
return {
  { name = "hunt_found_equal_rates", target = "free_top", real = "double", error = "attitude", was = "2.5e16",
    what = "two moments equal, and the rates about them equal in size: the cosine of the phase at t = 0 is " ..
      "exactly 0, and the sign of its sine was lost: the rates began mirrored.",
    genes = {
      "0x1.0000000000000p+0", "0x1.0000000000000p+1", "0x1.0000000000000p+1", "0x1.999999999999ap-4",
      "0x1.0000000000000p+0", "-0x1.0000000000000p+0", "0x1.0000000000000p+0", "0x0.0p+0", "0x0.0p+0",
      "0x0.0p+0", "0x1.0624dd2f1a9fcp-10", "0x1.8000000000000p+1", "0x1.9000000000000p+6", "0x0.0p+0" } },
  { name = "hunt_found_equal_rates_float", target = "free_top", real = "float", error = "attitude", was = "4.7e7",
    what = "the same in float.",
    genes = {
      "0x1.0000000000000p+1", "0x1.0000000000000p+1", "0x1.8000000000000p+1", "0x1.0000000000000p+0",
      "-0x1.0000000000000p+0", "0x1.0000000000000p-3", "0x1.0000000000000p+0", "0x0.0p+0", "0x0.0p+0",
      "0x0.0p+0", "0x1.0000000000000p-10", "0x1.8000000000000p+1", "0x1.9000000000000p+6",
      "0x1.0000000000000p+0" } },
  { name = "hunt_found_slow_axis", target = "free_top", real = "double", error = "rates", was = "no number",
    what = "two moments equal and a rate about the third axis of less than 1e-160 of the others: its square " ..
      "underflowed, and NAME_solve returned 0 with states of no numbers.",
    genes = {
      "0x1.0000000000000p+0", "0x1.c000000000000p-1", "0x1.0000000000000p+0", "0x1.0000000000000p+0",
      "0x1.0000000000000p-190", "0x1.8000000000000p-1", "0x1.0000000000000p+0", "0x0.0p+0", "0x0.0p+0",
      "0x0.0p+0", "0x1.0624dd2f1a9fcp-10", "0x1.8000000000000p+1", "0x1.9000000000000p+6", "0x0.0p+0" } },
  { name = "hunt_found_slow_axis_float", target = "free_top", real = "float", error = "rates", was = "no number",
    what = "the same in float, from 1e-19 on.",
    genes = {
      "0x1.0000000000000p+0", "0x1.c000000000000p-1", "0x1.0000000000000p+0", "0x1.0000000000000p+0",
      "0x1.0000000000000p-90", "0x1.8000000000000p-1", "0x1.0000000000000p+0", "0x0.0p+0", "0x0.0p+0",
      "0x0.0p+0", "0x1.0000000000000p-10", "0x1.8000000000000p+1", "0x1.9000000000000p+6", "0x0.0p+0" } },
  { name = "hunt_found_backward_ticks", target = "symmetric_top", real = "float", error = "attitude", was = "116",
    what = "a phase that runs backwards kept 48 bits of 1 - |phase of a tick|, not of the phase, so that " ..
      "5e8 ticks were off by a hundred units.",
    genes = {
      "0x1.dd270a0000000p+11", "0x1.25c8320000000p+9", "-0x1.64d0000000000p+13", "-0x1.594f340000000p+12",
      "-0x1.f52e140000000p+6", "-0x1.e0a3d80000000p+1", "0x1.1223ee0000000p-5", "-0x1.847b8a0000000p+1",
      "-0x1.28bb6e0000000p+2", "0x1.0c5a5e0000000p-25", "-0x1.f81de20000000p-31", "0x1.fc81400000000p+28",
      "0x1.0000000000000p+0" } },
  { name = "hunt_found_turned_sphere", target = "free_tensor", real = "float", error = "attitude", was = "4.9e3",
    what = "nearly a sphere in turned axes: the three differences of the moments, each rounded, did not add " ..
      "up, and the mean rate about L had half of the pair's digits.",
    genes = {
      "0x1.57b2e2p+11", "0x1.57b2e4p+11", "0x1.57b2e2p+11", "-0x1.4804bp-11", "-0x1.4f9c5ap-11",
      "0x1.f24cfep-12", "0x1.410004p+0", "0x1.375a28p+0", "-0x1.40c8cep+1", "-0x1.0430b4p+1", "-0x1.f957f8p+3",
      "0x1.bd2128p+3", "0x0p+0", "0x1.bp+10", "0x1p+9", "0x0p+0", "0x0p+0" } },
}
