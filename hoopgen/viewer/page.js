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
  const words = Words.of(page);
  const { seconds } = Words;
  const { said } = words;
  const state = { shot: 0, time: 0, stop: 0, speed: 1, playing: false, together: false, shown: [] };
  let picture = null; // none without WebGL; the words stay
  let frame = 0; // asked for by what runs

  const { scenery } = page; // of any scene but the hoop
  const VIEWS = scenery?.views ?? Camera.VIEWS;

  const chosen = () => shots[state.shot];

  /** Give an element the colour of a surface, which style sheets have of the hoop alone. */
  function paint(element, surface) {
    if (scenery && surface.startsWith("body-")) {
      element.style.color = `var(--${surface})`;
      element.classList.add("body");
    }
    return element;
  }

  function make(tag, properties = {}, ...children) {
    const element = Object.assign(document.createElement(tag), properties);
    element.append(...children);
    return element;
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

  function listEvents(shot) {
    const rows = shot.events.map((event, k) => {
      const button = make(
        "button",
        { type: "button", onclick: () => halt(k + 1) },
        tag(event.surface, Badges.label(event)),
        make("span", { textContent: words.named(event.surface) }),
        make("span", { textContent: seconds(event.time) }),
      );
      button.dataset.surface = event.surface;
      button.dataset.time = event.time;
      return make("li", {}, button);
    });
    if (!rows.length) rows.push(make("li", { textContent: "none" }));
    $("events").replaceChildren(...rows);
  }

  /** Make the slider as long as what is played, with a tick for each event of the chosen shot. */
  function measure() {
    const ticks = chosen().events.map((event) => {
      const tick = paint(make("i", { className: event.surface }), event.surface);
      tick.style.left = `${(100 * event.time) / span()}%`;
      return tick;
    });
    $("ticks").replaceChildren(...ticks);
    $("slider").max = span();
    $("play").disabled = $("slider").disabled = span() === 0;
  }

  function legend() {
    const touched = new Set(shots.flatMap((shot) => shot.events.map((event) => event.surface)));
    const entries = [
      ...page.surfaces.map((name, k) => [scenery ? `body-${k}` : name, "", name]),
      ...(touched.has("end") ? [["end", "hoop", words.named("end")]] : []),
    ];
    entries.push([shots.length > 1 ? "" : "path", "dots", `every ${Scene.beatOf(shots)} s`]);
    const falls = shots.some((shot) => Flight.lasts(shot) > shot.duration);
    if (falls) entries.push([shots.length > 1 ? "" : "fall", "dashes", "after the end, not simulated"]);
    const items = entries.map(([name, form, text]) =>
      make("li", {}, paint(make("span", { className: `swatch ${form} ${name}` }), name), text),
    );
    $("legend").replaceChildren(...items);
    $("scale").textContent = scenery
      ? `To scale. The grid below is ${words.gridSaid()}.`
      : `To scale. The floor’s grid is ${words.gridSaid()}; the ring hangs at ${words.round(page.ring_height)}.`;
  }

  function filters() {
    const there = GROUPS.filter((group) => page[`${group}s`].length);
    const fieldsets = there.map((group) => {
      const textContent = group === "outcome" ? "Outcome" : "Kind";
      const boxes = count(group).map(([value, number]) => {
        const box = make("input", { type: "checkbox", checked: true, onchange: sift });
        [box.name, box.value] = [group, value];
        const label = make("label", {}, box);
        if (group === "outcome") {
          const swatch = make("span", { className: "swatch line" });
          swatch.style.color = `var(--ink-${page.outcomes.indexOf(value)})`;
          label.append(swatch);
        }
        label.append(`${said(value)} ${number}`);
        return label;
      });
      return make("fieldset", {}, make("legend", { textContent }), ...boxes);
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
    const shown = (state.shown = passing());
    const options = shown.map((k) => {
      const parts = [shots[k].label, said(shots[k].outcome)];
      if (!scenery) parts.push(said(shots[k].kind));
      return make("option", { value: k, textContent: parts.join(" · ") });
    });
    $("shot").replaceChildren(...options);
    for (const id of ["shot", "previous", "next"]) $(id).disabled = !shown.length;
    picture?.filter(shown);
    if (shown.length && !shown.includes(state.shot)) choose(shown[0]);
    else reach();
    $("shot").value = state.shot;
  }

  /** Choose the shot so many places on among those shown. */
  function step(places) {
    const { shown } = state;
    const at = shown.indexOf(state.shot);
    if (shown.length) choose(shown[(at + places + shown.length) % shown.length]);
  }

  // What changes

  /** Return how long what is played lasts, s: the chosen shot, or the longest of those shown. */
  function span() {
    const played = state.together && state.shown.length ? state.shown : [state.shot];
    return played.reduce((most, k) => Math.max(most, Flight.lasts(shots[k])), 0);
  }

  /** Play all shots, released together; pressed again, the chosen one alone is there. */
  function gather() {
    state.together = !state.together;
    $("together").setAttribute("aria-pressed", state.together);
    picture?.gather(state.together);
    reach();
    if (state.together) play(0);
  }

  /** See to it that the time is within what is played. */
  function reach() {
    measure();
    seek(state.time);
  }

  /** Put another shot in the place of the only one, in the scene of its own parameters. */
  function replace(shot, ghost) {
    shots[0] = { ...shot, duration: shot.flights.at(-1)[0] };
    picture?.replace(ghost);
    legend();
    choose(0);
  }

  function choose(k) {
    state.shot = k;
    const shot = chosen();
    $("shot").value = k;
    Object.assign(document.body.dataset, { shot: k, outcome: shot.outcome, kind: shot.kind });
    tell();
    listEvents(shot);
    measure();
    picture?.choose(shot);
    seek(state.together ? state.time : 0);
  }

  /** Say how the chosen shot is released, and how it ends. */
  function tell() {
    const shot = chosen();
    $("outcome").replaceChildren(
      make("b", { textContent: said(Words.capital(shot.outcome)) }),
      make("span", { textContent: `${words.kind(shot)}, ${words.outcome(shot)}` }),
    );
    const more = [
      shot.uncertain && "Uncertain: some decision is within the bound on its rounding error.",
      shot.airless && "While the ball rolls, no air acts along the surface.",
    ].filter(Boolean);
    if (more.length) $("outcome").append(make("span", { textContent: `. ${more.join(" ")}` }));
    fill($("release"), words.release(shot));
  }

  /** Say lengths and speeds in the other units. */
  function convert() {
    words.convert();
    picture?.lay();
    $("units").textContent = words.other();
    legend();
    tell();
    seek(state.time, state.playing, state.stop);
    document.dispatchEvent(new Event("units"));
  }

  /** Go to a time, or to a stop of the chosen shot, of which several may be at one time. */
  function seek(time, playing = state.playing, stop = null) {
    const shot = chosen();
    state.time = Math.min(Math.max(time, 0), span());
    state.stop = stop ?? Stops.at(shot, state.time);
    state.playing = playing && span() > 0;
    $("slider").value = state.time;
    $("clock").textContent = `${state.time.toFixed(3)} / ${seconds(span())}`;
    $("slider").setAttribute("aria-valuetext", seconds(state.time));
    $("play").setAttribute("aria-label", state.playing ? "Pause" : "Play");
    const forms = { play: "M3 1l11 7-11 7z", pause: "M3 1h3.5v14H3zM9.5 1H13v14H9.5z" };
    $("play").querySelector("path").setAttribute("d", forms[state.playing ? "pause" : "play"]);
    $("when").textContent = `At ${seconds(Math.min(state.time, Flight.lasts(shot)))}`;
    fill($("now"), words.now(shot, state.time));
    const told = words.stop(shot, state.stop, state.time);
    if ($("stop").textContent !== told) $("stop").textContent = told;
    [...$("events").querySelectorAll("button")].forEach((button, k) => {
      if (k === state.stop - 1) button.setAttribute("aria-current", "step");
      else button.removeAttribute("aria-current");
    });
    document.body.dataset.time = state.time;
    picture?.move(shot, state.time);
  }

  /** Stop at one of the chosen shot's stops, by its number. */
  function halt(stop) {
    seek(Stops.times(chosen())[stop], false, stop);
  }

  /** Go to the contact before (-1) or after (1). */
  function stepTo(way) {
    const stop = Stops.beside(chosen(), state.stop, state.time, way);
    if (stop !== null) halt(stop);
  }

  function toggle() {
    const ended = state.time >= span();
    if (state.playing) seek(state.time, false);
    else play(ended ? 0 : state.time);
  }

  function play(time) {
    seek(time, true);
    cancelAnimationFrame(frame);
    if (state.playing) frame = requestAnimationFrame((now) => run(now, now));
  }

  function run(now, before) {
    if (!state.playing) return;
    // A page that was out of sight goes on where it was.
    const time = state.time + state.speed * Math.min((now - before) / 1000, 0.1);
    seek(time, time < span());
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

  function darkened() {
    $("theme").setAttribute("aria-pressed", Theme.isDark());
  }

  function keys(event) {
    if (event.ctrlKey || event.altKey || event.metaKey) return;
    const { target } = event;
    const way = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
    if (event.shiftKey && way) {
      event.preventDefault();
      stepTo(way);
    } else if (event.key === " " && !target.closest("button, select, input[type=checkbox]")) {
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
  darkened();
  legend();
  filters();
  $("sample").hidden = $("together").hidden = shots.length === 1;
  $("ghost").hidden = !page.ghost;
  try {
    picture = Picture.create(
      $("stage"),
      $("picture"),
      $("badges"),
      shots,
      page,
      paint,
      choose,
      words.grid,
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
  $("back").onclick = () => stepTo(-1);
  $("on").onclick = () => stepTo(1);
  $("together").onclick = gather;
  $("ghost").onchange = ({ target }) => picture?.haunt(target.checked);
  $("theme").onclick = Theme.toggle;
  $("units").textContent = words.other();
  $("units").onclick = convert;
  $("slider").oninput = () => seek($("slider").valueAsNumber, false);
  $("shot").onchange = () => choose(Number($("shot").value));
  $("previous").onclick = () => step(-1);
  $("next").onclick = () => step(1);
  document.addEventListener("keydown", keys);
  window.addEventListener("hashchange", () => follow(views));
  sift();
  choose(state.shot);
  follow(views);
  Theme.tell(() => {
    darkened();
    picture?.repaint();
  });
  window.hoopgen = {
    balls: () => picture.balls(),
    play: () => !$("play").disabled && play(0),
    replace,
    words,
    stateAt: (shot, time) => Flight.stateAt(shots[shot], time),
  };
})();
