// SPDX-License-Identifier: BSD-3-Clause
// Which page this is, and its parts that all have.

const main = document.getElementById("main");
document.getElementById("kind").textContent = { run: "report", study: "study", fit: "fit", stiffness: "stiffness" }[data.kind];
document.getElementById("title").textContent = data.title || data.folder;
const afterwards = { run: showRun, study: showStudy, fit: showFit, stiffness: showStiffness }[data.kind](main);
document.getElementById("contents").append(...[...main.querySelectorAll("section[id]")].map((element) => h("a", { href: "#" + element.id }, element.querySelector("h2").textContent)));
drawCharts();
matchMedia("(prefers-color-scheme: dark)").addEventListener("change", drawCharts);
afterwards().then(() => document.documentElement.setAttribute("data-ready", ""));
