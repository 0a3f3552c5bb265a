/* Formulas of studies that need no scene: releases, and the interval of a share.

   Generated from templates/js/studies.js.j2, the same for every scene, with
   Jinja2 3.1.6. Do not edit: change templates/ and run `make generate`.
   Numbers in, an array of numbers out; SI units. */
"use strict";

/**
 * Direction from the ring's centre opposite to which the ball is sent.
 *
 * h = azimuth + angle. 1 operation: 1 addition.
 * Returns heading.
 */
function release_heading(azimuth, angle) {
  return [azimuth + angle];
}

/**
 * State of a release, given the sine and the cosine of its angles.
 *
 * ahead = -(cos h, sin h). 12 operations: 1 subtraction, 8 multiplications, 3 negations.
 * Returns x, y, z, vx, vy, vz, wx, wy, wz.
 */
function release_state(speed, backspin, sidespin, height, distance, ring_height, sin_heading, cos_heading, sin_elevation, cos_elevation, sin_angle, cos_angle) {
  const _s0 = -cos_heading;
  const _s1 = speed * cos_elevation;
  const _s2 = -sin_heading;
  return [distance * cos_angle, distance * sin_angle, height - ring_height, _s0 * _s1, _s2 * _s1, speed * sin_elevation, backspin * _s2, -(backspin * _s0), sidespin];
}

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
