-- fields.lua -- the fields of a scene's tables, what its own words make, and its words: for the editor and the manual.
--
-- A group is {name, about, fields = {{name, type, unit | "", default | nil, about, needed = true}, ...}, also = type of
-- further keys | nil, array = true where the fields may stand without names}.  Types are those of the definitions
-- (language/definitions.lua).  What checks a scene is in dsl/; tests/cli/init.t holds this list to what dsl/
-- says that it has.  Shapes and effects have tables of their own, in mass/ and effects/.
-- SPDX-License-Identifier: GPL-3.0-or-later

local fields = {}

fields.groups = {
  { name = "Scene", about = "The description that a scene returns: return scene { ... }.", fields = {
    { "name", "string", "", nil, "prefix of functions, files and macros: a letter, then letters, digits or _",
      needed = true },
    { "body", "Shape", "", nil, "what moves: a shape, or shapes put together", needed = true },
    { "origin", "string|Vector", "m", '"centroid"',
      "the point about which the body turns: a named point of its shape, or coordinates of the shape" },
    { "effects", "Effect[]", "", "{}", "what acts on the body; without effects it is free" },
    { "initial", "Initial", "", "at rest", "the state at t = 0" },
    { "time", "Time", "", "10 s by steps of 1 ms",
      "how long, and by which step; the method is the option --method of the command" },
    { "accuracy", "number", "", nil,
      "the largest error of the state over the horizon, relative to its size, between 0 and 1: gen plans for it" },
    { "budget", "Budget", "", nil, "what a planned step may cost" },
    { "ranges", "Ranges", "", nil, "from where motions start and for which parameters: planner, proof, fixed point" },
    { "outputs", "string[]", "", "all",
      "states, attitude, rates, position, velocity, energy, momentum, momentum_body: what is needed of the motion" },
    { "events", "Event[]", "", "{}", "zero crossings that run looks for" },
    { "measure", "Measure", "", nil, "what sensors say, for polhode fit" },
  } },
  { name = "Initial", about = "The state at t = 0.", fields = {
    { "omega", "Vector", "rad/s", "{0, 0, 0}", "angular velocity in body axes" },
    { "attitude", "Rotation", "", "{1, 0, 0, 0}", "rotation from body axes to inertial axes" },
    { "position", "Vector", "m", "{0, 0, 0}",
      "centre of mass, inertial axes; needs an effect that moves the body, such as effect.translation" },
    { "velocity", "Vector", "m/s", "{0, 0, 0}", "of the centre of mass, inertial axes; needs such an effect" },
  } },
  { name = "Time", about = "How long a run takes, and its step.", fields = {
    { "horizon", "Value", "s", "10", "the end of the motion" },
    { "step", "Value", "s", "0.001", "step of fixed-step methods, of events and of firmware" },
  } },
  { name = "Rotation", array = true, about = "A rotation in one of five forms; a plain list is a quaternion.",
    fields = {
      { "axis", '"x"|"y"|"z"|Vector', "", nil, "axis of a turn, of any length; with angle" },
      { "angle", "Value", "rad", nil, "angle of the turn about axis" },
      { "euler", '"xyx"|"xzx"|"yxy"|"yzy"|"zxz"|"zyz"|"xyz"|"xzy"|"yxz"|"yzx"|"zxy"|"zyx"', "", nil,
        "turns about the body's axes, each as it stands after those before; with angles" },
      { "angles", "Vector", "rad", nil, "the three angles of euler" },
      { "vector", "Vector", "rad", nil, "axis times angle" },
      { "matrix", "Vector[]", "", nil, "three rows; the columns are the body's axes in space" },
      { "quaternion", "Value[]", "", nil, "{w, x, y, z}, body to space, of any length but 0" },
    } },
  { name = "Ranges", also = "any", about = "Where motions start. Parameters and further states stand by their names.",
    fields = {
      { "omega", "any", "rad/s", nil, "r (each component within -r and r), {lowest, highest}, or three of these" },
      { "attitude", '"any"|Value', "rad", nil, '"any", or the angle within which it is from the initial one' },
      { "position", "any", "m", nil, "as omega" },
      { "velocity", "any", "m/s", nil, "as omega" },
    } },
  { name = "Budget", about = "What a planned step may cost.", fields = {
    { "ops", "integer", "", nil, "operations a step" },
    { "real", '"double"|"float"', "", nil, "type of the numbers" },
    { "target", '"x86-64"|"cortex-m0"|"cortex-m3"|"cortex-m4f"|"cortex-m7"|"rv32imac"|"rv32imafc"|"avr"', "", nil,
      "the processor whose table of costs counts" },
  } },
  { name = "Event", about = "A zero crossing that run looks for, and names.", fields = {
    { "name", "string", "", nil, "its name in the table of events", needed = true },
    { "when", "Value", "", nil, "expression of t and states that crosses zero", needed = true },
    { "direction", "-1|0|1", "", "0", "1 upward, -1 downward, 0 both" },
    { "stop", "boolean", "", "false", "the run ends there" },
  } },
  { name = "Measure", also = "any", about = "Outputs by name: expressions, lists of them, or names of states.",
    fields = {
      { "columns", "table<string, string|string[]>", "", nil, "columns of the log, by output" },
      { "sigma", "table<string, any>", "", nil, "standard deviations of the noise, by output" },
    } },
  { name = "Limits", about = "Limits of an input; both or none.", fields = {
    { "min", "Value", "", nil, "the least value, in the input's unit" },
    { "max", "Value", "", nil, "the largest value" },
  } },
}

-- What a scene calls, beside shapes and effects: {call, {{argument, type, about}, ...}, result, about}.
fields.functions = {
  { "param", { { "name", "string", "its name in the code" }, { "default", "number|string", "its value in the scene" },
    { "unit", "string?", 'such as "kg m^2"; without one a pure number' } }, "Value",
    "a parameter: it stays a symbol in formulas and in the generated code" },
  { "quantity", { { "number", "number|string", "a plain number" }, { "unit", "string", 'such as "mm"' } }, "Value",
    "an exact number with a unit" },
  { "exact", { { "digits", "string", 'such as "1/3" or "0.1"' } }, "Value", "an exact number" },
  { "input", { { "name", "string", "its name in the code" }, { "unit", "string?", "of its value" },
    { "limits", "Limits?", "it is kept between these" } }, "Value", "a number that is decided while the body moves" },
  { "scene", { { "description", "Scene", "all that there is" } }, "any", "the scene: return scene { ... }" },
}

-- What moves a shape: {name, {{argument, type, about}}, about}.
fields.placing = {
  { "at", { { "position", "Vector", "m: where the shape's own origin comes to lie" } }, "the shape, moved" },
  { "turned", { { "rotation", "Rotation", "about the shape's own origin" } }, "the shape, turned" },
  { "scaled", { { "factor", "Value|Vector", "one factor, or three" } }, "the shape, scaled about its own origin" },
  { "sheared", { { "by", "table<string, Value>", "{xy = k}: x grows by k y; any of the six pairs" } },
    "the shape, sheared" },
  { "mirrored", { { "axis", '"x"|"y"|"z"', "across which plane" } }, "the shape, mirrored in a plane" },
}

-- What an expression of the motion may be made of: {name, unit, about}.
fields.words = {
  { "t", "s", "time" },
  { "qw", "", "attitude, scalar part" }, { "qx", "", "attitude, x" }, { "qy", "", "attitude, y" },
  { "qz", "", "attitude, z" },
  { "wx", "rad/s", "angular velocity about body axis x" }, { "wy", "rad/s", "angular velocity about body axis y" },
  { "wz", "rad/s", "angular velocity about body axis z" },
  { "rx", "m", "position of the centre of mass, inertial x" }, { "ry", "m", "position, inertial y" },
  { "rz", "m", "position, inertial z" },
  { "vx", "m/s", "velocity of the centre of mass, inertial x" }, { "vy", "m/s", "velocity, inertial y" },
  { "vz", "m/s", "velocity, inertial z" },
  { "x", "m", "coordinate in a region's density and limits" }, { "y", "m", "coordinate of a region" },
  { "z", "m", "coordinate of a region" },
  { "pi", "", "3.14159..., exact in formulas" },
}

-- What a function of effect.custom receives: {name, type, about}.
fields.motion = {
  { "t", "Value", "time, s" }, { "q", "Value[]", "attitude {w, x, y, z}, body to inertial" },
  { "w", "Value[]", "angular velocity, body axes, rad/s" },
  { "r", "Value[]", "position of the centre of mass, inertial axes, m" },
  { "v", "Value[]", "velocity of the centre of mass, inertial axes, m/s" },
  { "L", "Value[]", "angular momentum, body axes, kg m^2/s" },
}

-- Shapes that dsl/ reads in a way of its own: the type of what they take.
fields.read_shapes = {
  points = { { "rows", "Value[][]", "{{mass, x, y, z}, ...}, kg and m" } },
  region = { { "limits", "table", "{{x, lowest, highest}, {y, ..}, {z, ..}, density = .. or mass = ..}" } },
  mesh = { { "file", "string", "STL, OBJ or PLY, in the scene's folder or below", needed = true },
    { "units", "string", 'of the file, such as "mm"; default "m"' },
    { "kind", '"volume"|"surface"|"wires"', 'what has mass; default "volume"' },
    { "weld", "number", "vertices nearer than this part of the longest side are one, such as 1e-6; default 0" } },
  inertial = { { "file", "string", "URDF, MJCF or SDF, in the scene's folder or below", needed = true },
    { "link", "string", "the link's name" } },
}

return fields
