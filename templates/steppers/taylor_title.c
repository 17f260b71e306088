%% -- taylor_title.c -- the heading of the Taylor series stepper: part of scene.c.  SPDX-License-Identifier: MIT-0
/* ---- Taylor series: Jorba, Zou 2005, Experimental Mathematics 14, 99; Knuth, TAOCP 2, 4.7 ---- */
