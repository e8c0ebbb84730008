"use strict";
// Figures as inline SVG: axes, points with error bars, curves; brushing, CSV and SVG of what is shown.

const SVG = "http://www.w3.org/2000/svg";
const WIDTH = 460, WIDE = 940, HEIGHT = 320, LEFT = 66, RIGHT = 12, TOP = 12, BOTTOM = 48, GAP = 12;
// Most entries in a key: more are not read. Beyond, colours run along a scale (`scaled`).
const MOST_ENTRIES = 8;
// Most names along an axis that the key of a narrow figure lists, beside its series.
const MOST_NAMES = 6;
// Width of a letter along an axis, of usual names in common fonts.
const LETTER = 6.6;
const AXIS_TEXT = {fill: "var(--ink)", "font-size": "12.5", "font-family": "system-ui, sans-serif"};
// Okabe and Ito's colours, which stay apart for colour-blind readers, with a shape for each.
// The style sheet has them for light and for dark pages.
const COLOURS = Array.from({length: 8}, (_, k) => `var(--mark${k})`);
const SHAPES = ["circle", "square", "triangle", "diamond", "down", "plus", "cross", "ring"];

function node(name, attributes, parent, text) {
  const element = document.createElementNS(SVG, name);
  for (const [key, value] of Object.entries(attributes || {})) element.setAttribute(key, value);
  if (text !== undefined) element.textContent = text;
  if (parent) parent.append(element);
  return element;
}

function html(name, attributes, parent, text) {
  const element = document.createElement(name);
  for (const [key, value] of Object.entries(attributes || {})) element.setAttribute(key, value);
  if (text !== undefined) element.textContent = text;
  if (parent) parent.append(element);
  return element;
}

function shapePath(shape, x, y, r) {
  const p = (...points) => "M" + points.map(([a, b]) => (x + a * r).toFixed(1) + " " + (y + b * r).toFixed(1)).join("L");
  switch (shape) {
    case "square": return p([-.9, -.9], [.9, -.9], [.9, .9], [-.9, .9]) + "Z";
    case "triangle": return p([0, -1.2], [1.1, .8], [-1.1, .8]) + "Z";
    case "down": return p([0, 1.2], [1.1, -.8], [-1.1, -.8]) + "Z";
    case "diamond": return p([0, -1.3], [1.1, 0], [0, 1.3], [-1.1, 0]) + "Z";
    case "plus": return p([-1.2, 0], [1.2, 0]) + p([0, -1.2], [0, 1.2]);
    case "cross": return p([-1, -1], [1, 1]) + p([-1, 1], [1, -1]);
    default: return `M${(x - r).toFixed(1)} ${y.toFixed(1)}a${r} ${r} 0 1 0 ${2 * r} 0a${r} ${r} 0 1 0 ${-2 * r} 0Z`;
  }
}

// Round numbers between two values: about `count` ticks, or the powers of ten with 2 and 5.
function ticksOf(low, high, log, count) {
  if (log) {
    const ticks = [];
    for (let power = Math.floor(Math.log10(low)); power <= Math.ceil(Math.log10(high)); ++power) {
      for (const factor of [1, 2, 5]) {
        const tick = factor * Math.pow(10, power);
        if (tick >= low * .999 && tick <= high * 1.001) ticks.push(tick);
      }
    }
    return ticks.length > 7 ? ticks.filter(t => Math.abs(Math.log10(t) - Math.round(Math.log10(t))) < 1e-9) : ticks;
  }
  const raw = (high - low) / count, unit = Math.pow(10, Math.floor(Math.log10(raw))), steps = [1, 2, 5, 10];
  const ticksAt = step => {
    const ticks = [];
    for (let k = Math.ceil(low / step - 1e-9); k * step <= high + 1e-9 * step; ++k) ticks.push(k * step);
    return ticks;
  };
  // A smaller step where fewer than three ticks lie in the range: two say little about an axis, one nothing.
  const first = steps.findIndex(f => f * unit >= raw), ticks = ticksAt(unit * steps[first]);
  return ticks.length >= 3 ? ticks : ticksAt(unit * (first > 0 ? steps[first - 1] : .5));
}

// A number with the sign of print.
const withMinus = text => text.replace(/^(\(?)-/, "$1−");

function tickText(value, step) {
  if (value === 0) return "0";
  if (value < 0) return "−" + tickText(-value, step);
  const size = value;
  if (size >= 1e5 || size < 1e-3) {
    const digits = step ? Math.max(0, Math.floor(Math.log10(size) + 1e-9) - Math.floor(Math.log10(step) + 1e-9)) : 0;
    return value.toExponential(Math.min(digits, 4)).replace("e+", "e");
  }
  const digits = step ? Math.max(0, Math.min(6, -Math.floor(Math.log10(step) + 1e-9))) : 0;
  return step ? value.toFixed(digits) : String(Number(value.toPrecision(2)));
}

// Smooth curve through points in the coordinates of the screen (monotone in each part).
function curvePath(points) {
  if (points.length < 3) return "M" + points.map(p => p.join(" ")).join("L");
  const n = points.length, slopes = [], tangents = [];
  for (let k = 0; k + 1 < n; ++k) slopes.push((points[k + 1][1] - points[k][1]) / (points[k + 1][0] - points[k][0]));
  tangents.push(slopes[0]);
  for (let k = 1; k + 1 < n; ++k) tangents.push(slopes[k - 1] * slopes[k] <= 0 ? 0 : 2 / (1 / slopes[k - 1] + 1 / slopes[k]));
  tangents.push(slopes[n - 2]);
  let path = `M${points[0][0].toFixed(1)} ${points[0][1].toFixed(2)}`;
  for (let k = 0; k + 1 < n; ++k) {
    const third = (points[k + 1][0] - points[k][0]) / 3;
    path += `C${(points[k][0] + third).toFixed(1)} ${(points[k][1] + third * tangents[k]).toFixed(2)} ` +
      `${(points[k + 1][0] - third).toFixed(1)} ${(points[k + 1][1] - third * tangents[k + 1]).toFixed(2)} ` +
      `${points[k + 1][0].toFixed(1)} ${points[k + 1][1].toFixed(2)}`;
  }
  return path;
}

function save(name, type, text) {
  const link = html("a", {download: name, href: URL.createObjectURL(new Blob([text], {type}))});
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 1000);
}

// Colour of a share from 0 to 1 along the scale that stands for many values of a quantity.
const scaleColour = share => `color-mix(in oklab, var(--scale1) ${Math.round(100 * share)}%, var(--scale0))`;

// Series of which there are too many for a key: those of one `group` have a shape in common, and the colour runs
// with their `value`. Returns the series and the entries of the key.
function scaled(series, quantity) {
  const groups = [...new Set(series.map(s => s.group))], values = series.map(s => s.value);
  const low = Math.min(...values), high = Math.max(...values), log = low > 0 && high > 3 * low;
  const share = v => high > low ? (log ? Math.log(v / low) / Math.log(high / low) : (v - low) / (high - low)) : 0;
  const shapeOf = group => SHAPES[groups.indexOf(group) % SHAPES.length];
  const named = groups.slice(0, groups.length < MOST_ENTRIES ? groups.length : MOST_ENTRIES - 2);
  return {
    series: series.map(s => ({...s, colour: scaleColour(share(s.value)), shape: shapeOf(s.group), keyless: true})),
    entries: [{scale: true, label: `${quantity} ${three(low)} to ${three(high)}`}, ...named.filter(g => g).map(group => ({shape: shapeOf(group), label: group})),
      ...(named.length < groups.length ? [{label: `and ${groups.length - named.length} more, named where a reading is pointed at`}] : [])]
  };
}

// A figure. `spec`: {name, title, xLabel, yLabel, logX, zero, lines, names(), times(), parts, wide, quantity, reach()};
// with names, these stand at x = 0, 1, ... in place of numbers (numbers from 1 and a list in the key where they have no
// room), and below them times or other second lines; with parts, axes of these labels
// stand one above the other.
// `reach()`: [[low, high], ...] of each part over all models between which a reader switches, which the axes hold so
// that they stay. `quantity`: what the `value` of the series is.
// `contents()` returns the series that are shown now: {label, points: [{x, y, error, id}],
// curve: [[x, y], ...], marks: [{x, y}]}, and if it wants: part (0: the upper one), kind (in the CSV), colour, shape, dash,
// width, straight (lines between the points of the curve), keyless, group, value, texts: [{x, y, text}].
class Plot {
  constructor(parent, spec, contents, page) {
    Object.assign(this, {spec, contents, page, at: -1});
    this.figure = html("figure", {}, parent);
    const caption = html("figcaption", {}, this.figure);
    html("span", {}, caption, spec.title);
    const buttons = html("span", {}, caption);
    html("button", {type: "button", "aria-label": "Save the numbers of " + spec.title + " as CSV"}, buttons, "CSV")
      .addEventListener("click", () => save(spec.name + ".csv", "text/csv", this.csv()));
    buttons.append(" ");
    html("button", {type: "button", "aria-label": "Save " + spec.title + " as SVG"}, buttons, "SVG")
      .addEventListener("click", () => save(spec.name + ".svg", "image/svg+xml", this.svgText()));
    this.svg = node("svg", {tabindex: "0", role: "img",
      "aria-label": spec.title + ". Arrow keys step through the readings.", "data-name": spec.name}, this.figure);
    this.key = html("ul", {class: "key"}, this.figure);
    this.svg.addEventListener("keydown", event => this.onKey(event));
    this.svg.addEventListener("pointerdown", event => this.onDown(event));
    this.svg.addEventListener("pointermove", event => this.onMove(event));
    this.svg.addEventListener("pointerup", () => this.onUp());
    this.svg.addEventListener("pointercancel", () => this.endBrush());
    this.svg.addEventListener("pointerleave", () => { if (!this.dragged) this.page.show(-1); });
    this.draw();
  }

  range(values, log, pad) {
    let low = Math.min(...values), high = Math.max(...values);
    if (!(low < high)) { const d = Math.abs(low) * .05 || 1; low -= d; high += d; if (log) low = Math.max(low, high / 2); }
    if (log) { const f = Math.pow(high / low, pad); return [low / f, high * f]; }
    const d = (high - low) * pad;
    return [low - d, high + d];
  }

  // Whether names along the axis do not touch: the room of each is that of the axis over the number of names.
  roomFor(names) {
    const times = this.spec.times ? this.spec.times() : [], longest = Math.max(...[...names, ...times].map(name => name.length));
    return longest * LETTER < (this.width - LEFT - RIGHT) / (names.length + .2);
  }
  // Width of the drawing: a wide figure is drawn anew where the page is narrow, so that its letters stay legible.
  get width() { return this.spec.wide && this.page.roomy() ? WIDE : WIDTH; }

  draw() {
    const {spec, width} = this, all = this.contents();
    const many = spec.quantity && all.length > MOST_ENTRIES ? scaled(all, spec.quantity) : {series: all, entries: []}, {series} = many;
    this.shown = series;
    this.svg.setAttribute("viewBox", `0 0 ${width} ${HEIGHT}`);
    const labels = spec.parts || [spec.yLabel], xs = [], ysOf = labels.map(() => spec.zero ? [-2.5, 2.5] : spec.lines ? [0] : []);
    for (const s of series) {
      const ys = ysOf[s.part || 0];
      for (const p of s.points) { xs.push(p.x); ys.push(p.y - (p.error || 0), p.y + (p.error || 0)); }
      for (const c of [...(s.curve || []), ...(s.marks || []).map(m => [m.x, m.y])]) { xs.push(c[0]); ys.push(c[1]); }
    }
    this.svg.replaceChildren();
    if (xs.length === 0) return;
    if (spec.reach && this.page.keepAxes) (this.reached = this.reached || spec.reach()).forEach((ends, part) => ysOf[part].push(...ends));
    const names = spec.names ? spec.names() : null;
    const [x0, x1] = names ? [-.5, names.length - .3] : this.range(xs, spec.logX, .06);
    const xOf = x => LEFT + (width - LEFT - RIGHT) * (spec.logX ? Math.log(x / x0) / Math.log(x1 / x0) : (x - x0) / (x1 - x0));
    const height = (HEIGHT - TOP - BOTTOM - GAP * (labels.length - 1)) / labels.length;
    const yOfPart = labels.map((label, part) => {
      const top = TOP + part * (height + GAP), bottom = top + height, [y0, y1] = this.range(ysOf[part], false, .06);
      const yOf = y => bottom - height * (y - y0) / (y1 - y0);
      this.axes(x0, x1, y0, y1, xOf, yOf, names, {label, top, bottom, last: part + 1 === labels.length});
      return yOf;
    });
    this.key.replaceChildren();
    this.places = [];
    for (const entry of many.entries) this.keyEntry(entry);
    series.forEach((s, index) => this.drawSeries(s, index, xOf, yOfPart[s.part || 0]));
    const times = spec.times ? spec.times() : [];
    if (names && !this.roomFor(names) && names.length <= (width === WIDTH ? MOST_NAMES : 2 * MOST_NAMES)) names.forEach((name, x) => html("li", {}, this.key, `${x + 1}: ${name}` + (times[x] ? `, ${times[x]}` : "")));
    if (names && this.roomFor(names)) times.forEach((time, x) => node("text", {...AXIS_TEXT, fill: "var(--soft)", x: xOf(x), y: HEIGHT - BOTTOM + 31, "text-anchor": "middle"}, this.svg, time));
    this.mark();
  }

  axes(x0, x1, y0, y1, xOf, yOf, names, {label, top, bottom, last}) {
    const {spec, svg} = this;
    const text = AXIS_TEXT;
    const every = names && !this.roomFor(names) ? Math.ceil(names.length / 12) : 1;  // numbers of more names would touch
    const xTicks = names ? names.map((_, k) => k).filter(k => k % every === 0) : ticksOf(x0, x1, spec.logX, 5), yTicks = ticksOf(y0, y1, false, bottom - top > 200 ? 5 : 4);
    const xStep = spec.logX ? 0 : xTicks[1] - xTicks[0], yStep = yTicks[1] - yTicks[0];
    for (const x of xTicks) {
      node("line", {x1: xOf(x), x2: xOf(x), y1: top, y2: bottom, stroke: "var(--grid)"}, svg);
      if (last) node("text", {...text, x: xOf(x), y: bottom + 16, "text-anchor": "middle"}, svg, names ? this.roomFor(names) ? names[x] : String(x + 1) : tickText(x, xStep));
    }
    for (const y of yTicks) {
      node("line", {x1: LEFT, x2: this.width - RIGHT, y1: yOf(y), y2: yOf(y), stroke: "var(--grid)"}, svg);
      node("text", {...text, x: LEFT - 6, y: yOf(y) + 4, "text-anchor": "end"}, svg, tickText(y, yStep));
    }
    if (spec.zero || spec.lines) node("line", {x1: LEFT, x2: this.width - RIGHT, y1: yOf(0), y2: yOf(0), stroke: "var(--soft)", "stroke-width": 1.5}, svg);
    node("rect", {x: LEFT, y: top, width: this.width - LEFT - RIGHT, height: bottom - top, fill: "none", stroke: "var(--soft)"}, svg);
    if (last) node("text", {...text, x: (LEFT + this.width - RIGHT) / 2, y: HEIGHT - 8, "text-anchor": "middle"}, svg, spec.xLabel);
    const middle = (top + bottom) / 2;
    node("text", {...text, x: 14, y: middle, "text-anchor": "middle", transform: `rotate(-90 14 ${middle})`}, svg, label);
  }

  drawSeries(s, index, xOf, yOf) {
    const colour = s.colour || COLOURS[index % COLOURS.length], shape = s.shape || (s.colour ? "square" : SHAPES[(index + 3 * Math.floor(index / 8)) % SHAPES.length]);
    if (s.curve && s.curve.length > 1) {
      const line = s.curve.map(([x, y]) => [xOf(x), yOf(y)]);
      node("path", {d: this.spec.names || s.straight ? "M" + line.map(p => p.map(v => v.toFixed(1)).join(" ")).join("L") : curvePath(line), fill: "none", stroke: colour, "stroke-width": s.width || 2,
        class: "curve", ...(s.dash ? {"stroke-dasharray": "5 3"} : {})}, this.svg);
    }
    for (const m of s.marks || []) {
      const x = xOf(m.x), y = yOf(m.y), half = m.half || 5;
      // A stem to zero joins the two ends of a range around it.
      if (m.stem) node("path", {d: `M${x.toFixed(1)} ${y.toFixed(2)}V${yOf(0).toFixed(2)}`, stroke: colour, "stroke-width": 1}, this.svg);
      node("path", {d: `M${(x - half).toFixed(1)} ${y.toFixed(2)}h${2 * half}`, stroke: colour, "stroke-width": 2, class: "mark"}, this.svg);
    }
    const hollow = ["plus", "cross", "ring"].includes(shape), radius = s.radius || 4.2;
    for (const p of s.points) {
      const x = xOf(p.x), y = yOf(p.y);
      const bar = p.error ? node("path", {d: `M${x.toFixed(1)} ${yOf(p.y - p.error).toFixed(1)}V${yOf(p.y + p.error).toFixed(1)}`, stroke: colour, "stroke-width": 1.2}, this.svg) : null;
      const point = node("path", {d: shapePath(shape, x, y, radius), fill: hollow ? "none" : colour, stroke: colour, "stroke-width": hollow ? 1.8 : 1, "data-id": p.id}, this.svg);
      this.places.push({x, y, id: p.id, point, bar});
    }
    for (const t of s.texts || []) node("text", {x: xOf(t.x), y: this.spec.lines ? Math.min(yOf(t.y) + 4, yOf(0) - 5) : yOf(t.y) + 4, "text-anchor": "start", fill: "var(--ink)", "font-size": "12.5", "font-weight": 650, "font-family": "system-ui, sans-serif",
      stroke: "var(--ground)", "stroke-width": 4, "paint-order": "stroke"}, this.svg, t.text);
    if (s.label && !s.keyless) this.keyEntry({label: s.label, straight: s.straight, width: s.width, dash: s.dash, shape, colour});
  }

  // Line of the key: a symbol or a piece of line, or the colours of a scale, and words.
  keyEntry({label, straight, width, dash, shape, colour = "var(--ink)", scale}) {
    const entry = html("li", {}, this.key);
    if (scale || straight || shape) {
      const long = scale ? 64 : 16;
      const icon = node("svg", {viewBox: `0 0 ${long} 12`, width: long, height: 12, style: `display:inline;width:${long}px;height:12px;vertical-align:-1px`, "aria-hidden": "true"}, entry);
      if (scale) for (let k = 0; k < 8; ++k) node("path", {d: `M${8 * k} 2h8v8h-8Z`, fill: scaleColour(k / 7)}, icon);
      else node("path", {d: straight ? "M1 6h14" : shapePath(shape, 8, 6, 4), fill: ["plus", "cross", "ring"].includes(shape) ? "none" : colour, stroke: colour,
        ...(straight ? {"stroke-width": width} : {}), ...(dash ? {"stroke-dasharray": "5 3"} : {})}, icon);
    }
    entry.append(" " + label);
  }

  // Shows which readings are marked, under the pointer, or left out.
  mark() {
    for (const {point, bar, id} of this.places || []) {
      const marked = this.page.marked.has(id), here = this.page.here === id, out = this.page.out === id;
      const opacity = out || this.page.marked.size > 0 && !marked && !here ? .25 : 1;
      for (const part of bar ? [point, bar] : [point]) part.setAttribute("opacity", opacity);
      if (here || marked) {
        point.setAttribute("stroke", "var(--ink)");
        point.setAttribute("stroke-width", 2.2);
      } else {
        const fill = point.getAttribute("fill");
        if (fill !== "none") { point.setAttribute("stroke", fill); point.setAttribute("stroke-width", 1); }
      }
    }
  }

  position(event) {
    const box = this.svg.getBoundingClientRect();
    return [(event.clientX - box.left) * this.width / box.width, (event.clientY - box.top) * HEIGHT / box.height];
  }
  nearest(x, y) {
    let best = {id: -1}, distance = 14;
    for (const place of this.places || []) {
      const d = Math.hypot(place.x - x, place.y - y);
      if (d < distance) { best = place; distance = d; }
    }
    return best.id;
  }
  onKey(event) {
    const step = {ArrowRight: 1, ArrowDown: 1, ArrowLeft: -1, ArrowUp: -1}[event.key];
    const places = [...this.places].sort((a, b) => a.x - b.x);
    if (step && places.length > 0) {
      this.at = (this.at + step + places.length) % places.length;
      this.page.show(places[this.at].id);
      event.preventDefault();
    } else if (event.key === "Escape") { this.page.markOnly([]); this.page.show(-1); }
  }
  onDown(event) {
    this.dragged = {from: this.position(event), to: null};
    this.svg.setPointerCapture(event.pointerId);
  }
  endBrush() {
    this.dragged = null;
    if (this.brush) this.brush.remove();
    this.brush = null;
  }
  onMove(event) {
    const [x, y] = this.position(event);
    if (!this.dragged) { this.page.show(this.nearest(x, y)); return; }
    this.dragged.to = [x, y];
    const [a, b] = this.dragged.from;
    if (!this.brush) this.brush = node("rect", {fill: "var(--accent)", opacity: .18}, this.svg);
    for (const [key, value] of Object.entries({x: Math.min(a, x), y: Math.min(b, y), width: Math.abs(x - a), height: Math.abs(y - b)})) this.brush.setAttribute(key, value);
  }
  onUp() {
    if (!this.dragged) return;
    const {from, to} = this.dragged;
    this.endBrush();
    if (!to || Math.hypot(to[0] - from[0], to[1] - from[1]) < 5) {
      const id = this.nearest(...from);
      this.page.markOnly(id < 0 ? [] : [id]);
      return;
    }
    const inside = (v, a, b) => v >= Math.min(a, b) && v <= Math.max(a, b);
    this.page.markOnly(this.places.filter(p => inside(p.x, from[0], to[0]) && inside(p.y, from[1], to[1])).map(p => p.id));
  }

  csv() {
    // An apostrophe in front of what a spreadsheet would take for a formula.
    const safe = text => /^[=+\-@\t\r]/.test(text) && isNaN(text) ? "'" + text : text;
    const quoted = any => (text => /[",\n]/.test(text) ? '"' + text.replaceAll('"', '""') + '"' : text)(safe(any));
    const names = this.spec.names ? this.spec.names() : null, at = x => names ? quoted(names[Math.round(x)]) : x;
    const rows = [["series", "kind", this.spec.xLabel, this.spec.yLabel || "value", "standard error"].map(quoted)];
    for (const s of this.shown) {
      for (const p of s.points) rows.push([quoted(s.label), s.kind || "measured", at(p.x), p.y, p.error || ""]);
      for (const m of s.marks || []) if (!m.mirrored) rows.push([quoted(s.label), s.points.length > 0 ? "model at the reading" : s.kind, at(m.x), m.y, ""]);
      if (!names) for (const [x, y] of s.curve || []) rows.push([quoted(s.label), s.kind || "model curve", x, y, ""]);
    }
    return rows.map(row => row.join(",")).join("\n") + "\n";
  }
  // The drawing as a file of its own, with the colours that are shown now.
  svgText() {
    const copy = this.svg.cloneNode(true), style = getComputedStyle(document.documentElement);
    copy.setAttribute("xmlns", SVG);
    copy.setAttribute("style", "background:" + style.getPropertyValue("--ground").trim());
    // The key, below the axes.
    const entries = [...this.key.children], ROW = 18;
    copy.setAttribute("viewBox", `0 0 ${this.width} ${HEIGHT + ROW * entries.length + 6}`);
    entries.forEach((entry, k) => {
      const line = node("g", {transform: `translate(${LEFT} ${HEIGHT + ROW * k})`}, copy), icons = [...entry.querySelectorAll("svg path")];
      line.append(...icons.map(icon => icon.cloneNode(true)));
      node("text", {x: icons.length > 1 ? 70 : 22, y: 10, fill: "var(--ink)", "font-size": "12.5", "font-family": "system-ui, sans-serif"}, line, entry.textContent.trim());
    });
    return copy.outerHTML.replace(/var\((--[a-z0-9]+)\)/g, (_, name) => style.getPropertyValue(name).trim());
  }
}
