/* Flight in the scene hoop.

   Generated from templates/js/flight.js.j2, scene hoop, derivation 7ceba1546743c869,
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
