// What the worker has found, in words, lists and pictures.
"use strict";

const Results = (() => {
  const $ = (id) => document.getElementById(id);
  const shown = {}; // by name, how to draw it again
  let map = null;

  const percent = (share, digits = 1) => `${(100 * share).toFixed(digits)}%`;
  /** Say a share that is not zero. */
  const some = (share) => (share < 5e-4 ? "<0.1%" : percent(share));
  const count = (number) => number.toLocaleString("en");

  function make(tag, properties = {}, ...children) {
    const element = Object.assign(document.createElement(tag), properties);
    element.append(...children);
    return element;
  }

  /** Return the classes of shots in their order, with their colours. */
  function classes(spec) {
    return ["made", "missed"].flatMap((end, row) =>
      Object.entries(spec.colours[end]).map(([kind, colour]) => {
        return { end, row, kind: spec.kinds.names.indexOf(kind), colour, text: `${end}, ${kind.replace("_", ", ")}` };
      }),
    );
  }

  function scatter(found, { now, spec, words, parameters }) {
    const share = found.count ? found.made / found.count : NaN;
    const [big, small] = $("share").children;
    const digits = share < 0.01 || share > 0.99 ? 2 : 1; // no interval is said to be a point
    const [low, high] = found.interval.map((end) => percent(end, digits));
    big.textContent = found.count ? percent(share, digits) : "–";
    const interval = make("span", { textContent: `${low} to ${high} (95%, Wilson)` });
    small.replaceChildren(`made: ${count(found.made)} of ${count(found.count)}`, " ", interval);
    const there = classes(spec).map((one) => ({ ...one, number: found.tally[one.kind][one.row] }));
    const seen = there.filter(({ number }) => number);
    $("bar").replaceChildren(
      ...seen.map(({ number, colour }) => {
        const part = make("i");
        Object.assign(part.style, { width: percent(number / found.count, 3), background: colour });
        return part;
      }),
    );
    $("bar").setAttribute("aria-label", seen.map(({ text, number }) => `${text} ${some(number / found.count)}`).join("; "));
    $("kinds").replaceChildren(
      ...seen.map(({ text, number, colour }) => {
        const swatch = make("i");
        swatch.style.background = colour;
        return make("li", {}, swatch, text, make("span", { textContent: some(number / found.count) }));
      }),
    );
    const spread = spec.variables.scatter.map(({ name, label, kind }) => `${label.toLowerCase()} ${words.say(kind, now[name])}`);
    $("throws-note").textContent = `${count(found.count + found.invalid)} throws about this release, standard deviations: ${spread.join(", ")}. Every change uses the same random numbers (seed ${now.seed})${found.invalid ? `; ${count(found.invalid)} are invalid and left out` : ""}.`;
    const made = spec.outcomes.indexOf("made");
    const [mean, deviation] = found.angle;
    $("entries-note").textContent = `Where each throw comes down through the ring’s plane if it touches nothing before: blue if it is made, orange if not. Entry angle ${words.say("angle", mean)} ± ${words.say("angle", deviation)}.`;
    $("entries").setAttribute("aria-label", $("entries-note").textContent);
    $("landings-note").textContent = `Where misses come down to ${words.say("length", spec.catching_height)} above the floor, as if nobody caught them before. Open circle: the shooter.`;
    $("landings").setAttribute("aria-label", $("landings-note").textContent);
    const shooter = [now.distance * Math.cos(now.angle), now.distance * Math.sin(now.angle)];
    shown.scatter = () => {
      Charts.entries($("entries"), found, parameters, made);
      Charts.landings($("landings"), found, parameters, shooter, spec.courts[now.preset].lines);
    };
    shown.scatter();
  }

  function inks(spec) {
    const rgb = (colour) => [...[1, 3, 5].map((at) => Number.parseInt(colour.slice(at, at + 2), 16)), 255];
    const other = rgb(spec.colours.other);
    const table = spec.outcomes.map(() => spec.kinds.names.map(() => other));
    for (const { end, kind, colour } of classes(spec)) table[spec.outcomes.indexOf(end)][kind] = rgb(colour);
    return (outcome, kind) => table[outcome][kind];
  }

  function drawMap(found, { now, spec, words }) {
    map = found;
    const axes = [["speed", "Speed"], ["angle", "Elevation"]].map(([kind, name]) => ({ name, ...words.unit(kind) }));
    const inkOf = inks(spec);
    const at = [now.speed, now.elevation];
    shown.map = () => Charts.map($("map"), found, inkOf, at, axes);
    shown.map();
    const made = found.outcome.filter((end) => spec.outcomes[end] === "made").length;
    $("map").setAttribute(
      "aria-label",
      `Outcome over speed and elevation about this shot: ${percent(made / found.outcome.length)} of the map is made`,
    );
  }

  function changes(found, { spec, words }, set) {
    const made = document.body.dataset.outcome === "made";
    $("change-title").textContent = made ? "What would have missed it" : "What would have made it";
    const labels = Object.fromEntries(Object.values(spec.variables).flat().map((one) => [one.name, one]));
    const rows = spec.vary.map((name, k) => ({ ...(found[k] ?? { name, waiting: true }), ...labels[name] }));
    $("changes").replaceChildren(
      ...rows.map(({ name, label, kind, value, changed, within, waiting }) => {
        if (waiting) return make("li", { className: "none" }, label, make("span", { textContent: "…" }));
        const small = { length: "short" }[kind] ?? kind;
        const { size, symbol, decimals } = words.unit(small);
        const amount = (away) => {
          const digits = Math.max(1 - Math.floor(Math.log10(Math.abs(away) / size)), decimals);
          return `${(Math.abs(away) / size).toFixed(Math.min(digits, 12))}${/^\p{L}/u.test(symbol) ? " " : ""}${symbol}`;
        };
        const tried = within === undefined ? "" : `none ${within > 0 ? `within ±${amount(within)}` : "found"} in ${Study.PATIENCE / 1000} s`;
        if (changed === undefined) {
          return make("li", { className: "none" }, label, make("span", { textContent: tried || "no such change nearby" }));
        }
        const away = changed - value;
        const said = `${away > 0 ? "+" : "−"}${amount(away)}`;
        const button = make("button", { type: "button", textContent: "Try", onclick: () => set({ [name]: changed }) });
        button.setAttribute("aria-label", `Try ${label} ${said}`);
        const item = make("li", {}, label, make("b", { textContent: tried ? `${said}?` : said }), button);
        if (tried) item.title = `A nearer one may exist: ${tried}`;
        item.dataset.name = name;
        item.dataset.changed = changed;
        return item;
      }),
    );
    $("change-note").textContent = "The smallest change of one variable alone, narrowed down as far as doubles decide. Thousands of values are tried; intervals between them may be missed. In Python, hoopgen counterfactual proves both sides.";
  }

  /** Show the digest of the results of a scene's fixed shots beside Python's; null: not known yet. */
  function fingerprint(digest, { scene, fixed }) {
    $("hash-command").textContent = `hoopgen hash ${scene}`;
    $("hash").textContent = digest ?? "…";
    const verdicts = [
      `✗ In Python, where this page was made, it was ${fixed.sha256}.`,
      "✓ The same as hoopgen had in Python where this page was made.",
    ];
    $("verdict").textContent = digest === null ? "" : verdicts[Number(digest === fixed.sha256)];
    if (!globalThis.crypto?.subtle) {
      $("verdict").textContent = "This address is not secure, and browsers give no SHA-256 there.";
    }
  }

  function repaint() {
    for (const draw of Object.values(shown)) draw();
  }

  const mapAt = (x, y) => map && Charts.mapAt($("map"), map.window, x, y);

  return { changes, fingerprint, map: drawMap, mapAt, repaint, scatter };
})();
