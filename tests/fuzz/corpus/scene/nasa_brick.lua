-- The brick of NASA's six-degree-of-freedom check cases (TM-2015-218675, case 2): tumbling without torque.
return scene {
  name    = "nasa_brick",
  body    = tensor { mass = quantity(0.155404754, "slug"), xx = quantity(0.001894220, "slug ft^2"),
                     yy = quantity(0.006211019, "slug ft^2"), zz = quantity(0.007194665, "slug ft^2") },
  initial = { omega = {quantity(10, "deg/s"), quantity(20, "deg/s"), quantity(30, "deg/s")} },
  time    = { horizon = 30 },
}
