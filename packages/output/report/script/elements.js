// SPDX-License-Identifier: BSD-3-Clause
// Elements, numbers, tables.
// The files of this folder are one script, in the order of CMakeLists.txt. Texts from files only ever become text nodes.
"use strict";

const data = JSON.parse(document.getElementById("data").textContent);

/** An element with attributes (functions become listeners) and children (texts or elements). */
function h(tag, attributes = {}, ...children) {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (typeof value === "function") element.addEventListener(name, value);
    else if (value !== null && value !== false) element.setAttribute(name, value === true ? "" : value);
  }
  element.append(...children.flat().filter((child) => child !== null && child !== undefined));
  return element;
}

/** A number with a few digits: 1234.6, 0.01235, 1.25e-7. */
function short(value, digits = 4) {
  if (value === null || !Number.isFinite(value)) return "–";
  if (value === 0) return "0";
  const size = Math.abs(value);
  if (size >= 1e6 || size < 1e-4) return value.toExponential(digits - 2).replace(/\.?0*e\+?/, "e");
  return String(Number(value.toPrecision(digits)));
}

/** The unit, of those with their sizes, in which numbers up to `most` read well. */
function unitFor(most, units) {
  let chosen = units[0];
  for (const unit of units) if (most >= unit[1]) chosen = unit;
  return { name: chosen[0], size: chosen[1] };
}
const forceUnit = (most) => unitFor(most, [["pN", 1], ["nN", 1e3], ["µN", 1e6], ["mN", 1e9]]);
const largest = (values) => values.reduce((most, v) => Math.max(most, Math.abs(v)), 0);

/** Rows of a CSV text (RFC 4180). */
function csvRows(text) {
  const rows = [];
  let row = [], field = "", quoted = false;
  for (let i = 0; i < text.length; ++i) {
    const c = text[i];
    if (quoted) {
      if (c === '"' && text[i + 1] === '"') field += text[++i];
      else if (c === '"') quoted = false;
      else field += c;
    } else if (c === '"') quoted = true;
    else if (c === "," || c === "\n") {
      row.push(field);
      field = "";
      if (c === "\n") rows.push(row), (row = []);
    } else if (c !== "\r") field += c;
  }
  return rows;
}

/** A table of a CSV file: names of columns, rows as texts, and columns of numbers by name. */
class Table {
  constructor(excerpt) {
    const rows = csvRows(excerpt ? excerpt.text : "");
    this.names = rows.shift() || [];
    this.rows = rows.filter((row) => row.length === this.names.length);
    this.of = excerpt ? excerpt.of : 0;
  }
  has(name) { return this.names.includes(name); }
  texts(name) { const c = this.names.indexOf(name); return this.rows.map((row) => row[c]); }
  column(name) { return this.texts(name).map((text) => (text === "" || text === undefined ? NaN : Number(text))); }
  last(name) { return this.column(name).at(-1); }
  /** Some of the rows. */
  where(keep) {
    const part = new Table(null);
    part.names = this.names;
    part.rows = this.rows.filter((row) => keep((name) => row[this.names.indexOf(name)]));
    return part;
  }
  excerptNote() { return this.rows.length < this.of ? `${this.rows.length} of ${this.of} rows are shown; the file has them all.` : null; }
}

/** Fields that are no numbers stand at the left, and whole sentences have several lines. */
const textClass = (field) => (/^[^\d.+–-]/.test(field) ? { class: field.length > 30 && /^[a-z]+ \S+ \S+ /.test(field) ? "text long" : "text" } : {});

/** A table in an element that scrolls by itself, from the keyboard too. */
function htmlTable(label, names, rows, { tall = false } = {}) {
  return h("div", { class: "scroll" + (tall ? " tall" : ""), tabindex: "0", role: "region", "aria-label": label },
    h("table", {},
      h("thead", {}, h("tr", {}, names.map((name, column) => h("th", { scope: "col", ...textClass(rows.length > 0 ? rows[0][column] : "") }, name)))),
      h("tbody", {}, rows.map((row) => h("tr", {}, row.map((field) => h("td", textClass(field), field)))))));
}

/** Filled when it is opened first. */
function lazyDetails(summary, make) {
  const details = h("details", {}, h("summary", {}, summary));
  details.addEventListener("toggle", () => { if (details.open && details.children.length === 1) details.append(make()); });
  return details;
}

/** A group of radio buttons that looks like one control. */
function choice(name, label, options, selected, change) {
  return h("fieldset", { class: "choice" }, h("legend", { class: "hidden-text" }, label), options.map(([value, text]) =>
    h("label", {}, h("input", { type: "radio", name, value, checked: value === selected, change: () => change(value) }), text)));
}

/** A list to choose from. options: [[value, text]]. */
function select(id, label, options, selected, change) {
  const element = h("select", { id, change: () => change(element.value) }, options.map(([value, text]) => h("option", { value, selected: value === selected }, text)));
  return h("label", {}, label + " ", element);
}

function slider(id, text, count, value, change) {
  const input = h("input", { type: "range", id, min: 0, max: count - 1, step: 1, value, "aria-label": text });
  const shown = h("span", { class: "value quiet", id: id + "-value" });
  input.addEventListener("input", () => change(Number(input.value)));
  return { input, shown, element: count > 1 ? h("label", { class: "slider" }, text, input, shown) : null };
}

/** A list of what is to be known: tell("good", "look" or "note", text) adds to it. */
function checkList() {
  const list = h("ul", { class: "checks" });
  const tell = (level, text) => list.append(h("li", {}, h("span", { class: `badge ${level}` }, { good: "in order", look: "look", note: "note" }[level]), h("span", {}, text)));
  return { list, tell };
}

/** The ground of a number from -1 to 1: blue below zero, orange above. */
const tint = (share) => `background: rgba(${share < 0 ? "11, 95, 158" : "184, 86, 11"}, ${(0.55 * Math.abs(share)).toFixed(3)})`;

/** A section of the page. */
function section(id, title, ...children) {
  const element = h("section", { id, "aria-labelledby": id + "-title" }, h("h2", { id: id + "-title" }, title), children);
  return element;
}
