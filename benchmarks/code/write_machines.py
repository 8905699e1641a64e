#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes the machines of the code benchmark: each as a RoboChart model (../models) and as a nested switch.

M1: two states, two events. M2: three states with a clock, two booleans, a during action. M3: three levels with 20
states, six of them composite, 40 transitions between siblings of which 12 have guards, entry, exit and transition
actions everywhere, 8 events. M4: flat, 100 states, 200 transitions, 8 events. Every action is one store to an actuator.
Usage: write_machines.py; it writes the models, which are stored because tests read them. The benchmark calls
`write_switches` (../bench_code.py); the switch of M2 is written by hand.
"""
import pathlib
import random

HERE = pathlib.Path(__file__).resolve().parent
MODELS = HERE.parent / "models"


class State:
    def __init__(self, name, parent=None):
        self.name, self.parent, self.children, self.ways = name, parent, [], []
        self.entry = self.exit = 0
        if parent:
            parent.children.append(self)

    @property
    def path(self):
        return (self.parent.path + "_" if self.parent else "") + self.name


class Way:
    def __init__(self, name, source, target, event, action, guard=None, update=False):
        self.name, self.source, self.target, self.event, self.action = name, source, target, event, action
        self.guard, self.update = guard, update


def nested():
    """M3."""
    choice = random.Random(3)
    top = [State(f"T{i}") for i in range(4)]
    regions = [top]
    for i, (second, third) in enumerate([(3, 3), (3, 3), (2, 2)]):
        regions.append([State(f"U{k}", top[i]) for k in range(second)])
        regions.append([State(f"V{k}", regions[-1][0]) for k in range(third)])
    states = [state for region in regions for state in region]
    for number, state in enumerate(states):
        state.entry, state.exit = 100 + number, 200 + number
    guarded = set(choice.sample(range(40), 12))
    number = 0
    for region in regions:
        for state in region:
            for event in choice.sample(range(8), 2):
                target = choice.choice([other for other in region if other is not state])
                guard = choice.randrange(3) if number in guarded else None
                state.ways.append(Way(f"t{number}", state, target, event, 300 + number, guard, number % 5 == 0))
                number += 1
    return top


def flat():
    """M4."""
    choice = random.Random(4)
    states = [State(f"S{i}") for i in range(100)]
    number = 0
    for state in states:
        for event in choice.sample(range(8), 2):
            state.ways.append(Way(f"t{number}", state, choice.choice(states), event, 300 + number))
            number += 1
    return states


def pair():
    """M1."""
    moving, stopped = State("Moving"), State("Stopped")
    moving.ways.append(Way("t0", moving, stopped, 0, 1))
    stopped.ways.append(Way("t1", stopped, moving, 1, 2))
    return [moving, stopped]


def program(way):
    text = f"act ( {way.action} )"
    return text + " ; if v >= 3 then v = 0 else v = v + 1 end" if way.update else text


def model_state(state, lines, depth):
    tab = "\t" * depth
    lines.append(f"{tab}state {state.name} {{")
    if state.entry:
        lines.append(f"{tab}\tentry act ( {state.entry} )")
        lines.append(f"{tab}\texit act ( {state.exit} )")
    model_region(state.children, lines, depth + 1)
    lines.append(f"{tab}}}")


def model_region(states, lines, depth):
    if not states:
        return
    tab = "\t" * depth
    lines.append(f"{tab}initial i")
    lines.append(f"{tab}transition begin {{ from i to {states[0].name} }}")
    for state in states:
        model_state(state, lines, depth)
    for state in states:
        for way in state.ways:
            guard = f" condition v <= {way.guard}" if way.guard is not None else ""
            lines.append(f"{tab}transition {way.name} {{ from {state.name} to {way.target.name} "
                         f"trigger e{way.event}{guard} action {program(way)} }}")


def model(name, states, events, variable):
    lines = [f"// Machine {name} of the code benchmark (benchmarks/code/write_machines.py).", f"package {name.lower()}",
             "", "interface Actuator {", "\tact ( value : nat )", "}", "", f"stm {name} {{", "\trequires Actuator"]
    lines += [f"\tevent e{i}" for i in range(events)]
    if variable:
        lines.append("\tvar v : nat = 0")
    model_region(states, lines, 1)
    lines.append("}")
    (MODELS / f"{name.lower()}.rct").write_text("\n".join(lines) + "\n")


def leaves(state):
    return [leaf for child in state.children for leaf in leaves(child)] if state.children else [state]


def first(state):
    return first(state.children[0]) if state.children else state


def entries(state):
    """Entry actions from a state to its first leaf."""
    return ([state.entry] if state.entry else []) + (entries(state.children[0]) if state.children else [])


def switch_case(way, lines, depth):
    """The entries of the target are constant; the exits below a composite source are in a separate switch."""
    tab = "    " * depth
    source, target = way.source, way.target
    if source.entry:
        lines.append(f"{tab}leave_{source.path}(s);" if source.children else f"{tab}act({source.exit});")
    lines.append(f"{tab}act({way.action});")
    if way.update:
        lines.append(f"{tab}s.v = s.v >= 3 ? 0 : s.v + 1;")
    for entry in entries(target):
        lines.append(f"{tab}act({entry});")
    lines.append(f"{tab}s.at = At::{first(target).path};")
    lines.append(f"{tab}return true;")


def switch_function(state, lines):
    """A composite state's own transitions, for all its leaves."""
    lines += ["", f"inline bool on_{state.path}(State& s, unsigned e) {{", "    switch (e) {"]
    switch_events(state, lines, 2)
    lines += ["        default: break;", "    }", "    return false;", "}"]


def switch_events(state, lines, depth):
    tab = "    " * depth
    for way in state.ways:
        if way.guard is not None or source_acts(way):
            lines.append(f"{tab}case {way.event}:")
            if way.guard is not None:
                lines.append(f"{tab}    if (s.v > {way.guard}) break;")
            switch_case(way, lines, depth + 1)
        else:
            lines.append(f"{tab}case {way.event}: act({way.action}); s.at = At::{way.target.path}; return true;")


def source_acts(way):
    """Whether there are exit or entry actions in addition to the action of the transition."""
    return way.source.entry or way.update


def around(leaf):
    result, at = [], leaf.parent
    while at:
        result.append(at)
        at = at.parent
    return result


def leave_function(state, lines):
    lines += ["", f"inline void leave_{state.path}(State& s) {{", "    switch (s.at) {"]
    for child in state.children:
        for leaf in leaves(child):
            lines.append(f"        case At::{leaf.path}:")
        lines.append(f"            leave_{child.path}(s);" if child.children else f"            act({child.exit});")
        lines.append("            break;")
    lines += ["        default: break;", "    }", f"    act({state.exit});", "}"]


def composites(states):
    """Composite states, inner ones first."""
    return [found for state in states if state.children for found in composites(state.children) + [state]]


def enumerators(every):
    names = [leaf.path for leaf in every]
    return ["    " + ", ".join(names[i:i + 10]) + "," for i in range(0, len(names), 10)]


def write_switch(name, states, variable, folder):
    inner = composites(states)
    every = [leaf for state in states for leaf in leaves(state)]
    lines = [f"// Machine {name} of the code benchmark as hand-written code: a switch on the state, with a nested switch on "
             "the event.", "// Transitions of a composite state are tried after those of its children.", "#pragma once", "",
             "#include <cstdint>", "", '#include "actuator.hpp"', "", f"namespace by_hand_{name.lower()} {{", "",
             "enum class At : std::uint8_t {", *enumerators(every), "};", "", "struct State {"]
    if variable:
        lines.append("    std::uint32_t v = 0;")
    lines += [f"    At at = At::{first(states[0]).path};", "};", "", "inline void begin(State&) {"]
    lines += [f"    act({entry});" for entry in entries(states[0])] + ["}"]
    for state in inner:
        leave_function(state, lines)
    for state in inner:
        switch_function(state, lines)
    lines += ["", "inline bool step(State& s, unsigned e) {", "    switch (s.at) {"]
    for leaf in every:
        lines += [f"        case At::{leaf.path}:", "            switch (e) {"]
        switch_events(leaf, lines, 4)
        lines += ["                default: break;", "            }"]
        outer = " || ".join(f"on_{state.path}(s, e)" for state in around(leaf))
        lines.append(f"            return {outer or 'false'};")
    lines += ["    }", "    return false;", "}", "", f"}}  // namespace by_hand_{name.lower()}"]
    (folder / f"{name.lower()}_switch.hpp").write_text("\n".join(lines) + "\n")


def machines():
    """Name, states and number of events."""
    return ("M1", pair(), 2), ("M3", nested(), 8), ("M4", flat(), 8)


def write_switches(folder):
    for name, states, _ in machines():
        write_switch(name, states, name == "M3", folder)


def main():
    for name, states, events in machines():
        model(name, states, events, name == "M3")


if __name__ == "__main__":
    main()
