// The error as it fell: a column for each model of the study, in the order in which they were fitted, one for what the
// diagnosis proposes or corrects, and one for the model of switches and sliders once a reader has moved them.

// Most steps of the ladder that are drawn, the latest: more columns would have no room for their names.
const MOST_STEPS = 5;

class LadderPicture {
  constructor(page) {
    this.page = page;
    const {ladder, current, proposed, corrected} = page.data;
    this.columns = ladder.slice(-MOST_STEPS).map(step => ({name: step.name, when: step.when, index: this.indexOf(step.effects), rms: step.rms}));
    const last = this.columns[this.columns.length - 1];
    if (!last || last.index !== current) this.columns.push({name: last ? "study.toml now" : "this study", index: current});
    if (proposed !== null && proposed !== current) this.columns.push({name: page.data.proposed_name, when: page.data.proposed_as, index: proposed});
    if (corrected) this.columns.push({name: "error corrected", when: corrected.of, index: null, rms: corrected.rms, off: corrected.deviations});
    this.dry = page.data.readings.map(r => r.liquid_content === 0);
  }
  // Number of the fitted combination that has exactly these effects; null: none has.
  indexOf(effects) {
    const {switches, always} = this.page.data, {models} = this.page;
    if (!always.every(name => effects.includes(name)) || !effects.every(name => always.includes(name) || switches.some(s => s.name === name))) return null;
    const index = switches.reduce((sum, s, k) => sum + (effects.includes(s.name) ? 1 << k : 0), 0);
    return models[index].why_not === undefined ? index : null;
  }
  // When each model became the study's, or what else there is to say below its name; empty: nothing.
  times() { return this.columns.map(c => c.when || ""); }
  names() { return this.shown().map(c => c.name); }
  // The columns, and one for the model below where it is not the study's, or is on its way.
  shown() {
    const {page} = this, untouched = page.index === page.data.current && page.d.every(d => d === 0) && !page.move;
    return untouched ? this.columns : [...this.columns, {name: "switches below", index: null, now: true}];
  }

  // Deviations [%] of the readings from a fitted combination, relative to the measured values as their RMS is.
  deviations(index, which, off) {
    if (off) return off[which];
    const {page} = this, predicted = index === null ? page.predicted(which) : page.models[index].predict(page.models[index].parameters.map(() => 0), which);
    return page.data.readings.map((r, id) => 100 * (1 - predicted[id] / r.values[which]));
  }
  series() {
    const columns = this.shown(), roomy = this.page.roomy(), width = roomy ? .56 : .4, half = roomy ? 24 : 12, n = this.page.data.readings.length;
    return [0, 1].flatMap(which => {
      const points = [[], []], bars = [], texts = [], line = [];
      columns.forEach((column, x) => {
        const known = column.now || column.index !== null || column.off;
        const rms = known && !column.off ? this.page.rmsOf(column.now ? null : column.index, which) : column.rms[which];
        if (known) this.deviations(column.now ? null : column.index, which, column.off).forEach((y, id) =>
          points[this.dry[id] ? 0 : 1].push({x: x + (n > 1 ? width * (id / (n - 1) - .5) : 0), y, id}));
        bars.push({x, y: rms, half, stem: true}, {x, y: -rms, half, stem: true, mirrored: true});
        texts.push({x: x + width / 2 + .04, y: rms, text: `${rms < .995 ? rms.toFixed(2) : rms.toPrecision(3)} %`});
        if (!column.now) line.push([x, rms]);
      });
      const of = ["shear stress", "solid fraction"][which], more = {part: which, keyless: which > 0};
      return [
        {...more, label: "RMS deviation", keyless: true, kind: `${of}: RMS`, colour: "var(--mark1)", width: 1, dash: true, points: [], curve: line},
        ...[["dry reading", "circle", "var(--mark0)"], ["wet reading", "square", "var(--mark2)"]].map(([label, shape, colour], wet) =>
          ({...more, label, kind: `${of}: deviation`, shape, colour, radius: n > 40 ? 2.6 : 3.4, points: points[wet]})).filter(s => s.points.length > 0),
        {...more, label: "RMS deviation", kind: `${of}: RMS`, colour: "var(--mark1)", straight: true, width: 2, points: [], marks: bars, texts}
      ];
    });
  }
  // Ends of the vertical axes: over all combinations between which the axes stay.
  reach() {
    return [0, 1].map(which => this.page.kept().flatMap(index => ends(this.deviations(index, which))));
  }
}
const ends = values => { const known = [...values].filter(v => isFinite(v)); return known.length > 0 ? [Math.min(...known), Math.max(...known)] : []; };
