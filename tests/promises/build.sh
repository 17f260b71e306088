#!/bin/sh
# build.sh - compiles one emitted project once; what the compilers say and made is judged by judge.lua.
# SPDX-License-Identifier: GPL-3.0-or-later
#
#   build.sh DIRECTORY NAME LEVEL C C++
# LEVEL: -O0 ..; C: a further standard that clang is to hold it against, c11 ..; C++: a compiler with its standard,
# "g++ -std=c++17" ..
#
# Leaves in DIRECTORY: said (all warnings and errors), NAME.o, NAME.nm, NAME.ci (calls and frames), NAME.sections.
# -O0: the calls are those of the source, none inlined, none made a jump.

cd "$1" || exit 1
export LC_ALL=C
name=$2 level=$3 c=$4 cxx=$5
warn="-pedantic -Wall -Wextra -Wconversion -Wdouble-promotion -Wshadow -ffp-contract=off"
more="-Wcast-align -Wcast-qual -Wundef -Wvla -Wunused-macros -Wredundant-decls -Wformat=2 -Wsign-conversion
  -Wfloat-conversion -Wmissing-declarations -Wpointer-arith -Wwrite-strings -Wswitch-default -Wswitch-enum"
only_c="-Wstrict-prototypes -Wmissing-prototypes -Wold-style-definition -Wnested-externs -Wbad-function-cast
  -Wc++-compat"
gcc="-Walloca -Wlogical-op -Wduplicated-cond -Wduplicated-branches -Wnull-dereference"
clang="-Wunreachable-code -Wcomma -Wassign-enum -Wshorten-64-to-32 -Wextra-semi
  -Wmissing-variable-declarations"

# On x86 gcc pushes the arguments that do not fit into registers and calls such a frame dynamic,bounded, in which they
# are not counted; set apart beforehand, as other processors have it, the frame is static.
case $(gcc -dumpmachine) in
x86_64* | i?86*) gcc="$gcc -maccumulate-outgoing-args" ;;
esac

# The header alone, included twice; what a user's own file sees of it.
printf '#include "%s.h"\n#include "%s.h"\nextern int user;\nint user;\n' "$name" "$name" >twice.c
{
  # shellcheck disable=SC2086
  gcc -std=c99 $level $warn $more $only_c $gcc -fno-math-errno -fcallgraph-info=su -c "$name.c" -o "$name.o"
  # shellcheck disable=SC2086
  clang -std="$c" $warn $more $only_c $clang -fsyntax-only "$name.c"
  # shellcheck disable=SC2086
  gcc -std="$c" $warn $more $only_c $gcc -fsyntax-only twice.c
  # shellcheck disable=SC2086
  $cxx -x c++ $warn $more -fsyntax-only "$name.c" "${name}_test.c" twice.c
} >said 2>&1
nm "$name.o" >"$name.nm" 2>&1
objdump -h "$name.o" >"$name.sections" 2>&1
exit 0
