/* status.c - what the status codes mean, in words, and the version.
   SPDX-License-Identifier: GPL-3.0-or-later

   One list in the order of enum ph_status: a phrase states the rule that was broken, without a full
   stop, so that a caller can put it into a sentence of its own. */
#include "polhode.h"

/* ORDER of enum ph_status (polhode.h). */
static const char *const phrases[] = {
    "no error",
    "a number is not finite",
    "a result exceeds the range of double precision",
    "mass and density must be positive",
    "lengths and scale factors must be positive",
    "an inner size must be smaller than the outer one",
    "wrong number of items",
    "no shape has that name",
    "a hole must lie within the body that it is taken from",
    "points, edges or a matrix must span an area or a volume",
    "an outline must not cross, touch or repeat itself",
    "a height, angle, coordinate or limit exceeds what the shape allows",
    "a moment of inertia must not be negative",
    "a principal moment must not exceed the sum of the other two",
    "a direction must not be the zero vector",
    "a quaternion must not be zero",
    "a rotation matrix must be orthonormal and right-handed",
    "Euler angles need three axes of x, y, z, neighbours different",
    "a plane must be touched in one point, not by a disc that lies flat",
    "torque about an axis that has no moment of inertia",
    "the method is unknown or cannot do what is asked",
    "no steps lead on: the step is not positive, or so short that time stands still",
    "tolerance or order is outside its bounds",
    "more steps than allowed",
    "out of memory",
    "the file cannot be read",
    "the file is malformed",
    "the volume of a mesh is defined only if its faces close",
    "the mesh has no volume, area or length",
    "the equations jump here and drive the motion back to the jump from both sides",
};

_Static_assert(sizeof phrases / sizeof phrases[0] == PH_ECHATTER + 1, "one phrase for each status");

const char *ph_status_phrase(int status) {
  return status >= 0 && status <= PH_ECHATTER ? phrases[status] : "unknown status";
}

const char *ph_version(void) {
  return PH_VERSION;
}
