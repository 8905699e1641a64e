"use strict";
// What all pages have. Tables of the class "sortable": their headings become buttons that sort by their column, upwards, then downwards, then
// as written.
(function () {
  const text = (row, column) => (row.cells[column] ? row.cells[column].textContent.trim() : "");
  const collator = new Intl.Collator("en", { numeric: true });
  // Numbers may have thousands apart, and units; what is none comes last.
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
        // Rows that are equal stay as written.
        table.tBodies[0].append(...written.slice().sort((one, other) => sign * compare(text(one, column), text(other, column))));
      });
    });
  }
})();
// Pictures shrink to their place, but not so far that their text cannot be read: then the figure around them scrolls.
(function () {
  const least = 0.6;
  for (const svg of document.querySelectorAll(".drawn svg")) {
    const width = svg.width.baseVal.value;
    if (width > 0) svg.style.minWidth = Math.round(width * least) + "px";
  }
})();
