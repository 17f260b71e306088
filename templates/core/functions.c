%% -- functions.c -- the functions that are made of equations: part of scene.c.  SPDX-License-Identifier: MIT-0
%% for _, f in ipairs(functions) do

${f.head}
{
%%   for _, line in ipairs(f.lines) do
  ${line}
%%   end
}
%% end

