// Sliders with fields beside them, one of each for a variable, in the units that the page shows.
"use strict";

const Controls = (() => {
  /**
   * Make the controls of variables, {name, label, kind, low, high, step} in SI, into a holder.
   * `change(name, value, done)` is told a new value, SI; `unitOf(kind)` how it is shown.
   */
  function create(holder, variables, unitOf, change) {
    const made = variables.map((variable) => [variable.name, control(variable)]);
    holder.append(...made.map(([, { row }]) => row));
    const by = Object.fromEntries(made);

    function control({ name, label, kind, low, high }) {
      const row = Object.assign(document.createElement("div"), { className: "control" });
      const id = `set-${name}`;
      const text = Object.assign(document.createElement("label"), { textContent: label, htmlFor: id });
      const field = Object.assign(document.createElement("input"), { type: "number", id, step: "any" });
      field.inputMode = "decimal";
      const symbol = Object.assign(document.createElement("span"), { className: "unit" });
      const slider = Object.assign(document.createElement("input"), { type: "range", step: "any" });
      slider.setAttribute("aria-label", label);
      const tell = (input, done) => {
        const value = input.valueAsNumber * unitOf(kind).size;
        field.toggleAttribute("aria-invalid", !Number.isFinite(value));
        if (Number.isFinite(value)) change(name, value, done);
      };
      slider.oninput = () => tell(slider, false);
      slider.onchange = () => tell(slider, true);
      field.onchange = () => tell(field, true);
      row.append(text, slider, field, symbol);
      return { row, field, symbol, slider, kind, low, high };
    }

    /** Show values, SI, by name. */
    function show(values) {
      for (const [name, { field, symbol, slider, kind, low, high }] of Object.entries(by)) {
        const unit = unitOf(kind);
        const value = values[name] / unit.size;
        const step = 10 ** -unit.decimals;
        const end = (bound) => Math.round(bound / unit.size / step) * step; // whole steps
        Object.assign(slider, { min: end(low), max: end(high), step });
        slider.value = value;
        field.step = step;
        const said = `${Number(value.toFixed(unit.decimals + 1))}`;
        if (field.valueAsNumber !== Number(said)) field.value = said;
        symbol.textContent = unit.symbol;
        const spoken = `${Number(value.toFixed(unit.decimals))} ${unit.symbol}`;
        slider.setAttribute("aria-valuetext", spoken);
        field.setAttribute("aria-description", unit.symbol);
      }
    }

    return { show };
  }

  return { create };
})();
