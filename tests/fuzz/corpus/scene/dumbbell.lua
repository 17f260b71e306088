-- Two particles on a massless rod, oblique to the axes: no moment about the line that joins them.
local m1, m2 = param("m1", 1, "kg"), param("m2", 2, "kg")
local d = param("d", 0.3, "m")
return scene {
  name    = "dumbbell",
  body    = points { {m1, -2*d, -2*d, -d}, {m2, d, d, d/2} },
  initial = { omega = {1, -2, 0.5} },
  time    = { horizon = 10 },
}
