// The ball between its contacts, by the generated kernel `flight` (Eq. 3): a position here has the
// same bits as hoopgen.Trajectory.at gives.
"use strict";

const Flight = (() => {
  /** Return the index of the flight at a time, s; at a contact, of the one that starts there. */
  function indexAt(flights, time) {
    let low = 0;
    let high = flights.length;
    while (high - low > 1) {
      const middle = (low + high) >> 1;
      if (flights[middle][0] <= time) low = middle;
      else high = middle;
    }
    return low;
  }

  /** Return x y z (m), vx vy vz (m/s), wx wy wz (rad/s), so many seconds into a flight. */
  function along(flight, t, gravity) {
    const [, x, y, z, vx, vy, vz, ...spin] = flight;
    return [...hoop_flight(t, x, y, z, vx, vy, vz, gravity), ...spin];
  }

  /** Return the state of a shot at a time, s. */
  function stateAt(shot, time) {
    const flight = shot.flights[indexAt(shot.flights, time)];
    return along(flight, time - flight[0], shot.parameters.gravity);
  }

  /** Return points that show a shot's path as smooth curves, contacts among them. A parabola cut
   * into n pieces is off by 1/n² of its height at most: a long flight needs no more than `most`. */
  function pathOf(shot, step = 0.02, most = 200) {
    const { flights } = shot;
    const points = [flights[0].slice(1, 4)];
    for (let k = 0; k + 1 < flights.length; k++) {
      const lasts = flights[k + 1][0] - flights[k][0];
      const pieces = Math.max(1, Math.min(most, Math.ceil(lasts / step)));
      for (let i = 1; i < pieces; i++) {
        points.push(along(flights[k], (lasts * i) / pieces, shot.parameters.gravity).slice(0, 3));
      }
      points.push(flights[k + 1].slice(1, 4));
    }
    return points;
  }

  return { indexAt, stateAt, pathOf };
})();
