// Draws the equations of a page with KaTeX.
document.addEventListener("DOMContentLoaded", () => {
  for (const equation of document.querySelectorAll(".math")) {
    const displayMode = equation.tagName === "DIV";
    katex.render(equation.textContent, equation, {displayMode, throwOnError: false});
  }
});
