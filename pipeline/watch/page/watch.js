"use strict";
const EVERY_MS = 500, STALE_S = 3;
const at = (id) => document.getElementById(id);

function show(id, text) { at(id).textContent = text; }
function round(value, digits) { return value === null || value === undefined ? "–" : Number(value.toPrecision(digits)).toLocaleString("en"); }
function bytes(value) { return value > 1e9 ? round(value / 1e9, 3) + " GB" : round(value / 1e6, 3) + " MB"; }

function fact(name, text, id, bad) {
  const box = document.createElement("div"), label = document.createElement("span"), value = document.createElement("b");
  label.textContent = name; value.textContent = text; value.id = id;
  if (bad) value.className = "bad";
  box.append(label, value);
  return box;
}

function facts(d) {
  const stale = !d.ended && d.age_s !== null && d.age_s > STALE_S;
  const left = d.left && d.left.median !== null ? `${round(d.left.median, 3)} (${round(d.left.low, 3)} to ${round(d.left.high, 3)})` : "no forecast";
  at("facts").replaceChildren(
    fact("state", d.ended ? d.state : d.samples ? (stale ? "silent" : "recording") : d.state, "state", stale),
    fact("samples", d.samples.toLocaleString("en"), "samples"),
    fact("rate (Hz)", round(d.rate_hz, 6), "rate"),
    fact("frames lost, bad", d.lost === null ? `–, ${d.bad}` : `${d.lost}, ${d.bad}`, "lost", d.lost > 0 || d.bad > 0),
    fact("last sample", d.age_s === null ? "–" : `${d.age_s < 10 ? d.age_s.toFixed(1) : Math.round(d.age_s)} s ago`, "age", stale),
    fact("disk left", bytes(d.free_bytes), "disk", d.free_bytes < 1e9),
    fact("strokes", d.strokes === null ? "–" : d.planned ? `${d.strokes} of ${d.planned}` : `${d.strokes}`, "strokes"),
    fact("strokes left, forecast", left, "left"),
    fact("clock jumps", `${d.jumps}`, "jumps", d.jumps > 0),
    ...(d.behind_bytes ? [fact("still to read", bytes(d.behind_bytes), "behind")] : []),
    ...(d.replaced ? [fact("recording replaced", `${d.replaced} times`, "replaced")] : []));
}

function ticks(low, high) {
  const raw = (high - low) / 5 || 1, ten = 10 ** Math.floor(Math.log10(raw));
  const step = [1, 2, 5, 10].map((one) => one * ten).find((one) => one >= raw);
  const found = [];
  for (let one = Math.ceil(low / step) * step; one <= high + step * 1e-6; one += step) found.push(one);
  return { found, digits: Math.max(0, -Math.floor(Math.log10(step))) };
}

function range(lists) {
  let low = Infinity, high = -Infinity;
  for (const list of lists) for (const one of list) if (one !== null) { low = Math.min(low, one); high = Math.max(high, one); }
  if (low > high) return [0, 1];
  const room = (high - low) * 0.04 || Math.abs(low) * 0.01 || 1;
  return [low - room, high + room];
}

function axes(canvas, xs, ys, xLabel, yLabel) {
  const ratio = window.devicePixelRatio || 1, width = canvas.clientWidth, height = canvas.clientHeight;
  canvas.width = width * ratio; canvas.height = height * ratio;
  const pen = canvas.getContext("2d");
  pen.scale(ratio, ratio);
  const [x0, x1] = range(xs), [y0, y1] = range(ys), left = 64, right = width - 8, top = 8, bottom = height - 36;
  const x = (value) => left + (value - x0) / (x1 - x0) * (right - left), y = (value) => bottom - (value - y0) / (y1 - y0) * (bottom - top);
  pen.font = "12px system-ui, sans-serif"; pen.fillStyle = "#444"; pen.strokeStyle = "#e4e4ea"; pen.textAlign = "center";
  const across = ticks(x0, x1), up = ticks(y0, y1);
  for (const one of across.found) { pen.beginPath(); pen.moveTo(x(one), top); pen.lineTo(x(one), bottom); pen.stroke(); pen.fillText(one.toFixed(across.digits), x(one), bottom + 14); }
  pen.textAlign = "right";
  for (const one of up.found) { pen.beginPath(); pen.moveTo(left, y(one)); pen.lineTo(right, y(one)); pen.stroke(); pen.fillText(one.toFixed(up.digits), left - 6, y(one) + 4); }
  pen.textAlign = "center"; pen.fillText(xLabel, (left + right) / 2, height - 6);
  pen.save(); pen.translate(12, (top + bottom) / 2); pen.rotate(-Math.PI / 2); pen.fillText(yLabel, 0, 0); pen.restore();
  return { pen, x, y };
}

function band(plot, xs, low, high, colour, alpha) {
  const { pen, x, y } = plot;
  pen.globalAlpha = alpha; pen.strokeStyle = colour; pen.lineWidth = 1.4; pen.beginPath();
  xs.forEach((one, k) => { if (one === null || low[k] === null) return; pen.lineTo(x(one), y(low[k])); pen.lineTo(x(one), y(high[k])); });
  pen.stroke(); pen.globalAlpha = 1;
}

function label(name) {
  const units = { motor_turns: "twist (turns)", displacement_mm: "displacement (mm)", load_n: "load (N)", temperature_c: "temperature (°C)", motor_current_a: "current (A)" };
  return units[name] || name;
}

function draw(d) {
  const loops = d.loops;
  const plot = axes(at("loop"), loops.map((one) => one.motor_turns), loops.flatMap((one) => [one.low_mm, one.high_mm, one.simulated_mm]), "twist (turns)", "displacement (mm)");
  loops.forEach((one, k) => {
    band(plot, one.motor_turns, one.low_mm, one.high_mm, "#2166ac", 0.25 + 0.75 * (k + 1) / loops.length);
    band(plot, one.motor_turns.slice(0, one.simulated_mm.length), one.simulated_mm, one.simulated_mm, "#d6604d", 0.8);
  });
  const box = at("channels");
  while (box.children.length > d.channels.length) box.lastChild.remove();
  while (box.children.length < d.channels.length) box.append(document.createElement("canvas"));
  d.channels.forEach((one, k) => {
    const shown = axes(box.children[k], [d.time_s], [one.low, one.high], k === d.channels.length - 1 ? "time (s)" : "", label(one.name));
    band(shown, d.time_s, one.low, one.high, "#2166ac", 1);
  });
}

let listed = "";
function verdicts(d) {
  show("verdict", d.verdict || "This run has no diagnosis yet.");
  const text = JSON.stringify([d.verdicts, d.index]);
  if (text === listed) return;
  listed = text;
  const link = (name, path) => { const a = document.createElement("a"); a.textContent = name; a.href = "/reports/" + path.split("/").map(encodeURIComponent).join("/"); return a; };
  at("index").replaceChildren(...(d.index ? [link("All reports", "index.html")] : []));
  at("verdicts").replaceChildren(...d.verdicts.map((one) => {
    const row = document.createElement("tr"), run = document.createElement("td"), said = document.createElement("td");
    run.append(link(one.run, one.page)); said.textContent = one.verdict; row.append(run, said);
    return row;
  }));
}

async function look() {
  try {
    const answer = await fetch("/data.json", { cache: "no-store", signal: AbortSignal.timeout(5000) });
    if (!answer.ok) throw new Error(answer.status === 403 ? "not allowed; open the address that was printed" : `answer ${answer.status}`);
    const d = await answer.json();
    if (d.run !== undefined) {
      document.title = d.run; show("run", d.run);
      show("about", [d.material, d.string && `string ${d.string}`, d.device].filter(Boolean).join(" · "));
      facts(d); draw(d); verdicts(d);
      const link = at("link"); link.className = ""; link.textContent = "live";
    }
  } catch (error) {
    const link = at("link"); link.className = "bad"; link.textContent = `no answer, trying again (${error.message})`;
  }
  setTimeout(look, EVERY_MS);
}
look();
