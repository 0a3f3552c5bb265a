/* Flight in the scene court, and where a body is touched.

   Generated from templates/js/flight.js.j2, scene court, derivation 6850e5812fbcfc63,
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
function court_flight(t, x, y, z, vx, vy, vz, p_gravity) {
  return [x + (vx * t), y + (vy * t), z + (t * (vz - ((0.5 * p_gravity) * t))), vx, vy, vz - (p_gravity * t)];
}

/**
 * Outward unit normal n3 at a contact.
 *
 * Table 2. 13 operations: 2 additions, 1 subtraction, 7 multiplications, 2 divisions, 1 square root.
 * Returns nx, ny, nz.
 */
function court_ring_normal(x, y, z, p_ball_radius, p_ring_radius, p_wire_radius) {
  const _s0 = 1.0 / (p_ball_radius + p_wire_radius);
  const _s1 = Math.sqrt(((x * x) + (y * y)));
  const _s2 = (_s0 * (_s1 - p_ring_radius)) * (1.0 / _s1);
  return [x * _s2, y * _s2, z * _s0];
}

/**
 * Outward unit normal n3 at a contact.
 *
 * Table 2. 36 operations: 6 additions, 6 subtractions, 4 multiplications, 3 divisions, 1 square root, 2 negations, 7 comparisons, 7 selections.
 * Returns nx, ny, nz.
 */
function court_backboard_normal(x, y, z, p_ball_radius, p_board_distance, p_board_half_width, p_board_bottom, p_board_top, p_board_thickness) {
  const _s0 = p_board_distance + x;
  const _s1 = -((p_board_distance + p_board_thickness) + x);
  const _s2 = (_s0 < 0.0 ? 0.0 : _s0) - (_s1 < 0.0 ? 0.0 : _s1);
  const _s3 = y - p_board_half_width;
  const _s4 = -(p_board_half_width + y);
  const _s5 = (_s3 < 0.0 ? 0.0 : _s3) - (_s4 < 0.0 ? 0.0 : _s4);
  const _s6 = z - p_board_top;
  const _s7 = p_board_bottom - z;
  const _s8 = (_s6 < 0.0 ? 0.0 : _s6) - (_s7 < 0.0 ? 0.0 : _s7);
  const _s9 = Math.sqrt((((_s2 * _s2) + (_s5 * _s5)) + (_s8 * _s8)));
  const _s10 = 0.5 * p_ball_radius;
  const _s11 = _s9 < _s10 ? _s10 : _s9;
  return [_s2 / _s11, _s5 / _s11, _s8 / _s11];
}

/**
 * Outward unit normal n3 at a contact.
 *
 * Table 2. 36 operations: 5 additions, 7 subtractions, 4 multiplications, 3 divisions, 1 square root, 2 negations, 7 comparisons, 7 selections.
 * Returns nx, ny, nz.
 */
function court_bridge_normal(x, y, z, p_ball_radius, p_ring_radius, p_wire_radius, p_board_distance, p_bridge_half_width, p_bridge_depth) {
  const _s0 = p_ring_radius + x;
  const _s1 = -(p_board_distance + x);
  const _s2 = (_s0 < 0.0 ? 0.0 : _s0) - (_s1 < 0.0 ? 0.0 : _s1);
  const _s3 = z - p_wire_radius;
  const _s4 = (p_wire_radius - p_bridge_depth) - z;
  const _s5 = (_s3 < 0.0 ? 0.0 : _s3) - (_s4 < 0.0 ? 0.0 : _s4);
  const _s6 = y - p_bridge_half_width;
  const _s7 = -(p_bridge_half_width + y);
  const _s8 = (_s6 < 0.0 ? 0.0 : _s6) - (_s7 < 0.0 ? 0.0 : _s7);
  const _s9 = Math.sqrt((((_s2 * _s2) + (_s5 * _s5)) + (_s8 * _s8)));
  const _s10 = 0.5 * p_ball_radius;
  const _s11 = _s9 < _s10 ? _s10 : _s9;
  return [_s2 / _s11, _s8 / _s11, _s5 / _s11];
}

/**
 * Time at which the centre comes down to a height, and its upward velocity then.
 *
 * Eq. 3, solved. 14 operations: 2 additions, 2 subtractions, 4 multiplications, 1 division, 1 square root, 1 negation, 1 comparison, 2 selections.
 * Returns time, vz.
 */
function court_descent(z, vz, level, p_gravity) {
  const _s0 = z - level;
  const _s1 = Math.sqrt(((vz * vz) + ((2.0 * p_gravity) * _s0)));
  const _s2 = vz < 0.0;
  return [(_s2 ? (2.0 * _s0) : (vz + _s1)) / (_s2 ? (_s1 - vz) : p_gravity), -_s1];
}
