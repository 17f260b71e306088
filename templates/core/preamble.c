%% -- preamble.c -- what stands before the definitions of a file: part of it.  SPDX-License-Identifier: MIT-0

%% for i, h in ipairs(source_includes) do
#include ${h}
%%   if i == #source_includes then

%%   end
%% end
%% if declares_real then
typedef ${name}_real real;

%% end
