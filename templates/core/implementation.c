%% -- implementation.c -- the code behind the header of a scene in one file.  SPDX-License-Identifier: MIT-0

/* The code, in the one file of the program that defines ${upper}_IMPLEMENTATION before it includes this. */
#if defined ${upper}_IMPLEMENTATION && !defined POLHODE_${upper}_IMPLEMENTED
#define POLHODE_${upper}_IMPLEMENTED
${preamble}
${definitions}
#endif
