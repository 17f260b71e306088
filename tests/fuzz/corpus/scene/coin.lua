-- A spinning coin in free flight: Feynman's plate wobbles twice while it spins once.
local r, d = param("r", 11.6, "mm"), param("d", 2.33, "mm")
return scene {
  name    = "coin",
  body    = solid.cylinder { r = r, h = d, mass = quantity(8.5, "g") },
  initial = { omega = {1.5, 0, 30} },
  time    = { horizon = 5 },
}
