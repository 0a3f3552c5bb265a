// The worker: it answers the newest question and drops those that came before.
"use strict";

if (typeof document === "undefined") {
  let [newest, ready] = [0, null];
  const rest = () => new Promise((go) => setTimeout(go));

  self.onmessage = async ({ data }) => {
    if (data.spec) {
      ready = Engine.start(data.modules, data.spec.layout).then((engine) => ({
        engine,
        study: Study.of(engine, data.spec),
        spec: data.spec,
      }));
      return;
    }
    newest = Math.max(newest, data.id);
    const { engine, study, spec } = await ready;
    await rest(); // for newer questions
    for (const [name, question] of Object.entries(data.questions)) {
      const begun = performance.now();
      let answer;
      for (const part of parts(name, question, engine, study, spec)) {
        if (data.id && data.id < newest) return; // 0 is no question about a shot
        answer = part();
        await rest();
      }
      const milliseconds = performance.now() - begun;
      if (data.id >= newest || !data.id) self.postMessage({ id: data.id, name, answer, milliseconds });
    }
  };

  /** Return functions of which the last one returns an answer: between them newer questions come. */
  function parts(name, question, engine, study, spec) {
    if (name === "fingerprint") {
      const parameters = spec.presets[spec.fixed.preset];
      return [() => Fingerprint.bytes(engine, spec.fixed, parameters, spec.layout)];
    }
    if (name !== "changes") return [() => study[name](question)];
    const found = [];
    return question.vary.map((variable) => () => {
      found.push(study.change(variable, question));
      return found;
    });
  }
}
