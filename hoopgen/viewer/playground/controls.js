// Sliders with fields beside them, one of each for a variable, in the units that the page shows.
"use strict";

const Controls = (() => {
  /**
   * Make the controls of variables, {name, label, kind, low, high, group, infinite} in SI, into a
   * holder. `change(name, value, done)` is told a new value, SI; `unitOf(kind)` how it is shown.
   */
  function create(holder, variables, unitOf, change) {
    const made = variables.map((variable) => [variable.name, control(variable)]);
    holder.replaceChildren();
    variables.forEach(({ group }, k) => {
      if (group && group !== variables[k - 1]?.group) {
        holder.append(Object.assign(document.createElement("h3"), { textContent: group }));
      }
      holder.append(made[k][1].row);
    });
    const by = Object.fromEntries(made);

    function control({ name, label, kind, low, high, group, infinite }) {
      const row = Object.assign(document.createElement("div"), { className: "control" });
      const id = `set-${name}`;
      const text = Object.assign(document.createElement("label"), { htmlFor: id });
      text.textContent = group ? label.slice(0, -group.length - 1) : label;
      const field = Object.assign(document.createElement("input"), { type: "number", id, step: "any" });
      field.inputMode = "decimal";
      const symbol = Object.assign(document.createElement("span"), { className: "unit" });
      const slider = Object.assign(document.createElement("input"), { type: "range", step: "any" });
      for (const input of [field, slider]) input.setAttribute("aria-label", label);
      if (infinite) field.placeholder = "∞";
      const tell = (input, done) => {
        const empty = infinite && input.value === "" && !input.validity.badInput;
        const value = empty ? Infinity : input.valueAsNumber * unitOf(kind).size;
        field.toggleAttribute("aria-invalid", Number.isNaN(value));
        if (!Number.isNaN(value)) change(name, value, done);
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
        symbol.textContent = unit.symbol;
        field.setAttribute("aria-description", unit.symbol);
        if (value === Infinity) {
          field.value = "";
          slider.setAttribute("aria-valuetext", "infinite");
          continue;
        }
        const said = `${Number(value.toFixed(unit.decimals + 1))}`;
        if (field.valueAsNumber !== Number(said)) field.value = said;
        const spoken = `${Number(value.toFixed(unit.decimals))} ${unit.symbol}`;
        slider.setAttribute("aria-valuetext", spoken);
      }
    }

    return { show };
  }

  return { create };
})();
