// The playground: every change of the controls is simulated at once, and drawn by the viewer.
"use strict";

(async () => {
  const $ = (id) => document.getElementById(id);
  const page = JSON.parse($("spec").textContent);
  const { words } = hoopgen;
  const CELLS = [96, 72]; // of the map
  const WINDOW = [1.0, (15 * Math.PI) / 180]; // m/s and rad to each side of the shot
  const SHOWN = { scatter: ["throws", "entries", "landings"], map: ["map"], changes: ["changes"] };
  const STEEP = [5, 85].map((degrees) => (degrees * Math.PI) / 180);
  const still = window.matchMedia("(prefers-reduced-motion: reduce)");
  const studies = {}; // by scene, once each is started
  const digests = {}; // by scene, of the fixed shots; null once it is asked for
  let spec = {}; // of the scene as it is
  let now = page.start; // SI, and names
  let [asked, latest] = [0, {}];
  const banner = Object.assign(document.createElement("p"), { id: "banner" });
  banner.setAttribute("role", "status");

  // The shot

  /** Return the values of a preset that have controls. */
  function ownSizes({ variables, presets }, preset) {
    return Object.fromEntries(variables.scene.map(({ name }) => [name, presets[preset][name]]));
  }

  /** Return the names of what a link says of a scene, but for scene, preset and seed. */
  function namesOf({ variables }) {
    return Object.values(variables).flat().map(({ name }) => name);
  }

  function release() {
    return Object.fromEntries(spec.layout.arguments.map((name) => [name, now[name]]));
  }

  function parameters() {
    const own = spec.variables.scene.map(({ name }) => [name, now[name]]);
    return { ...spec.presets[now.preset], ...Object.fromEntries(own) };
  }

  function deviations() {
    return Object.fromEntries(spec.scattered.map((name) => [name, now[`sd_${name}`]]));
  }

  /** Return the outward normal of a body where the ball's centre is, by the generated kernel. */
  function normalAt(body, [x, y, z]) {
    const given = { ...parameters(), x, y, z };
    const kernel = globalThis[`${spec.scene}_${body}_normal`];
    return kernel(...spec.normals[body].map((name) => given[name]));
  }

  /** Return a shot as the viewer has them, with the points at which bodies are touched. */
  function shown(found) {
    const sizes = parameters();
    const { ball_radius: ball, gravity } = sizes;
    const { bodies } = spec.kinds;
    const rows = found.events[0];
    let contact = 0;
    const events = rows.map(({ surface, time, before, kind }) => {
      const centre = before.slice(0, 3);
      const end = surface >= bodies.length;
      const normal = end ? [0, 0, 0] : normalAt(bodies[surface], centre);
      const name = spec.layout.events[kind];
      return {
        number: name === "impact" ? ++contact : 0,
        kind: name,
        surface: end ? "end" : bodies[surface],
        time,
        at: centre.map((value, k) => value - ball * normal[k]),
      };
    });
    const flights = [[0, ...found.release]];
    const rolls = [];
    rows.forEach(({ time, after }, row) => {
      flights.push([time, ...after]);
      const roll = found.rolls.find((one) => one.row === row);
      if (!roll) return;
      const next = rows[row + 1];
      const begin = flights.length - 1;
      flights.push(...roll.pieces, [next.time, ...next.before]);
      rolls.push([begin, flights.length - 1]);
    });
    const outcome = spec.outcomes[found.outcome[0]];
    const last = flights.at(-1);
    const [fall] = hoop_descent(last[3], last[6], ball - spec.ring_height, gravity);
    const falls = ["made", "missed", "short"].includes(outcome) && Number.isFinite(fall);
    return {
      ...{ label: "Shot", outcome, kind: spec.kinds.names[found.kind] },
      ...{ uncertain: Boolean(found.uncertain[0]), parameters: sizes, flights, rolls, events },
      ...(falls ? { floor_time: last[0] + fall } : {}),
    };
  }

  function fly(play) {
    latest = studies[spec.scene].shot({ release: release(), parameters: parameters() });
    const invalid = spec.outcomes[latest.outcome[0]] === "invalid";
    $("fault").hidden = !invalid;
    if (invalid) {
      $("fault").textContent = "This is no valid shot: the ball starts inside a body, or a size is not allowed.";
      return;
    }
    hoopgen.replace(shown(latest), spec.courts[now.preset]);
    if (play && !still.matches) hoopgen.play();
  }

  // Controls

  /** Start the engine of the scene unless it runs, then simulate and draw the shot as it is. */
  function update(play = false) {
    const { scene } = now;
    if (studies[scene]) {
      redraw(play);
      return;
    }
    document.body.dataset.asked = ++asked; // what is shown is of another scene
    Study.start(Study.specOf(page, scene), modules).then((study) => {
      studies[scene] = study;
      if (now.scene === scene) redraw(play);
    });
  }

  function redraw(play) {
    if (spec.scene !== now.scene) furnish();
    for (const one of shownControls) one.show(now);
    $("scene").value = now.scene;
    $("preset").value = now.preset;
    const [x, y] = [now.distance * Math.cos(now.angle), now.distance * Math.sin(now.angle)];
    plan.draw([x, y], now.azimuth + now.angle, parameters(), spec.courts[now.preset].lines);
    ask(); // first: the worker answers while the page draws
    fly(play);
    verify();
  }

  /** Have the controls of the scene as it is. */
  function furnish() {
    spec = studies[now.scene].spec;
    shownControls = Object.entries(spec.variables).map(([group, own]) =>
      Controls.create($(`of-${group}`), own, words.unit, change),
    );
  }

  function set(changed, done = true) {
    now = { ...now, ...changed };
    update(done);
    if (done) history.replaceState(null, "", link());
  }

  /** Go to another scene or preset: the release and the scatter stay. */
  function rebuild(scene, preset) {
    const own = ownSizes(Study.specOf(page, scene), preset);
    set({ scene, preset, ...own });
  }

  /** Return the address's fragment: the whole shot, in SI, each number to the bit. */
  function link() {
    const names = ["scene", ...namesOf(Study.specOf(page, now.scene)), "preset", "seed"];
    return `#${names.map((name) => `${name}=${now[name]}`).join("&")}`;
  }

  /** Take the shot that the address says; what it leaves out is as it is at the start. */
  function follow() {
    const given = new URLSearchParams(location.hash.slice(1));
    const named = (table, name, usual) => (Object.hasOwn(table, given.get(name) ?? "") ? given.get(name) : usual);
    const scene = named(page.scenes, "scene", page.start.scene);
    const there = Study.specOf(page, scene);
    const preset = named(there.presets, "preset", page.start.preset);
    const next = { ...page.start, scene, preset, ...ownSizes(there, preset) };
    const infinite = there.variables.scene.filter((one) => one.infinite).map(({ name }) => name);
    const number = (name) => (given.has(name) && given.get(name) !== "" ? Number(given.get(name)) : NaN);
    for (const name of namesOf(there)) {
      const value = number(name);
      if (Number.isFinite(value) || (value === Infinity && infinite.includes(name))) next[name] = value;
    }
    const seed = number("seed");
    if (Number.isSafeInteger(seed) && seed >= 0) next.seed = seed;
    now = next;
    update();
  }

  function python() {
    const number = (value) => (value === Infinity ? 'float("inf")' : value);
    const own = Object.entries(parameters()).filter(([name, value]) => value !== spec.presets[now.preset][name]);
    const changes = own.map(([name, value]) => `"${name}": ${number(value)}`).join(", ");
    const hoop = `hoopgen.${now.preset.toUpperCase()}${spec.suffix}${changes ? ` | {${changes}}` : ""}`;
    const scene = `scene=hoopgen.${spec.scene.toUpperCase()}`;
    return `import hoopgen\n\nstate = [${latest.release.join(", ")}]\nshots = hoopgen.simulate(state, ${hoop}, ${scene}, record=True)\nprint(shots.trajectory(0))\n`;
  }

  async function copy(text, what) {
    try {
      await navigator.clipboard.writeText(text);
      $("copied").textContent = `${what} copied`;
    } catch {
      prompt(`${what}:`, text); // no clipboard without a secure address
    }
  }

  // Many throws

  function bounds(value, half, [low, high] = [0, Infinity]) {
    return [Math.max(value - half, low), Math.min(value + half, high)];
  }

  /** Ask the worker about the shot as it is; it drops older questions. */
  function ask() {
    const given = { release: release(), parameters: parameters() };
    const speeds = bounds(now.speed, WINDOW[0]);
    const angles = bounds(now.elevation, WINDOW[1], STEEP);
    const questions = {
      scatter: { ...given, deviations: deviations(), seed: now.seed, count: spec.throws },
      map: { ...given, window: [speeds, angles], size: CELLS },
      changes: { ...given, vary: spec.vary },
    };
    worker.postMessage({ id: ++asked, scene: spec.scene, questions });
    document.body.dataset.asked = asked;
    for (const id of Object.values(SHOWN).flat()) $(id).setAttribute("aria-busy", true);
  }

  /** Have the fixed shots of the scene simulated, once, and show their digest. */
  function verify() {
    const { scene } = spec;
    if (!(scene in digests)) {
      digests[scene] = null;
      worker.postMessage({ id: 0, scene, questions: { fingerprint: {} } });
    }
    Results.fingerprint(digests[scene], spec);
  }

  async function answered({ data: { id, scene, name, answer, milliseconds } }) {
    document.body.dataset[name] = milliseconds;
    if (name === "fingerprint") {
      digests[scene] = await Fingerprint.sha256(answer);
      if (spec.scene === scene) verify();
      return;
    }
    if (id !== asked) return;
    const whole = name !== "changes" || answer.length === spec.vary.length;
    if (whole) for (const one of SHOWN[name]) $(one).removeAttribute("aria-busy");
    Results[name](answer, { now, spec, words, parameters: parameters() }, set);
    if (name === "scatter") tell(answer);
    if (name === "changes" && whole) document.body.dataset.answered = id;
  }

  /** Say over the picture how the shot ends, and how many of the throws go in. */
  function tell(found) {
    const { outcome, kind } = document.body.dataset;
    const share = ` · ${((100 * found.made) / found.count).toFixed(1)}% of such throws go in`;
    const how = kind === "none" ? "" : ` (${words.said(kind)})`;
    banner.replaceChildren(
      Object.assign(document.createElement("b"), { textContent: `${Words.capital(outcome)}${how}` }),
      found.count ? share : "",
    );
  }

  // Begin

  const modules = {};
  for (const { name } of Object.values(page.scenes).flatMap((scene) => scene.modules)) {
    modules[name] = await Engine.bytesOf($(name).textContent);
  }
  const scripts = [...document.querySelectorAll("script[data-worker]")].map((one) => one.textContent);
  const worker = new Worker(URL.createObjectURL(new Blob(scripts, { type: "text/javascript" })));
  worker.onmessage = answered;
  worker.postMessage({ spec: page, modules });

  $("stage").append(banner);
  const place = (x, y, done) => {
    // The line of the throw turns with the place: the aim at the ring stays.
    set({ distance: Math.hypot(x, y), angle: Math.atan2(y, x) }, done);
  };
  const plan = Plan.create($("plan"), place);
  const change = (name, value, done) => set({ [name]: value }, done);
  let shownControls = [];
  $("scene").append(...Object.entries(page.scenes).map(([name, { label }]) => new Option(label, name)));
  $("scene").onchange = ({ target: { value } }) => rebuild(value, now.preset);
  $("preset").append(...Object.keys(page.courts).map((name) => new Option(name.toUpperCase(), name)));
  $("preset").onchange = ({ target: { value } }) => rebuild(now.scene, value);
  $("copy-link").onclick = () => copy(location.href.split("#")[0] + link(), "Link");
  $("copy-python").onclick = () => copy(python(), "Python code");
  $("map").onclick = ({ offsetX, offsetY }) => {
    const at = Results.mapAt(offsetX, offsetY);
    if (at) set({ speed: at[0], elevation: at[1] });
  };
  document.addEventListener("units", () => update());
  window.addEventListener("hashchange", follow);
  Theme.tell(() => Results.repaint());
  window.addEventListener("resize", () => Results.repaint());
  follow();
  Object.assign(window.hoopgen, { link, latest: () => latest, python });
})();
