%% -- taken.c -- the clock after a step that was taken, in NAME_METHOD_run: part of scene.c.  SPDX-License-Identifier: MIT-0
%% if has_knots then
    if (last) {
      if (!(end < t1 || end > t1)) return steps + 1;
      t = end;
      lost = ${zero};
      h *= factor;
      if (${fabs}(whole) > ${fabs}(h)) h = whole; /* it was cut short */
      continue;
    }
%% else
    if (last) return steps + 1;
%% end
    next_t = t + (h + lost);
    lost = (h + lost) - (next_t - t);
    t = next_t;
    h *= factor;
