(function () {
  const data = JSON.parse(document.getElementById("space").textContent);
  const part = (id) => document.getElementById(id);
  const text = (number) => data.texts[number];
  const roles = { input: 1, output: 2, tock: 3, termination: 4 };
  document.documentElement.classList.add("scripted");
  if (data.states.length === 0) return;

  /* The steps so far: the labels that were taken, with their numbers among the offers. There is one state more than steps. */
  let way = [];
  let states = [0];
  let digits = "";
  /* The number of steps that are shown at first, because showing many steps takes long. */
  let mostEntries = 200;

  const labelOf = ([what, place, hidden, role, word, fired]) =>
    ({ text: text(what), place: text(place), hidden: hidden === 1, role, word: word < 0 ? null : text(word), fired });
  const labels = data.labels.map(labelOf);
  function offersOf(state) {
    const flat = data.states[state][1];
    const result = [];
    for (let i = 0; i < flat.length; i += 2) result.push({ label: labels[flat[i]], target: flat[i + 1] });
    return result;
  }
  const here = () => states[states.length - 1];
  const timeOf = (steps) => way.slice(0, steps).filter((step) => step.label.role === roles.tock).length;

  /* ---- taking steps ---- */

  function go(number) {
    const offer = offersOf(here())[number];
    if (!offer || offer.target < 0) return false;
    way.push({ label: offer.label, number });
    states.push(offer.target);
    return true;
  }
  /* True if the state is left at once, because a hidden step is its only offer. */
  function passes(state) {
    const offers = offersOf(state);
    return !part("hidden").checked && offers.length === 1 && offers[0].label.hidden && offers[0].target >= 0;
  }
  function settle() {
    const met = new Set([here()]);
    while (passes(here()) && go(0)) {
      if (met.has(here())) break;
      met.add(here());
    }
  }
  function backTo(steps) {
    way.length = steps;
    states.length = steps + 1;
  }
  function take(number) {
    digits = "";
    if (!go(number)) return say("what is behind this offer is not embedded");
    settle();
    show(true);
  }
  function undo() {
    if (way.length === 0) return;
    let steps = way.length - 1;
    while (steps > 0 && passes(states[steps])) --steps;
    backTo(steps);
    settle();
    show(true);
  }
  function start() {
    backTo(0);
    settle();
    show(true);
  }
  function tock() {
    const offers = offersOf(here());
    const last = offers.length - 1;
    if (last >= 0 && offers[last].label.role === roles.tock) take(last);
    else say("time cannot pass here");
  }

  /* ---- the address: "#1.1.4x9" contains the numbers of the offers that were taken; "#0": no step ---- */

  function address() {
    const words = [];
    for (let i = 0; i < way.length;) {
      let end = i;
      while (end < way.length && way[end].number === way[i].number) ++end;
      words.push((way[i].number + 1) + (end - i > 1 ? "x" + (end - i) : ""));
      i = end;
    }
    return "#" + (words.length === 0 ? "0" : words.join("."));
  }
  function fromAddress() {
    backTo(0);
    const wanted = location.hash.slice(1);
    if (wanted === "") settle();
    let good = true;
    for (const word of wanted === "" || wanted === "0" ? [] : wanted.split(".")) {
      const match = /^([0-9]{1,9})(?:x([0-9]{1,9}))?$/.exec(word);
      for (let i = match ? Number(match[2] || 1) : 0; good && i > 0; --i) good = go(Number(match[1]) - 1);
      good = good && match !== null;
    }
    show(false);
    if (!good) say("the address could be followed to step " + way.length + " only");
  }

  /* ---- display ---- */

  function element(name, content, look) {
    const made = document.createElement(name);
    if (content) made.textContent = content;
    if (look) made.className = look;
    return made;
  }
  /* The file without its folders; the tooltip contains the whole path. */
  function placeOf(place) {
    const made = element("small", place.slice(place.lastIndexOf("/") + 1));
    made.title = place;
    return made;
  }
  function fill(list, items) {
    list.replaceChildren(...items);
    list.hidden = items.length === 0;
  }
  function say(words) {
    part("status").textContent = words;
  }
  function offerItem(offer, index) {
    const item = element("li");
    const button = element("button");
    button.type = "button";
    button.append(element("span", String(index + 1), "index"));
    button.append(element("span", (offer.label.hidden ? "(hidden) " : "") + offer.label.text, "what"));
    if (offer.label.place) button.append(placeOf(offer.label.place));
    if (offer.target < 0) button.append(element("small", "not embedded"));
    button.disabled = offer.target < 0;
    button.addEventListener("click", () => take(index));
    item.append(button);
    return item;
  }
  function showOffers() {
    const list = part("offers");
    const focused = Array.from(list.querySelectorAll("button")).indexOf(document.activeElement);
    const offers = offersOf(here());
    const wanted = part("find").value;
    fill(list, offers.map(offerItem));
    Array.from(list.children).forEach((item, index) => { item.hidden = !offers[index].label.text.includes(wanted); });
    part("find").closest("p").hidden = offers.length < 10 && wanted === "";
    const buttons = Array.from(list.querySelectorAll("button:enabled"));
    if (focused >= 0 && buttons.length > 0) buttons[Math.min(focused, buttons.length - 1)].focus();
    const missing = offers.filter((offer) => offer.target < 0).length;
    const error = data.states[here()][4];
    part("ends").textContent =
      error !== undefined ? "What can happen cannot be evaluated: " + text(error)
      : offers.length === 0 ? "Nothing can happen any more."
      : missing > 0 ? "The embedded states end here (" + data.limit + "): behind " + missing + " of " + offers.length +
                      " offers there are others." : "";
    part("ends").hidden = part("ends").textContent === "";
  }
  function showAbsences() {
    fill(part("absences"), data.states[here()][2].map((number) => {
      const [component, what, reason, place] = data.absences[number].map(text);
      const item = element("li");
      item.append(element("span", what, "what"), element("span", reason, "reason"), element("small", component),
                  placeOf(place));
      return item;
    }));
    part("absences-title").hidden = part("absences").hidden;
  }
  function valuesOf(machine) {
    const result = new Map();
    if (machine)
      for (let i = 0; i < machine[4].length; i += 2)
        result.set(text(machine[4][i]), machine[4][i + 1] < 0 ? "-" : text(machine[4][i + 1]));
    return result;
  }
  function machinesOf(state) {
    return data.states[state][0].map((number) => data.machines[number]);
  }
  function machineItem(machine, before) {
    const item = element("li");
    item.append(element("strong", text(data.instances[machine[0]])), element("span", text(machine[1]), "where"),
                placeOf(text(machine[2])));
    const was = valuesOf(before);
    const table = element("table");
    for (const [name, value] of valuesOf(machine)) {
      const row = table.insertRow();
      const heading = element("th", name);
      heading.scope = "row";
      row.append(heading, element("td", value));
      const changed = before !== undefined && was.get(name) !== value;
      row.className = changed ? "changed" : "";
      row.append(element("td", !changed ? "" : was.has(name) ? "was " + was.get(name) : "new"));
    }
    if (table.rows.length > 0) item.append(table);
    return item;
  }
  /* The number of steps before the last choice. Hidden steps may have followed the choice. */
  function lastChoice() {
    let steps = way.length - 1;
    while (steps > 0 && passes(states[steps])) --steps;
    return steps;
  }
  function showMachines() {
    const before = way.length === 0 ? [] : machinesOf(states[lastChoice()]);
    const items = machinesOf(here()).map((machine) => machineItem(machine, before.find((each) => each[0] === machine[0])));
    const process = data.states[here()][3];
    if (items.length === 0 && process !== undefined) items.push(element("li", text(process)));
    fill(part("machines"), items);
  }
  /* ---- the structure of the process: an operator that is folded stays folded in later states ---- */

  const folded = new Set();
  const textOfPart = (number) => data.parts[number].slice(0, 2).join();
  function partItem(number, before, path) {
    const [what, offers, ...parts] = data.parts[number];
    const item = element("li");
    const changed = before !== undefined && textOfPart(before) !== textOfPart(number);
    if (parts.length === 0) {
      item.append(element(changed ? "mark" : "span", text(what)), element("small", text(offers)));
      return item;
    }
    const branch = element("details");
    branch.open = !folded.has(path);
    branch.addEventListener("toggle", () => { if (branch.open) folded.delete(path); else folded.add(path); });
    const was = before === undefined ? [] : data.parts[before].slice(2);
    const list = element("ul");
    list.append(...parts.map((each, index) => partItem(each, was.length === parts.length ? was[index] : undefined, path + "." + index)));
    branch.append(element("summary", text(what)), list);
    item.append(branch);
    return item;
  }
  function showStructure() {
    const whole = data.structures[here()];
    const before = way.length === 0 ? -1 : data.structures[states[lastChoice()]];
    part("tree").replaceChildren(...(whole < 0 ? [] : [partItem(whole, before < 0 ? undefined : before, "")]));
    part("structure").hidden = whole < 0;
  }
  function mark(instance, ids, name) {
    for (const id of ids)
      for (const each of document.querySelectorAll('figure[data-machine="' + instance + '"] [data-element="' + text(id) + '"]'))
        each.classList.add(name);
  }
  function showFigures() {
    for (const each of document.querySelectorAll("figure .on, figure .fired")) each.classList.remove("on", "fired");
    for (const machine of machinesOf(here())) mark(machine[0], machine[3], "on");
    for (let i = way.length === 0 ? 0 : lastChoice(); i < way.length; ++i) {
      const fired = way[i].label.fired;
      for (let k = 0; k < fired.length; k += 2) mark(fired[k], [fired[k + 1]], "fired");
    }
  }
  function wayItem(steps, time, words, look) {
    const item = element("li", "", look);
    item.value = steps;
    const button = element("button");
    button.type = "button";
    if (data.timed) button.append(element("span", "t=" + time, "index"));
    button.append(element("span", words, "what"));
    if (steps === way.length) button.setAttribute("aria-current", "step");
    button.addEventListener("click", () => {
      backTo(steps);
      show(true);
    });
    item.append(button);
    return item;
  }
  /* Consecutive time units are one entry: [number of steps including it, time before it, text, look]. */
  function entries() {
    const result = [[0, 0, "the beginning", ""]];
    let time = 0;
    for (let i = 0; i < way.length;) {
      let end = i + 1;
      const label = way[i].label;
      const tock = label.role === roles.tock;
      while (tock && end < way.length && way[end].label.role === roles.tock) ++end;
      const words = tock && end - i > 1 ? (end - i) + " time units pass" : label.text;
      result.push([end, time, words, label.hidden ? "quiet" : ""]);
      if (tock) time += end - i;
      i = end;
    }
    return result;
  }
  function allItem(count) {
    const item = element("li");
    const button = element("button", count + " steps before; show them all");
    button.type = "button";
    button.addEventListener("click", () => {
      mostEntries = Infinity;
      showWay();
    });
    item.append(button);
    return item;
  }
  function showWay() {
    const list = part("way");
    const focused = list.contains(document.activeElement);
    const all = entries();
    const left = Math.max(0, all.length - mostEntries);
    const items = all.slice(left).map((entry) => wayItem(...entry));
    if (left > 0) items.unshift(allItem(all[left - 1][0]));
    fill(list, items);
    list.scrollTop = list.scrollHeight;
    if (focused) list.lastElementChild.firstElementChild.focus();
  }
  function show(moved) {
    digits = "";
    showOffers();
    showAbsences();
    showMachines();
    showStructure();
    showFigures();
    showWay();
    part("log-text").hidden = true;
    const offers = offersOf(here()).length;
    const last = way.length === 0 ? "the beginning" : way[way.length - 1].label.text;
    say("step " + way.length + (data.timed ? ", t=" + timeOf(way.length) : "") + ": " + last + "; " +
        (offers === 1 ? "1 offer" : offers + " offers"));
    part("undo").disabled = part("start").disabled = way.length === 0;
    try {
      if (moved) history.pushState(null, "", address());
      else history.replaceState(null, "", address());
    } catch (error) {
      /* Browsers limit the number of changes of the address. */
    }
  }

  /* ---- the steps as a log, by the rules of `save` (docs/step.md) ---- */

  function logText() {
    const cycles = [{ inputs: [], rest: [] }];
    way.forEach(({ label }, index) => {
      if (label.hidden) return;
      const cycle = cycles[cycles.length - 1];
      if (label.role === roles.tock) {
        const waiting = offersOf(states[index]).find(({ label: each }) => !each.hidden && each.role === roles.output);
        if (waiting)
          throw new Error("time passes where " + waiting.label.text + " is on offer; in cycles it is done at once");
        cycle.rest.push("tock");
        cycles.push({ inputs: [], rest: [] });
      } else if (label.role === roles.termination) {
        cycle.rest.push("terminate");
      } else if (label.role === roles.input || label.role === roles.output) {
        if (label.word === null) throw new Error(label.text + " has a value with parts, which is not written to logs");
        const name = (word) => word.slice(0, word.indexOf("?"));
        if (label.role === roles.output) cycle.rest.push(label.word);
        else if (cycle.inputs.some((word) => name(word) === name(label.word)))
          throw new Error(label.text + " happens twice within one time unit; a cycle reads each input once");
        else cycle.inputs.push(label.word);
      }
    });
    const lines = cycles.map((cycle) => cycle.inputs.concat(cycle.rest).join(" ")).filter((line) => line !== "");
    return data.log + lines.map((line) => line + "\n").join("");
  }
  async function copyLog() {
    let log = "";
    try {
      log = logText();
    } catch (refusal) {
      return say("no log: " + refusal.message);
    }
    const area = part("log-text");
    area.value = log;
    area.hidden = false;
    area.select();
    try {
      await navigator.clipboard.writeText(log);
      say("the way is copied as a log");
    } catch (refusal) {
      say("the way as a log, to be copied");
    }
  }

  /* ---- keys ---- */

  function digit(key) {
    const count = offersOf(here()).length;
    digits += key;
    const number = Number(digits);
    if (number < 1 || number > count) {
      say("there is no offer " + digits);
      digits = "";
    } else if (number * 10 > count) take(number - 1);
    else say("offer " + digits + ": Enter takes it");
  }
  const keys = { u: undo, Backspace: undo, ArrowLeft: undo, t: tock, Home: start };
  document.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.altKey || event.metaKey || event.target.matches("input[type=search], textarea")) return;
    if (event.key === "Enter" && event.target.closest("summary")) return;
    if (/^[0-9]$/.test(event.key)) digit(event.key);
    else if (event.key === "Enter" && digits !== "") take(Number(digits) - 1);
    else if (event.key === "Escape") digits = "";
    else if (keys[event.key]) keys[event.key]();
    else return;
    event.preventDefault();
  });
  part("undo").addEventListener("click", undo);
  part("start").addEventListener("click", start);
  if (part("tock")) part("tock").addEventListener("click", tock);
  if (part("log")) part("log").addEventListener("click", copyLog);
  part("find").addEventListener("input", showOffers);
  part("hidden").addEventListener("change", () => {
    settle();
    show(true);
  });
  window.addEventListener("hashchange", fromAddress);
  fromAddress();
})();
