// The ball between its contacts, by the generated kernel `flight` (Eq. 3): a position here has the
// same bits as hoopgen.Trajectory.at gives. Where it rolls it is followed in short pieces, each a
// cubic with the positions and velocities at its ends, and with a spin that changes evenly.
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

  /** Tell whether the ball rolls from one of a shot's flights to the next. */
  function rolls(shot, k) {
    return shot.rolls.some(([first, end]) => first <= k && k < end);
  }

  /** Return the state some seconds into a piece of a roll. */
  function rolled(piece, next, t) {
    const lasts = next[0] - piece[0];
    if (!(lasts > 0)) return piece.slice(1);
    const s = t / lasts;
    const between = (k) => piece[k] + s * (next[k] - piece[k]);
    const moved = [1, 2, 3].map((k) => {
      const step = next[k] - piece[k];
      const [from, to] = [lasts * piece[k + 3] - step, step - lasts * next[k + 3]];
      const place = between(k) + s * (1 - s) * ((1 - s) * from + s * to);
      return [place, (step + (1 - s) * (1 - 3 * s) * from + s * (2 - 3 * s) * to) / lasts];
    });
    return [0, 1].flatMap((k) => moved.map((one) => one[k])).concat([7, 8, 9].map(between));
  }

  /** Return when a shot is no longer followed, s: at its end, or when the ball is on the floor. */
  function lasts(shot) {
    return shot.floor_time ?? shot.duration;
  }

  /** Return the state of a shot at a time, s. After its end the ball falls on to the floor, as if
   * it touched nothing: that is not simulated. Where there is no floor, it stays at the end. */
  function stateAt(shot, asked) {
    const time = Math.min(asked, lasts(shot));
    const k = indexAt(shot.flights, time);
    const [flight, next] = [shot.flights[k], shot.flights[k + 1]];
    if (rolls(shot, k)) return rolled(flight, next, time - flight[0]);
    return along(flight, time - flight[0], shot.parameters.gravity);
  }

  /** Return the mean spin over the first seconds of a flight, in which it is constant, or a roll. */
  function spinOver(shot, k, seconds) {
    const [flight, next] = [shot.flights[k], shot.flights[k + 1]];
    if (!rolls(shot, k)) return flight.slice(7);
    return rolled(flight, next, seconds / 2).slice(6);
  }

  /** Return points that show a shot's path as smooth curves, contacts among them. A parabola cut
   * into n pieces is off by 1/n² of its height at most: a long flight needs no more than `most`. */
  function pathOf(shot, step = 0.02, most = 200) {
    const { flights } = shot;
    const points = [flights[0].slice(1, 4)];
    for (let k = 0; k + 1 < flights.length; k++) {
      const lasts = flights[k + 1][0] - flights[k][0];
      const pieces = rolls(shot, k) ? 1 : Math.max(1, Math.min(most, Math.ceil(lasts / step)));
      for (let i = 1; i < pieces; i++) {
        points.push(along(flights[k], (lasts * i) / pieces, shot.parameters.gravity).slice(0, 3));
      }
      points.push(flights[k + 1].slice(1, 4));
    }
    return points;
  }

  /** Return points of a ball's fall from the end of its shot to the floor; none if there is none. */
  function fallOf(shot, pieces = 40) {
    const { duration } = shot;
    const over = lasts(shot) - duration;
    if (!(over > 0)) return [];
    const times = Array.from({ length: pieces + 1 }, (_, k) => duration + (over * k) / pieces);
    return times.map((time) => stateAt(shot, time).slice(0, 3));
  }

  return { fallOf, indexAt, lasts, stateAt, spinOver, pathOf };
})();
