-- calls.lua -- C text that calls every public function of an emitted header on the scene's own state, for paint.c.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
--     local text, names = calls.of(name, header, depth)
-- text: calls.h; names: the functions, in the order of the table calls[].  Arguments by their type and name; one that
-- is not known is an error, so that no function is left out.

local calls = {}

-- Scalars by name, in any real type.
local VALUES = { t = "1/(NAME_real)8", h = "STEP", t0 = "0", t1 = "STEP", tolerance = "1/(NAME_real)1024", most = "3",
  s = "STEP", n = "2", k = "0", axis = "2", dissipation = "1" }

-- Arrays that are read, by name; NAME_inertia's tensor where one is wanted.
local READ = { x = "start", x0 = "start", u = "inputs", p = "parameters", I = "tensor", t = "times" }

local function argument(name, text, objects)
  local const = string.find(text, "const ", 1, true)
  local kind, word = string.match(text, "([%w_]+) %*?([%w_]+)[%[%]%w_*]*$")
  local array = string.find(text, "[*%[]")
  if not kind then error("no argument: " .. text) end
  if kind == name .. "_real" or string.find(kind, "^u?int") or kind == "int" or kind == "size_t" then
    if not array then return VALUES[word] or error("no value for " .. text) end
    if const then return READ[word] or "vector" end
    if word == "x" then return "state" end
    objects[word] = kind
    return "out_" .. word
  end
  if kind == name .. "_model" then return const and "&model" or "&other" end
  objects[kind] = true
  return "&object_" .. string.sub(kind, #name + 2)
end

function calls.of(name, header, depth)
  header = string.gsub(header, "/%*.-%*/", " ")
  local upper, names, bodies, objects, declared = string.upper(name), {}, {}, {}, {}
  for result, f, parameters in string.gmatch(header, "([%w_]+) (" .. name .. "_[%w_]+)(%b());") do
    local list = {}
    for text in string.gmatch(string.sub(parameters, 2, -2), "[^,]+") do
      text = string.gsub(string.gsub(text, "%s+", " "), "^ ", "")
      list[#list + 1] = argument(name, text, objects)
    end
    names[#names + 1] = f
    bodies[#bodies + 1] = string.format("static void call_%d(void)\n{\n  %s%s(%s);\n}\n", #names - 1,
      result == "void" and "" or "kept = (int)", f, table.concat(list, ", "))
  end
  local sorted = {}
  for key in pairs(objects) do sorted[#sorted + 1] = key end
  table.sort(sorted)
  for i, key in ipairs(sorted) do
    declared[i] = objects[key] == true and string.format("static %s object_%s;\n", key, string.sub(key, #name + 2))
      or string.format("static %s out_%s[ROOM];\n", objects[key], key)
  end
  local has = {}
  for _, f in ipairs(names) do has[string.sub(f, #name + 2)] = true end
  local table_of = {}
  for i = 1, #names do table_of[i] = "call_" .. i - 1 end
  local text = [[
#include "NAME.h"
#define DEPTH ]] .. depth .. [[

#define STEP (1/(NAME_real)64)
#define ROOM (3*UPPER_NX*UPPER_NX + 64)

static volatile int kept;
static NAME_model model, other;
static NAME_real start[UPPER_NX], state[UPPER_NX], inputs[UPPER_NU + 1], parameters[UPPER_NP + 1], tensor[6];
static const NAME_real times[2] = {0, 1}, vector[9] = {1, 2, 3, 4, 5, 6, 7, 8, 9};
]] .. table.concat(declared) .. table.concat(bodies) .. [[
static void (*const calls[])(void) = {]] .. table.concat(table_of, ", ") .. [[};

static int prepare(void)
{
  NAME_defaults(parameters);
  if (NAME_init(&model, 0) != 0) return 0;
  NAME_initial(&model, start);
  (void)tensor;
  (void)times;
  (void)vector;
  (void)inputs;
]] .. (has.inertia and "  NAME_inertia(&model, tensor);\n" or "") ..
    (has.solve and "  if (NAME_solve(&object_orbit, &model, start) != 0) return 0;\n" or "") .. [[
  return 1;
}

static void restore(void)
{
  int i;

  for (i = 0; i < UPPER_NX; i++) state[i] = start[i];
}
]]
  text = string.gsub(string.gsub(text, "%f[%w]NAME%f[%W]", name), "%f[%w]UPPER%f[%W]", upper)
  text = string.gsub(string.gsub(text, "NAME_", name .. "_"), "UPPER_", upper .. "_")
  return text, names
end

return calls
