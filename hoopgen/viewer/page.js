// The page: one shot chosen and in motion, told in words beside the picture.
"use strict";

(() => {
  const $ = (id) => document.getElementById(id);
  const page = JSON.parse($("data").textContent);
  const shots = page.shots.map((shot) => ({
    ...shot,
    parameters: { ...page.parameters, ...shot.parameters },
    duration: shot.flights.at(-1)[0],
  }));
  const SPEEDS = [1, 0.5, 0.1];
  const GROUPS = ["outcome", "kind"];
  const state = { shot: 0, time: 0, speed: 1, playing: false };
  let picture = null; // none without WebGL; the words stay
  let frame = 0; // asked for by what runs

  const { scenery } = page; // of any scene but the hoop
  const VIEWS = scenery ? Camera.VIEWS.slice(0, 3) : Camera.VIEWS;

  const chosen = () => shots[state.shot];

  /** Return what a surface is called: of other scenes, `body-0` and so on stand for the bodies. */
  function named(surface) {
    return scenery && surface !== "end" ? page.surfaces[surface.slice(5)] : surface;
  }

  /** Give an element the colour of a surface, which style sheets have of the hoop alone. */
  function paint(element, surface) {
    if (scenery && surface.startsWith("body-")) {
      element.style.color = scenery.bodies[surface.slice(5)].colour;
      element.classList.add("body");
    }
    return element;
  }

  function make(tag, properties = {}, ...children) {
    const element = Object.assign(document.createElement(tag), properties);
    element.append(...children);
    return element;
  }

  const said = (word) => word.replaceAll("_", scenery ? " " : ", ");
  const seconds = (time) => `${time.toFixed(3)} s`;
  const metres = (length) => `${length.toFixed(2)} m`;
  const hertz = (rate) => `${(rate / (2 * Math.PI)).toFixed(2)} Hz`;
  const degrees = (angle) => `${((180 / Math.PI) * angle).toFixed(1)}°`;

  // Words

  function outcomeWords(shot) {
    const [, x, y] = shot.flights.at(-1);
    const contacts = shot.events.filter((event) => event.number).length;
    const many = `${contacts} contact${contacts === 1 ? "" : "s"}`;
    const words = {
      capped: `${many}, and not yet at the end plane`,
      short: "never comes down through the end plane",
    };
    if (scenery) {
      const ended = shot.events.at(-1)?.surface === "end";
      return ended ? `after ${seconds(shot.duration)}` : `after ${many}, ${seconds(shot.duration)}`;
    }
    const away = `${Math.hypot(x, y).toFixed(3)} m from the ring’s centre`;
    return words[shot.outcome] ?? `${away} after ${seconds(shot.duration)}`;
  }

  function kindWords(shot) {
    return shot.kind === "none" ? "" : ` (${said(shot.kind)})`;
  }

  function releaseRows(shot) {
    const [, x, y, z, vx, vy, vz, wx, wy, wz] = shot.flights[0];
    const level = Math.hypot(vx, vy);
    if (scenery) {
      return [
        ["Speed", `${Math.hypot(level, vz).toFixed(3)} m/s`],
        [`From ${scenery.axes.join(", ")}`, place([x, y, z])],
        ["Spin", hertz(Math.hypot(wx, wy, wz))],
      ];
    }
    const rows = [
      ["Speed", `${Math.hypot(level, vz).toFixed(3)} m/s`],
      ["Elevation", degrees(Math.atan2(vz, level))],
      ["Height, distance", `${metres(z + page.ring_height)}, ${metres(Math.hypot(x, y))}`],
    ];
    // Backspin turns about the level axis across the line of flight, as in hoopgen.release.
    const back = level > 0 ? (wx * vy - wy * vx) / level : 0;
    if (back) rows.push([back > 0 ? "Backspin" : "Topspin", hertz(Math.abs(back))]);
    if (wz) rows.push(["Sidespin", hertz(wz)]);
    return rows;
  }

  function nowRows(shot, time) {
    const [x, y, z, vx, vy, vz, ...spin] = Flight.stateAt(shot, time);
    const above = [["Above the floor", metres(z + page.ring_height)]];
    return [
      [scenery ? scenery.axes.join(", ") : "x, y, z", place([x, y, z])],
      ...(scenery ? [] : above),
      ["Speed", `${Math.hypot(vx, vy, vz).toFixed(2)} m/s`],
      ["Spin", hertz(Math.hypot(...spin))],
    ];
  }

  const place = (point) => `${point.map((value) => fixed(value, 3)).join(", ")} m`;

  function fixed(value, digits) {
    return (Number(value.toFixed(digits)) + 0).toFixed(digits).replace("-", "−");
  }

  function fill(list, rows) {
    const parts = rows.map((row) => {
      const [name, value] = row.map((textContent, k) => make(k ? "dd" : "dt", { textContent }));
      return make("div", {}, name, value);
    });
    list.replaceChildren(...parts);
  }

  // Parts of the page

  /** Make a row of buttons of which one is pressed. */
  function choices(holder, labels, choose) {
    const buttons = labels.map((label, k) => {
      const press = () => {
        buttons.forEach((button, other) => button.setAttribute("aria-pressed", other === k));
        choose(k);
      };
      return make("button", { type: "button", textContent: label, onclick: press });
    });
    buttons.forEach((button, k) => button.setAttribute("aria-pressed", k === 0));
    holder.replaceChildren(...buttons);
    return buttons;
  }

  function tag(surface, label) {
    const words = make("span", { textContent: label });
    return paint(make("span", { className: `tag ${surface}` }, words), surface);
  }

  const endWord = scenery ? "end" : "end plane";

  function listEvents(shot) {
    const rows = shot.events.map((event) => {
      const ends = event.surface === "end";
      const button = make(
        "button",
        { type: "button", onclick: () => seek(event.time, false) },
        tag(event.surface, Badges.label(event)),
        make("span", { textContent: ends ? endWord : named(event.surface) }),
        make("span", { textContent: seconds(event.time) }),
      );
      button.dataset.surface = event.surface;
      button.dataset.time = event.time;
      return make("li", {}, button);
    });
    if (!rows.length) rows.push(make("li", { textContent: "none" }));
    $("events").replaceChildren(...rows);
    const ticks = shot.events.map((event) => {
      const tick = paint(make("i", { className: event.surface }), event.surface);
      tick.style.left = `${(100 * event.time) / shot.duration}%`;
      return tick;
    });
    $("ticks").replaceChildren(...ticks);
  }

  function legend() {
    const touched = new Set(shots.flatMap((shot) => shot.events.map((event) => event.surface)));
    const entries = [
      ...page.surfaces.map((name, k) => [scenery ? `body-${k}` : name, "", name]),
      ...(touched.has("end") ? [["end", "hoop", endWord]] : []),
    ];
    entries.push([shots.length > 1 ? "" : "path", "dots", `every ${Scene.beatOf(shots)} s`]);
    const items = entries.map(([name, form, words]) =>
      make("li", {}, paint(make("span", { className: `swatch ${form} ${name}` }), name), words),
    );
    $("legend").replaceChildren(...items);
    const height = `${page.ring_height} m`;
    $("scale").textContent = scenery
      ? `To scale. The grid below is ${scenery.step} m.`
      : `To scale. The floor’s grid is 1 m; the ring hangs at ${height}.`;
  }

  function filters() {
    const there = GROUPS.filter((group) => page[`${group}s`].length);
    const fieldsets = there.map((group) => {
      const words = group === "outcome" ? "Outcome" : "Kind";
      const boxes = count(group).map(([value, number]) => {
        const box = make("input", { type: "checkbox", checked: true, onchange: sift });
        [box.name, box.value] = [group, value];
        const label = make("label", {}, box);
        if (group === "outcome") {
          const swatch = make("span", { className: "swatch line" });
          swatch.style.color = scenery ? scenery.inks[value] : `var(--${value})`;
          label.append(swatch);
        }
        label.append(`${said(value)} ${number}`);
        return label;
      });
      return make("fieldset", {}, make("legend", { textContent: words }), ...boxes);
    });
    $("filters").replaceChildren(...fieldsets);
  }

  /** Count the shots by a group's values, in the order in which hoopgen lists those. */
  function count(group) {
    return page[`${group}s`]
      .map((value) => [value, shots.filter((shot) => shot[group] === value).length])
      .filter(([, number]) => number > 0);
  }

  /** Return the indices of the shots that the filters let through. */
  function passing() {
    const off = [...document.querySelectorAll("#filters input:not(:checked)")];
    return shots.flatMap((shot, k) => (off.some((box) => shot[box.name] === box.value) ? [] : [k]));
  }

  function sift() {
    const shown = passing();
    const options = shown.map((k) => {
      const words = [shots[k].label, said(shots[k].outcome)];
      if (!scenery) words.push(said(shots[k].kind));
      return make("option", { value: k, textContent: words.join(" · ") });
    });
    $("shot").replaceChildren(...options);
    for (const id of ["shot", "previous", "next"]) $(id).disabled = !shown.length;
    picture?.filter(shown);
    if (shown.length && !shown.includes(state.shot)) choose(shown[0]);
    else $("shot").value = state.shot;
  }

  /** Choose the shot so many places on among those shown. */
  function step(places) {
    const shown = passing();
    const at = shown.indexOf(state.shot);
    if (shown.length) choose(shown[(at + places + shown.length) % shown.length]);
  }

  // What changes

  function choose(k) {
    state.shot = k;
    const shot = chosen();
    $("shot").value = k;
    $("outcome").replaceChildren(
      make("b", { textContent: said(shot.outcome[0].toUpperCase() + shot.outcome.slice(1)) }),
      make("span", { textContent: `${kindWords(shot)}, ${outcomeWords(shot)}` }),
    );
    if (shot.uncertain) {
      const why = ". Uncertain: some decision is within the bound on its rounding error.";
      $("outcome").append(make("span", { textContent: why }));
    }
    Object.assign(document.body.dataset, { shot: k, outcome: shot.outcome, kind: shot.kind });
    fill($("release"), releaseRows(shot));
    listEvents(shot);
    $("slider").max = shot.duration;
    $("play").disabled = $("slider").disabled = shot.duration === 0;
    picture?.choose(shot);
    seek(0, state.playing);
  }

  function seek(time, playing = state.playing) {
    const shot = chosen();
    state.time = Math.min(Math.max(time, 0), shot.duration);
    state.playing = playing && shot.duration > 0;
    $("slider").value = state.time;
    $("clock").textContent = `${state.time.toFixed(3)} / ${seconds(shot.duration)}`;
    $("slider").setAttribute("aria-valuetext", seconds(state.time));
    $("play").setAttribute("aria-label", state.playing ? "Pause" : "Play");
    const forms = { play: "M3 1l11 7-11 7z", pause: "M3 1h3.5v14H3zM9.5 1H13v14H9.5z" };
    $("play").querySelector("path").setAttribute("d", forms[state.playing ? "pause" : "play"]);
    $("when").textContent = `At ${seconds(state.time)}`;
    fill($("now"), nowRows(shot, state.time));
    const last = shot.events.findLastIndex((event) => event.time <= state.time);
    [...$("events").querySelectorAll("button")].forEach((button, k) => {
      if (k === last) button.setAttribute("aria-current", "step");
      else button.removeAttribute("aria-current");
    });
    document.body.dataset.time = state.time;
    picture?.move(shot, state.time);
  }

  function toggle() {
    const ended = state.time >= chosen().duration;
    seek(ended && !state.playing ? 0 : state.time, !state.playing);
    cancelAnimationFrame(frame);
    if (state.playing) frame = requestAnimationFrame((now) => run(now, now));
  }

  function run(now, before) {
    if (!state.playing) return;
    // A page that was out of sight goes on where it was.
    const time = state.time + state.speed * Math.min((now - before) / 1000, 0.1);
    seek(time, time < chosen().duration);
    frame = requestAnimationFrame((later) => run(later, now));
  }

  /** Open at what the address asks for: #shot=2&time=0.5&view=side. */
  function follow(views) {
    const asked = new URLSearchParams(location.hash.slice(1));
    const shot = shots.findIndex((_, k) => `${k}` === asked.get("shot"));
    if (shot >= 0) choose(shot);
    const time = Number.parseFloat(asked.get("time"));
    if (Number.isFinite(time)) seek(time, false);
    views[VIEWS.findIndex((view) => view.toLowerCase() === asked.get("view"))]?.click();
  }

  function keys(event) {
    if (event.ctrlKey || event.altKey || event.metaKey) return;
    const { target } = event;
    if (event.key === " " && !target.closest("button, select, input[type=checkbox]")) {
      event.preventDefault();
      if (!$("play").disabled) toggle();
    } else if (target === $("picture") && picture?.key(event.key)) {
      event.preventDefault();
    }
  }

  // Begin

  document.title = $("title").textContent = page.title;
  $("about").textContent = page.about;
  $("about").hidden = !page.about;
  $("picture").setAttribute("aria-label", `${page.title}, drawn in space`);
  legend();
  filters();
  $("sample").hidden = shots.length === 1;
  try {
    picture = Picture.create(
      $("stage"),
      $("picture"),
      $("badges"),
      shots,
      page.ring_height,
      scenery,
      paint,
      choose,
    );
  } catch (error) {
    $("sorry").textContent = "This browser draws no WebGL, so there is no picture.";
    $("sorry").hidden = false;
    $("views").hidden = true;
    console.error(error);
  }
  choices($("speeds"), SPEEDS.map((speed) => `${speed}×`), (k) => (state.speed = SPEEDS[k]));
  const views = choices($("views"), VIEWS, (k) => picture?.look(VIEWS[k]));
  $("play").onclick = toggle;
  $("slider").oninput = () => seek($("slider").valueAsNumber, false);
  $("shot").onchange = () => choose(Number($("shot").value));
  $("previous").onclick = () => step(-1);
  $("next").onclick = () => step(1);
  document.addEventListener("keydown", keys);
  window.addEventListener("hashchange", () => follow(views));
  sift();
  choose(state.shot);
  follow(views);
  window.hoopgen = { stateAt: (shot, time) => Flight.stateAt(shots[shot], time) };
})();
