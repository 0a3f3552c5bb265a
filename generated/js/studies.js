/* The interval of a share.

   Generated from templates/js/studies.js.j2, the same for every scene, with
   Jinja2 3.1.6. Do not edit: change templates/ and run `make generate`.
   Numbers in, an array of numbers out; SI units. */
"use strict";

/**
 * Ends of the score interval of a share.
 *
 * Wilson (1927). 19 operations: 4 additions, 2 subtractions, 5 multiplications, 3 divisions, 1 square root, 2 comparisons, 2 selections.
 * Returns low, high.
 */
function wilson_interval(made, shots, quantile) {
  const _s0 = quantile * quantile;
  const _s1 = shots + _s0;
  const _s2 = made + (0.5 * _s0);
  const _s3 = quantile * Math.sqrt(((0.25 * _s0) + ((made * (shots - made)) / shots)));
  return [(0.0 < made) ? ((_s2 - _s3) / _s1) : 0.0, (made < shots) ? ((_s3 + _s2) / _s1) : 1.0];
}
