-- main.lua -- the command line: options, the command, the exit status.
--
-- Exit status: 0; 1 the scene is wrong; 2 the command line is wrong; 3 the numbers failed a check; 70 a bug (an error
-- that reaches the host).  Results go to standard output, everything else to standard error.
-- SPDX-License-Identifier: GPL-3.0-or-later

local options = require "generator.commands.options"

local usage = [[
usage: polhode gen     SCENE [-o DIR] [--real double|float] [--bake] [--method rk4,exact] [--set a=0.3 ...]
                             [--accuracy E] [--order N] [--with jacobians,compensated,proof,q31] [--libm own|system]
                             [--project make|cmake|arduino|platformio|zephyr|firmware|fmu]
                             [--show lower|power|fold|cse|dce|order]
                             [--target all|cortex-m4f,...]   (instructions, flash, stack, counted under emulators)
       polhode run     SCENE [--engine general|generated] [--method M] [--step H] [--tolerance E]
                             [--until T --every DT | --at T1,T2,...] [--format csv|json] [-o FILE]
                             [--real double|float] [--set a=0.3 ...]
       polhode explain SCENE [--format text|markdown|latex|json|urdf|mjcf|sdf] [--set a=0.3 ...]
                             [--target all|cortex-m4f,...] [--real double|float]
       polhode explain --diff A B [--format text|json]     the terms by which two scenes differ
       polhode check   SCENE... [--real double|float]
       polhode bench   SCENE [--method M,...] [--accuracy E] [--until T] [--no-closed] [--no-peers] [--all]
                             [--format text|csv|markdown] [-o DIR] [--set a=0.3 ...]
       polhode chart   SCENE --over A=LOW:HIGH,B=LOW:HIGH [--axis x|y|z|0|1|2] [--dissipation] [-o FILE.svg]
                             [--set a=0.3 ...]   (NAME=NUMBER, in the parameter's own unit)
       polhode chart   SCENE --linearised [-o FILE.svg]
       polhode mesh    FILE [--kind volume|surface|wires] [--units mm] [--mass "2 kg" | --density "2.7 g/cm^3"]
                             [--format text|json]
       polhode links   FILE             (URDF, MJCF, SDF: can each link's inertial exist?)
       polhode list    shapes|effects|methods|bodies|constants [--format markdown -o DIR: shapes, with pictures]
       polhode --version | --help
]]

local commands = {
  gen = function() return require "generator.commands.gen" end,
  run = function() return require "generator.commands.run" end,
  explain = function() return require "generator.commands.explain" end,
  check = function() return require "generator.commands.check" end,
  bench = function() return require "generator.commands.bench" end,
  links = function() return require "generator.commands.links" end,
  chart = function() return require "generator.commands.chart" end,
  mesh = function() return require "generator.commands.mesh" end,
  list = function() return require "generator.commands.list" end,
}

return function(host, args)
  local name = args[1]
  if name == "--help" or name == "-h" then
    host.out(usage)
    return 0
  end
  if name == "--version" then
    host.out("polhode " .. require("generator.driver").version .. "\n")
    return 0
  end
  if not name or not commands[name] then
    host.err((name and "polhode: no command " .. string.format("%q", name) .. "\n" or "") .. usage)
    return 2
  end
  for i = 2, #args do
    if args[i] == "--help" or args[i] == "-h" then
      host.out(usage)
      return 0
    end
  end
  local command = commands[name]()
  local given, why = options.parse(command.options, command.operands, args)
  if not given then
    host.err("polhode " .. name .. ": " .. why .. "\n" .. usage)
    return 2
  end
  return command.run(host, given)
end
