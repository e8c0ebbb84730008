// The page: all combinations of effects are embedded with second-order expansions of the predictions;
// switches choose a combination, sliders move its parameters.

// Numbers of an array that the program wrote (page_data.h).
class Reader {
  constructor(base64) {
    const text = atob(base64), bytes = new Uint8Array(text.length);
    for (let k = 0; k < text.length; ++k) bytes[k] = text.charCodeAt(k);
    this.view = new DataView(bytes.buffer);
    this.at = 0;
  }
  float() { this.at += 4; return this.view.getFloat32(this.at - 4, true); }
  floats(count) { return Float64Array.from({length: count}, () => this.float()); }
  unsigned(width) {
    let value = 0;
    for (let k = 0; k < width; ++k) value += this.view.getUint8(this.at++) * 2 ** (8 * k);
    return value;
  }
  // Integers of one or two bytes, with the scale of the greatest before them.
  scaled(count, width = 2) {
    const unit = this.float() / (width === 2 ? 32767 : 127);
    return Float64Array.from({length: count}, () => { this.at += width; return unit * (width === 2 ? this.view.getInt16(this.at - 2, true) : this.view.getInt8(this.at - 1)); });
  }
}

// A fitted combination of effects. `d`: distances of the parameters from the fit in standard errors.
class Model {
  constructor(json, readings, points) {
    Object.assign(this, json);
    this.count = readings.length + points;
    this.readings = readings;
  }
  unpack() {
    if (this.values) return;
    const reader = new Reader(this.response), p = this.parameters.length;
    this.values = [reader.floats(this.count), reader.floats(this.count)];
    this.coefficients = Array.from({length: p + p * (p + 1) / 2}, (_, k) => [0, 1].map(() => reader.scaled(this.count, k < p ? 2 : 1)));
    const errors = new Reader(this.errors);
    this.sigma = [errors.floats(this.readings.length), errors.floats(this.readings.length)];
    const terms = 1 + this.coefficients.length;
    this.chi2Form = new Reader(this.form).floats(terms * (terms + 1) / 2);
    const without = new Reader(this.without);
    this.withoutColumns = Array.from({length: 1 + p}, () => without.scaled(this.fitted));
  }
  // Fall of chi2 and shifts of the parameters where a fitted reading is left out of the fit.
  withoutReading(id) {
    this.unpack();
    return this.withoutColumns.map(column => column[id]);
  }
  terms(d) {
    const terms = [...d];
    for (let i = 0; i < d.length; ++i) for (let j = i; j < d.length; ++j) terms.push(d[i] * d[j]);
    return terms;
  }
  // Stress ratio (0) or solid fraction (1) at all readings, then at the points of curves.
  predict(d, which) {
    this.unpack();
    const result = Float64Array.from(this.values[which]), terms = this.terms(d);
    terms.forEach((t, k) => { if (t !== 0) this.coefficients[k][which].forEach((c, n) => { result[n] += t * c; }); });
    return result;
  }
  chi2At(d) {
    this.unpack();
    const t = [1, ...this.terms(d)];
    let sum = 0, at = 0;
    for (let i = 0; i < t.length; ++i) for (let j = i; j < t.length; ++j) sum += (i === j ? 1 : 2) * this.chi2Form[at++] * t[i] * t[j];
    return sum;
  }
  // RMS of predicted/measured - 1 over all readings [%].
  rmsAt(d, which) {
    const predicted = this.predict(d, which);
    let sum = 0;
    this.readings.forEach((r, k) => { sum += (predicted[k] / r.values[which] - 1) ** 2; });
    return 100 * Math.sqrt(sum / this.readings.length);
  }
}

// Text of a number with its standard error: as many digits as the error has two.
function withError(value, error) {
  if (!(error > 0) || !isFinite(error)) return value.toPrecision(4);
  const power = Math.floor(Math.log10(error)), digits = 1 - power;
  if (digits > 6 || Math.abs(value) >= 1e6) {
    const exponent = Math.floor(Math.log10(Math.max(Math.abs(value), error)));
    const scale = Math.pow(10, exponent), places = Math.max(0, exponent - power + 1);
    return withMinus(`(${(value / scale).toFixed(places)} ± ${(error / scale).toFixed(places)})`) + `e${exponent}`;
  }
  const places = Math.max(0, digits);
  return withMinus(`${value.toFixed(places)} ± ${error.toFixed(places)}`);
}
// Names of files without the ending that all of them have.
function shortNames(files) {
  const ending = files[0].match(/\.[A-Za-z]\w*$/);
  return ending && files.every(file => file.endsWith(ending[0])) ? files.map(file => file.slice(0, -ending[0].length)) : files;
}
const fitText = p => p.determined ? p.text : "not determined by the readings";
const unitText = unit => unit === "1" ? "" : " " + unit;
const three = value => withMinus(Math.abs(value) >= 1000 ? value.toFixed(0) : String(Number(value.toPrecision(3))));

// Whether the curve of a series passes the model's values at the readings to half of their errors; it
// does not where these depend on more than the quantity along the x axis.
function passes(series) {
  return series.curve.length < 2 || series.marks.every((m, k) => {
    const found = series.curve.findIndex(([x]) => x >= m.x), after = found < 0 ? series.curve.length - 1 : Math.max(1, found);
    const [a, b] = [series.curve[after - 1], series.curve[after]];
    return Math.abs(a[1] + (b[1] - a[1]) * (m.x - a[0]) / (b[0] - a[0]) - m.y) < series.points[k].error / 2;
  });
}

// Duration of the transition from one model to another [ms]; chosen: long enough to follow a reading by eye, short
// enough not to wait for.
const MOVE = 450;

class Page {
  constructor(data) {
    Object.assign(this, {data, marked: new Set(), here: -1, told: -1, out: -1, plots: [], keepAxes: true, move: null});
    this.models = data.models.map(m => m.why_not === undefined ? new Model(m, data.readings, data.points) : m);
    this.index = data.current;
    this.d = [];
    this.makeSwitches();
    this.choose(this.models[this.index].why_not === undefined ? this.index : this.models.findIndex(m => m.why_not === undefined));
    this.makePlots();
    this.makeRecordings();
    this.makeReadings();
    this.update();
    // A wide figure takes another form where the page becomes narrow.
    let roomy = this.roomy();
    addEventListener("resize", () => { if (window.page === this && roomy !== this.roomy()) { roomy = this.roomy(); this.drawAll(); } });
  }
  roomy() { return document.documentElement.clientWidth >= 700; }
  // Words for a reading, as in the tables of the program: its file and step, or the line of its file.
  nameOf(id) {
    const r = this.data.readings[id];
    return r.step ? `${r.file} step ${r.step}` : `${r.file}:${r.line}`;
  }
  // Combinations between which the axes of figures stay: no effect, the study's, each of these and one effect more or
  // less, and all effects; those that fit worse than both the first two would leave the others no room.
  kept() {
    const {current, switches} = this.data, flips = switches.flatMap((_, k) => [current ^ 1 << k, 1 << k]);
    const chi2Of = index => this.models[index].why_not === undefined ? this.models[index].chi2 : 0;
    const worst = Math.max(chi2Of(0), chi2Of(current));
    return [...new Set([0, current, ...flips, this.models.length - 1])].filter(index =>
      this.models[index].why_not === undefined && (index === 0 || index === current || this.models[index].chi2 <= worst));
  }
  // Relative RMS deviation of a combination, or of the model that is shown (null).
  rmsOf(index, which) {
    if (index !== null) return this.models[index].rms[which];
    const shown = this.d.some(d => d !== 0) ? this.model.rmsAt(this.d, which) : this.model.rms[which];
    return this.move ? this.move.rms[which] + this.move.share * (shown - this.move.rms[which]) : shown;
  }
  // Predictions that are shown: on the way to another model, between those of the two.
  predicted(which) { return this.between("values", which, this.model.predict(this.d, which)); }
  sigma(which) {
    this.model.unpack();
    return this.between("sigma", which, this.model.sigma[which]);
  }
  between(what, which, to) {
    if (!this.move) return to;
    const from = this.move[what][which], {share} = this.move;
    return to.map((value, k) => from[k] + share * (value - from[k]));
  }
  // Shows the way from what was shown to the present model, unless the reader wants no motion.
  startMove(from) {
    this.move = null;
    if (matchMedia("(prefers-reduced-motion: reduce)").matches || document.hidden) return;
    const begun = performance.now(), move = {...from, share: 0};
    this.move = move;
    const step = now => {
      if (this.move !== move || window.page !== this) return;
      const t = Math.max(0, Math.min(1, (now - begun) / MOVE));
      move.share = t * t * (3 - 2 * t);
      if (t >= 1) this.move = null;
      this.drawAll(t < 1);
      if (t < 1) requestAnimationFrame(step);
    };
    requestAnimationFrame(step);
  }
  // Draws all figures that depend on the model. `seen`: only those in the window.
  drawAll(seen = false) {
    for (const plot of this.plots) {
      const box = seen ? plot.figure.getBoundingClientRect() : null;
      if (!box || box.bottom > 0 && box.top < innerHeight) plot.draw();
    }
  }
  get model() { return this.models[this.index]; }
  isOn(k) { return (this.index >> k & 1) === 1; }

  makeSwitches() {
    const field = document.getElementById("switches");
    if (this.data.always.length > 0) html("p", {class: "gain", id: "always"}, field, "Always on: " + this.data.always.join(", "));
    this.boxes = this.data.switches.map((s, k) => {
      const label = html("label", {title: s.summary}, field);
      const box = html("input", {type: "checkbox", "data-effect": s.name}, label);
      label.append(" " + s.name + " ");
      const gain = html("span", {class: "gain"}, label);
      box.addEventListener("change", () => this.flip(k, box.checked));
      return {box, gain, label};
    });
    // Those that are in the model first, then those with which chi2 falls most. Later switching keeps the order.
    const chi2With = k => { const other = this.models[this.index ^ 1 << k]; return this.isOn(k) ? -1 : other.why_not === undefined ? other.chi2 : Infinity; };
    this.boxes.map((box, k) => k).sort((a, b) => chi2With(a) - chi2With(b)).forEach(k => field.append(this.boxes[k].label));
    if (this.boxes.length === 0) { html("p", {}, field, "This page has no switches: no effect leads, or it was made with --switches 0."); return; }
    const label = html("label", {class: "axes", title: "Axes that stay show how far the model moves; axes that follow show the present model closely."}, field);
    const box = html("input", {type: "checkbox", id: "keep-axes"}, label);
    box.checked = this.keepAxes;
    label.append(" Axes stay when an effect is switched");
    box.addEventListener("change", () => { this.keepAxes = box.checked; this.drawAll(); });
  }
  flip(k, on) {
    const wanted = on ? this.index | 1 << k : this.index & ~(1 << k);
    if (this.models[wanted].why_not !== undefined) {
      this.boxes[k].box.checked = !on;
      this.say(`This combination cannot be fitted: ${this.models[wanted].why_not}.`);
      return;
    }
    const out = this.out, both = f => [0, 1].map(f);
    const from = {values: both(which => this.predicted(which)), sigma: both(which => this.sigma(which)), rms: both(which => this.rmsOf(null, which))};
    this.choose(wanted);
    if (out < this.model.fitted) this.out = out;
    this.startMove(from);
    this.update();
  }
  choose(index) {
    this.index = index;
    this.d = this.model.parameters.map(() => 0);
    this.out = -1;
    this.makeSliders();
  }
  makeSliders() {
    const field = document.getElementById("sliders");
    field.replaceChildren(html("legend", {}, null, "Parameters"));
    this.sliders = this.model.parameters.map((p, k) => {
      const label = html("label", {}, field), text = html("span", {}, label);
      const [low, high] = p.trusted;
      const slider = html("input", {type: "range", min: low, max: high, step: "any", value: p.value, "data-parameter": p.name,
        "aria-label": p.name + unitText(p.unit)}, label);
      slider.disabled = !(low < high);
      if (slider.disabled) slider.title = "The expansion of the model about its fit does not hold along this parameter.";
      slider.addEventListener("input", () => {
        this.d[k] = p.error > 0 ? (Number(slider.value) - p.value) / p.error : 0;
        this.update();
      });
      return {slider, text};
    });
    const back = html("button", {type: "button"}, field, "Back to the fit");
    back.addEventListener("click", () => { this.choose(this.index); this.update(); });
    html("p", {class: "note"}, field, "Within the range of each slider, curves differ from the program's by at most a tenth of a reading's error.");
  }

  makePlots() {
    const place = id => document.getElementById(id), labels = ["stress ratio [1]", "solid fraction [1]"], names = ["stress-ratio", "solid-fraction"];
    this.ladder = new LadderPicture(this);
    this.plots.push(new Plot(place("ladder-figure"), {name: "ladder", title: "Deviation of each reading from the model", wide: true,
      xLabel: "", parts: ["shear stress [%]", "solid fraction [%]"], lines: true, names: () => this.ladder.names(), times: () => this.ladder.times(), reach: () => this.ladder.reach()}, () => this.ladder.series(), this));
    this.data.panels.forEach((panel, number) => [0, 1].forEach(which => {
      this.plots.push(new Plot(place("figures"), {name: `${panel.title.split(" ")[0].toLowerCase()}-${names[which]}`, title: `${panel.title}: ${["stress ratio", "solid fraction"][which]}`,
        xLabel: panel.x_label, yLabel: labels[which], logX: panel.log_x, quantity: panel.quantity,
        reach: () => [this.kept().flatMap(index => this.reachOf(number, which, index))]}, () => this.seriesOf(number, which), this));
    }));
    this.makeResiduals(place("residual-figures"));
  }
  makeResiduals(figures) {
    const {readings} = this.data, yLabel = "(measured − model)/error [1]";
    const reach = () => [this.kept().flatMap(index => [0, 1].flatMap(which => ends(this.residualsOf(index, which))))];
    const last = Math.max(...readings.map(r => r.time)), [unit, second] = last < 600 ? ["s", 1] : last < 36000 ? ["min", 60] : ["h", 3600];
    // Only quantities that a rheometer sets over decades have logarithmic axes.
    const axes = [["normal_stress", "normal stress [Pa]", 1, true], ["inertial_number", "inertial number I [1]", 1, true], ["liquid_content", "liquid content [1]", 1], ["height", "height [mm]", 1e3],
      ["time", `time [${unit}]`, 1 / second]];
    for (const [key, label, factor, wide] of axes) {
      const values = readings.map(r => r[key]).filter(v => v !== null);
      const low = Math.min(...values), high = Math.max(...values);
      if (values.length < readings.length || !(high > low * 1.02 + 1e-12)) continue;
      this.plots.push(new Plot(figures, {name: "residuals-" + key.replace("_", "-"), title: "Residuals against " + label.replace(/ \[.*/, ""), xLabel: label,
        yLabel, logX: Boolean(wide) && low > 0 && high > 5 * low, zero: true, reach}, () => this.residuals(r => r[key] * factor), this));
    }
    const files = [...new Set(readings.map(r => r.file))];
    if (files.length > 1) {
      this.plots.push(new Plot(figures, {name: "residuals-file", title: "Residuals by file", xLabel: files.length > MOST_NAMES ? "file, in the order of study.toml" : "file", yLabel, zero: true,
        reach, names: () => shortNames(files)}, () => this.residualsByFile(files), this));
    }
    this.plots.push(new Plot(figures, {name: "quantiles", title: "Residuals against a normal distribution", xLabel: "expected from the normal distribution [1]",
      yLabel, zero: true, reach}, () => this.quantiles(), this));
  }
  // Recordings change with nothing: they are drawn once.
  makeRecordings() {
    const figures = document.getElementById("recording-figures");
    this.recordings = this.data.recordings.filter(r => r.parts.length > 0).map((r, number) => new Plot(figures, {name: `recording-${number + 1}`, title: r.name,
      xLabel: r.x_label, parts: r.parts.map(part => part.label)}, () => recordingSeries(r), this));
  }
  markPlots() { for (const plot of [...this.plots, ...this.recordings]) plot.mark(); }
  seriesOf(number, which) {
    const panel = this.data.panels[number], predicted = this.predicted(which), n = this.data.readings.length;
    return panel.series.map(s => ({
      label: s.label, group: s.group, value: s.value,
      points: s.members.map(id => ({x: panel.x[id], y: this.data.readings[id].values[which], error: this.data.readings[id].errors[which], id})),
      marks: s.members.map(id => ({x: panel.x[id], y: predicted[id]})),
      curve: s.x.map((x, k) => [x, predicted[n + s.first + k]]).sort((a, b) => a[0] - b[0])
    })).map(s => passes(s) ? s : {...s, curve: []});
  }
  // Ends of the predictions of a combination at the readings of a panel.
  reachOf(number, which, index) {
    const model = this.models[index], predicted = model.predict(model.parameters.map(() => 0), which);
    return ends(this.data.panels[number].series.flatMap(s => s.members.map(id => predicted[id])));
  }
  residualsOf(index, which) {
    const model = this.models[index], predicted = model.predict(model.parameters.map(() => 0), which);
    return this.data.readings.map((r, id) => (r.values[which] - predicted[id]) / model.sigma[which][id]);
  }
  normalised(which) {
    const predicted = this.predicted(which), sigma = this.sigma(which);
    return this.data.readings.map((r, id) => (r.values[which] - predicted[id]) / sigma[id]);
  }
  residuals(xOf) {
    return ["shear stress", "solid fraction"].map((label, which) => ({label, kind: "residual",
      points: this.normalised(which).map((y, id) => ({x: xOf(this.data.readings[id]), y, id}))}));
  }
  // With the mean of each file as a dash; the readings of a file stand beside one another, in their order.
  residualsByFile(files) {
    const {readings} = this.data, of = files.map(file => readings.flatMap((r, id) => r.file === file ? [id] : []));
    const place = readings.map((r, id) => { const at = files.indexOf(r.file), ids = of[at]; return at + .6 * ((ids.indexOf(id) + .5) / ids.length - .5); });
    return ["shear stress", "solid fraction"].map((label, which) => {
      const values = this.normalised(which);
      return {label, kind: "residual", points: values.map((y, id) => ({x: place[id], y, id})),
        marks: of.map((ids, x) => ({x, y: ids.reduce((sum, id) => sum + values[id], 0) / ids.length, half: Math.min(24, 150 / files.length), mirrored: true}))};
    });
  }
  quantiles() {
    return ["shear stress", "solid fraction"].map((label, which) => {
      const sorted = this.normalised(which).map((y, id) => ({y, id})).sort((a, b) => a.y - b.y), n = sorted.length;
      const limits = [normalQuantile(.5 / n), normalQuantile(1 - .5 / n)];
      return {label, kind: "residual", points: sorted.map(({y, id}, k) => ({x: normalQuantile((k + .5) / n), y, id})),
        curve: which === 0 && n > 1 ? [[limits[0], limits[0]], [limits[1], limits[1]]] : []};
    });
  }

  update() {
    const {model} = this;
    this.boxes.forEach(({box, gain}, k) => {
      box.checked = this.isOn(k);
      const other = this.models[this.index ^ 1 << k];
      if (other.why_not !== undefined) { gain.textContent = "(cannot be fitted)"; return; }
      const change = other.chi2 - model.chi2;
      gain.textContent = this.isOn(k) ? `(without it chi2 = ${three(other.chi2)})` : Math.abs(change) < .05 ? "(with it chi2 stays)" : `(with it chi2 ${change > 0 ? "rises" : "falls"} by ${three(Math.abs(change))})`;
    });
    model.parameters.forEach((p, k) => {
      const value = p.value + this.d[k] * p.error, moved = this.d[k] !== 0;
      this.sliders[k].text.textContent = `${p.name} = ${moved ? Number(value.toPrecision(4)) + unitText(p.unit) + " (fit: " : ""}${fitText(p)}${moved ? ")" : ""}`;
    });
    this.score();
    this.drawAll();
    if (this.told >= 0) this.tell(this.told);
    this.fillReadings();
    this.fitTable();
  }
  score() {
    const {model} = this, moved = this.d.some(d => d !== 0), chi2 = moved ? model.chi2At(this.d) : model.chi2;
    const rms = [0, 1].map(which => moved ? model.rmsAt(this.d, which) : model.rms[which]);
    const box = document.getElementById("score");
    box.replaceChildren();
    html("p", {class: "big", "data-chi2": chi2}, box, `chi2 = ${chi2.toFixed(2)} for ${model.dof} degrees of freedom`);
    html("p", {"data-rms": rms.join(" ")}, box, `Relative RMS error: ${rms[0].toFixed(2)} % in shear stress, ${rms[1].toFixed(2)} % in solid fraction`);
    html("p", {}, box, moved ? "Parameters were moved away from the fit." :
      `p ${model.p < 1e-3 ? "< 0.001" : "= " + model.p.toPrecision(2)}: probability of a chi2 at least as large from errors alone${model.converged ? "" : ". The fit did not converge"}`);
    if (model.fitted < this.data.readings.length) html("p", {}, box, `${model.fitted} readings were fitted, ${this.data.readings.length - model.fitted} predicted.`);
    if (this.out >= 0) {
      const [fall, ...shifts] = model.withoutReading(this.out);
      html("p", {"data-without": fall}, box, `Refit without ${this.nameOf(this.out)}: chi2 falls by ${three(fall)}; ` +
        model.parameters.map((p, k) => {
          const errors = Math.abs(shifts[k]) / p.error;
          return errors < .05 ? `${p.name} stays` :
            `${p.name} ${shifts[k] < 0 ? "falls" : "rises"} by ${Number(Math.abs(shifts[k]).toPrecision(2))}${unitText(p.unit)} (${errors.toFixed(1)} errors)`;
        }).join(", ") + ". Figures and numbers above are of the fit with it.");
    }
  }

  makeReadings() {
    const table = document.getElementById("readings"), head = html("tr", {}, html("thead", {}, table));
    for (const text of ["reading", "normal stress [Pa]", "I [1]", "liquid content [1]", "stress ratio [1]", "model [1]", "solid fraction [1]", "model [1]", "residuals [errors]", "leave out"]) html("th", {scope: "col"}, head, text);
    this.body = html("tbody", {}, table);
    this.rows = this.data.readings.map((r, id) => {
      const row = html("tr", {}, this.body);
      html("td", {title: `from line ${r.line} of ${r.file} on`}, row, this.nameOf(id));
      for (const v of [r.normal_stress, r.inertial_number, r.liquid_content]) html("td", {}, row, three(v));
      html("td", {}, row, withError(r.values[0], r.errors[0]));
      const ratio = html("td", {}, row);
      html("td", {}, row, withError(r.values[1], r.errors[1]));
      const fraction = html("td", {}, row), residuals = html("td", {}, row), last = html("td", {}, row);
      const button = html("button", {type: "button", "aria-label": `Leave out ${this.nameOf(id)}`}, last, "leave out");
      button.addEventListener("click", () => { this.out = this.out === id ? -1 : id; this.update(); this.markPlots(); });
      row.addEventListener("pointerenter", () => this.show(id));
      return {row, ratio, fraction, residuals, button};
    });
  }
  // Residuals of the present model, whatever is on its way in the figures.
  finalResiduals(which) {
    const predicted = this.model.predict(this.d, which);
    return this.data.readings.map((r, id) => (r.values[which] - predicted[id]) / this.model.sigma[which][id]);
  }
  fillReadings() {
    const predicted = [0, 1].map(which => this.model.predict(this.d, which)), off = [0, 1].map(which => this.finalResiduals(which));
    this.rows.forEach(({row, ratio, fraction, residuals, button}, id) => {
      ratio.textContent = predicted[0][id].toFixed(4);
      fraction.textContent = predicted[1][id].toFixed(4);
      residuals.textContent = off.map(each => withMinus(each[id].toFixed(1))).join(", ");
      button.disabled = id >= this.model.fitted;
      button.textContent = this.out === id ? "take in" : "leave out";
      row.classList.toggle("out", this.out === id);
      row.classList.toggle("marked", this.marked.has(id));
    });
  }
  fitTable() {
    const place = document.getElementById("fit-table"), {model} = this;
    place.replaceChildren();
    const table = html("table", {}, place);
    html("caption", {}, table, `Fitted to ${model.fitted} readings: chi2 = ${model.chi2.toFixed(2)} of all readings for ${model.dof} degrees of freedom; reduced chi2 = ${(model.chi2 / model.dof).toFixed(3)}`);
    const head = html("tr", {}, html("thead", {}, table)), body = html("tbody", {}, table);
    for (const text of ["parameter", "value ± standard error", "allowed range"]) html("th", {scope: "col"}, head, text);
    for (const p of model.parameters) {
      const row = html("tr", {}, body), range = `${three(p.lower)} to ${three(p.upper)}${unitText(p.unit)}${p.at_bound ? " (at an end)" : ""}`;
      for (const text of [p.name, fitText(p), range]) html("td", {}, row, text);
    }
    if (model.parameters.length < 2) return;
    const second = html("table", {}, place);
    html("caption", {}, second, "Correlations of the fitted parameters [1]");
    const top = html("tr", {}, html("thead", {}, second)), rows = html("tbody", {}, second);
    for (const text of ["parameter", ...model.parameters.map(p => p.name)]) html("th", {scope: "col"}, top, text);
    model.correlations.forEach((values, k) => {
      const row = html("tr", {}, rows);
      html("td", {}, row, model.parameters[k].name);
      for (const v of values) html("td", {}, row, v === null ? "" : withMinus(v.toFixed(3)));
    });
  }

  show(id) {
    if (id === this.here) return;
    this.here = id;
    this.markPlots();
    if (id >= 0) this.tell(id); else document.getElementById("reading").classList.remove("afloat");
  }
  // Describes a reading; the line stays when the pointer leaves, so that it follows the model.
  tell(id) {
    const r = this.data.readings[id], predicted = [0, 1].map(which => this.model.predict(this.d, which)[id]), off = [0, 1].map(which => this.finalResiduals(which)[id]);
    this.say(`${this.nameOf(id)}: ${three(r.normal_stress)} Pa, I = ${three(r.inertial_number)}` +
      `${r.liquid_content ? `, liquid content ${three(r.liquid_content)}` : ", dry"}. Stress ratio ${withError(r.values[0], r.errors[0])}, model ${predicted[0].toFixed(4)} (${withMinus(off[0].toFixed(1))} errors). ` +
      `Solid fraction ${withError(r.values[1], r.errors[1])}, model ${predicted[1].toFixed(4)} (${withMinus(off[1].toFixed(1))} errors).`);
    this.told = id;
  }
  say(text) { this.told = -1; this.line(text); }
  // The line on a reading, at the lower edge of the window where its place is out of sight.
  line(text) {
    const line = document.getElementById("reading");
    line.textContent = text;
    line.classList.remove("afloat");
    const box = line.getBoundingClientRect();
    line.classList.toggle("afloat", this.here >= 0 && (box.bottom < 0 || box.top > innerHeight));
  }
  markOnly(ids) {
    this.marked = new Set(ids.filter(id => id >= 0));
    this.markPlots();
    this.rows.forEach(({row}, id) => row.classList.toggle("marked", this.marked.has(id)));
    if (this.marked.size > 1) this.say(`${this.marked.size} readings are marked: ${[...this.marked].sort((a, b) => a - b).map(id => this.nameOf(id)).join(", ")}. Escape unmarks them.`);
  }
}

// Course of a recording in each part, and the means over the rows that are averaged.
function recordingSeries(recording) {
  const colours = {"reading": "var(--mark2)", "no plateau, no reading": "var(--mark1)"}, inKey = new Set();
  const at = share => Number((recording.from + recording.span * share / 65535).toPrecision(6));
  return recording.parts.flatMap((part, index) => {
    const numbers = new Reader(part.points), course = [];
    while (numbers.at < numbers.view.byteLength) {
      const x = at(numbers.unsigned(2));
      course.push([x, Number((part.low + part.range * numbers.unsigned(2) / 65535).toPrecision(7))]);
    }
    const windows = recording.windows.filter(w => w.means[index] !== null).map(w => {
      const mean = w.means[index], keyless = inKey.has(w.kind);
      inKey.add(w.kind);
      return {part: index, label: w.kind, kind: "mean " + part.label, keyless, straight: true, width: 4,
        colour: colours[w.kind] || "var(--mark6)", dash: w.kind !== "reading", curve: [[w.from, mean], [w.to, mean]],
        points: w.reading === null ? [] : [{x: (w.from + w.to) / 2, y: mean, id: w.reading}]};
    });
    return [{part: index, label: "recorded", kind: part.label, keyless: index > 0, straight: true, width: 1, colour: "var(--soft)", points: [], curve: course}, ...windows];
  });
}

// Quantile of the normal distribution by bisection of its distribution function.
function normalQuantile(p) {
  let low = -8, high = 8;
  for (let k = 0; k < 60; ++k) { const middle = (low + high) / 2; if (normalShare(middle) < p) low = middle; else high = middle; }
  return (low + high) / 2;
}
// Distribution function of the normal distribution, by its series or its continued fraction.
function normalShare(x) {
  if (x < 0) return 1 - normalShare(-x);
  if (x > 6) return 1;
  let sum = x, term = x;
  for (let k = 1; k < 200; ++k) { term *= x * x / (2 * k + 1); sum += term; }
  return .5 + sum * Math.exp(-x * x / 2) / Math.sqrt(2 * Math.PI);
}

// Buttons that copy a text. A browser that gives no access to the clipboard selects the text instead.
function offerCopies() {
  for (const button of document.querySelectorAll("button[data-copy]")) button.addEventListener("click", async () => {
    const source = document.getElementById(button.dataset.copy);
    try {
      await navigator.clipboard.writeText(source.textContent);
      button.textContent = "Copied";
    } catch (error) {
      getSelection().selectAllChildren(source);
      button.textContent = document.execCommand("copy") ? "Copied" : "Selected: press Ctrl-C";
    }
  });
}
// Opens the fold of a section to which a link leads.
function openTarget() {
  const target = location.hash.length > 1 && document.getElementById(decodeURIComponent(location.hash.slice(1)));
  const fold = target && target.classList.contains("folded") && target.querySelector("details");
  if (fold) fold.open = true;
}
addEventListener("hashchange", openTarget);

// Shows the data that are in the document; null where it has none.
function showData() {
  offerCopies();
  openTarget();
  const text = document.getElementById("data"), data = text && JSON.parse(text.textContent);
  window.page = data && data.readings.length > 0 ? new Page(data) : null;
}
try { showData(); } catch (error) { window.page = null; console.error(error); }
