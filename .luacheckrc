std = "lua54"
max_line_length = 120
-- Unused `self`-like arguments are written `_`; shadowing is refused.
files["bodies/*.lua"] = {
  read_globals = {
    "param", "input", "scene", "solid", "shell", "plate", "rod", "wire", "points", "tensor", "effect",
    "extrude", "revolve", "region", "mesh", "inertial", "contact",
    "quantity", "exact", "pi", "sqrt", "sin", "cos", "tan", "asin", "acos",
    "atan", "atan2", "exp", "log", "sinh", "cosh", "tanh", "abs",
    "t", "qw", "qx", "qy", "qz", "wx", "wy", "wz", "rx", "ry", "rz", "vx", "vy", "vz",
  },
}
files["tests/fuzz/scenes/*.lua"] = files["bodies/*.lua"]
