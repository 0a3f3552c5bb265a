// Releases and their scatter, kinds of shots, and the interval of a share: as hoopgen has them.
"use strict";

const Release = (() => {
  const ARGUMENTS = "speed elevation azimuth backspin sidespin height distance angle".split(" ");
  const BLOCK = 1 << 26;

  /** Write the state of a release into an array, at a place: `hoopgen.release`, its operations in
   * their order, with the sine and cosine of `engine`. Lengths in m, angles in rad. */
  function write(states, at, release, engine, ringHeight) {
    const { speed, elevation, azimuth, backspin, sidespin, height, distance, angle } = release;
    const heading = azimuth + angle;
    const [aheadX, aheadY] = [-engine.cos(heading), -engine.sin(heading)];
    const fast = speed < 0 ? NaN : speed; // an angle gives the direction
    const level = fast * engine.cos(elevation);
    states[at] = distance * engine.cos(angle) + 0; // no negative zeros
    states[at + 1] = distance * engine.sin(angle) + 0;
    states[at + 2] = height - ringHeight + 0;
    states[at + 3] = level * aheadX + 0;
    states[at + 4] = level * aheadY + 0;
    states[at + 5] = fast * engine.sin(elevation) + 0;
    states[at + 6] = backspin * aheadY + 0;
    states[at + 7] = backspin * -aheadX + 0;
    states[at + 8] = sidespin + 0;
  }

  /** Return the states of many releases, which differ from one in some arguments' columns. */
  function states(release, columns, count, engine, ringHeight) {
    const found = new Float64Array(9 * count);
    const own = { ...release };
    for (let row = 0; row < count; row++) {
      for (const [name, values] of Object.entries(columns)) own[name] = values[row];
      write(found, 9 * row, own, engine, ringHeight);
    }
    return found;
  }

  /** Return numbers of a normal distribution: sfc32 (C. Doty-Humphrey, PractRand), 53 bits of two
   * of its numbers, and G. Marsaglia's polar method, whose logarithm is that of `engine`. */
  function normals(count, seed, engine) {
    let [a, b, c, counter] = [0, seed | 0, seed < 2 ** 32 ? 0 : (seed / 2 ** 32) | 0, 1];
    const word = () => {
      const sum = (a + b + counter) | 0;
      counter = (counter + 1) | 0;
      a = b ^ (b >>> 9);
      b = (c + (c << 3)) | 0;
      c = (((c << 21) | (c >>> 11)) + sum) | 0;
      return sum >>> 0;
    };
    for (let k = 0; k < 15; k++) word();
    const even = () => ((word() >>> 5) * BLOCK + (word() >>> 6)) / (BLOCK * 2 ** 27);
    const found = new Float64Array(count);
    for (let k = 0; k < count; ) {
      const [u, v] = [2 * even() - 1, 2 * even() - 1];
      const square = u * u + v * v;
      if (square >= 1 || square === 0) continue;
      const scale = Math.sqrt((-2 * engine.log(square)) / square);
      found[k++] = u * scale;
      if (k < count) found[k++] = v * scale;
    }
    return found;
  }

  /** Return the kind of each shot, by the table of hoopgen.hoop.kinds. */
  function kinds({ outcome, counts, first }, { table, bodies }) {
    const [ring, board, bridge] = ["ring", "backboard", "bridge"].map((name) => bodies.indexOf(name));
    return outcome.map((end, row) => {
      const touched = (body) => counts[bodies.length * row + body] > 0;
      const frame = touched(ring) || touched(bridge);
      return table[touched(board) * 1 + frame * 2 + (first[row] === board) * 4][end];
    });
  }

  /** Return the ends of Wilson's score interval of a share; z is the normal quantile. */
  function wilson(made, shots, z) {
    if (!shots) return [0, 1];
    const half = z * Math.sqrt((made * (shots - made)) / shots + 0.25 * z * z);
    const [middle, whole] = [made + 0.5 * z * z, shots + z * z];
    return [made > 0 ? (middle - half) / whole : 0, made < shots ? (middle + half) / whole : 1];
  }

  return { ARGUMENTS, kinds, normals, states, wilson, write };
})();
