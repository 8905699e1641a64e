(function () {
  document.documentElement.classList.add("scripted");
  const source = document.getElementById("data");
  if (!source) return;
  const data = JSON.parse(source.textContent);
  const letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_";
  const value = new Map(Array.from(letters, (letter, index) => [letter, index]));
  const get = (id) => document.getElementById(id);
  const slider = get("time"), clock = get("clock"), play = get("play"), status = get("status");
  const choice = { trial: get("trial"), robot: get("robot"), speed: get("speed"), links: get("links"), trail: get("trail") };
  const world = document.querySelector(".sim-scene > svg");
  const uses = Array.from(world.querySelectorAll(".sim-robot"));
  const counts = Array.from(document.querySelectorAll(".sim-count"));
  const figures = Array.from(document.querySelectorAll("figure[data-machine]"));
  const rows = Array.from(get("pose").querySelectorAll("td"));
  const plots = Array.from(document.querySelectorAll(".sim-plot"));
  const calm = matchMedia("(prefers-reduced-motion: reduce)");
  const [left, top_, width, height] = data.view;
  const record = 6 + 2 * data.machines;
  let trial = null, frames = [], now = 0, playing = null, shownStates = "";

  // The robots of a frame: x, y (upwards), heading in radians, the states of the machines.
  function robots(text) {
    const number = (at) => 64 * value.get(text[at]) + value.get(text[at + 1]);
    const list = [];
    for (let at = 0; at < text.length; at += record) {
      const states = [];
      for (let m = 0; m < data.machines; ++m) states.push(number(at + 6 + 2 * m));
      list.push({ x: left + width * number(at) / 4095, y: -(top_ + height * number(at + 2) / 4095),
                  heading: 2 * Math.PI * number(at + 4) / 4096, states: states });
    }
    return list;
  }
  const turn = (angle) => angle - 2 * Math.PI * Math.round(angle / (2 * Math.PI));
  function frameAt(time) {
    let index = 0;
    while (index + 1 < trial.times.length && trial.times[index + 1] <= time + 1e-9) ++index;
    return index;
  }
  function between(index, time) {
    const here = frames[index], next = frames[index + 1];
    const share = next && !calm.matches ? (time - trial.times[index]) / (trial.times[index + 1] - trial.times[index]) : 0;
    if (!(share > 0)) return here;
    return here.map((a, r) => ({ x: a.x + share * (next[r].x - a.x), y: a.y + share * (next[r].y - a.y),
                                 heading: a.heading + share * turn(next[r].heading - a.heading), states: a.states }));
  }
  const fixed = (number) => (Math.round(number * 10) / 10).toFixed(1);
  const name = (machine, state) => data.states[machine].names[state] || "between states";

  function drawRobots(list) {
    const total = counts.map(() => 0);
    list.forEach((robot, r) => {
      const state = Math.min(robot.states[0], counts.length - 1);
      ++total[state];
      uses[r].setAttribute("transform", "translate(" + robot.x.toFixed(2) + " " + (-robot.y).toFixed(2) + ") rotate(" +
                                        (-robot.heading * 180 / Math.PI).toFixed(1) + ")");
      if (uses[r].getAttribute("href") !== "#w" + state) uses[r].setAttribute("href", "#w" + state);
    });
    counts.forEach((count, state) => { count.textContent = total[state]; });
  }
  function drawLinks(list) {
    let path = "";
    if (choice.links && choice.links.checked)
      for (let a = 0; a < list.length; ++a)
        for (let b = a + 1; b < list.length; ++b)
          if (Math.hypot(list[a].x - list[b].x, list[a].y - list[b].y) <= data.link)
            path += "M" + fixed(list[a].x) + " " + fixed(-list[a].y) + "L" + fixed(list[b].x) + " " + fixed(-list[b].y);
    world.querySelector(".sim-links").setAttribute("d", path);
  }
  function drawChosen(list, index) {
    const chosen = Number(choice.robot.value), robot = list[chosen];
    const ring = world.querySelector(".sim-chosen");
    ring.setAttribute("cx", robot.x.toFixed(2));
    ring.setAttribute("cy", (-robot.y).toFixed(2));
    let path = "";
    if (choice.trail.checked) {
      for (let f = 0; f <= index; ++f) path += (f ? "L" : "M") + fixed(frames[f][chosen].x) + " " + fixed(-frames[f][chosen].y);
      path += "L" + fixed(robot.x) + " " + fixed(-robot.y);
    }
    world.querySelector(".sim-trail").setAttribute("d", path);
    const texts = [fixed(robot.x) + " cm", fixed(robot.y) + " cm", (turn(robot.heading) * 180 / Math.PI).toFixed(0) + "°"];
    robot.states.forEach((state, machine) => texts.push(name(machine, state)));
    rows.forEach((cell, i) => { cell.textContent = texts[i]; });
    const kind = data.kinds.filter((first) => first <= chosen).length - 1;
    if (shownStates === kind + ":" + robot.states.join()) return;
    shownStates = kind + ":" + robot.states.join();
    for (const figure of figures) {
      figure.hidden = Number(figure.dataset.kind) !== kind;
      for (const part of figure.querySelectorAll(".on")) part.classList.remove("on");
      const machine = Number(figure.dataset.machine);
      for (const id of data.states[machine].elements[robot.states[machine]] || [])
        for (const part of figure.querySelectorAll('[data-element="' + id + '"]')) part.classList.add("on");
    }
  }
  function draw(time) {
    now = Math.max(0, Math.min(trial.times[trial.times.length - 1], time));
    const index = frameAt(now), list = between(index, now);
    drawRobots(list);
    drawLinks(list);
    drawChosen(list, index);
    slider.value = index;
    clock.textContent = fixed(now) + " s";
    slider.setAttribute("aria-valuetext", fixed(now) + " seconds");
    for (const plot of plots) {
      const x = Number(plot.dataset.left) + Number(plot.dataset.width) * now / Number(plot.dataset.end);
      const line = plot.querySelector(".sim-now");
      line.setAttribute("x1", x);
      line.setAttribute("x2", x);
    }
    return index;
  }
  // Changes made by the reader are announced in the status line and stored in the address.
  function show(time, silent) {
    const index = draw(time);
    if (silent) return;
    const robot = Number(choice.robot.value);
    const stop = trial.stop && trial.stop.robot === robot ? "; it stopped at " + fixed(trial.stop.time) + " s: " + trial.stop.why : "";
    status.textContent = "trial " + trial.number + ", " + fixed(now) + " s: robot " + robot + " in " +
                         frames[index][robot].states.map((state, m) => name(m, state)).join(", ") + stop;
    history.replaceState(null, "", "#trial/" + trial.number + "/frame/" + index + "/robot/" + robot);
  }
  function step(by) { stop(); show(trial.times[Math.max(0, Math.min(trial.times.length - 1, frameAt(now) + by))]); }
  function choose(robot) { choice.robot.value = Math.max(0, Math.min(data.robots - 1, robot)); show(now); }
  function chooseTrial(index) {
    trial = data.trials[index];
    choice.trial.value = index;
    frames = trial.frames.map(robots);
    shownStates = "";
    slider.max = trial.times.length - 1;
    if (trial.stop && trial.stop.robot < data.robots) choice.robot.value = trial.stop.robot;
    for (const line of document.querySelectorAll(".sim-trial"))
      line.classList.toggle("shown", Number(line.dataset.trial) === trial.number - 1);
  }

  function stop() {
    if (playing !== null) cancelAnimationFrame(playing);
    playing = null;
    play.textContent = "play";
  }
  function start() {
    if (now >= trial.times[trial.times.length - 1]) draw(0);
    play.textContent = "pause";
    let before = null;
    // For readers who prefer less motion, the time changes twice a second, without movement in between.
    const tick = (at) => {
      if (before === null) before = at;
      if (!calm.matches || at - before >= 500) {
        draw(now + (at - before) / 1000 * Number(choice.speed.value));
        before = at;
      }
      if (now >= trial.times[trial.times.length - 1]) { stop(); show(now); } else playing = requestAnimationFrame(tick);
    };
    playing = requestAnimationFrame(tick);
  }
  function toggle() { if (playing === null) start(); else step(0); }
  function move(where) {
    if (where === "first") step(-trial.times.length);
    if (where === "back") step(-1);
    if (where === "next") step(1);
    if (where === "last") step(trial.times.length);
  }

  play.addEventListener("click", toggle);
  slider.addEventListener("input", () => { stop(); show(trial.times[Number(slider.value)]); });
  for (const button of document.querySelectorAll("[data-move]")) button.addEventListener("click", () => move(button.dataset.move));
  choice.trial.addEventListener("change", () => { stop(); chooseTrial(Number(choice.trial.value)); show(now); });
  choice.robot.addEventListener("change", () => show(now));
  for (const box of [choice.links, choice.trail]) if (box) box.addEventListener("change", () => draw(now));
  world.addEventListener("click", (event) => {
    const robot = event.target.closest(".sim-robot");
    if (robot) choose(Number(robot.dataset.robot));
  });
  for (const plot of plots)
    plot.addEventListener("click", (event) => {
      const at = new DOMPoint(event.clientX, event.clientY).matrixTransform(plot.getScreenCTM().inverse()).x;
      stop();
      show(trial.times[frameAt((at - Number(plot.dataset.left)) / Number(plot.dataset.width) * Number(plot.dataset.end))]);
    });
  document.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.altKey || event.metaKey || event.target.closest("select, summary, a")) return;
    const field = event.target.closest("input, button");
    const act = { ArrowRight: () => step(1), k: () => step(-1), j: () => step(1), ArrowLeft: () => step(-1), Home: () => move("first"),
                  End: () => move("last"), "[": () => choose(Number(choice.robot.value) - 1),
                  "]": () => choose(Number(choice.robot.value) + 1), " ": field ? undefined : toggle }[event.key];
    if (!act) return;
    event.preventDefault();
    act();
  });
  function fromAddress() {
    const match = /^#trial\/([0-9]+)(?:\/frame\/([0-9]+))?(?:\/robot\/([0-9]+))?$/.exec(location.hash);
    const index = match ? data.trials.findIndex((each) => each.number === Number(match[1])) : 0;
    if (index < 0 || !match && trial) return;
    stop();
    chooseTrial(index);
    if (match && match[3] !== undefined) choice.robot.value = Math.min(data.robots - 1, Number(match[3]));
    const last = trial.times.length - 1;
    show(trial.times[match && match[2] !== undefined ? Math.min(last, Number(match[2])) : last], !match);
    if (match) get("world").scrollIntoView();
  }
  const longest = Math.max(...data.trials.map((each) => each.times[each.times.length - 1]));
  const speeds = Array.from(choice.speed.options, (option) => Number(option.value));
  choice.speed.value = speeds.reduce((best, speed) => Math.abs(longest / speed - 20) < Math.abs(longest / best - 20) ? speed : best);
  get("pose").hidden = false;
  addEventListener("hashchange", fromAddress);
  fromAddress();
})();
