#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Compares `robochart-verify rules` with SLEEC-TK's published encoding, for a rule about a model whose measures have
many values.

The published encoding (arXiv 2307.03697) composes the rule with memories. Each measure is read once in each second, in a
fixed order, and its value is kept until the next reading (if a second ends before all are read, they are read again). The
component has to refine rule and memories in the traces model. Here the encoding is written as CSPM, with one process for
each memory, and `robochart-verify cspm` decides it over the same timed semantics of the model, up to a limit of states.
Prints both answers with states, CPU seconds and memory. With few values (first line) both are decided and agree.

Usage: benchmarks/decide_rules.py --program PROGRAM [--values N] [--limit STATES]   (benchmarks/run.py rules)
"""
import argparse
import json
import re
import tempfile
from pathlib import Path

import measured

MODEL = """package care

interface Readings { event temperature : nat event heart : nat event oxygen : nat event check }
interface Acts { callHelp() alarm() }

stm Carer {
	uses Readings
	requires Acts
	var value : nat = 0
	var hot : boolean = false, fast : boolean = false, thin : boolean = false
	clock T
	initial start
	state Temperature { }
	state Heart { }
	state Oxygen { }
	state Ready { }
	transition begin { from start to Temperature }
	transition one { from Temperature to Heart trigger temperature?value #T action hot = (value > LIMIT); value = 0 }
	transition two { from Heart to Oxygen trigger heart?value condition since(T) < 1 action fast = (value > LIMIT); value = 0 }
	transition three { from Oxygen to Ready trigger oxygen?value condition since(T) < 1 action thin = (value < LIMIT); value = 0 }
	transition help { from Ready to Ready trigger check condition since(T) < 1 /\\ hot /\\ fast /\\ not thin action callHelp() }
	transition warn { from Ready to Ready trigger check condition since(T) < 1 /\\ hot /\\ fast /\\ thin action alarm() }
	transition well { from Ready to Ready trigger check condition since(T) < 1 /\\ not (hot /\\ fast) }
	transition late { from Heart to Temperature condition since(T) >= 1 action hot = false }
	transition later { from Oxygen to Temperature condition since(T) >= 1 action hot = false; fast = false }
	transition again { from Ready to Temperature condition since(T) >= 1 action hot = false; fast = false; thin = false }
}
"""

RULES = """def_start
    event check
    event callHelp
    event alarm
    measure temperature : numeric
    measure heart : numeric
    measure oxygen : numeric
def_end
rule_start
    Help when check and temperature > LIMIT and heart > LIMIT then callHelp within 30 seconds
        unless oxygen < LIMIT then alarm within 5 seconds
rule_end
"""

# Every second starts with one reading of each measure, in the order of the text; then the events of the rule may occur.
PUBLISHED = """
Values = {0..MOST}
channel r_temperature, r_heart, r_oxygen, i_temperature, i_heart, i_oxygen : Values
channel e_check, e_callHelp, e_alarm
Events_ = {e_check, e_callHelp, e_alarm}

Order = r_temperature?x -> (r_heart?y -> (r_oxygen?z -> Running [] tock -> Order) [] tock -> Order) [] tock -> Order
Running = ([] e : Events_ @ e -> Running) [] tock -> Order
Memory(read, inner) = let Holds(x) = inner!x -> Holds(x) [] read?y -> Holds(y) within read?x -> Holds(x)
Memories = (Memory(r_temperature, i_temperature) ||| Memory(r_heart, i_heart)) ||| Memory(r_oxygen, i_oxygen)

Trigger = e_check -> i_temperature?t -> i_heart?h -> (if t > LIMIT and h > LIMIT then Monitor else Trigger)
          [] e_callHelp -> Trigger [] e_alarm -> Trigger [] tock -> Trigger
Monitor = i_oxygen?o -> (if o < LIMIT then Until(e_alarm, 5) else Until(e_callHelp, 30))
Until(e, n) = e -> Trigger [] n > 0 & tock -> Until(e, n - 1)

Readings_ = {| r_temperature, r_heart, r_oxygen |}
Inner = {| i_temperature, i_heart, i_oxygen |}
Rule = ((Order [| Readings_ |] Memories) [| union(Inner, union(Events_, {tock})) |] TimedTrigger) \\ Inner
TimedTrigger = Trigger
Component = COMPONENT[[ CHANNELS ]]
assert Rule [T= Component
"""


def write(folder, values):
    limit = str(values // 2)
    most = str(values - 1)
    (folder / "care.rct").write_text(MODEL.replace("LIMIT", limit))
    (folder / "care.sleec").write_text(RULES.replace("LIMIT", limit))
    return limit, most


def ours(options, folder, values):
    child = measured.run([options.program, "rules", "care.sleec", "care.rct", "--range", f"nat=0..{values - 1}",
                          "--format", "json", "--no-cache"], folder)
    verdict = json.loads(child.output)["verdicts"][0]
    return verdict["verdict"], str(verdict["states"]), child


def published(options, folder, values, limit, most):
    emitted = measured.run([options.program, "emit", "csp", "care.rct", "--timed", "--range", f"nat=0..{values - 1}",
                            "-o", "emitted"], folder)
    scripts = sorted((folder / "emitted" / "csp-gen").rglob("*.csp"))
    if emitted.exit != 0 or not scripts:
        raise SystemExit(emitted.said())
    timed = next(path for path in scripts if "timed" in str(path))
    links = ", ".join(f"care::Carer::{name}.in <- r_{name}" for name in ("temperature", "heart", "oxygen"))
    links += ", care::Carer::check.in <- e_check, care::Carer::callHelpCall <- e_callHelp, care::Carer::alarmCall <- e_alarm"
    text = PUBLISHED.replace("LIMIT", limit).replace("MOST", most).replace("CHANNELS", links)
    text = text.replace("COMPONENT", "care::Carer::D__(0)")
    script = folder / "published.csp"
    script.write_text(timed.read_text() + text)
    number = len(re.findall(r"^assert", script.read_text(), re.MULTILINE))
    child = measured.run([options.program, "cspm", "published.csp", "--assertion", str(number), "--brief", "--no-cache",
                          "--progress", "never", "--max-states", str(options.limit), "--memory", "12GiB"], folder)
    said = " ".join(child.said().split())
    reached = re.search(r"the limit of (\d+) states was reached", said)
    if reached:
        return "not decided", f"more than {int(reached.group(1)):,}", child
    states = re.search(r"([\d,]+) states", said)
    return {0: "refines", 1: "does not refine"}.get(child.exit, said), states.group(1) if states else "?", child


def line(what, values, word, states, child):
    print(f"{what:10} {values:4} values  {word}; {states} states, {child.cpu:.1f} CPU s, {child.wall:.1f} s, "
          f"{child.rss / 2**20:.0f} MiB", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", required=True)
    parser.add_argument("--values", type=int, default=150)
    parser.add_argument("--limit", type=int, default=20_500_000)
    options = parser.parse_args()
    options.program = str(Path(options.program).resolve())
    for values in (8, options.values):
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name)
            limit, most = write(folder, values)
            line("rules", values, *ours(options, folder, values))
            line("published", values, *published(options, folder, values, limit, most))


if __name__ == "__main__":
    main()
