/* Flight in the scene hoop, and where a body is touched.

   Generated from templates/js/flight.js.j2, scene hoop, derivation d045c64f80c6d78c,
   with SymPy 1.14.0 and Jinja2 3.1.6. Do not edit: change derive/ or templates/
   and run `make generate`.
   Numbers in, an array of numbers out; SI units. */
"use strict";

/**
 * Position and velocity at time t of a flight.
 *
 * Eq. 3. 11 operations: 3 additions, 2 subtractions, 6 multiplications.
 * Returns x, y, z, vx, vy, vz.
 */
function hoop_flight(t, x, y, z, vx, vy, vz, p_gravity) {
  return [x + (vx * t), y + (vy * t), z + (t * (vz - ((0.5 * p_gravity) * t))), vx, vy, vz - (p_gravity * t)];
}

/**
 * Outward unit normal n3 at a contact.
 *
 * Table 2. 13 operations: 2 additions, 1 subtraction, 7 multiplications, 2 divisions, 1 square root.
 * Returns nx, ny, nz.
 */
function hoop_ring_normal(x, y, z, p_ball_radius, p_ring_radius, p_wire_radius) {
  const _s0 = 1.0 / (p_ball_radius + p_wire_radius);
  const _s1 = Math.sqrt(((x * x) + (y * y)));
  const _s2 = (_s0 * (_s1 - p_ring_radius)) * (1.0 / _s1);
  return [x * _s2, y * _s2, z * _s0];
}

/**
 * Outward unit normal n3 at a contact.
 *
 * Table 2. No operations.
 * Returns nx, ny, nz.
 */
function hoop_backboard_normal() {
  return [1.0, 0.0, 0.0];
}

/**
 * Outward unit normal n3 at a contact.
 *
 * Table 2. No operations.
 * Returns nx, ny, nz.
 */
function hoop_bridge_normal() {
  return [0.0, 0.0, 1.0];
}

/**
 * Time at which the centre comes down to a height, and its upward velocity then.
 *
 * Eq. 3, solved. 14 operations: 2 additions, 2 subtractions, 4 multiplications, 1 division, 1 square root, 1 negation, 1 comparison, 2 selections.
 * Returns time, vz.
 */
function hoop_descent(z, vz, level, p_gravity) {
  const _s0 = z - level;
  const _s1 = Math.sqrt(((vz * vz) + ((2.0 * p_gravity) * _s0)));
  const _s2 = vz < 0.0;
  return [(_s2 ? (2.0 * _s0) : (vz + _s1)) / (_s2 ? (_s1 - vz) : p_gravity), -_s1];
}
