// Shows the pixel that is pointed at. Nothing is computed here: each pixel's steps and drawing lie packed in
// the page, a strip of pixels a script element, a pixel a line of JSON.
"use strict";

const frame = document.getElementById("frame");
const mark = document.getElementById("mark");
const field = document.getElementById("pixel");
const steps = document.getElementById("steps");
const [width, height, strip] = ["width", "height", "strip"].map((name) => Number(frame.dataset[name]));
let [col, row] = [Number(frame.dataset.col), Number(frame.dataset.row)];
let held = false;

/** The unpacked strips, by their ids; the latest ones. */
const unpacked = new Map();
const MOST = 32;

/** The lines of a strip. */
function lines(id) {
  if (!unpacked.has(id)) {
    if (unpacked.size >= MOST) unpacked.delete(unpacked.keys().next().value);
    unpacked.set(id, unpack(document.getElementById(id).textContent));
  }
  return unpacked.get(id);
}

async function unpack(letters) {
  const bytes = Uint8Array.from(atob(letters), (letter) => letter.charCodeAt(0));
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
  return (await new Response(stream).text()).split("\n");
}

/** Shows a pixel; where another is asked for in the meantime, that one. */
async function show(toCol, toRow) {
  [col, row] = [clamp(toCol, width), clamp(toRow, height)];
  const shown = `${col},${row}`;
  if (field !== document.activeElement) field.value = shown;
  Object.assign(mark.style, {
    left: `${(100 * (col + 0.5)) / width}%`,
    top: `${(100 * (row + 0.5)) / height}%`,
    width: `${100 / width}%`,
    height: `${100 / height}%`,
  });
  const part = Math.floor(col / strip);
  const look = JSON.parse((await lines(`r${row}-${part}`))[col - part * strip]);
  if (shown !== `${col},${row}`) return;
  document.getElementById("ray").innerHTML = look.drawing;
  steps.replaceChildren(...look.sections.map(section));
  steps.dataset.pixel = shown;
}

const clamp = (place, count) => Math.min(Math.max(Math.floor(place) || 0, 0), count - 1);

function element(name, content = "", className = "") {
  const it = document.createElement(name);
  it.append(...[content].flat());
  if (className) it.className = className;
  return it;
}

/** A section of the steps: its title, its steps, its table, its remarks. */
function section([title, source, rows, columns, table, remarks]) {
  const heading = element("h2", [title, " ", element("span", source)]);
  const parts = [heading];
  if (rows.length) {
    const step = ([symbol, formula, value, note]) => {
      const head = element("th", symbol);
      head.scope = "row";
      const cells = [element("td", formula), element("td", value, "value"), element("td", note, "note")];
      return element("tr", [head, ...cells]);
    };
    const names = ["symbol", "formula", "value", "what it means"];
    parts.push(wide(title, names, rows.map(step)));
  }
  if (table.length) {
    const line = (cells) => element("tr", cells.map((cell) => element("td", cell, "value")));
    parts.push(wide(title, columns, table.map(line)));
  }
  return element("div", parts.concat(remarks.map((remark) => element("p", remark))));
}

/** A table that scrolls by itself where it is wide. */
function wide(title, names, rows) {
  const heads = names.map((name) => {
    const head = element("th", name);
    head.scope = "col";
    return head;
  });
  const parts = [element("thead", element("tr", heads)), element("tbody", rows)];
  const box = element("div", element("table", parts), "wide");
  Object.assign(box, { tabIndex: 0, role: "region", ariaLabel: title });
  return box;
}

function point(event) {
  const box = frame.getBoundingClientRect();
  const across = (event.clientX - box.left) / box.width;
  const down = (event.clientY - box.top) / box.height;
  return [across * width, down * height];
}

frame.addEventListener("pointermove", (event) => {
  if (!held && event.pointerType !== "touch") show(...point(event));
});

frame.addEventListener("click", (event) => {
  held = event.pointerType !== "touch" && !held;
  mark.classList.toggle("held", held);
  show(...point(event));
});

frame.addEventListener("keydown", (event) => {
  const ways = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };
  const way = ways[event.key];
  if (!way || event.ctrlKey || event.altKey || event.metaKey) return;
  event.preventDefault();
  const by = event.shiftKey ? 10 : 1;
  show(col + by * way[0], row + by * way[1]);
});

field.addEventListener("input", () => {
  const pixel = /^\s*(\d+)\s*,\s*(\d+)\s*$/.exec(field.value);
  const inside = pixel !== null && Number(pixel[1]) < width && Number(pixel[2]) < height;
  field.setAttribute("aria-invalid", String(!inside));
  if (inside) show(Number(pixel[1]), Number(pixel[2]));
});

field.addEventListener("blur", () => {
  field.value = `${col},${row}`;
  field.setAttribute("aria-invalid", "false");
});

show(col, row);
