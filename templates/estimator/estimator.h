%% -- estimator.h -- the tensor of inertia from a gyro: part of scene.h.  SPDX-License-Identifier: MIT-0
/* ---- the tensor of inertia from measured rates ----
 * Recursive least squares in fixed memory for theta, the entries xx yy zz xy xz yz of the tensor
 * (off-diagonals are tensor entries), with I w = W(w) theta.  Euler's equation
 * d(I w + h)/dt + w x (I w + h) = N, times f = sin(k pi t/T), k = 1 and 2, is integrated by parts
 * over a window of length T, so that no measured value is differentiated [Shinbrot 1957]:
 *   [int f w x W(w) dt - int f' W(w) dt] theta = int f (N - w x h) dt + int f' h dt
 * N: torques in body axes, h: momentum of wheels and rotors relative to the body.  The integrals are
 * sums over the samples, each at the middle of its interval, with f' times tan(d)/d, d = k pi/2n,
 * which makes them exact where the rates change evenly.
 * The noise n of a sample enters the equations as M n, M = f (w x I - (I w + h) x) - f' I, and no
 * sample belongs to two windows: so the covariance is that of the noise, and nothing is tuned.
 * (I in M is the estimate once its errors are below a sixteenth, before that the model's.)
 * Without a torque that is known only ratios are determined: hold one entry (its error is 0).
 * A window of a quarter to half a turn of the motion tells most; where the rates change by less than
 * the noise within it, the estimate tends to 0.  Subtract a gyro's bias first. */
typedef struct {
  ${name}_real theta[6]; /* the estimate, in units of `moment` */
  ${name}_real U[6][6], D[6]; /* its covariance U D U^T, U unit upper triangular, in moment^2 */
  ${name}_real I[3][3]; /* the tensor that turns noise into the equations', in `moment` */
  ${name}_real moment; /* kg m^2: a third of the trace of the model's tensor */
  ${name}_real dt, sigma, variance[3]; /* s, rad/s, and of each axis (its sigma/sigma)^2 */
  ${name}_real start[2], turn[2]; /* cosine and sine of pi/2n and pi/n */
  ${name}_real slope[2]; /* f' dt over the cosine, k = 1 and 2 */
  ${name}_real c, s; /* cosine and sine of pi t/T at the next sample */
  ${name}_real w[3], h[3]; /* of the window's first sample */
  ${name}_real A[6][6], b[6], R[6][6]; /* A theta = b and the covariance of b in sigma^2, R's lower half */
  ${name}_real chi2; /* sum of the squares of all innovations, in their variances: about `rows` */
  long rows; /* equations taken */
  int window, count; /* samples of a window, and so far */
} ${name}_estimator;

/* Begins with the model's tensor.  dt: between samples, s; window: samples, from 4 on; sigma: the
 * gyro's standard deviations a sample, rad/s, positive; error: how far the model's entries may be
 * off, kg m^2, a standard deviation each; 0 holds an entry.  Returns 0, or 1 if one of them is out
 * of range or the model has no moment. */
int ${name}_estimator_open(${name}_estimator *e, const ${name}_model *m, ${name}_real dt, int window, const ${name}_real sigma[3], const ${name}_real error[6]);

/* One sample: rates in rad/s, torque N and momentum h in body axes or null pointers.  Returns 0; 1
 * if the window is complete (a sample beyond that is left out): ${name}_estimator_solve is due, at
 * any time; 2 if a number is not finite, and the window begins anew. */
int ${name}_estimator_add(${name}_estimator *e, const ${name}_real w[3], const ${name}_real torque[3], const ${name}_real h[3]);

/* A gap in the samples: the window begins anew. */
void ${name}_estimator_gap(${name}_estimator *e);

/* The window's six equations move the estimate, and the next window begins.  Returns 0, 1 if the
 * window is not complete (nothing is done), 2 if one of its numbers is out of range (it is left out). */
int ${name}_estimator_solve(${name}_estimator *e);

/* The estimate and its standard errors, kg m^2. */
void ${name}_estimator_inertia(const ${name}_estimator *e, ${name}_real I[6], ${name}_real error[6]);

/* The covariance by rows, in moment^2. */
void ${name}_estimator_covariance(const ${name}_estimator *e, ${name}_real C[36]);

/* Iyy/Ixx and Izz/Ixx with their standard errors, to first order.  Returns 1 if Ixx is not positive. */
int ${name}_estimator_ratios(const ${name}_estimator *e, ${name}_real ratio[2], ${name}_real error[2]);
