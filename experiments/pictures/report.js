// SPDX-License-Identifier: GPL-3.0-or-later
// report.js - shows the facts of a report: texts, tables, pictures, and a player of the motion.
// Everything that is shown is made by make(), from texts. Start reading at the end.
"use strict";

const KINDS = ["#e69f00", "#56b4e9", "#009e73", "#0072b2", "#d55e00", "#cc79a7", "#b8a700", "#000000"];
const NO_VALUE = "#b3b3b3";

// An element with properties and children; strings become text.
function make(name, properties, ...children) {
  const element = Object.assign(document.createElement(name), properties || {});
  for (const child of children) if (child !== null && child !== undefined) element.append(child);
  return element;
}

function bytesOf(letters) {
  const text = atob(letters || "");
  const bytes = new Uint8Array(text.length);
  for (let n = 0; n < text.length; ++n) bytes[n] = text.charCodeAt(n);
  return bytes;
}

function numbersOf(Type, letters) {
  return new Type(bytesOf(letters).buffer);
}

// Six digits, without zeros that say nothing.
function digits(value) {
  if (value === null || !Number.isFinite(value)) return "–";
  const text = value.toPrecision(6);
  return text.replace(/(\.\d*?)0*(e.*)?$/, (all, part, power) => (part === "." ? "" : part) + (power || ""));
}

// Round numbers of a range, at most about `wanted` of them.
function ticks(low, high, wanted) {
  const raw = (high - low) / Math.max(wanted, 1);
  if (!(raw > 0)) return [];
  const power = Math.pow(10, Math.floor(Math.log10(raw)));
  const step = power * [1, 2, 5, 10].find((digit) => digit * power >= raw * 0.999);
  const found = [];
  for (let k = Math.ceil(low / step - 1e-9); k <= high / step + 1e-9; ++k) found.push(k * step);
  return found.map((value) => (Math.abs(value) < step * 1e-9 ? 0 : value));
}

// A canvas with as many dots as the screen has; returns its context in points of the page.
function prepared(canvas, height) {
  const width = canvas.clientWidth, ratio = window.devicePixelRatio || 1;
  canvas.style.height = height + "px";
  canvas.width = Math.round(width * ratio);
  canvas.height = Math.round(height * ratio);
  const context = canvas.getContext("2d");
  context.setTransform(ratio, 0, 0, ratio, 0, 0);
  context.clearRect(0, 0, width, height);
  context.font = "12px 'DejaVu Sans', Verdana, sans-serif";
  return context;
}

// --- the motion ---

class Motion {
  constructor(facts) {
    this.facts = facts;
    this.frames = facts.steps.length;
    this.count = facts.bodies.reduce((sum, body) => sum + body.count, 0);
    this.places = numbersOf(Uint16Array, facts.places);
    this.links = numbersOf(Int32Array, facts.links);
    this.forces = facts.forces ? numbersOf(Float32Array, facts.forces) : null;
    this.gone = numbersOf(Float32Array, facts.gone);
    this.fields = facts.fields.map((field) => ({ ...field, shades: bytesOf(field.shades) }));
    this.largest = 0;
    for (let n = 0; this.forces && n < this.forces.length; n += 2)
      this.largest = Math.max(this.largest, Math.hypot(this.forces[n], this.forces[n + 1]));
  }

  x(frame, n) {
    const [low, high] = this.facts.box;
    return low + (high - low) * this.places[2 * (frame * this.count + n)] / 65535;
  }

  y(frame, n) {
    const low = this.facts.box[2], high = this.facts.box[3];
    return low + (high - low) * this.places[2 * (frame * this.count + n) + 1] / 65535;
  }
}

class Player {
  constructor(run, place) {
    this.run = run;
    this.motion = new Motion(run.motion);
    this.frame = 0;
    this.playing = false;
    this.zoom = 1;
    this.shift = [0, 0];
    this.field = this.motion.fields.length > 0 ? 0 : -1;
    this.build(place);
    this.draw();
  }

  build(place) {
    const player = this, motion = this.motion;
    this.canvas = make("canvas", { tabIndex: 0, title: "wheel: zoom, drag: move, double click: all" });
    this.button = make("button", { type: "button", onclick: () => this.play(!this.playing) }, "▶ play");
    this.slider = make("input", {
      type: "range", min: 0, max: motion.frames - 1, value: 0, step: 1, ariaLabel: "frame",
      oninput: () => { this.play(false); this.show(Number(this.slider.value)); } });
    this.said = make("span", { className: "said" });
    const speed = make("select", { ariaLabel: "frames in a second" });
    for (const rate of [1, 5, 10, 25, 50]) speed.append(make("option", { value: rate, selected: rate === 25 }, `${rate} frames/s`));
    speed.onchange = () => { this.rate = Number(speed.value); };
    this.rate = 25;
    const colour = make("select", { ariaLabel: "colours" });
    motion.fields.forEach((field, n) => colour.append(make("option", { value: n }, field.name)));
    colour.append(make("option", { value: -1 }, "bodies"));
    colour.onchange = () => { this.field = Number(colour.value); this.draw(); };
    this.bonds = this.box("links", motion.links.length > 0, false);
    this.arrows = this.box("forces", motion.largest > 0, motion.largest > 0);
    const step = (by) => make("button", { type: "button", onclick: () => { this.play(false); this.show(this.frame + by); } }, by < 0 ? "◀" : "▶|");
    place.append(this.canvas,
      make("div", { className: "controls" }, this.button, step(-1), step(1), this.slider, this.said),
      make("div", { className: "controls" }, speed, make("label", null, "colour by ", colour), this.bonds.label, this.arrows.label));
    this.buildCurves(place);
    this.canvas.onwheel = (event) => { event.preventDefault(); this.scale(event); };
    this.canvas.ondblclick = () => { this.zoom = 1; this.shift = [0, 0]; this.draw(); };
    this.canvas.onpointerdown = (event) => { this.held = [event.clientX, event.clientY]; this.canvas.setPointerCapture(event.pointerId); };
    this.canvas.onpointerup = () => { this.held = null; };
    this.canvas.onpointermove = (event) => {
      if (!this.held) return;
      this.shift[0] += event.clientX - this.held[0];
      this.shift[1] += event.clientY - this.held[1];
      this.held = [event.clientX, event.clientY];
      this.draw();
    };
    this.canvas.onkeydown = (event) => {
      const keys = { " ": () => player.play(!player.playing), ArrowLeft: () => player.show(player.frame - 1), ArrowRight: () => player.show(player.frame + 1) };
      if (!keys[event.key]) return;
      event.preventDefault();
      keys[event.key]();
    };
  }

  box(name, there, checked) {
    const input = make("input", { type: "checkbox", checked, onchange: () => this.draw() });
    return { input, label: there ? make("label", null, input, " " + name) : null };
  }

  // Curves of what was measured run along, with a cursor; a click shows that instant.
  buildCurves(place) {
    if (!this.run.curves || this.run.curves.length === 0) return;
    const choice = make("select", { ariaLabel: "what was measured" });
    this.run.curves.forEach((curve, n) => choice.append(make("option", { value: n }, curve.name)));
    choice.onchange = () => { this.curve = Number(choice.value); this.drawCurve(); };
    this.curve = 0;
    this.plot = make("canvas", { title: "click: shows that instant" });
    this.plot.onclick = (event) => {
      const at = this.stepAt(event.offsetX), steps = this.motion.facts.steps;
      let nearest = 0;
      steps.forEach((step, n) => { if (Math.abs(step - at) < Math.abs(steps[nearest] - at)) nearest = n; });
      this.play(false);
      this.show(nearest);
    };
    place.append(make("div", { className: "controls" }, make("label", null, "measured: ", choice)), this.plot);
  }

  scale(event) {
    const factor = Math.pow(1.0015, -event.deltaY), zoom = Math.min(Math.max(this.zoom * factor, 0.5), 200);
    const left = event.offsetX - this.middle[0] - this.shift[0], top = event.offsetY - this.middle[1] - this.shift[1];
    this.shift[0] -= left * (zoom / this.zoom - 1);
    this.shift[1] -= top * (zoom / this.zoom - 1);
    this.zoom = zoom;
    this.draw();
  }

  play(playing) {
    if (playing === this.playing) return;
    this.playing = playing;
    this.button.textContent = playing ? "❚❚ pause" : "▶ play";
    if (!playing) return;
    if (this.frame >= this.motion.frames - 1) this.frame = 0;
    let last = performance.now(), drawn = 0;
    const began = last;
    const next = (now) => {
      if (!this.playing || !this.canvas.isConnected) return;
      const due = Math.floor((now - last) * this.rate / 1000);
      if (due > 0) {
        last += due * 1000 / this.rate;
        this.show(Math.min(this.frame + due, this.motion.frames - 1));
      }
      drawn += 1;
      this.fluency = drawn * 1000 / Math.max(now - began, 1);
      if (this.frame >= this.motion.frames - 1) this.play(false);
      else requestAnimationFrame(next);
    };
    requestAnimationFrame(next);
  }

  show(frame) {
    this.frame = Math.min(Math.max(frame, 0), this.motion.frames - 1);
    this.slider.value = this.frame;
    this.draw();
  }

  // From lengths to points of the canvas: x is left + scale x, y is top - scale y.
  fit() {
    const [left, right, low, high] = this.motion.facts.box, width = this.canvas.clientWidth;
    const room = 58, bar = this.field >= 0 ? 92 : 12;
    const wanted = (width - room - bar) * (high - low) / (right - left);
    const height = Math.min(Math.max(wanted, 130), 560);
    const inner = [width - room - bar, height];
    const scale = Math.min(inner[0] / (right - left), inner[1] / (high - low)) * this.zoom;
    this.middle = [room + inner[0] / 2, 12 + height / 2];
    this.frameBox = [room, 12, inner[0], height];
    this.unit = scale;
    this.left = this.middle[0] + this.shift[0] - scale * (left + right) / 2;
    this.top = this.middle[1] + this.shift[1] + scale * (low + high) / 2;
    return height + 12 + 40;
  }

  draw() {
    const context = prepared(this.canvas, this.fit());
    const [x, y, width, height] = this.frameBox;
    context.save();
    context.beginPath();
    context.rect(x, y, width, height);
    context.clip();
    this.drawWalls(context, true);
    if (this.bonds.input.checked) this.drawLinks(context);
    this.drawParticles(context);
    this.drawWalls(context, false);
    if (this.arrows.input.checked) this.drawForces(context);
    context.restore();
    this.drawAxes(context);
    const facts = this.motion.facts, step = facts.steps[this.frame], time = facts.times[this.frame];
    this.said.textContent = `step ${step}` + (time === step ? "" : `, time ${digits(time)} ${facts.timeUnit}`);
    this.drawCurve();
  }

  colourOf(frame, n, body) {
    if (this.field < 0) return KINDS[body % KINDS.length];
    const field = this.motion.fields[this.field], shade = field.shades[frame * this.motion.count + n];
    return shade < field.map.length ? field.map[shade] : NO_VALUE;
  }

  drawParticles(context) {
    const motion = this.motion, frame = this.frame;
    let n = 0;
    motion.facts.bodies.forEach((body, b) => {
      const size = Math.max((body.spacing || 1) * this.unit, 1), half = size / 2;
      const round = body.flows && size > 3;
      for (const end = n + body.count; n < end; ++n) {
        const x = this.left + this.unit * motion.x(frame, n), y = this.top - this.unit * motion.y(frame, n);
        context.fillStyle = this.colourOf(frame, n, b);
        if (round) {
          context.beginPath();
          context.arc(x, y, 0.46 * size, 0, 7);
          context.fill();
        } else {
          context.fillRect(x - half, y - half, size + 0.4, size + 0.4);
        }
      }
    });
  }

  drawLinks(context) {
    const motion = this.motion, links = motion.links, frame = this.frame;
    context.strokeStyle = "#888";
    context.lineWidth = 1;
    context.beginPath();
    for (let k = 0; k < links.length; k += 3) {
      if (links[k + 2] <= frame) continue;
      context.moveTo(this.left + this.unit * motion.x(frame, links[k]), this.top - this.unit * motion.y(frame, links[k]));
      context.lineTo(this.left + this.unit * motion.x(frame, links[k + 1]), this.top - this.unit * motion.y(frame, links[k + 1]));
    }
    context.stroke();
  }

  drawForces(context) {
    const motion = this.motion, frame = this.frame, longest = 70 / motion.largest;
    context.strokeStyle = context.fillStyle = "#a40000";
    context.lineWidth = 1.4;
    for (let n = 0; n < motion.count; ++n) {
      const at = 2 * (frame * motion.count + n), fx = motion.forces[at] * longest, fy = -motion.forces[at + 1] * longest;
      const size = Math.hypot(fx, fy);
      if (!(size > 1.5)) continue;
      const x = this.left + this.unit * motion.x(frame, n), y = this.top - this.unit * motion.y(frame, n);
      const head = Math.min(7, size / 2), ux = fx / size, uy = fy / size;
      context.beginPath();
      context.moveTo(x, y);
      context.lineTo(x + fx - ux * head, y + fy - uy * head);
      context.stroke();
      context.beginPath();
      context.moveTo(x + fx, y + fy);
      context.lineTo(x + fx - ux * head - uy * head / 2.5, y + fy - uy * head + ux * head / 2.5);
      context.lineTo(x + fx - ux * head + uy * head / 2.5, y + fy - uy * head - ux * head / 2.5);
      context.fill();
    }
  }

  drawWalls(context, below) {
    const walls = this.motion.facts.walls || [];
    context.strokeStyle = below ? "#dddddd" : "#444";
    context.lineWidth = below ? 7 : 1.6;
    walls.forEach((wall, w) => {
      const at = 2 * (this.frame * walls.length + w), dx = this.motion.gone[at], dy = this.motion.gone[at + 1];
      context.beginPath();
      for (let k = 0; k < wall.points.length; k += 2) {
        const x = this.left + this.unit * (wall.points[k] + dx), y = this.top - this.unit * (wall.points[k + 1] + dy);
        if (wall.radius > 0) context.arc(x, y, wall.radius * this.unit, 0, 7);
        else if (k === 0) context.moveTo(x, y);
        else context.lineTo(x, y);
      }
      if (wall.closed && !(wall.radius > 0)) context.closePath();
      context.stroke();
    });
  }

  drawAxes(context) {
    const [x, y, width, height] = this.frameBox;
    context.strokeStyle = context.fillStyle = "#1a1a1a";
    context.lineWidth = 1;
    context.strokeRect(x + 0.5, y + 0.5, width, height);
    context.textAlign = "center";
    context.textBaseline = "top";
    const shown = this.unit / this.motion.facts.lengthFactor, length = this.motion.facts.lengthUnit;
    for (const value of ticks((x - this.left) / shown, (x + width - this.left) / shown, width / 80)) {
      const at = this.left + shown * value;
      context.fillRect(at, y + height, 1, 4);
      context.fillText(digits(value), at, y + height + 6);
    }
    context.textAlign = "right";
    context.textBaseline = "middle";
    for (const value of ticks((this.top - y - height) / shown, (this.top - y) / shown, height / 50)) {
      const at = this.top - shown * value;
      context.fillRect(x - 4, at, 4, 1);
      context.fillText(digits(value), x - 6, at);
    }
    context.textAlign = "center";
    context.textBaseline = "top";
    context.fillText(`x (${length})`, x + width / 2, y + height + 22);
    context.save();
    context.translate(4, y + height / 2);
    context.rotate(-Math.PI / 2);
    context.fillText(`y (${length})`, 0, 0);
    context.restore();
    this.drawBar(context);
  }

  drawBar(context) {
    if (this.field < 0) return;
    const field = this.motion.fields[this.field], [x, y, width, height] = this.frameBox, left = x + width + 12;
    for (let k = 0; k < field.map.length; ++k) {
      context.fillStyle = field.map[field.map.length - 1 - k];
      context.fillRect(left, y + k * height / field.map.length, 12, height / field.map.length + 1);
    }
    context.fillStyle = "#1a1a1a";
    context.textAlign = "left";
    context.textBaseline = "middle";
    for (const value of ticks(field.low, field.high, height / 45))
      context.fillText(digits(value), left + 16, y + height * (field.high - value) / (field.high - field.low));
    context.textBaseline = "top";
    context.textAlign = "right";
    context.fillText(field.label, left + 76, y + height + 22);
  }

  valuesOf(number) {
    const curve = this.run.curves[number];
    if (!curve.read) curve.read = numbersOf(Float32Array, curve.values);
    return curve.read;
  }

  stepAt(x) {
    const steps = this.run.sampled, [left, width] = this.across;
    return steps[0] + (x - left) / width * (steps[steps.length - 1] - steps[0]);
  }

  drawCurve() {
    if (!this.plot) return;
    const context = prepared(this.plot, 150), curve = this.run.curves[this.curve], values = this.valuesOf(this.curve);
    const steps = this.run.sampled, first = steps[0], last = Math.max(steps[steps.length - 1], first + 1);
    let low = Infinity, high = -Infinity;
    for (const value of values) if (Number.isFinite(value)) { low = Math.min(low, value); high = Math.max(high, value); }
    if (!(low <= high)) { low = 0; high = 1; }
    const room = low < high ? Math.max((high - low) * 0.06, Math.abs(high) * 1e-6) : Math.abs(high) * 0.1 || 1;
    low -= room;
    high += room;
    const left = 70, top = 22, width = this.plot.clientWidth - left - 26, height = 96;
    this.across = [left, width];
    const x = (step) => left + width * (step - first) / (last - first), y = (value) => top + height * (high - value) / (high - low);
    context.strokeStyle = context.fillStyle = "#1a1a1a";
    context.strokeRect(left + 0.5, top + 0.5, width, height);
    context.textAlign = "left";
    context.textBaseline = "top";
    context.fillText(`${curve.name} (${curve.unit})`, left, 4);
    context.textAlign = "right";
    context.textBaseline = "middle";
    const few = ticks(low, high, 3);
    for (const value of few.length > 1 ? few : ticks(low, high, 6)) context.fillText(digits(value), left - 6, y(value));
    context.textAlign = "center";
    context.textBaseline = "top";
    for (const value of ticks(first, last, width / 110)) context.fillText(digits(value), x(value), top + height + 6);
    context.strokeStyle = "#0072b2";
    context.lineWidth = 1.3;
    context.beginPath();
    let drawing = false;
    for (let n = 0; n < values.length; ++n) {
      if (!Number.isFinite(values[n])) { drawing = false; continue; }
      if (drawing) context.lineTo(x(steps[n]), y(values[n]));
      else context.moveTo(x(steps[n]), y(values[n]));
      drawing = true;
    }
    context.stroke();
    context.strokeStyle = "#d55e00";
    context.beginPath();
    const now = x(this.motion.facts.steps[this.frame]);
    context.moveTo(now, top);
    context.lineTo(now, top + height);
    context.stroke();
  }
}

// --- texts and tables ---

function paragraphs(text) {
  return make("div", null, ...String(text || "").split(/\n\s*\n/).map((part) => make("p", null, part)));
}

function tableOf(head, rows) {
  return make("div", { className: "wide" }, make("table", null,
    make("thead", null, make("tr", null, ...head.map((name) => make("th", null, name)))),
    make("tbody", null, ...rows)));
}

function cells(...texts) {
  return make("tr", null, ...texts.map((text) => text instanceof Node ? text : make("td", null, text ?? "")));
}

function verdicts(run) {
  return tableOf(["quantity", "expected", "measured", "verdict", "source"], run.verdicts.map((v) =>
    cells(v.quantity, v.expected, v.measured, make("td", { className: v.verdict === "holds" ? "holds" : "fails" }, v.verdict), v.source)));
}

function pictures(list) {
  return list.map((picture) => make("figure", null,
    make("img", { src: picture.image, alt: picture.title, loading: "lazy" }), make("figcaption", null, picture.title)));
}

function section(title, ...children) {
  return make("section", null, make("h2", null, title), ...children);
}

function provenance(run) {
  const rows = Object.entries(run.provenance).map(([name, text]) => cells(name, text.trim().replace(/\n/g, "; ")));
  rows.unshift(cells("ended", run.ended), cells("seed", run.seeds > 1 ? `${run.seed} and ${run.seeds - 1} more` : String(run.seed)));
  return tableOf(["", ""], rows);
}

// A whole run, into `place`.
function showRun(run, place) {
  place.replaceChildren();
  const motion = run.motion, left = [];
  if (motion.every > 1) left.push(`every ${motion.every}th frame`);
  if (motion.stride > 1) left.push(`every ${motion.stride}th particle`);
  const stage = make("div", null), player = section("Motion", stage);
  if (left.length > 0) player.append(make("p", { className: "quiet" }, `To keep this page small the player shows ${left.join(" and ")}; the results have all.`));
  place.append(player);
  if (run.verdicts) place.append(section(`Expected and measured${motion.lengthUnit === "length" ? "" : ", in reduced units"}`, verdicts(run)));
  if (run.certificate) place.append(section("Certificate", make("p", null, run.certificate)));
  if (run.warnings) place.append(section("Cautions", make("pre", null, run.warnings)));
  if (run.pictures.length > 0) place.append(section("Pictures", ...pictures(run.pictures)));
  place.append(section("Where it comes from", provenance(run),
    make("details", null, make("summary", null, "scenario"), make("pre", null, run.scenario)),
    make("details", null, make("summary", null, "BibTeX"), make("pre", null, run.bibtex))));
  return new Player(run, stage);
}

function heading(page, facts) {
  document.title = facts.title;
  page.append(make("h1", null, facts.title));
  if (facts.source) page.append(make("p", { className: "quiet" }, facts.source));
  if (facts.about) page.append(paragraphs(facts.about));
}

// A sweep: its table, which a click on a heading sorts, and the case that a click opens.
function showSweep(page, facts) {
  const place = make("div", null), table = facts.table, body = make("tbody", null);
  let sorted = -1, upwards = true;
  const open = (row) => {
    const run = facts.runs[row.run];
    if (!run) return;
    for (const other of table.rows) other.shown.classList.toggle("chosen", other === row);
    window.player = showRun(run, place);
    place.prepend(make("h2", null, run.name));
  };
  let alive = 0;
  for (const row of table.rows) {
    row.run = row.failure ? -1 : alive++;
    row.shown = make("tr", { className: "opens", tabIndex: 0, onclick: () => open(row), onkeydown: (event) => { if (event.key === "Enter") open(row); } });
    row.cells.forEach((value, n) => {
      const error = row.errors[n];
      row.shown.append(make("td", { className: "number" }, digits(value) + (error > 0 ? ` ± ${digits(Number(error.toPrecision(2)))}` : "")));
    });
    if (row.failure) row.shown.append(make("td", { className: "fails" }, row.failure));
  }
  const fill = () => body.replaceChildren(...table.rows.map((row) => row.shown));
  const head = table.head.map((of, n) => make("th", { className: "sorts", onclick: () => {
    upwards = sorted === n ? !upwards : true;
    sorted = n;
    table.rows.sort((a, b) => ((a.cells[n] ?? -Infinity) - (b.cells[n] ?? -Infinity)) * (upwards ? 1 : -1));
    fill();
  } }, of.unit ? `${of.name} (${of.unit})` : of.name));
  fill();
  page.append(section("Cases", make("p", { className: "quiet unprinted" }, "A click on a heading sorts, one on a row opens that case below."),
    make("div", { className: "wide" }, make("table", null, make("thead", null, make("tr", null, ...head)), body))));
  if (facts.pictures.length > 0) page.append(section("Pictures", ...pictures(facts.pictures)));
  page.append(place);
  const first = table.rows.find((row) => row.run >= 0);
  if (first) open(first);
}

const facts = JSON.parse(document.getElementById("facts").textContent);
const page = document.getElementById("page");
if (facts.table) {
  heading(page, facts);
  showSweep(page, facts);
} else {
  const place = make("div", null);
  heading(page, facts.runs[0]);
  page.append(place);
  window.player = showRun(facts.runs[0], place);
}
window.addEventListener("resize", () => window.player && window.player.draw());
