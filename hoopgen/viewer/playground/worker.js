// The worker: it answers the newest question and drops those that came before.
"use strict";

if (typeof document === "undefined") {
  let newest = 0;
  let page = null; // its data, and the modules
  const started = {}; // by scene
  const BUSY = 30; // ms without a look at newer questions: browsers wait for 4 ms at each
  const rest = () => new Promise((go) => setTimeout(go));

  self.onmessage = async ({ data }) => {
    if (data.spec) {
      page = data;
      return;
    }
    newest = Math.max(newest, data.id);
    const { scene } = data;
    started[scene] ??= Study.start(Study.specOf(page.spec, scene), page.modules);
    const study = await started[scene];
    await rest(); // for newer questions
    for (const [name, question] of Object.entries(data.questions)) {
      const begun = performance.now();
      let rested = begun;
      for (const answer of steps(name, question, study)) {
        if (answer !== undefined) {
          self.postMessage({ id: data.id, scene, name, answer, milliseconds: performance.now() - begun });
        }
        if (performance.now() - rested < BUSY) continue;
        await rest();
        rested = performance.now();
        if (data.id && data.id < newest) return; // 0 is no question about a shot
      }
    }
  };

  /** Yield answers, of which the last one is whole, and nothing where newer questions may come. */
  function* steps(name, question, study) {
    const { engine, spec } = study;
    if (name === "fingerprint") {
      yield* Fingerprint.steps(engine, spec.fixed, spec.presets[spec.fixed.preset], spec.layout);
    } else if (name === "changes") {
      const found = [];
      for (const variable of question.vary) {
        let change;
        for (change of study.change(variable, question)) yield;
        found.push(change);
        yield found;
      }
    } else {
      yield study[name](question);
    }
  }
}
