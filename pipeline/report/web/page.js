// Tables sort by a click on a head; a long one has a field that hides other rows, and one that is paged shows some at a
// time; figures enlarge; links open what is folded.
const number = text => {
  const found = text.trim().replace(/^n=/, "").match(/^[-+−]?\d+(\.\d+)?(e[-+]?\d+)?/i);
  return found ? parseFloat(found[0].replace("−", "-")) : NaN;
};

function sort(table, column, head) {
  const falling = head.ariaSort === "ascending";
  for (const other of head.parentNode.cells) other.removeAttribute("aria-sort");
  head.ariaSort = falling ? "descending" : "ascending";
  const rows = [...table.tBodies[0].rows], text = row => row.cells[column].textContent.trim();
  const filled = rows.filter(row => text(row)), numeric = filled.every(row => !isNaN(number(text(row))));
  const order = numeric ? (a, b) => number(text(a)) - number(text(b)) : (a, b) => text(a).localeCompare(text(b));
  filled.sort((a, b) => (falling ? -1 : 1) * order(a, b));
  table.tBodies[0].append(...filled, ...rows.filter(row => !text(row)));
  show(table, 0);
}

const LONG = 25, SHOWN = 15; // rows: a longer table has a field; of one that is paged so many are shown

function show(table, first) {
  const [field, ways] = [table.field, table.ways], rows = [...table.tBodies[0].rows];
  if (!field) return;
  const wanted = field.value.toLowerCase(), only = field.only;
  table.classList.toggle("filtered", Boolean(wanted)); // a name that stands once may be hidden with its row
  const fits = row => only ? [...row.cells].some(cell => cell.textContent === only)
    : row.textContent.toLowerCase().includes(wanted);
  const found = rows.filter(fits), until = ways && first !== null ? first + SHOWN : found.length, from = first || 0;
  const shown = new Set(found.slice(from, until));
  for (const row of rows) row.hidden = !shown.has(row);
  if (!ways) return;
  const way = (words, to) => Object.assign(document.createElement("button"), {
    textContent: words, disabled: to !== null && (to < 0 || to >= found.length), onclick: () => show(table, to) });
  const said = found.length ? ` ${from + 1} to ${Math.min(until, found.length)} of ${found.length} ` : " none ";
  const paged = found.length > SHOWN && first !== null;
  ways.replaceChildren(...(paged ? [way("‹ before", from - SHOWN), said, way("next ›", from + SHOWN), " ", way("show all", null)]
    : [said, ...(found.length > SHOWN ? [way("show few", 0)] : [])]));
}

for (const table of document.querySelectorAll("table.sortable")) {
  const heads = table.tHead.rows[table.tHead.rows.length - 1].cells;
  [...heads].forEach((head, column) => {
    const button = document.createElement("button");
    button.append(...head.childNodes);
    button.onclick = () => sort(table, column, head);
    head.append(button);
  });
  if (table.tBodies[0].rows.length <= (table.classList.contains("paged") ? SHOWN : LONG)) continue;
  const field = table.field = document.createElement("input");
  field.type = "search";
  field.placeholder = "show only rows with …";
  field.oninput = () => { field.only = ""; show(table, 0); };
  table.parentNode.before(field);
  if (table.classList.contains("paged")) {
    table.ways = document.createElement("span");
    table.ways.className = "ways";
    field.after(table.ways);
    show(table, 0);
  }
}

for (const link of document.querySelectorAll("a[data-only]")) link.onclick = event => {
  const table = document.querySelector(`${link.getAttribute("href")} table`);
  event.preventDefault();
  if (!table.field) return;
  table.field.value = table.field.only = table.field.only === link.dataset.only ? "" : link.dataset.only;
  show(table, 0);
};

const large = document.createElement("dialog");
large.onclick = () => large.close();
document.body.append(large);
for (const link of document.querySelectorAll("a.enlarge")) link.onclick = event => {
  if (event.ctrlKey || event.metaKey || event.shiftKey) return;
  event.preventDefault();
  large.replaceChildren(link.firstElementChild.cloneNode());
  large.showModal();
};

function unfold() {
  const target = document.getElementById(decodeURIComponent(location.hash.slice(1)));
  for (let node = target; node; node = node.parentElement) if (node.tagName === "DETAILS") node.open = true;
  if (target) target.scrollIntoView();
}
addEventListener("hashchange", unfold);
if (location.hash) unfold();
addEventListener("beforeprint", () => {
  for (const one of document.querySelectorAll("details")) one.open = true;
  for (const table of document.querySelectorAll("table.paged")) show(table, null);
});
