// The smallest change of one variable with which a shot ends otherwise, as hoopgen.counterfactual
// looks for it: many values are tried, the nearest change is narrowed down as far as doubles decide.
// Nothing is proved here.
"use strict";

const Nearest = (() => {
  const TRIALS = 2000; // values of the first look to each side
  const ROUNDS = 3; // in which gaps between values with different contacts are split
  const SPLIT = 8;
  const MAX_SPLIT = 400; // gaps of a round
  const SECTIONS = 64; // into which a gap is divided, again and again
  const RESULTS = ["outcome", "contacts", "counts", "first", "uncertain"];

  /** Return the range in which to look, about the value of the release. */
  function range(name, value, { away, limits }) {
    const wide = name === "distance" ? Math.min(away[name], Math.abs(value)) : away[name];
    const half = wide ?? 0.25 * Math.abs(value);
    const [least, most] = limits[name] ?? [-Infinity, Infinity];
    return [Math.min(Math.max(value - half, least), value), Math.max(Math.min(value + half, most), value)];
  }

  // Generators: they yield nothing after each step, so that a worker can look for newer questions.

  /**
   * Return the nearer change to both sides: {name, value, unchanged, changed}; null where there is
   * none. `run` simulates values of the variable; the other result must last `steady` times the
   * change.
   */
  function* change(name, value, made, run, ranges, steady = 0.05) {
    const found = [];
    for (const end of range(name, value, ranges)) {
      const gap = yield* towards(value, end, made, run, steady);
      if (gap) found.push(gap);
    }
    found.sort((one, other) => Math.abs(one[1] - value) - Math.abs(other[1] - value));
    if (!found.length) return null;
    return { name, value, unchanged: found[0][0], changed: found[0][1] };
  }

  function* towards(value, end, made, run, steady) {
    const reach = end - value;
    if (!reach || !Number.isFinite(reach)) return null;
    const near = Array.from({ length: TRIALS / 4 }, (_, k) => 10 ** (-9 + (9 * k) / (TRIALS / 4 - 1)));
    const even = Array.from({ length: (TRIALS * 3) / 4 }, (_, k) => k / ((TRIALS * 3) / 4 - 1));
    const away = ordered([...near, ...even]);
    const values = yield* refined(away.map((share) => value + reach * share), run);
    const [tried, changed] = yield* decided(values, made, run);
    for (let start = 1; start < tried.length; start++) {
      if (!changed[start]) continue;
      let stop = start;
      while (stop + 1 < tried.length && changed[stop + 1]) stop++;
      if (Math.abs(tried[stop] - tried[start]) >= steady * Math.abs(tried[start] - value)) {
        return yield* narrowed([tried[start - 1], tried[start]], made, run);
      }
      start = stop;
    }
    return null;
  }

  function ordered(values) {
    return [...new Set(values)].sort((one, other) => one - other);
  }

  /** Return more values, between those whose contacts differ. */
  function* refined(values, run) {
    let all = values;
    for (let round = 0; round < ROUNDS; round++) {
      const { marks } = yield* run(all);
      const between = [];
      for (let k = 1, gaps = 0; k < all.length && gaps < MAX_SPLIT; k++) {
        if (marks[k] === marks[k - 1]) continue;
        gaps++;
        for (let part = 1; part < SPLIT; part++) {
          between.push(all[k - 1] + ((all[k] - all[k - 1]) * part) / SPLIT);
        }
      }
      const up = all.at(-1) >= all[0];
      all = ordered([...all, ...between]);
      if (!up) all.reverse();
    }
    return all;
  }

  /** Return the values whose results are certain, and whether each is another; the first is not. */
  function* decided(values, made, run) {
    const found = yield* run(values);
    const keep = values.map((_, k) => k).filter((k) => k === 0 || found.marks[k] !== "");
    return [keep.map((k) => values[k]), keep.map((k) => k > 0 && found.made[k] !== made)];
  }

  function* narrowed(gap, made, run) {
    for (;;) {
      const step = (gap[1] - gap[0]) / SECTIONS;
      const inner = Array.from({ length: SECTIONS - 1 }, (_, k) => gap[0] + step * (k + 1));
      const [values, changed] = yield* decided([gap[0], ...inner, gap[1]], made, run);
      const last = changed.lastIndexOf(false);
      if (last + 1 >= values.length) return gap;
      const closer = [values[last], values[last + 1]];
      if (Math.abs(closer[1] - closer[0]) >= Math.abs(gap[1] - gap[0])) return gap;
      gap = closer;
    }
  }

  return { RESULTS, change, range };
})();
