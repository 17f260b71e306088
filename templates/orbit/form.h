%% -- form.h -- what a closed form is: part of scene.h.  SPDX-License-Identifier: MIT-0
/* ---- closed form: ${theorem} ----
 *
%% for _, line in ipairs(closed_text) do
 * ${line}
%% end
 */
