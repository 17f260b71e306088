%% -- split_title.c -- the heading of the splitting steppers: part of scene.c.  SPDX-License-Identifier: MIT-0
/* ---- Splitting: Dullweber, Leimkuhler, McLachlan 1997, J. Chem. Phys. 107, 5840; McLachlan, Quispel 2002 ---- */
