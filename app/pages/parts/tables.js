"use strict";
// The script of all pages. In tables of the class "sortable", the headings become buttons that sort by their column:
// first ascending, then descending, then in the original order.
(function () {
  const text = (row, column) => (row.cells[column] ? row.cells[column].textContent.trim() : "");
  const collator = new Intl.Collator("en", { numeric: true });
  // Numbers may have separators of thousands, and units. Texts that are not numbers come last.
  function number(words) {
    const match = /^-?[0-9][0-9,]*(?:\.[0-9]+)?/.exec(words);
    return match ? Number(match[0].replaceAll(",", "")) : undefined;
  }
  function compare(one, other) {
    const [a, b] = [number(one), number(other)];
    if (a !== undefined && b !== undefined && a !== b) return a - b;
    return (a === undefined) - (b === undefined) || collator.compare(one, other);
  }
  for (const table of document.querySelectorAll("table.sortable")) {
    const headings = Array.from(table.tHead.rows[0].cells);
    const written = Array.from(table.tBodies[0].rows);
    if (written.length < 2) continue;
    headings.forEach((heading, column) => {
      const button = document.createElement("button");
      button.type = "button";
      button.append(...heading.childNodes);
      heading.append(button);
      button.addEventListener("click", () => {
        const next = { ascending: "descending", descending: "" }[heading.getAttribute("aria-sort")] ?? "ascending";
        for (const each of headings) each.removeAttribute("aria-sort");
        if (next !== "") heading.setAttribute("aria-sort", next);
        const sign = { ascending: 1, descending: -1, "": 0 }[next];
        // Equal rows keep their original order.
        table.tBodies[0].append(...written.slice().sort((one, other) => sign * compare(text(one, column), text(other, column))));
      });
    });
  }
})();
// Pictures shrink to the available space, but their text stays readable. If the space is too small, the figure scrolls.
(function () {
  const least = 0.6;
  for (const svg of document.querySelectorAll(".drawn svg")) {
    const width = svg.width.baseVal.value;
    if (width > 0) svg.style.minWidth = Math.round(width * least) + "px";
  }
})();
