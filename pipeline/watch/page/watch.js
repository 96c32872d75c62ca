"use strict";
const EVERY_MS = 500, STALE_S = 3, BAND = 2 /* sigma */, OTHER_PACE = 0.1, FADES = 0.35 /* to, from stroke to stroke */;
const COLOURS = ["#2166ac", "#4d9221", "#762a83", "#b8860b", "#008b8b", "#8c510a"], SIMULATOR = "#d6604d"; // as came.png has them
const ZONED = { year: "numeric", month: "2-digit", day: "2-digit", hour: "2-digit", minute: "2-digit", second: "2-digit", timeZoneName: "short" };
const KEY = "watch-token", BLACK = "#111";
const at = (id) => document.getElementById(id);

function show(id, text) { at(id).textContent = text; }
function round(value, digits) { return value === null || value === undefined ? "–" : Number(value.toPrecision(digits)).toLocaleString("en"); }
function moment(utc) { return new Date(utc).toLocaleString("sv", ZONED); }
function bytes(value) { return value > 1e9 ? round(value / 1e9, 3) + " GB" : round(value / 1e6, 3) + " MB"; }

function fact(name, text, id, bad) {
  const box = document.createElement("div"), label = document.createElement("span"), value = document.createElement("b");
  label.textContent = name; value.textContent = text; value.id = id;
  if (bad) value.className = "bad";
  box.append(label, value);
  return box;
}

// as capture says it: a synthetic rig at another pace than life sends more than its own rate
function rate(d) {
  if (!d.come_hz || Math.abs(d.come_hz / d.rate_hz - 1) < OTHER_PACE) return round(d.rate_hz, 6);
  return round(d.come_hz, 3) + (d.rate_hz ? ` (${round(d.come_hz / d.rate_hz, 2)} times the ${round(d.rate_hz, 6)} of the rig's own clock)` : "");
}

function facts(d) {
  const stale = !d.ended && d.age_s !== null && d.age_s > STALE_S;
  const left = d.left && d.left.words ? d.left.words : "no forecast", until = d.left && d.left.words && d.left.until;
  // a program's strokes, not those of the rig's own motion; of an earlier step's run nothing tells any more
  const planned = d.loop?.moves?.winds || (d.loop && d.ended ? 0 : d.planned);
  at("facts").replaceChildren(
    fact("state", d.state, "state", stale),
    fact("samples", d.samples.toLocaleString("en") + (d.unnamed && !d.samples ? `; ${d.unnamed.toLocaleString("en")} lines without names are kept` : ""), "samples"),
    fact(d.come_hz ? "samples per second" : "samples per second by the rig's clock", rate(d), "rate"),
    fact("frames lost, bad", d.lost === null ? `–, ${d.bad}` : `${d.lost}, ${d.bad}`, "lost", d.lost > 0 || d.bad > 0),
    d.ended && d.ended_utc ? fact("ended at", moment(d.ended_utc), "age") : fact("last sample", d.age_s === null ? "–" : `${d.age_s < 10 ? d.age_s.toFixed(1) : Math.round(d.age_s)} s ago`, "age", stale),
    fact("disk left", bytes(d.free_bytes), "disk", d.free_bytes < 1e9),
    fact("strokes", d.strokes === null ? "–" : planned ? `${d.strokes} of ${planned}` : `${d.strokes}`, "strokes"),
    fact(until ? `strokes left, forecast, until ${until}` : "strokes left, forecast", left, "left"),
    fact("clock jumps", `${d.jumps}`, "jumps", d.jumps > 0),
    ...(d.behind_bytes ? [fact("still to read", bytes(d.behind_bytes), "behind")] : []),
    ...(d.replaced ? [fact("recording replaced", `${d.replaced} times`, "replaced")] : []));
}

function draw(d) {
  const loops = d.loops;
  show("empty", d.empty);
  for (const id of ["loop", "loop-key"]) at(id).hidden = !loops.length;
  if (loops.length) drawLoops(loops, d);
  const box = at("channels");
  while (box.children.length > d.channels.length) box.lastChild.remove();
  while (box.children.length < d.channels.length) box.append(document.createElement("canvas"));
  at("channels-part").hidden = !d.channels.length;
  d.channels.forEach((one, k) => {
    const shown = axes(box.children[k], [d.time_s], [one.low, one.high], k === d.channels.length - 1 ? "time (s)" : "", label(one.name));
    const [times, values] = inOrder(one);
    line(shown, times, values, BLACK, 1);
  });
}

function drawLoops(loops, d) {
  const plot = axes(at("loop"), loops.map((one) => one.motor_turns), loops.flatMap((one) => [one.displacement_mm, one.simulated_mm]), "twist (turns)", "displacement (mm)");
  loops.forEach((one, k) => {
    const shade = FADES ** (loops.length - 1 - k);
    line(plot, one.motor_turns, one.displacement_mm, BLACK, shade);
    if (d.noise_mm) strip(plot, one.simulated_turns, one.simulated_mm, BAND * d.noise_mm, SIMULATOR);
    line(plot, one.simulated_turns, one.simulated_mm, SIMULATOR, 0.8 * shade);
  });
  const twice = d.noise_mm && `± ${round(BAND * d.noise_mm, 2)} mm`;
  show("noise", !twice || !loops.some((one) => one.simulated_mm.length) ? "" : isSeen(plot, BAND * d.noise_mm) ? `noise band ${twice}: twice the noise of one reading` : `noise band ${twice}: too thin to draw`);
}

// No name of an element's: a name that nothing here defines is that element, in each page.
function linkTo(name, path) {
  const a = document.createElement("a");
  a.textContent = name; a.href = "/reports/" + path.split("/").map(encodeURIComponent).join("/");
  return a;
}

let listed = "";
function verdicts(d) {
  show("verdict", d.verdict || "This run has no diagnosis yet.");
  const text = JSON.stringify([d.verdicts, d.index, d.verdict_page, d.verdict_text, d.verdict_of, d.left]);
  if (text === listed) return;
  listed = text;
  at("verdict-page").replaceChildren(...(d.verdict_page ? ["It stands in ", linkTo(`reports/${d.verdict_page}`, d.verdict_page), ...(d.verdict_text && d.verdict_text !== d.verdict_page ? [", as text in ", linkTo(`reports/${d.verdict_text}`, d.verdict_text)] : []), d.verdict_of ? `: ${d.verdict_of}` : ""] : []));
  at("left-file").replaceChildren(...(d.left ? ["The strokes left stand in ", linkTo(`reports/${d.left.file}`, d.left.file), ".", d.left.until && ` Counted until ${d.left.until}.`, d.left.rests && ` From ${d.left.rests}.`, ...d.left.beside.map((other) => ` Also: ${other}.`)] : []));
  at("index").replaceChildren(...(d.index ? [linkTo("All reports", "index.html")] : []));
  const others = d.verdicts.filter((one) => one.run !== d.run);
  at("others").hidden = !others.length;
  at("verdicts").replaceChildren(...others.map((one) => {
    const row = document.createElement("tr"), run = document.createElement("td"), said = document.createElement("td");
    run.append(linkTo(one.run, one.page)); said.textContent = one.verdict; row.append(run, said);
    return row;
  }));
}

function takeToken() {
  const given = new URLSearchParams(location.search).get("token");
  if (given) { sessionStorage.setItem(KEY, given); history.replaceState(null, "", "/"); }
  return sessionStorage.getItem(KEY);
}
const token = takeToken();

async function press(button) {
  const body = JSON.stringify(button === "approve" ? { question: asked } : {});
  const head = { "Content-Type": "application/json", "X-Watch-Token": token };
  try {
    const answer = await fetch("/" + button, { method: "POST", headers: head, body, signal: AbortSignal.timeout(5000) });
    show("said", answer.ok ? (button === "stop" ? "Stop was said." : "Approved.") : await answer.text());
  } catch (error) { show("said", `no answer (${error.message}); it may not have been heard`); }
  at("clear").checked = false;
}

const opened = Date.now(), WAIT_MS = 4000;
const NO_DATA = "connected, but no data yet: a long recording is read from its beginning first. If this stays, look at the terminal of watch; start it again and open the address that it prints.";
function jobs(d) {
  const j = d.jobs;
  at("jobs-part").hidden = !j;
  if (!j) return;
  show("jobs", `${j.done} of ${j.total} done${j.ended ? `, ended at ${moment(j.ended_utc)}` : ""}; ${j.failures} failed`);
  at("jobs").className = j.failures ? "bad" : "";
  const rows = [...j.failed.map((one) => ["failed", one]), ...j.running.map((one) => ["running", one])];
  at("job-list").replaceChildren(...rows.map((cells) => {
    const row = document.createElement("tr");
    row.append(...cells.map((text) => { const cell = document.createElement("td"); cell.textContent = text; return cell; }));
    return row;
  }));
}

function connection(text, bad) { const line = at("link"); line.className = bad ? "bad" : ""; line.textContent = text; }

// A part that cannot be drawn leaves the others as they are: a fault of the page is no fault of the recording.
function parts(d) {
  let fault = null;
  for (const part of [facts, loop, draw, jobs, verdicts]) {
    try { part(d); } catch (error) { console.error(error); fault = fault || `${part.name}: ${error.message}`; }
  }
  connection(fault ? `connected, but a part of this page cannot be shown (${fault})` : "connected", fault);
}

async function look() {
  let d = null;
  try {
    const answer = await fetch("/data.json", { cache: "no-store", signal: AbortSignal.timeout(5000) });
    if (!answer.ok) throw new Error(answer.status === 403 ? "not allowed; open the address that was printed" : `answer ${answer.status}`);
    d = await answer.json();
  } catch (error) { connection(`no answer, trying again (${error.message})`, true); }
  if (d && d.run !== undefined) {
    document.title = d.run; show("run", d.run);
    show("about", [d.material, d.string && `string ${d.string}`, d.device].filter(Boolean).join(" · "));
    parts(d);
  } else if (d && Date.now() - opened > WAIT_MS) show("link", NO_DATA);
  setTimeout(look, EVERY_MS);
}
at("approve").addEventListener("click", () => press("approve"));
at("stop").addEventListener("click", () => press("stop"));
at("clear").addEventListener("change", () => { at("approve").disabled = !token || !at("clear").checked; });
look();
