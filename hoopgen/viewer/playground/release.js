// Arguments of releases, and kinds of shots, as hoopgen has them.
"use strict";

const Release = (() => {
  /** Return the arguments of releases as `hoopgen.release` takes them: lengths in m, angles in rad,
   * numbers or columns; what is never negative is not a number where it is. */
  function checked(given, names) {
    const from = (value) => (value < 0 ? NaN : value);
    const own = names.map((name) => [name, typeof given[name] === "number" ? from(given[name]) : given[name].map(from)]);
    return { ...given, ...Object.fromEntries(own) };
  }

  /** Return the kind of each shot, by the table of hoopgen.hoop.kinds. */
  function kinds({ outcome, counts, first }, { table, bodies }) {
    const [ring, board, bridge] = ["ring", "backboard", "bridge"].map((name) => bodies.indexOf(name));
    const touched = (row, body) => counts[bodies.length * row + body] > 0;
    return outcome.map((end, row) => {
      const frame = touched(row, ring) || touched(row, bridge);
      return table[touched(row, board) * 1 + frame * 2 + (first[row] === board) * 4][end];
    });
  }

  return { checked, kinds };
})();
