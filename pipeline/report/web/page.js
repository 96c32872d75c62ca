// Tables sort by a click on a head; a long table has a field that hides other rows; links open what is folded.
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
}

for (const table of document.querySelectorAll("table.sortable")) {
  const heads = table.tHead.rows[table.tHead.rows.length - 1].cells;
  [...heads].forEach((head, column) => {
    const button = document.createElement("button");
    button.append(...head.childNodes);
    button.onclick = () => sort(table, column, head);
    head.append(button);
  });
}

for (const table of document.querySelectorAll("table.sortable")) {
  if (table.tBodies[0].rows.length < 25) continue;
  const field = document.createElement("input");
  field.type = "search";
  field.placeholder = "show only rows with …";
  field.oninput = () => {
    const wanted = field.value.toLowerCase();
    for (const row of table.tBodies[0].rows) row.hidden = !row.textContent.toLowerCase().includes(wanted);
  };
  table.parentNode.before(field);
}

function unfold() {
  const target = document.getElementById(decodeURIComponent(location.hash.slice(1)));
  for (let node = target; node; node = node.parentElement) if (node.tagName === "DETAILS") node.open = true;
  if (target) target.scrollIntoView();
}
addEventListener("hashchange", unfold);
if (location.hash) unfold();
addEventListener("beforeprint", () => document.querySelectorAll("details").forEach(one => (one.open = true)));
