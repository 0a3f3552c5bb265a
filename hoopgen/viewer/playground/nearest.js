// The smallest change of one variable with which a shot ends otherwise, as hoopgen.counterfactual
// looks for it: many values are tried, the nearest change is narrowed down as far as doubles decide.
// Nothing is proved here.
"use strict";

const Nearest = (() => {
  const TRIALS = 2000; // values of the first look to each side
  const ROUNDS = 3; // in which gaps between values with different contacts are split
  const BLOCK = 25; // values that are tried before the other side's: those beyond a change are few
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
   * Return the nearer change to both sides: {name, value, unchanged, changed}, without the last two
   * where there is none. `run` simulates values of the variable, and gives null once it is late;
   * the other result must last `steady` times the change. The sides are looked through outwards, in
   * turns, so that hardly anything beyond the nearer change is simulated. Once `late()`, the look
   * ends; `within` is how far it came where a change, or a nearer one, may be further away.
   */
  function* change(name, value, made, run, ranges, { steady = 0.05, late = () => false } = {}) {
    const sides = range(name, value, ranges).map((end) => of(value, end, made, run, { steady, late }));
    const least = () => Math.min(...sides.map((side) => (side.gap ? Math.abs(side.gap[1] - value) : Infinity)));
    const open = () => sides.filter((side) => !side.done && side.clear() < least());
    for (let left = open(); left.length; left = open()) {
      if (late()) break;
      left.sort((one, other) => one.tried() - other.tried());
      yield* left[0].further();
    }
    const gaps = sides.flatMap(({ gap }) => (gap ? [gap] : []));
    gaps.sort((one, other) => Math.abs(one[1] - value) - Math.abs(other[1] - value));
    const within = open().length ? { within: Math.min(...open().map((side) => side.clear())) } : {};
    if (!gaps.length) return { name, value, ...within };
    return { name, value, unchanged: gaps[0][0], changed: gaps[0][1], ...within };
  }

  /** Return the look to one side. `further` simulates the next values; `gap` is there once a change
   * is found; up to the distance `clear` there is none; values are tried up to the distance `tried`. */
  function of(value, end, made, run, { steady, late }) {
    const reach = end - value;
    const some = (TRIALS * 3) / 4;
    const near = Array.from({ length: TRIALS / 4 }, (_, k) => 10 ** (-9 + (9 * k) / (TRIALS / 4 - 1)));
    const even = Array.from({ length: some }, (_, k) => k / (some - 1));
    const away = ordered([...near, ...even]);
    const splits = Array(ROUNDS).fill(0); // gaps of each round, so far
    let [next, last] = [0, null]; // of `away`, and the last value there with its mark
    let start = 1; // the first of `values` that is not looked at
    const [values, changed] = [[], []]; // of those that are decided
    const side = { gap: null, done: !reach || !Number.isFinite(reach), clear, tried, further };
    return side;

    function clear() {
      return Math.abs((values[start - 1] ?? value) - value);
    }

    function tried() {
      return Math.abs(last === null ? 0 : last.at - value);
    }

    function* further() {
      const block = away.slice(next, next + BLOCK).map((share) => value + reach * share);
      const found = yield* refined(last, block, (some) => run(some, late), splits, reach > 0);
      if (!found) return; // it is late
      next += BLOCK;
      for (const one of found.slice(last === null ? 0 : 1)) {
        const first = !values.length;
        if (!first && one.mark === "") continue;
        values.push(one.at);
        changed.push(!first && one.made !== made);
      }
      last = found.at(-1);
      yield* judge(next >= away.length);
    }

    /** Look for a change that lasts among the values so far; `whole`: no more will come. */
    function* judge(whole) {
      for (; start < values.length; start++) {
        if (!changed[start]) continue;
        let stop = start;
        while (stop + 1 < values.length && changed[stop + 1]) stop++;
        if (Math.abs(values[stop] - values[start]) >= steady * Math.abs(values[start] - value)) {
          side.gap = yield* narrowed([values[start - 1], values[start]], made, run);
          side.done = true;
          return;
        }
        if (stop + 1 === values.length && !whole) return; // it may last
        start = stop;
      }
      side.done = whole;
    }
  }

  function ordered(values) {
    return [...new Set(values)].sort((one, other) => one - other);
  }

  /** Return the results of values, and of more between those whose contacts differ: {at, made, mark}.
   * Null if it is late. `last` is the one before them, and `splits` counts the gaps of each round. */
  function* refined(last, values, run, splits, up) {
    const known = new Map(last === null ? [] : [[last.at, last]]);
    let all = last === null ? values : [last.at, ...values];
    for (let round = 0; ; round++) {
      const fresh = all.filter((at) => !known.has(at));
      const simulated = yield* run(fresh);
      if (!simulated) return null;
      const { made, marks } = simulated;
      fresh.forEach((at, k) => known.set(at, { at, made: made[k], mark: marks[k] }));
      if (round === ROUNDS) return all.map((at) => known.get(at));
      const between = [];
      for (let k = 1; k < all.length && splits[round] < MAX_SPLIT; k++) {
        if (known.get(all[k]).mark === known.get(all[k - 1]).mark) continue;
        splits[round]++;
        for (let part = 1; part < SPLIT; part++) {
          between.push(all[k - 1] + ((all[k] - all[k - 1]) * part) / SPLIT);
        }
      }
      all = ordered([...all, ...between]);
      if (!up) all.reverse();
    }
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
