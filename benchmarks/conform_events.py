#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Measures how the time of `conform` grows with the number of events. The model is a delivery trolley with 8 events. Each
further event has a transition in the state Loading.

Usage: benchmarks/conform_events.py --program PROGRAM [EVENTS...]   (benchmarks/run.py events)
EVENTS: numbers of events, 8 or more; default: 8 12 16 30
"""
import argparse
import json
import tempfile
from pathlib import Path

import measured

OWN_EVENTS = ["hindered", "passable", "reached", "weak", "plugged", "full", "stop", "resume"]

MODEL = """package trolley

interface Drive {{ headFor(place : nat) rest() retreat() plug() freeze() complain() }}
interface Signals {{ {declarations} }}
robotic platform Chassis {{ provides Drive uses Signals }}

stm Deliver {{
	const places : nat = 4
	const patience : nat = 30
	const retreating : nat = 20
	const trials : nat = 3
	var place : nat = 0
	var trial : nat = 0
	var exhausted : boolean = false
	clock T
	requires Drive
	uses Signals
	initial start
	state Working {{
		initial i
		state Delivering {{
			initial j
			state Rolling {{ entry headFor(place) }}
			state Waiting {{ entry rest() }}
			state Retreating {{ entry retreat() }}
			state Trapped {{ entry rest(); complain() }}
			transition d0 {{ from j to Rolling }}
			transition d1 {{ from Rolling to Rolling trigger reached action place = (place + 1) % places; trial = 0 }}
			transition d2 {{ from Rolling to Waiting trigger hindered #T }}
			transition d3 {{ from Waiting to Rolling trigger passable action trial = 0 }}
			transition d4 {{ from Waiting to Retreating condition since(T) >= patience /\\ trial < trials action trial = trial + 1; #T }}
			transition d5 {{ from Retreating to Rolling condition since(T) >= retreating }}
			transition d6 {{ from Waiting to Trapped condition since(T) >= patience /\\ trial >= trials }}
			transition d7 {{ from Trapped to Rolling trigger passable action trial = 0 }}
		}}
		state Plugging {{ entry plug() }}
		state Loading {{ entry rest() }}
		junction energy
		transition w0 {{ from i to energy }}
		transition w1 {{ from energy to Plugging condition exhausted }}
		transition w2 {{ from energy to Delivering condition not exhausted }}
		transition w3 {{ from Delivering to Plugging trigger weak action exhausted = true }}
		transition w4 {{ from Plugging to Loading trigger plugged }}
		transition w5 {{ from Loading to Delivering trigger full action exhausted = false }}
{more}	}}
	state Frozen {{ entry freeze() }}
	transition t0 {{ from start to Working }}
	transition t1 {{ from Working to Frozen trigger stop }}
	transition t2 {{ from Frozen to Frozen trigger weak action exhausted = true }}
	transition t3 {{ from Frozen to Working trigger resume }}
}}

controller Steering {{
	requires Drive
	uses Signals
	sref deliver = Deliver
{inner}}}

module Trolley {{
	rref chassis = Chassis
	cref steering = Steering
{outer}}}
"""


def model_text(count):
    events = OWN_EVENTS + [f"notice{n}" for n in range(1, count - len(OWN_EVENTS) + 1)]
    lines = lambda template, names: "".join(template.format(e=name) for name in names)
    return MODEL.format(
        declarations=" ".join(f"event {event}" for event in events),
        more=lines("\t\ttransition x_{e} {{ from Loading to Loading trigger {e} }}\n", events[len(OWN_EVENTS):]),
        inner=lines("\tconnection Steering on {e} to deliver on {e}\n", events),
        outer=lines("\tconnection chassis on {e} to steering on {e} (_async)\n", events))


def measure(program, count):
    with tempfile.TemporaryDirectory() as folder:
        (Path(folder) / "trolley.rct").write_text(model_text(count))
        run = measured.run([program, "conform", folder, "--component", "Trolley", "--format", "json", "--no-cache"])
    result = json.loads(run.output)["conformance"][0]
    print(f"{count:3} events: {result['outcome']}, {result['codeStates']:,} states, {result['codeCycles']:,} cycles, "
          f"{run.cpu:.1f} s of CPU time", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", required=True)
    parser.add_argument("events", nargs="*", type=int, default=[8, 12, 16, 30])
    options = parser.parse_args()
    for count in options.events:
        measure(options.program, count)


if __name__ == "__main__":
    main()
