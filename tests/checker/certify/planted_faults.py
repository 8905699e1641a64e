#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Plants faults in a copy of the checker, and asks whether the certifier notices the wrong answers.

planted_faults.py BUILD FOLDER: copies the sources to FOLDER, plants all faults there, builds the command once, and runs
random scripts with one fault at a time. If a fault changes an answer to `holds`, the certificate of the claim must be
refused, or there must be none. Prints a line for each fault. Exits with 1 if a certificate of a wrong answer is accepted.
BUILD has robochart-certify, and the command without faults, whose answers are the expected ones.
planted_faults.py --plant ROOT plants the faults in these sources. planted_faults.py --run PROGRAM FAULTY CERTIFIER
FOLDER does the rest."""

import json
import os
import pathlib
import random
import shutil
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[3]
SEARCH = "checker/refine/search/"
VERDICT = "checker/refine/verdict/"
MACHINE = "checker/machine/"

# Each fault: its name, the file, the text that it replaces, and its text, in which FAULT is whether it is active.
FAULTS = [
    # The search.
    ("a fault of a state is overlooked", SEARCH + "expansion.cpp", "pair_.fault = monitor_.examine(node_, offer_);",
     "if (!FAULT) pair_.fault = monitor_.examine(node_, offer_);"),
    ("a forbidden event is overlooked", SEARCH + "expansion.cpp",
     "if (next.effect == Monitor::Effect::violation) pair_.forbidden = event;",
     "if (next.effect == Monitor::Effect::violation && !FAULT) pair_.forbidden = event;"),
    ("remembered answers of another node", SEARCH + "expansion.cpp",
     "if (remembered.event != event || remembered.node != node_)",
     "if (remembered.event != event || (remembered.node != node_ && !FAULT))"),
    ("taus are not followed", SEARCH + "expansion.cpp", "return add_row(node_, target, true);",
     "if (FAULT) return;\n        return add_row(node_, target, true);"),
    ("visible events are not followed", SEARCH + "expansion.cpp",
     "if (next.effect == Monitor::Effect::follow) add_row(next.node, target, false);",
     "if (next.effect == Monitor::Effect::follow && !FAULT) add_row(next.node, target, false);"),
    ("the node does not change", SEARCH + "expansion.cpp",
     "add_row(next.node, target, false);", "add_row(FAULT ? node_ : next.node, target, false);"),
    ("deadlock searches follow taus alone", SEARCH + "expansion.cpp",
     "if (!taus_alone_) add_row(node_, target, false);", "if (!taus_alone_ && !FAULT) add_row(node_, target, false);"),
    ("only faults of the first state count", SEARCH + "search.cpp",
     "if (pair.fault) return Finding{*pair.fault, first};",
     "if (pair.fault && (first == 0 || !FAULT)) return Finding{*pair.fault, first};"),
    ("a forbidden event is forgotten after its level", SEARCH + "search.cpp", "if (forbidden_) return forbidden_;",
     "if (forbidden_ && !FAULT) return forbidden_;"),
    ("the search ends after two levels", SEARCH + "search.cpp",
     "for (StateIndex first = 0; first != pairs_.size(); ++level) {",
     "for (StateIndex first = 0; first != pairs_.size() && !(FAULT && level == 2); ++level) {"),
    ("every seventh target is lost", SEARCH + "search.cpp",
     "if ((i - first) % between_counts == between_counts - 1) budget_.states(pairs_.size());",
     "if ((i - first) % between_counts == between_counts - 1) budget_.states(pairs_.size());\n"
     "        if (FAULT && i % 7 == 6) continue;"),
    ("the last pair of a level is not expanded", SEARCH + "search.cpp", "return search_alone(first, end);",
     "return search_alone(first, FAULT && end - first > 1 ? end - 1 : end);"),
    ("cycles of one tau do not count", SEARCH + "tau_cycle.cpp",
     "if (cyclic) least =", "if (cyclic && !(FAULT && members.size() == 1)) least ="),
    ("taus back are not noted", SEARCH + "tau_cycle.cpp", "marked_[vertex] = true;", "marked_[vertex] = !FAULT;"),
    ("antichains keep the larger nodes", SEARCH + "antichain.cpp",
     "return std::any_of(nodes.begin(), end, [&](Monitor::Node smaller) { return monitor.includes(node, smaller); });",
     "return std::any_of(nodes.begin(), end, [&](Monitor::Node smaller) { return FAULT || monitor.includes(node, smaller); });"),
    # What is forbidden.
    ("an unknown event is ignored", VERDICT + "monitors.cpp", "if (!next) return {Effect::violation};",
     "if (!next) return {FAULT ? Effect::ignore : Effect::violation};"),
    ("every node diverges", VERDICT + "monitors.cpp",
     "if (model_ == Model::failures_divergences && specification_.diverges(*next)) return {Effect::ignore};",
     "if (model_ == Model::failures_divergences && (FAULT || specification_.diverges(*next))) return {Effect::ignore};"),
    ("a state with a choice counts as unstable", VERDICT + "monitors.cpp",
     "if (offer.tau && !offer.can_tick()) return std::nullopt;",
     "if ((offer.tau || (FAULT && offer.events.size() > 1)) && !offer.can_tick()) return std::nullopt;"),
    ("the first event of an acceptance is enough", VERDICT + "monitors.cpp",
     "return std::includes(first, last, required.begin(), required.end());",
     "return FAULT ? required.empty() || std::find(first, last, required.front()) != last\n"
     "                     : std::includes(first, last, required.begin(), required.end());"),
    ("deadlocks are overlooked", VERDICT + "monitors.cpp", "return forbid_deadlock_ && offer.is_empty() ?",
     "return forbid_deadlock_ && offer.is_empty() && !FAULT ?"),
    # The normal form.
    ("an event leads to the targets of all events", VERDICT + "normal_form.cpp",
     "for (const ChoiceGraph::Edge& edge : graph_.edges(member, event)) targets.push_back(edge.target);",
     "for (const ChoiceGraph::Edge& edge : FAULT ? graph_.edges(member) : graph_.edges(member, event))\n"
     "                targets.push_back(edge.target);"),
    ("every node accepts nothing", VERDICT + "normal_form.cpp",
     "data.acceptances = minimal_sets(std::move(all), budget_);",
     "if (FAULT) all.emplace_back();\n    data.acceptances = minimal_sets(std::move(all), budget_);"),
    ("a tau is a divergence", VERDICT + "normal_form.cpp",
     "found = reached == on_path || reached == infinite;",
     "found = reached == on_path || reached == infinite || (FAULT && reached == finite);"),
    ("large nodes are the first node", VERDICT + "normal_form.cpp",
     "budget_.states(nodes_.size());\n    if (!may_grow_",
     "if (FAULT && seeds.size() > 2 && !nodes_.empty()) return 0;\n    budget_.states(nodes_.size());\n    if (!may_grow_"),
    ("states of the specification with tau accept, too", VERDICT + "lazy_graph.cpp", "offer.tau = true;",
     "offer.tau = !FAULT;"),
    ("smaller acceptances are added", VERDICT + "choice_graph.cpp",
     "if (!contains_smaller) minimal.push_back(std::move(set));",
     "if (FAULT && !set.empty()) set.pop_back();\n        if (!contains_smaller) minimal.push_back(std::move(set));"),
    # Reductions and static proofs.
    ("no implementation diverges", VERDICT + "check.cpp", "!is_tau_acyclic(implementation, budget)",
     "!(FAULT || is_tau_acyclic(implementation, budget))"),
    ("no process diverges", VERDICT + "check.cpp", "forbid_divergence && !is_tau_acyclic(system, budget)",
     "forbid_divergence && !(FAULT || is_tau_acyclic(system, budget))"),
    ("every specification is indifferent to exchanges", VERDICT + "indifference.cpp",
     "if (!holds_at(node, exchange)) return false;", "if (!FAULT && !holds_at(node, exchange)) return false;"),
    ("acceptances need not be indifferent", VERDICT + "indifference.cpp",
     "if (model_ == Model::traces) return true;", "if (model_ == Model::traces || FAULT) return true;"),
    ("all taus commute", MACHINE + "confluence.cpp", "if (!commutes_with(rule, other, state)) {",
     "if (!FAULT && !commutes_with(rule, other, state)) {"),
    ("confluent rules may have several results", MACHINE + "confluence.cpp",
     "if (!is_deterministic(rule, state)) return false;", "if (!FAULT && !is_deterministic(rule, state)) return false;"),
    ("confluence ignores priorities", MACHINE + "confluence.cpp",
     "if (cannot_fire(rules_->rules[by], tracked, state)) continue;",
     "if (FAULT || cannot_fire(rules_->rules[by], tracked, state)) continue;"),
    ("components with other transitions are equal", MACHINE + "exchange.cpp",
     "std::ranges::sort(expected);\n        if (mapped != expected) return false;\n    }\n    return true;",
     "std::ranges::sort(expected);\n        if (!FAULT && mapped != expected) return false;\n    }\n    return true;"),
    # Successors by rules.
    ("rules of the same level prevent each other", MACHINE + "supercombinator_system.cpp",
     "system_.best_level(number_) < rule.level) return;",
     "system_.best_level(number_) < rule.level + (FAULT ? 1 : 0)) return;"),
    ("rules do not assign states", MACHINE + "supercombinator_system.cpp",
     "for (std::uint32_t i = rule.first_assignment; i < rule.end_assignment; ++i)",
     "for (std::uint32_t i = rule.first_assignment; i < rule.end_assignment && !FAULT; ++i)"),
    ("the first transition of a participant is the only one", MACHINE + "supercombinator_system.cpp",
     "take_step(rule, participant.index, edge, next, revealed);\n            return;",
     "{\n                take_step(rule, participant.index, edge, next, revealed);\n                if (FAULT) break;\n"
     "            }\n            return;"),
    # The compilation of terms, which certificates at the term level do not use.
    ("every event is hidden", MACHINE + "combine.cpp",
     "terms_.contains(set, vector.event)) vector.event = tau;", "(FAULT || terms_.contains(set, vector.event))) vector.event = tau;"),
    ("operands synchronise on every event", MACHINE + "combine.cpp",
     "return event == tick || (event != tau && terms_.contains(set, event)); };",
     "return event == tick || (event != tau && (FAULT || terms_.contains(set, event))); };"),
    ("an event has only its first new name", MACHINE + "combine.cpp", "result.back().event = result.back().revealed = pair->second;",
     "result.back().event = result.back().revealed = pair->second;\n            if (FAULT) break;"),
    ("the second process of a sequence does not start", MACHINE + "combine.cpp",
     "vector.actions.push_back({node.children[1], true});", "if (!FAULT) vector.actions.push_back({node.children[1], true});"),
    ("only the first operand of a choice or an interrupt moves", MACHINE + "combine.cpp",
     "prepend_actions(vector, others);\n            result.push_back(std::move(vector));",
     "prepend_actions(vector, others);\n            if (FAULT && i > 0) continue;\n            result.push_back(std::move(vector));"),
    ("all operands of an alphabetised parallel perform each event", MACHINE + "combine.cpp",
     "if (event == tick || terms_.contains(term.sets[i], event)) who.push_back(&row[i]);",
     "if (FAULT || event == tick || terms_.contains(term.sets[i], event)) who.push_back(&row[i]);"),
    ("a component loses the last transition of a state", MACHINE + "component.cpp",
     "edges_.push_back({place, edge.revealed, edge.target});",
     "if (FAULT && row.size() > 1 && &edge == &row.back()) break;\n            edges_.push_back({place, edge.revealed, edge.target});"),
]

DECLARATION = """
#include <cstdlib>
namespace {
/// The fault with this number is active.
[[maybe_unused]] inline bool robochart_planted(int number) {
    static const char* const text = std::getenv("ROBOCHART_PLANTED");
    static const int active = text == nullptr ? 0 : std::atoi(text);
    return active == number;
}
}  // namespace
"""


def plant(root):
    """Plants all faults. Each text must occur exactly once."""
    declared = set()
    for number, (name, file, right, wrong) in enumerate(FAULTS, 1):
        path = root / file
        text = path.read_text()
        if text.count(right) < 1:
            sys.exit(f"{file}: the place of the fault `{name}` was not found")
        text = text.replace(right, wrong.replace("FAULT", f"robochart_planted({number})"), 1)
        if file not in declared:
            at = text.index("\nnamespace ")
            guard = "ROBOCHART_PLANTED_DECLARED"
            text = f"{text[:at]}\n#ifndef {guard}\n#define {guard}{DECLARATION}#endif\n{text[at:]}"
            declared.add(file)
        path.write_text(text)


# Claims that fail, each for a reason that some fault overlooks: nodes that change, wide choices, refusals of states with
# several events, large nodes, equal components that the specification distinguishes, components that end, choices of one
# participant, priorities.
FIXED = """
external prioritise
channel a, b, c, d
channel u, v : {0..9}
N0 = a -> b -> N0
N1 = a -> a -> STOP
assert N0 [T= N1
W0 = u?x -> STOP
W1 = u?x -> (if x == 6 then a -> STOP else STOP)
assert W0 [T= W1
assert W0 [FD= W1
R0 = a -> R0 [] (STOP |~| (b -> R0 [] c -> R0))
R1 = b -> R1 [] c -> R1
assert R0 [F= R1
R2 = (a -> R2 [] b -> R2) [] (STOP |~| c -> R2)
R3 = a -> R3 [] c -> R3
assert R2 [F= R3
L0 = a -> (b -> STOP |~| c -> STOP |~| d -> STOP)
L1 = a -> a -> STOP
assert L0 [T= L1
T0 = (a -> STOP) [> (a -> STOP [] b -> STOP)
T1 = a -> STOP
assert T0 [F= T1
All = {|u, v|}
Pairs = ||| i : {0..5} @ u.i -> v.i -> STOP
S0 = u.1 -> RUN(diff(All, {v.1})) [] u?x : {0, 2, 3, 4, 5} -> RUN(All)
assert S0 [T= Pairs
Must = v.0 -> Must [] (STOP |~| ([] x : diff(All, {v.0}) @ x -> Must))
S1 = u?x -> Must
assert S1 [F= Pairs
E0 = ((u.0 -> u.1 -> SKIP) ||| (u.2 -> u.3 -> SKIP) ||| (u.4 -> u.5 -> SKIP)); a -> a -> STOP
E1 = let Go = u?x -> Go [] a -> Ended
         Ended = u?x -> Ended within Go
assert E1 [T= E0
I0 = ((||| i : {0..3} @ u.i -> v.i -> STOP) /\\ a -> b -> b -> STOP) ||| (c -> STOP)
I1 = let Go = u?x -> Go [] v?x -> Go [] c -> Go [] a -> After
         After = b -> Last [] c -> After
         Last = c -> Last within Go
assert I1 [T= I0
C0 = (||| i : {0..3} @ u.i -> STOP) [| {u.0} |] (u.0 -> a -> STOP [] u.0 -> b -> STOP)
C1 = u?x -> C1 [] a -> C1
assert C1 [T= C0
H = (||| i : {0..5} @ (u.i -> STOP [] v.i -> STOP)) [| {|u|} |] (||| i : {0..5} @ u.i -> STOP)
assert STOP [T= H \\ {|u|}
P0 = prioritise(||| i : {0..5} @ u.i -> v.i -> a -> STOP, <{|v|}, {|u|}>)
A0 = (u.0 -> a -> STOP) [{u.0, a} || {u.1, b}] (u.1 -> b -> STOP)
assert STOP [T= A0
Q0 = ((a -> STOP) ||| (d -> STOP))[[a <- b, a <- c]]
assert RUN({b, d}) [T= Q0
assert RUN({|u, v|}) [T= P0
assert P0 :[deadlock free [F]]
"""


def sequential(numbers, names, depth):
    """A process without operators of parallel composition; recursion is guarded."""
    kind = numbers.random()
    if depth == 0 or kind < 0.1:
        return numbers.choice(["STOP", "SKIP", f"a -> {numbers.choice(names)}", f"b -> {numbers.choice(names)}"])
    inner = lambda: sequential(numbers, names, depth - 1)
    if kind < 0.55:
        return f"{numbers.choice('abcd')} -> " + (numbers.choice(names) if numbers.random() < 0.5 else f"({inner()})")
    if kind < 0.75:
        return f"({inner()}) [] ({inner()})"
    if kind < 0.9:
        return f"({inner()}) |~| ({inner()})"
    return f"({numbers.choice('abcd')} -> SKIP); ({inner()})"  # no recursion before `;`, which would have no end


def events(numbers):
    return "{" + ", ".join(sorted(numbers.sample("abcd", numbers.randint(0, 3)))) + "}"


def random_script(seed):
    """Processes with synchronisation, hiding, renaming, equal components and priorities, and all kinds of claims."""
    numbers = random.Random(seed)
    lines = ["external prioritise", "channel a, b, c, d", "channel e : {0..2}"]
    names = [f"P{i}" for i in range(4)]
    lines += [f"{name} = {sequential(numbers, names, 3)}" for name in names]
    mains = []
    for i in range(5):
        left, right = numbers.choice(names), numbers.choice(names)
        process = f"({left} [| {events(numbers)} |] {right})"
        if numbers.random() < 0.3:
            process = f"({process} ||| {numbers.choice(names)})"
        if numbers.random() < 0.3:
            process = f"(||| i : {{0..2}} @ {left}[[a <- e.i]]) [| {events(numbers)} |] {right}"
        if numbers.random() < 0.6:
            process = f"({process}) \\ {events(numbers)}"
        if numbers.random() < 0.25:
            process = f"prioritise({process}, <{{a, b}}, {{c}}>)"
        lines.append(f"M{i} = {process}")
        mains.append(f"M{i}")
    for left in mains + names[:2]:
        for right in mains:
            lines.append(f"assert {left} [{numbers.choice(['T', 'F', 'FD', 'FD'])}= {right}")
    for main in mains:
        lines += [f"assert {main} :[deadlock free [F]]", f"assert {main} :[deadlock free [FD]]",
                  f"assert {main} :[divergence free]"]
    return "\n".join(lines) + "\n"


def answers(program, script, options, fault, certificates):
    """The answers by assertion (1: holds, 0: fails), and the folders of certificates. None if the program ends abnormally or too late."""
    environment = dict(os.environ, ROBOCHART_PLANTED=str(fault), PATH="/usr/bin:/bin")
    command = [program, "cspm", script, "--no-cache", "--progress", "never", "--format", "json", "--max-states", "20000",
               *options]
    if certificates is not None:
        command += ["--certify", certificates]
    try:
        ran = subprocess.run(command, capture_output=True, text=True, timeout=60, env=environment)
        results = json.loads(ran.stdout)["results"]
        return [(result["result"], result.get("certificate", {}).get("folders", [])) for result in results] or None
    except (subprocess.TimeoutExpired, ValueError, KeyError):
        return None


def run(program, faulty, certifier, folder, scripts=12):
    """Runs all faults; returns whether all wrong answers are refused."""
    folder.mkdir(parents=True, exist_ok=True)
    cases = []
    texts = {"fixed": FIXED} | {f"random{seed}": random_script(seed) for seed in range(scripts)}
    for case, text in texts.items():
        script = folder / f"{case}.csp"
        script.write_text(text)
        for options in ([], ["--no-reduction"]):
            expected = answers(program, script, options, 0, None)
            if expected is None:
                sys.exit(f"{script}: no answers")
            cases.append((script, options, expected))
    accepted = 0
    effective = 0
    for number, (name, file, _, _) in enumerate(FAULTS, 1):
        wrong = refused = without = 0
        for script, options, expected in cases:
            certificates = folder / "certificates"
            shutil.rmtree(certificates, ignore_errors=True)
            found = answers(faulty, script, options, number, certificates)
            for (right, _), (answer, folders) in zip(expected, found or []):
                if answer != 1 or right != 0:
                    continue
                wrong += 1
                without += not folders
                for certificate in folders:
                    says = subprocess.run([certifier, "--answer", certificate], capture_output=True, text=True).stdout
                    refused += says.startswith("refused")
                    if says.startswith("certified"):
                        accepted += 1
                        print(f"ACCEPTED: {name}, {script} {options}: {certificate}")
        effective += wrong > 0
        print(f"{name} ({file}): {wrong} wrong answers, {refused} certificates refused, {without} without certificate", flush=True)
    print(f"{len(FAULTS)} faults, {effective} of which change an answer to `holds`; {accepted} wrong certificates accepted")
    return accepted == 0 and effective > 0


def build_and_run(build, folder):
    copy = folder / "source"
    shutil.rmtree(folder, ignore_errors=True)
    shutil.copytree(ROOT, copy, ignore=shutil.ignore_patterns("build", ".git"))
    plant(copy)
    subprocess.run(["cmake", "-S", copy, "-B", folder / "build", "-G", "Ninja", "-DROBOCHART_TESTS=OFF"], check=True,
                   stdout=subprocess.DEVNULL)
    subprocess.run(["cmake", "--build", folder / "build", "--target", "robochart-verify"], check=True,
                   stdout=subprocess.DEVNULL)
    return run(build / "app/robochart-verify", folder / "build/app/robochart-verify",
               build / "checker/certify/certifier/robochart-certify", folder / "work")


def main():
    words = sys.argv[1:]
    if len(words) == 2 and words[0] == "--plant":
        plant(pathlib.Path(words[1]))
    elif len(words) == 5 and words[0] == "--run":
        program, faulty, certifier, folder = (pathlib.Path(word).resolve() for word in words[1:])
        sys.exit(0 if run(program, faulty, certifier, folder) else 1)
    elif len(words) == 2:
        sys.exit(0 if build_and_run(pathlib.Path(words[0]).resolve(), pathlib.Path(words[1]).resolve()) else 1)
    else:
        sys.exit(__doc__)


main()
