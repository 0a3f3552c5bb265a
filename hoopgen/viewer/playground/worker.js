// The worker: it answers the newest question and drops those that came before.
"use strict";

if (typeof document === "undefined") {
  let newest = 0;
  let open = 0; // questions about shots that are being answered
  let page = null; // its data, and the modules
  const started = {}; // by scene
  const BUSY = 30; // ms without a look at newer questions: browsers wait for 4 ms at each
  const rest = () => new Promise((go) => setTimeout(go));

  self.onmessage = async ({ data }) => {
    if (data.spec) {
      page = data;
      return;
    }
    const aside = data.id === 0; // no question about a shot: it waits for those, and is not dropped
    newest = Math.max(newest, data.id);
    open += !aside;
    try {
      started[data.scene] ??= Study.start(Study.specOf(page.spec, data.scene), page.modules);
      const study = await started[data.scene];
      await answer(data, study, async () => {
        do await rest();
        while (aside && open);
        return aside || data.id === newest;
      });
    } finally {
      open -= !aside;
    }
  };

  /** Answer questions one after the other while `goOn`, asked first and now and then, says so. */
  async function answer({ id, scene, questions }, study, goOn) {
    if (!(await goOn())) return;
    for (const [name, question] of Object.entries(questions)) {
      const begun = performance.now();
      let rested = begun;
      for (const found of steps(name, question, study)) {
        if (found !== undefined) {
          self.postMessage({ id, scene, name, answer: found, milliseconds: performance.now() - begun });
        }
        if (performance.now() - rested < BUSY) continue;
        if (!(await goOn())) return;
        rested = performance.now();
      }
    }
  }

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
