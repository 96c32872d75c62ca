"use strict";
// Curves on a canvas: axes, lines between the least and the greatest, and a strip about a line.

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

const LINE = 1.4; // px

function line(plot, xs, ys, colour, alpha) {
  const { pen, x, y } = plot;
  pen.globalAlpha = alpha; pen.strokeStyle = colour; pen.lineWidth = LINE; pen.lineJoin = "round"; pen.beginPath(); // a pointed join is a spike above a top
  xs.forEach((one, k) => { if (one !== null && ys[k] !== null) pen.lineTo(x(one), y(ys[k])); });
  pen.stroke(); pen.globalAlpha = 1;
}

// The least and the greatest sample of each part, when each came: a ramp is a ramp, and no stair.
function inOrder(one) {
  const xs = [], ys = [];
  one.low.forEach((low, k) => {
    const both = [[one.low_s[k], low], [one.high_s[k], one.high[k]]];
    if (one.high_s[k] < one.low_s[k]) both.reverse();
    for (const [x, y] of both) { xs.push(x); ys.push(y); }
  });
  return [xs, ys];
}

// Whether a strip can be seen beside the line in its middle and a recorded one close to that.
function isSeen(plot, half) { return plot.y(-half) - plot.y(half) > 5 * LINE; }

function strip(plot, xs, middle, half, colour) {
  const { pen, x, y } = plot;
  pen.globalAlpha = 0.18; pen.fillStyle = colour; pen.beginPath();
  for (let k = 1; k < middle.length; k++) {
    const ends = [xs[k - 1], xs[k], middle[k - 1], middle[k]];
    if (ends.includes(null)) continue;
    pen.moveTo(x(ends[0]), y(ends[2] - half)); pen.lineTo(x(ends[0]), y(ends[2] + half));
    pen.lineTo(x(ends[1]), y(ends[3] + half)); pen.lineTo(x(ends[1]), y(ends[3] - half)); pen.closePath();
  }
  pen.fill("nonzero"); pen.globalAlpha = 1;
}

function label(name) {
  const units = { motor_turns: "twist (turns)", displacement_mm: "displacement (mm)", load_n: "load (N)", temperature_c: "temperature (°C)", motor_current_a: "current (A)" };
  return units[name] || name;
}
