// The playground: every change of the controls is simulated at once, and drawn by the viewer.
"use strict";

(async () => {
  const $ = (id) => document.getElementById(id);
  const spec = JSON.parse($("spec").textContent);
  const { words } = hoopgen;
  const variables = Object.values(spec.variables).flat();
  const NAMES = variables.map(({ name }) => name); // what a link says, but for preset and seed
  const CELLS = [96, 72]; // of the map
  const WINDOW = [1.0, (15 * Math.PI) / 180]; // m/s and rad to each side of the shot
  const STEEP = [5, 85].map((degrees) => (degrees * Math.PI) / 180);
  const still = window.matchMedia("(prefers-reduced-motion: reduce)");
  let now = { ...spec.start }; // SI, and the preset's name
  let [asked, latest] = [0, {}];
  const banner = Object.assign(document.createElement("p"), { id: "banner" });
  banner.setAttribute("role", "status");

  // The shot

  function release() {
    return Object.fromEntries(Release.ARGUMENTS.map((name) => [name, now[name]]));
  }

  function parameters() {
    const own = spec.variables.scene.map(({ name }) => [name, now[name]]);
    return { ...spec.presets[now.preset], ...Object.fromEntries(own) };
  }

  function deviations() {
    return Object.fromEntries(spec.scattered.map((name) => [name, now[`sd_${name}`]]));
  }

  /** Return a shot as the viewer has them, with the points at which bodies are touched. */
  function shown(found) {
    const sizes = parameters();
    const { ball_radius: ball, ring_radius: ring, wire_radius: wire, gravity } = sizes;
    const normals = [
      ([x, y, z]) => hoop_ring_normal(x, y, z, ball, ring, wire),
      () => hoop_backboard_normal(),
      () => hoop_bridge_normal(),
    ];
    const rows = found.events[0];
    let contact = 0;
    const events = rows.map(({ surface, time, before }) => {
      const centre = before.slice(0, 3);
      const end = surface >= normals.length;
      const normal = end ? [0, 0, 0] : normals[surface](centre);
      return {
        number: end ? 0 : ++contact,
        kind: end ? "end" : "impact",
        surface: end ? "end" : spec.kinds.bodies[surface],
        time,
        at: centre.map((value, k) => value - ball * normal[k]),
      };
    });
    const flights = [[0, ...found.release], ...rows.map(({ time, after }) => [time, ...after])];
    const outcome = spec.outcomes[found.outcome[0]];
    const last = flights.at(-1);
    const [fall] = hoop_descent(last[3], last[6], ball - spec.ring_height, gravity);
    const falls = ["made", "missed", "short"].includes(outcome) && Number.isFinite(fall);
    return {
      ...{ label: "Shot", outcome, kind: spec.kinds.names[found.kind] },
      ...{ uncertain: Boolean(found.uncertain[0]), parameters: sizes, flights, rolls: [], events },
      ...(falls ? { floor_time: last[0] + fall } : {}),
    };
  }

  function fly(play) {
    latest = study.shot({ release: release(), parameters: parameters() });
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

  function update(play = false) {
    const values = { ...now };
    for (const one of shownControls) one.show(values);
    $("preset").value = now.preset;
    const [x, y] = [now.distance * Math.cos(now.angle), now.distance * Math.sin(now.angle)];
    plan.draw([x, y], now.azimuth + now.angle, parameters(), spec.courts[now.preset].lines);
    fly(play);
    ask();
  }

  function set(change, done = true) {
    now = { ...now, ...change };
    update(done);
    if (done) history.replaceState(null, "", link());
  }

  /** Return the address's fragment: the whole shot, in SI, each number to the bit. */
  function link() {
    const parts = [...NAMES, "preset", "seed"].map((name) => `${name}=${now[name]}`);
    return `#${parts.join("&")}`;
  }

  /** Take the shot that the address says; what it leaves out is as it is at the start. */
  function follow() {
    const given = new URLSearchParams(location.hash.slice(1));
    const next = { ...spec.start };
    if (Object.hasOwn(spec.presets, given.get("preset") ?? "")) {
      next.preset = given.get("preset");
      for (const { name } of spec.variables.scene) next[name] = spec.presets[next.preset][name];
    }
    for (const name of [...NAMES, "seed"]) {
      const value = given.has(name) && given.get(name) !== "" ? Number(given.get(name)) : NaN;
      if (Number.isFinite(value)) next[name] = value;
    }
    now = next;
    update();
  }

  function python() {
    const own = Object.entries(parameters()).filter(([name, value]) => value !== spec.presets[now.preset][name]);
    const changes = own.map(([name, value]) => `"${name}": ${value}`).join(", ");
    const scene = `hoopgen.${now.preset.toUpperCase()}${changes ? ` | {${changes}}` : ""}`;
    return `import hoopgen\n\nstate = [${latest.release.join(", ")}]\nshots = hoopgen.simulate(state, ${scene}, record=True)\nprint(shots.trajectory(0))\n`;
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
    worker.postMessage({ id: ++asked, questions });
    document.body.dataset.asked = asked;
  }

  function answered({ data: { id, name, answer, milliseconds } }) {
    document.body.dataset[name] = milliseconds;
    if (name === "fingerprint") {
      Results.fingerprint(answer, spec.fixed.sha256);
      return;
    }
    if (id !== asked) return;
    Results[name](answer, { now, spec, words, parameters: parameters() }, set);
    if (name === "scatter") tell(answer);
    if (name === "changes") document.body.dataset.answered = id;
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

  const modules = spec.modules.map(({ name, lanes }) => {
    return { name, lanes, bytes: Engine.bytesOf($(name).textContent) };
  });
  const study = Study.of(await Engine.start(modules, spec.layout), spec);
  const scripts = [...document.querySelectorAll("script[data-worker]")].map((one) => one.textContent);
  const worker = new Worker(URL.createObjectURL(new Blob(scripts, { type: "text/javascript" })));
  worker.onmessage = answered;
  worker.postMessage({ spec, modules });

  $("stage").append(banner);
  const place = (x, y, done) => {
    // The line of the throw turns with the place: the aim at the ring stays.
    set({ distance: Math.hypot(x, y), angle: Math.atan2(y, x) }, done);
  };
  const plan = Plan.create($("plan"), place);
  const change = (name, value, done) => set({ [name]: value }, done);
  const shownControls = Object.entries(spec.variables).map(([group, own]) =>
    Controls.create($(`of-${group}`), own, words.unit, change),
  );
  $("preset").append(...Object.keys(spec.presets).map((name) => new Option(name.toUpperCase(), name)));
  $("preset").onchange = ({ target: { value: preset } }) => {
    const sizes = spec.variables.scene.map(({ name }) => [name, spec.presets[preset][name]]);
    set({ preset, ...Object.fromEntries(sizes) });
  };
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
  // Last: what the reader came for is first.
  worker.postMessage({ id: 0, questions: { fingerprint: {} } });
  Object.assign(window.hoopgen, { engine: study, link, latest: () => latest, python });
})();
