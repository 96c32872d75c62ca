"use strict";
// The loop that settles a tie: its step and state, what moves, and what each explanation foretells beside what came.

let asked = null;
const IN_TERMINAL = "waits for yes in the terminal where settle runs"; // of --approve ask: another way asks here, or nobody
const STATES = { proposed: "proposed", approved: "is made now", recorded: "is being diagnosed", diagnosed: "diagnosed" };
function loop(d) {
  const l = d.loop;
  at("loop-part").hidden = !l;
  if (!l) return;
  if (l.question !== asked) { asked = l.question; at("clear").checked = false; show("said", ""); }
  show("step", `Step ${l.step}: ${l.title || "the runs that were there"}${l.size && ` (${l.size})`}`);
  moves(l.moves);
  const what = l.stopping ? "stopping" : l.question ? "waits for approval" : l.at_work && l.state === "proposed" ? IN_TERMINAL : STATES[l.state];
  show("loop-state", l.at_work ? what : l.settled ? "settled" : `${what}; no loop is at work`);
  for (const id of ["clear-label", "approve"]) at(id).hidden = !l.question;
  at("approve").disabled = !token || !at("clear").checked;
  show("stop", l.state === "approved" ? "Stop the motor, then the loop" : "Stop the loop");
  at("still").hidden = !l.at_work || l.state === "approved"; at("stop").hidden = !l.at_work; at("stop").disabled = !token || l.stopping;
  at("no-token").hidden = Boolean(token) || !l.at_work;
  const c = l.came;
  at("came-file").replaceChildren(...(c ? [`What came in step ${c.step}, drawn over what each explanation foretold: `, c.page ? linkTo("came.png", c.page) : c.file] : []));
  foretold(l.foretold, d);
}

function moves(m) {
  at("moves").hidden = !m;
  if (!m) return;
  show("begins", m.begins); show("apart-then", m.apart);
  at("legs").replaceChildren(...[m.head, ...m.legs].map((cells, k) => {
    const row = document.createElement("tr");
    row.append(...cells.map((text) => Object.assign(document.createElement(k ? "td" : "th"), { textContent: text })));
    return row;
  }));
}

// As came.png of the step: what came with the reading before the motion as its zero, and the differences large.
function foretold(f, d) {
  at("foretold-part").hidden = !f;
  if (!f) return;
  const rivals = Object.entries(f.rivals), colour = (k) => f.alone ? SIMULATOR : COLOURS[k % COLOURS.length];
  at("rivals").replaceChildren(...rivals.map(([name], k) => {
    const one = document.createElement("span");
    one.textContent = name; one.style.color = colour(k);
    return one;
  }));
  const channel = f.came && d.channels.find((one) => one.name === "displacement_mm"), differ = rivals.length > 1 || f.came;
  at("came").hidden = !channel;
  const [times, values] = channel ? inOrder(channel) : [[], []], measured = values.map((one) => one === null ? null : one - f.came.zero_mm[0]);
  const whole = axes(at("foretold"), [f.time_s, times], [...rivals.map((one) => one[1]), measured], differ ? "" : "time (s)", "displacement (mm)");
  rivals.forEach(([, curve], k) => line(whole, f.time_s, curve, colour(k), 1));
  line(whole, times, measured, BLACK, 1);
  for (const id of ["apart", "apart-key"]) at(id).hidden = !differ;
  if (!differ) return;
  const apart = rivals.map(([, curve]) => curve.map((one, k) => one - f.calibrated[k])), came = f.came || { time_s: [], difference_mm: [] };
  const large = axes(at("apart"), [f.time_s, came.time_s], [...apart, came.difference_mm], "time (s)", "difference (mm)");
  apart.forEach((curve, k) => line(large, f.time_s, curve, colour(k), 1));
  line(large, came.time_s, came.difference_mm, BLACK, 1);
}
