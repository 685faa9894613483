// SPDX-License-Identifier: BSD-3-Clause
// Charts, by Chart.js.

const css = (name) => getComputedStyle(document.documentElement).getPropertyValue(name).trim();
const seriesColour = (n) => css("--s" + (n % 7));
const dashes = [[], [7, 4], [2, 3], [9, 3, 2, 3]];
const points = ["circle", "rect", "triangle", "rectRot", "crossRot", "star", "rectRounded"];
const charts = [];

Chart.defaults.animation = false;
Chart.defaults.maintainAspectRatio = false;
Chart.defaults.font.family = "system-ui, 'Segoe UI', Roboto, 'Noto Sans', 'DejaVu Sans', sans-serif";

/** Multiples of 1, 2 or 5 times a power of 10 between the ends of an axis, some eight of them. */
function evenTicks(min, max, least) {
  const wanted = Math.max((max - min) / 8, least) || 1, power = 10 ** Math.floor(Math.log10(wanted)), step = power * [1, 2, 5, 10].find((n) => n * power >= 0.999 * wanted);
  const first = Math.ceil(min / step - 1e-6), count = Math.floor(max / step + 1e-6) - first + 1;
  return Array.from({ length: Math.max(count, 0) }, (_, n) => ({ value: (first + n) * step }));
}

/** An axis with a title. scale: "linear", "whole" (numbers) or "log"; bounds: it ends at "ticks", or with the "data". */
function chartAxis(title, scale = "linear", bounds = "ticks") {
  const isLog = scale === "log", leading = (value) => Number(value.toExponential(0)[0]);
  return { type: isLog ? "logarithmic" : "linear", bounds, title: { display: true, text: title, color: css("--quiet") },
    ticks: { color: css("--quiet"), maxTicksLimit: isLog ? 12 : 8, precision: scale === "whole" ? 0 : undefined,
      callback: (value) => (isLog && ![1, 2, 5].includes(leading(value)) ? null : short(value, 6)) },
    grid: { color: css("--line"), drawBorder: false },
    afterBuildTicks: (axis) => { if (bounds === "data" && !isLog) axis.ticks = evenTicks(axis.min, axis.max, scale === "whole" ? 1 : 0); } };
}

/** The vertical bars of errors: datasets of one line that is broken between points. */
function errorBars(series, colour) {
  const data = series.points.flatMap(({ x, y }, i) => [{ x, y: y - series.errors[i] }, { x, y: y + series.errors[i] }, { x, y: NaN }]);
  return { label: series.label + ", errors", data, borderColor: colour, borderWidth: 1.5, pointRadius: 0, pointHitRadius: 0, isBand: true };
}

/** An axis of names, at 0, 1, ... */
function nameAxis(title, names) {
  const axis = chartAxis(title);
  axis.ticks.callback = (value) => names[value];
  return { ...axis, min: -0.5, max: names.length - 0.5, afterBuildTicks: (built) => { built.ticks = names.map((_, value) => ({ value })); } };
}

/** What the legend has: bands and errors belong to their lines, and a key of null to another's. */
const legendLabels = (chart) => Chart.defaults.plugins.legend.labels.generateLabels(chart).map((item) => ({ ...item, text: chart.data.datasets[item.datasetIndex].key ?? item.text }));

/** A chart of lines of {x, y}. series: {label, points, n (colour), dash, bare (no marks), marks (no line), errors: [half a bar],
 *  band: [lower, upper], key (in the legend, instead of the label; null: not there)}. xNames: of x = 0, 1, ... */
function lineChart(id, description, x, y, series, { low = false, yFromZero = false, legend = series.length > 1, xScale, yScale, xNames } = {}) {
  const canvas = h("canvas", { id, role: "img", "aria-label": description });
  const figure = h("figure", {}, h("div", { class: "chart" + (low ? " low" : "") }, canvas));
  const make = () => {
    const datasets = [];
    for (const s of series) {
      const colour = seriesColour(s.n);
      if (s.band) {
        const edge = { borderWidth: 0, pointRadius: 0, pointHitRadius: 0, isBand: true };
        datasets.push({ ...edge, label: s.label + ", lower", data: s.band[0], fill: false });
        datasets.push({ ...edge, label: s.label + ", upper", data: s.band[1], fill: "-1", backgroundColor: colour + "26" });
      }
      if (s.errors) datasets.push(errorBars(s, colour));
      datasets.push({ label: s.label, key: s.key, data: s.points, borderColor: colour, backgroundColor: colour, borderDash: dashes[(s.dash || 0) % 4], showLine: !s.marks,
        borderWidth: 2, pointStyle: s.bare ? "line" : points[s.n % 7], pointRadius: s.bare ? 0 : 3.5, pointHitRadius: 8, stepped: s.stepped || false });
    }
    return new Chart(canvas, { type: "line", data: { datasets }, options: {
      interaction: { mode: "nearest", axis: "xy", intersect: false },
      scales: { x: xNames ? nameAxis(x, xNames) : chartAxis(x, xScale, "data"), y: { ...chartAxis(y, yScale), beginAtZero: yFromZero } },
      plugins: {
        legend: { display: legend, labels: { color: css("--ink"), usePointStyle: true, boxHeight: 7, generateLabels: legendLabels, filter: ({ datasetIndex }, all) => !all.datasets[datasetIndex].isBand && all.datasets[datasetIndex].key !== null } },
        tooltip: { filter: (item) => !item.dataset.isBand, callbacks: { title: (items) => items.length ? `${x}: ${short(items[0].parsed.x)}` : "", label: (item) => `${item.dataset.label}: ${short(item.parsed.y, 6)}` } } } } });
  };
  charts.push({ make, chart: null });
  return figure;
}

/** A chart of curves around a point. series: {label, values (of equal angles, clockwise from the top), n, dash}; most: the radius;
 *  ends: names of the directions up, right, down and left; at: the text of an angle's number. */
function polarChart(id, description, unit, most, series, ends, at) {
  const canvas = h("canvas", { id, role: "img", "aria-label": description }), count = series[0].values.length, quarter = count / 4;
  const make = () => new Chart(canvas, {
    type: "radar",
    data: { labels: series[0].values.map((_, i) => (i % quarter === 0 ? ends[i / quarter] : "")),
      datasets: series.map(({ label, values, n, dash }) => ({ label, data: values, borderColor: seriesColour(n), backgroundColor: seriesColour(n), borderDash: dashes[(dash || 0) % 4], borderWidth: 2, pointRadius: 0, pointHitRadius: 8, fill: false })) },
    options: {
      interaction: { mode: "index", axis: "r", intersect: false },
      scales: { r: { min: 0, max: most, grid: { circular: true, color: css("--line") }, angleLines: { color: ({ index }) => (index % quarter === 0 ? css("--line") : "transparent") },
        pointLabels: { color: css("--ink"), font: { size: 14 } }, ticks: { color: css("--quiet"), backdropColor: css("--card"), maxTicksLimit: 5, includeBounds: false, callback: (value) => short(value) } } },
      plugins: { legend: { display: false }, tooltip: { callbacks: { title: (items) => (items.length ? at(items[0].dataIndex) : ""), label: (item) => `${item.dataset.label}: ${short(item.parsed.r)} ${unit}` } } } } });
  charts.push({ make, chart: null });
  return h("figure", {}, h("div", { class: "chart round" }, canvas));
}

/** A place for a chart that its reader may change. */
class ChartPlace {
  constructor() {
    this.element = h("div", { class: "place" });
    this.entry = null;
  }
  /** Puts a figure of lineChart() in the place of the one before. */
  show(figure) {
    const made = charts.at(-1), isDrawn = this.entry !== null && this.entry.chart !== null;
    if (this.entry) charts.splice(charts.indexOf(this.entry), 1);
    if (isDrawn) this.entry.chart.destroy();
    this.element.replaceChildren(figure);
    if (isDrawn) made.chart = made.make();
    this.entry = made;
  }
}

/** Charts are made once their elements are in the page, and again where light and dark change. */
function drawCharts() {
  for (const one of charts) {
    if (one.chart) one.chart.destroy();
    one.chart = one.make();
  }
}
