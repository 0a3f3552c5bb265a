// What a worker computes of a shot: its scatter, the map about it, and its nearest changes.
"use strict";

const Study = (() => {
  const RESULTS = ["outcome", "counts", "first", "state"];

  const MAX_PIECES = 120; // of a shot's rolls
  const PATIENCE = 5000; // ms in which a variable's nearest change is looked for
  const STRIDE = 100; // values of a variable that are simulated without a look at newer questions

  /** Return what the page knows of a scene, with what all scenes share. Null is infinity there. */
  function specOf(page, scene) {
    const { scenes, variables, ...shared } = page;
    const { presets, limit, fields, ...own } = scenes[scene];
    const values = Object.entries(presets).map(([name, preset]) => {
      return [name, Object.fromEntries(Object.entries(preset).map(([key, value]) => [key, value ?? Infinity]))];
    });
    return {
      ...{ ...shared, ...own, scene },
      presets: Object.fromEntries(values),
      limit: limit ?? Infinity,
      variables: { ...variables, scene: fields },
    };
  }

  /** Return the studies of a scene, of which `modules` has the builds by their names. */
  async function start(spec, modules) {
    const own = spec.modules.map((one) => ({ ...one, bytes: modules[one.name] }));
    const engine = await Engine.start(own, spec.layout);
    return { engine, spec, ...of(engine, spec) };
  }

  /** Return the studies of one engine; `spec` is that of its scene. */
  function of(engine, spec) {
    const { ring_height: ringHeight, most, limit } = spec;
    const made = spec.outcomes.indexOf("made");
    const invalid = spec.outcomes.indexOf("invalid");

    function simulate(states, parameters, results, record = false) {
      return engine.simulate(states, parameters, { most, limit, results, record });
    }

    /** Return the states of releases; an argument is one number, or a column. */
    function states(given, count) {
      return engine.releases(Release.checked(given, spec.from_zero), count, ringHeight);
    }

    /** Return one shot with its event log, all results, its release, and its rolls. */
    function shot({ release, parameters }) {
      const thrown = states(release, 1);
      const results = spec.layout.results.map(([name]) => name);
      const found = simulate(thrown, parameters, results, true);
      const rolls = rollsOf(found.events[0], thrown, parameters);
      return { ...found, kind: Release.kinds(found, spec.kinds)[0], release: [...thrown], rolls };
    }

    /** Return the rolls of a shot: the row of the event log with which each begins, and states
     * along it. The engine ends the shot at a time, and its state there is that of the ball. */
    function rollsOf(events, thrown, parameters) {
      const begun = events.flatMap(({ kind }, row) => {
        return spec.layout.events[kind] === "roll" && row + 1 < events.length ? [row] : [];
      });
      const lasts = (row) => events[row + 1].time - events[row].time;
      const all = begun.reduce((sum, row) => sum + lasts(row), 0);
      const step = Math.max(spec.roll_piece, all / MAX_PIECES);
      return begun.map((row) => {
        const count = Math.max(1, Math.ceil(lasts(row) / step));
        const pieces = [];
        for (let k = 1; k < count; k++) {
          const time = events[row].time + (lasts(row) * k) / count;
          const { state } = engine.simulate(thrown, parameters, { most, limit: time, results: ["state"] });
          pieces.push([time, ...state]);
        }
        return { row, pieces };
      });
    }

    /** Return releases about one, as `hoopgen.Scatter` draws them: each argument with a deviation
     * is normal, independently of the others. */
    function drawn({ release, deviations, seed, count }) {
      const names = spec.layout.arguments.filter((name) => deviations[name]);
      const streams = names.map((name) => spec.layout.arguments.indexOf(name));
      const noise = engine.noise(streams, names.map((name) => deviations[name]), seed, count);
      const columns = names.map((name, k) => [name, noise[k].map((away) => release[name] + away)]);
      return states({ ...release, ...Object.fromEntries(columns) }, count);
    }

    /** Return throws about a release. */
    function scatter(question) {
      const { parameters, count } = question;
      const thrown = drawn(question);
      const found = simulate(thrown, parameters, RESULTS);
      const kinds = Release.kinds(found, spec.kinds);
      const tally = spec.kinds.names.map(() => [0, 0]); // made, and not
      let [valid, total] = [0, 0];
      found.outcome.forEach((end, row) => {
        valid += end !== invalid;
        total += end === made;
        tally[kinds[row]][Number(end !== made)] += end !== invalid;
      });
      return {
        ...{ count: valid, made: total, invalid: count - valid, tally },
        interval: wilson_interval(total, valid, spec.z),
        ...{ outcome: found.outcome, kinds },
        ...entries(thrown, parameters),
        landings: landings(found, parameters),
      };
    }

    /** Return where balls come down to a height above the ring as if they touched nothing, x and y
     * of each row that is wanted, and NaN of others; `tell` is given the velocity there. */
    function arrivals(states, height, gravity, wanted, tell = () => {}) {
      const places = new Float32Array((2 * states.length) / 9).fill(NaN);
      for (let row = 0, at = 0; at < states.length; row++, at += 9) {
        if (!wanted(row)) continue;
        const [z, vx, vy, vz] = [states[at + 2], states[at + 3], states[at + 4], states[at + 5]];
        const [time, down] = hoop_descent(z, vz, height, gravity);
        if (!(time > 0)) continue;
        const there = hoop_flight(time, states[at], states[at + 1], z, vx, vy, vz, gravity);
        [places[2 * row], places[2 * row + 1]] = there;
        tell(vx, vy, down);
      }
      return places;
    }

    /** Return where flights come down through the ring's plane as if they touched nothing, and the
     * mean and the deviation of their angles there. */
    function entries(thrown, { gravity }) {
      let [number, sum, squares] = [0, 0, 0];
      const places = arrivals(thrown, 0, gravity, () => true, (vx, vy, down) => {
        const angle = Math.atan2(-down, Math.hypot(vx, vy));
        number += 1;
        sum += angle;
        squares += angle * angle;
      });
      const mean = sum / number;
      return { entries: places, angle: [mean, Math.sqrt(Math.max(squares / number - mean * mean, 0))] };
    }

    /** Return where misses come down to the height at which rebounds are caught. */
    function landings({ outcome, state }, { gravity }) {
      const missed = spec.outcomes.indexOf("missed");
      return arrivals(state, spec.catching_height - ringHeight, gravity, (row) => outcome[row] === missed);
    }

    /** Return the classes of shots over speed (across) and elevation (up), about a release. */
    function map({ release, parameters, window: [across, up], size: [wide, high] }) {
      const count = wide * high;
      const speed = new Float64Array(count);
      const elevation = new Float64Array(count);
      const between = ([low, top], k, cells) => low + ((top - low) * (k + 0.5)) / cells;
      for (let row = 0; row < count; row++) {
        speed[row] = between(across, row % wide, wide);
        elevation[row] = between(up, Math.floor(row / wide), high);
      }
      const thrown = states({ ...release, speed, elevation }, count);
      const found = simulate(thrown, parameters, RESULTS.slice(0, 3));
      return { window: [across, up], size: [wide, high], outcome: found.outcome, kinds: Release.kinds(found, spec.kinds) };
    }

    /** Yield nothing after each step, and at last the smallest change of a variable with which the
     * shot ends otherwise. */
    function* change(name, { release, parameters, patience = PATIENCE }) {
      const bodies = spec.kinds.bodies.length;
      const some = (values) => {
        const own = spec.parameters.includes(name);
        const column = Float64Array.from(values);
        const thrown = states({ ...release, ...(own ? {} : { [name]: column }) }, values.length);
        const given = own ? { ...parameters, [name]: column } : parameters;
        const found = simulate(thrown, given, Nearest.RESULTS);
        const { outcome, contacts, first, counts, uncertain } = found;
        const marks = values.map((_, k) => {
          if (uncertain[k] || outcome[k] === invalid) return ""; // not decided
          const by = counts.subarray(bodies * k, bodies * (k + 1));
          return [outcome[k], contacts[k], first[k], ...by].join();
        });
        return { made: values.map((_, k) => outcome[k] === made), marks };
      };
      const run = function* (values, late = () => false) {
        const all = { made: [], marks: [] };
        for (let at = 0; at < values.length; at += STRIDE) {
          const found = some(values.slice(at, at + STRIDE));
          all.made.push(...found.made);
          all.marks.push(...found.marks);
          yield;
          if (late()) return null;
        }
        return all;
      };
      const value = release[name] ?? parameters[name];
      const [itself] = some([value]).made;
      const until = performance.now() + patience;
      const late = () => performance.now() > until;
      yield yield* Nearest.change(name, value, itself, run, spec.ranges, { late });
    }

    return { change, drawn, map, scatter, shot };
  }

  return { PATIENCE, of, specOf, start };
})();
