(function () {
  document.documentElement.classList.add("scripted");
  const claims = Array.from(document.querySelectorAll("section.claim"));
  let current = null;
  function steps(claim) { return Array.from(claim.querySelectorAll("tr.step")); }
  function at(claim) { return steps(claim).findIndex((row) => row.getAttribute("aria-current") === "step"); }
  function marked(claim, list, name) {
    for (const word of (list || "").split(" ")) {
      const colon = word.indexOf(":");
      if (colon < 0) continue;
      const parts = 'figure[data-machine="' + word.slice(0, colon) + '"] [data-element="' + word.slice(colon + 1) + '"]';
      for (const part of claim.querySelectorAll(parts)) part.classList.add(name);
    }
  }
  // A row contains the variables of a machine only if they differ from those in the row before.
  function values(claim, rows, index) {
    for (const place of claim.querySelectorAll("figure .values")) {
      const figure = place.closest("figure");
      let at = index;
      while (at > 0 && !(figure.dataset.machine in valuesOf(rows[at]))) --at;
      place.textContent = "";
      (valuesOf(rows[at])[figure.dataset.machine] || []).forEach(([name, value, changed], i) => {
        if (i > 0) place.append(", ");
        const shown = document.createElement(changed && at === index ? "mark" : "span");
        shown.textContent = name + " = " + value;
        place.append(shown);
      });
    }
  }
  function valuesOf(row) { return JSON.parse(row.dataset.values); }
  // If there are several diagrams, scrolls to that of the machine that acts.
  function bring(panel, part) {
    if (!part) return;
    const [view, it] = [panel.getBoundingClientRect(), part.getBoundingClientRect()];
    if (it.top < view.top || it.bottom > view.bottom)
      panel.scrollTop += part.closest("figure").getBoundingClientRect().top - view.top;
    const after = part.getBoundingClientRect();
    if (after.bottom > view.bottom) panel.scrollTop += after.top - view.top - view.height / 3;
  }
  // Rows that have not been visible do not have their final height. After they are drawn, the row is searched again.
  function seek(panel, row, more) {
    if (row.getAttribute("aria-current") !== "step") return;
    if (row.offsetTop < panel.scrollTop || row.offsetTop + row.offsetHeight > panel.scrollTop + panel.clientHeight)
      panel.scrollTop = row.offsetTop - panel.clientHeight / 2;
    if (more > 0) requestAnimationFrame(() => seek(panel, row, more - 1));
  }
  // Browsers drop changes of the address after two hundred in ten seconds. After a hundred, the address is written at
  // most once per fifth of a second.
  const address = { text: "", timer: null, changes: 0 };
  function writeAddress() {
    clearTimeout(address.timer);
    address.timer = null;
    ++address.changes;
    setTimeout(() => { --address.changes; }, 10000);
    history.replaceState(null, "", address.text);
  }
  function addressIs(text) {
    address.text = text;
    if (address.changes < 100) writeAddress();
    else if (address.timer === null) address.timer = setTimeout(writeAddress, 200);
  }
  function show(claim, index, move) {
    const rows = steps(claim);
    if (rows.length === 0) return;
    index = Math.max(0, Math.min(rows.length - 1, index));
    for (const row of rows) row.removeAttribute("aria-current");
    for (const part of claim.querySelectorAll(".on, .fired")) part.classList.remove("on", "fired");
    const row = rows[index];
    row.setAttribute("aria-current", "step");
    marked(claim, row.dataset.on, "on");
    marked(claim, row.dataset.fired, "fired");
    values(claim, rows, index);
    claim.querySelector(".status").textContent = "step " + index + " of " + (rows.length - 1) + ": " + row.dataset.text;
    current = claim;
    seek(claim.querySelector(".steps"), row, 4);
    bring(claim.querySelector(".drawn"), claim.querySelector(".drawn .fired"));
    if (move) {
      addressIs("#" + claim.id + "/s/" + index);
      row.scrollIntoView({ block: "nearest" });
    }
  }
  // The next step in which the element is marked; after the last step, the search continues at the first.
  function nextWith(claim, figure, part) {
    const mark = figure.dataset.machine + ":" + part.dataset.element;
    const rows = steps(claim);
    const has = (row) => (row.dataset.on + " " + row.dataset.fired).split(" ").includes(mark);
    for (let i = 1; i <= rows.length; ++i) {
      const index = (at(claim) + i) % rows.length;
      if (has(rows[index])) return index;
    }
    return undefined;
  }
  function chosen(claim, figure, target) {
    for (let part = target.closest("[data-element]"); part; part = part.parentElement.closest("[data-element]")) {
      const index = nextWith(claim, figure, part);
      if (index !== undefined) return go(claim, index);
    }
  }
  /* ---- playing: one claim at a time; a step chosen by hand stops it ---- */

  // There is no movement between two steps. For readers who prefer less motion, each step takes at least three seconds.
  const calm = matchMedia("(prefers-reduced-motion: reduce)");
  let playing = null;
  function stop() {
    if (playing === null) return;
    clearTimeout(playing.timer);
    playing.claim.querySelector("button.play").textContent = "play";
    playing.claim.querySelector(".status").setAttribute("aria-live", "polite");
    playing = null;
  }
  function next(claim) {
    const wait = Number(claim.querySelector("select.speed").value);
    playing.timer = setTimeout(() => {
      show(claim, at(claim) + 1, true);
      if (at(claim) === steps(claim).length - 1) stop(); else next(claim);
    }, calm.matches ? Math.max(wait, 3000) : wait);
  }
  function play(claim) {
    stop();
    if (at(claim) === steps(claim).length - 1) show(claim, 0, true);
    claim.querySelector("button.play").textContent = "pause";
    claim.querySelector(".status").setAttribute("aria-live", "off");
    playing = { claim: claim };
    next(claim);
  }
  function toggle(claim) {
    if (playing !== null && playing.claim === claim) stop(); else play(claim);
  }
  function go(claim, index) {
    stop();
    show(claim, index, true);
  }

  // If the browser does not give access to the clipboard, the link is shown so that it can be copied by hand.
  async function copyLink(claim) {
    stop();
    show(claim, at(claim), true);
    writeAddress();
    const line = claim.querySelector(".address");
    const status = claim.querySelector(".status");
    try {
      await navigator.clipboard.writeText(location.href);
      line.hidden = true;
      status.textContent = "the link to step " + at(claim) + " is copied";
    } catch (refusal) {
      line.hidden = false;
      line.querySelector("input").value = location.href;
      line.querySelector("input").select();
      status.textContent = "the link to step " + at(claim) + ", to be copied";
    }
  }

  function fromAddress() {
    const match = /^#([a-z][0-9]+)(?:\/s\/([0-9]+))?$/.exec(location.hash);
    const claim = match && document.getElementById(match[1]);
    if (!claim || !claim.classList.contains("claim")) return;
    stop();
    show(claim, match[2] === undefined ? steps(claim).length - 1 : Number(match[2]), false);
    claim.scrollIntoView();
  }
  for (const claim of claims) {
    claim.querySelector(".steps").addEventListener("click", (event) => {
      const row = event.target.closest("tr.step");
      if (row && !event.target.closest("details")) go(claim, steps(claim).indexOf(row));
    });
    for (const figure of claim.querySelectorAll("figure[data-machine]"))
      figure.querySelector("svg").addEventListener("click", (event) => chosen(claim, figure, event.target));
    const size = claim.querySelector("button.size");
    size.addEventListener("click", () => {
      size.setAttribute("aria-pressed", claim.querySelector(".drawn").classList.toggle("full"));
    });
    for (const button of claim.querySelectorAll(".controls button[data-to]"))
      button.addEventListener("click", () => {
        const last = steps(claim).length - 1;
        const to = { first: 0, back: at(claim) - 1, next: at(claim) + 1, last: last };
        go(claim, to[button.dataset.to]);
      });
    claim.querySelector("button.play").addEventListener("click", () => toggle(claim));
    claim.querySelector("button.link").addEventListener("click", () => copyLink(claim));
    claim.querySelector("select.speed").addEventListener("change", () => {
      if (playing === null || playing.claim !== claim) return;
      clearTimeout(playing.timer);
      next(claim);
    });
    show(claim, steps(claim).length - 1, false);
  }
  current = claims.length > 0 ? claims[0] : null;
  document.addEventListener("keydown", (event) => {
    if (!current || event.ctrlKey || event.altKey || event.metaKey || event.target.closest("select, input[type=text]")) return;
    if (event.key === "p") return toggle(current);
    const to = { ArrowRight: at(current) + 1, j: at(current) + 1, ArrowLeft: at(current) - 1, k: at(current) - 1,
                 Home: 0, End: steps(current).length - 1 }[event.key];
    if (to === undefined) return;
    event.preventDefault();
    go(current, to);
  });
  const only = document.getElementById("only");
  if (only)
    only.addEventListener("change", () => {
      for (const row of document.querySelectorAll("#verdicts tbody tr")) row.hidden = only.checked && row.classList.contains("good");
    });
  window.addEventListener("hashchange", fromAddress);
  fromAddress();
})();
