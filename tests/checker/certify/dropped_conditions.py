#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
# Is the attack any good? Drops the conditions of the extracted program, one at a time and in a copy, and runs the attack
# against each copy, until it is noticed. dropped_conditions.py FOLDER [TRIALS [NAME]]: builds in the folder; prints after how
# many trials each drop is noticed, at most TRIALS (2000). With a NAME, only the drops with this text in their names. Exits
# with 1 if one is not noticed. `dropped_conditions.py --texts` only looks for the texts in the extracted program.
import pathlib
import re
import resource
import subprocess
import sys

here = pathlib.Path(__file__).resolve().parent
certifier = here.parents[2] / "checker" / "certify" / "certifier"

# Not in the list are conditions that others imply: bounds of numbers, which OCaml's arrays check too; that a witness is
# stable, since no acceptance that a stable state offers contains tau; that tau has no arc, since no run uses it; that a pair
# is visited at its place, since at the end each pair is the one that was visited at its place; that a state with tick
# has the acceptance {tick}, since the arc of tick comes from a member that can refuse everything else; that a leaf of a split
# has a component, since merging_ok checks this; and that a component whose state is moved gets a state, since each
# participant has an image that gets its state.

# The function, what is dropped in it, the text (a regular expression), and its replacement.
drops = [
    ("steps_to", "event", r"if eqb \(fst m\) a then", "if true then"),
    ("steps_to", "state", r"then eqs \(snd m\) u", "then true"),
    ("derived", "seed", r"then seed o\.from \(e\.member k j\)", "then true"),
    ("derived", "depth", r"ltb0 \(source\d* o\.from\)\.depth o\.depth", "true"),
    ("derived", "tau", r"then steps_to spec eqs \(e\.member k o\.from\) tau \(e\.member k j\)", "then true"),
    ("accepts", "tick", r"then memb tick a", "then true"),
    ("accepts", "offers", r"\(forallb \(fun m -> memb \(fst m\) a\) moves\)", "true"),
    ("check_acceptance", "witness", r"then accepts spec \(n\.acceptance n0 i\) \(e\.member n0 j\)", "then true"),
    ("check_divergence", "divergent node", r"if n\.divergent n0", "if false"),
    ("check_divergence", "same state", r"then eqs \(e\.member n0 \(e\.diverging_member n0\)\)\s+\(e\.loop \(e\.loop_entry n0\)\)", "then true"),
    ("check_node", "a member", r"\(ltb0 \(Uint63\.of_int \(0\)\) \(e\.size0 n0\)\)", "true"),
    ("check_node", "arcs", r"\(all_below \(check_arc spec eqs n e n0\) \(n\.arc_count n0\)\)", "true"),
    ("check_node", "acceptances", r"all_below \(check_acceptance spec n e n0\) \(n\.acceptance_count n0\)", "true"),
    ("check_node", "divergence", r"check_divergence eqs n e n0", "true"),
    ("check_root", "members", r"\(derived spec eqs e \(fun _ u -> eqs spec\.init u\) e\.origin_in_root n\.root\)", "true"),
    ("check_loop", "tau", r"then steps_to spec eqs \(e\.loop j\) tau \(e\.loop \(e\.loop_next j\)\)", "then true"),
    ("after", "event", r"if eqb b a then", "if true then"),
    ("cover", "node", r"if eqb \(p\.node_of j\) k", "if true"),
    ("cover", "state", r"if eqi \(p\.state_of j\) u", "if true"),
    ("cover", "visited earlier", r"ltb0 \(p\.place_of j\) b", "true"),
    ("cover", "largest pair", r"if ltb0 j high0\s+then Some high0", "if true then Some high0"),
    ("refusals_ok", "offers", r"then forallb offered \(n\.acceptance n0 i\)", "then true"),
    ("refusals_ok", "stable states", r"if offers moves tau then true else fits0 \(offers moves\)", "true"),
    ("refusals", "models", r"\| _ -> refusals_ok n p n0 moves", "| _ -> true"),
    ("event_needs", "forbidden event", r"\| None -> Forbidden", "| None -> Irrelevant"),
    ("event_needs", "ranks", r"Leads \(n0, \(ranked m\)\)", "Leads (n0, false)"),
    ("event_needs", "target", r"\| Some k -> if stop n m k then Irrelevant else Leads \(k, false\)", "| Some _ -> Irrelevant"),
    ("check_moves", "covered", r"match cover eqi p u k \(if earlier then Some p0 else None\) high0 with", "match Some high0 with"),
    ("check_pair", "pair", r"if eqb \(p\.pair_at p0\) j", "if true"),
    ("check_pair", "state", r"if fine \(p\.node_of j\) moves", "if true"),
    ("all_visited", "place", r"if ltb0 \(p\.place_of j\) x\.visited", "if true"),
    ("all_visited", "pair", r"then eqb \(p\.pair_at \(p\.place_of j\)\) j", "then true"),
    ("walk", "all pairs are visited", r"all_visited p x", "true"),
    ("enabled", "deadlock", r"\| \[\] -> false", "| [] -> true"),
    ("any_event", "ranks", r"\(if no_divergence p then eqb a tau else false\)", "false"),
    ("ready", "priority", r"negb \(ltb0 k l\)", "true"),
    ("add_moves", "assignments", r"app first \(app way\d* \(p0 :: l\)\)", "app first way0"),
    ("add_moves", "other participants", r"\| \[\] -> extend first way\d*", "| [] -> first"),
    ("merging_ok", "equal states", r"else equal_edges", "else let equal_edges _ _ = true in equal_edges"),
    ("ascending", "one target", r"if ltb0 last \(fst e\) then", "if true then"),
    ("ascending", "tick", r"if eqb last tick", "if false"),
    ("certify_determinism", "graph", r"\(choiceless_ok g\)", "true"),
    ("known_number", "state", r"if eqi \(h\.numbered_state j\) u then", "if true then"),
    ("nearer", "distance", r"ltb0 \(h\.distance k\) d", "true"),
    ("nearer", "target", r"\| None -> false", "| None -> nearer eqi goal0 h d rest found"),
    ("is_run", "steps", r"if steps_to p eqs s a u then", "if true then"),
    ("is_loop", "no taus", r"\| \[\] -> false", "| [] -> true"),
    ("is_loop", "taus", r"then if forallb \(fun m -> eqb \(fst m\) tau\) r", "then if true"),
    ("is_loop", "end", r"then eqs \(run_end s r\) s", "then true"),
    ("same_events", "event", r"if eqb a b then", "if true then"),
    ("same_events", "fewer events", r"\| _ :: _ -> false\)", "| _ :: _ -> true)"),
    ("refused", "tick", r"then negb \(eqb a tick\)", "then true"),
    ("refused", "event", r"else negb \(offers moves a\)", "else true"),
    ("can_refuse", "stable", r"negb \(offers moves tau\)", "true"),
    ("absence_needs", "ranks", r"\| FD -> true", "| FD -> false"),
    ("absence_needs", "last event", r"\| None -> Forbidden", "| None -> Irrelevant"),
    ("absence_fine", "tick", r"then x0 tick", "then true"),
    ("absence_fine", "offers", r"existsb \(fun mv -> x0 \(fst mv\)\) moves", "true"),
    ("certify_script", "split", r"\(split_ok z0\.defines x z0\.main\)", "true"),
    ("split_ok", "whole term", r"\(eq_term\s+\(term_of x [^\n]*\) p\)", "true"),
    ("split_ok", "different components", r"\(no_repetition \(leaves\d* x\.whole_tree\)\)", "true"),
    ("split_ok", "components", r"\(forallb \(component_ok d x\) \(seq 0 x\.slots\)\)", "true"),
    ("component_ok", "first state", r"\(ltb0 \(Uint63\.of_int \(0\)\) \(x\.states k\)\)", "true"),
    ("component_ok", "bound", r"\| None -> false", "| None -> true"),
    ("component_ok", "events", r"if Parray\.get listed \(fst m\) then", "if true then"),
    ("component_ok", "targets", r"then known x k \(snd m\)", "then true"),
    ("known", "state", r"if ltb0 v \(x\.states k\) then", "if true then"),
    ("known", "term", r"then eq_term \(x\.meaning k v\) p", "then true"),
    ("eq_term", "call", r"\| Call l -> eqb k l", "| Call _ -> true"),
    ("eq_term", "operands", r"then if eq_term p0 p' then eq_term q0 q' else false", "then true"),
    ("eq_term", "sets", r"if eqb b b'", "if true"),
    ("boxed", "levels of operands", r"if free \(snd c\)", "if true"),
    ("sure", "state is read", r"\| None -> false\)\s+\| Sets", "| None -> true)\n        | Sets"),
    ("determined", "one result", r"if eqb \(fst x\) e then eqb \(snd x\) g else true", "true"),
    ("determined", "possible", r"else false", "else true"),
    ("impossible", "event", r"negb \(has_event row_of k e v\)", "true"),
    ("overrules", "smaller level", r"if ltb0 l m", "if true"),
    ("overrules", "same region", r"then same_path g\.place h\.place", "then true"),
    ("commutes", "common state", r"then has_target row_of k d u \(goal row_of k e \(snd x\)\)", "then true"),
    ("commutes", "assigned by the other rule", r"\| Sets \(_, _\) -> false\)\s+\| _ :: _", "| Sets (_, _) -> true)\n         | _ :: _"),
    ("commutes", "assigned by the followed rule", r"\| Sets \(_, _\) -> false\)\)", "| Sets (_, _) -> true))"),
    ("undisturbed", "priorities", r"if \(?existsb \(\(=\) k\) g\.around\)? then leaves row_of r c k else true", "true"),
    ("leaves", "unchanged", r"eqb \(effect row_of r k v\) v", "true"),
    ("implies_cube", "states", r"\| Some v -> eqb v \(snd kv\)", "| Some _ -> true"),
    ("continues", "rule", r"if eqb \(c\.follows i\) \(c\.follows j\)", "if true"),
    ("continues", "entry", r"then implies_cube c0 \(c\.states_of i\)", "then true"),
    ("spared", "event", r"if eqb w\.performed r\.performed", "if true"),
    ("spared", "commutes", r"if forallb \(commutes row_of r\.items c0\) w\.items", "if true"),
    ("spared", "regions", r"if forallb \(undisturbed row_of r\.items c0\) w\.passages", "if true"),
    ("spared", "outcomes", r"forallb \(continues c j\) \(outcomes row_of c0 w\.items c0\)", "true"),
    ("entry_ok", "tau", r"if if any then true else eqb r\.performed tau", "if true"),
    ("entry_ok", "first level", r"if forallb \(fun g -> negb g\.prior\) r\.passages", "if true"),
    ("entry_ok", "sure", r"if forallb \(sure y row_of c0\) r\.items", "if true"),
    ("entry_ok", "tracked components", r"then forallb \(spared c row_of j r c0\) \(near \(fst kv\)\)", "then true"),
    ("entry_ok", "components of the rule", r"if forallb \(spared c row_of j r c0\)\s+\(near \(item_slot it\)\)", "if true"),
    ("entry_ok", "regions around", r"then forallb \(spared c row_of j r c0\)\s+\(around_of \(item_slot it\)\)", "then true"),
    ("passes", "states", r"eqb \(fst t x\) \(snd t\)", "true"),
    ("reduction_holds", "followed steps", r"confluent_ok y c any \(rows_by_event l y\)", "true"),
    ("reduction_holds", "automorphisms", r"automorphism_ok y \(size_of l\) g", "true"),
    ("reduction_holds", "plain process", r"\(plain y\)", "true"),
    ("plain", "no assignments", r"\(silent y\.whole\)", "true"),
    ("plain", "different components", r"\(no_repetition \(slots_of y\.whole\)\)", "true"),
    ("names_ok", "tau", r"\(same_test a b tau\)", "true"),
    ("names_ok", "tick", r"\(same_test a b tick\)", "true"),
    ("pull_ok", "bound of states", r"\(ltb0 w \(size_of0 j\)\)", "true"),
    ("pull_ok", "restored events", r"\(forallb \(fun e -> eqb [^\n]*\) l\)", "true"),
    ("pull_ok", "transitions", r"\(equal_edges \(rename_edges p l\) \(y\.edges j w\)\)", "true"),
    ("corresponds", "level", r"\(same_level q\.level q'\.level\)", "true"),
    ("corresponds", "event", r"\(eqb q'\.does \(m\.new_name q\.does\)\)", "true"),
    ("corresponds", "old event", r"\(eqb q\.does \(m\.old_name q'\.does\)\)", "true"),
    ("corresponds", "different participants", r"\(no_repetition \(map fst q'\.asks\)\)", "true"),
    ("corresponds", "number of requirements", r"\(\(<=\) \(length q\.asks\) \(length q'\.asks\)\)", "true"),
    ("corresponds", "restored requirements", r"\(eqb\s+\(old_name_at [^\n]*\)\s+\(snd a\)\)", "true"),
    ("corresponds", "requirements", r"if \(=\) \(fst c\) \(fst b\) then eqb \(snd c\) \(snd b\) else false", "true"),
    ("rules_correspond", "images of rules", r"\(all_numbered \(fun i q ->[^&]*? rules\)", "true"),
    ("rules_correspond", "rules of images", r"\(all_numbered \(fun i q' ->[^&]*? rules'\)", "true"),
    ("maps", "components", r"\(\(=\) \(pull_at g j\)\.source0 k\)", "true"),
    ("maps", "inner regions", r"maps0 q \(m\.deeper i\) q'", "true"),
    ("maps", "rules", r"\(rules_correspond g m parts to_ rules rules'\)", "true"),
    ("automorphism_ok", "targets", r"\(no_repetition \(map fst g\.pulls\)\)", "true"),
    ("automorphism_ok", "sources", r"\(no_repetition \(map \(fun x -> \(snd x\)\.source0\) g\.pulls\)\)", "true"),
    ("indifferent_node", "arcs", r"\| Some j -> eqb j k\s+\| None -> false", "| _ -> true"),
    ("indifferent_node", "acceptances", r"then forallb \(among \(n\.acceptance n0 i\) f\) \(n\.acceptance n0 j\)", "then true"),
]


# The attacks with forged automorphisms alone notice conditions in these functions.
of_symmetry = {"reduction_holds", "plain", "names_ok", "pull_ok", "corresponds", "rules_correspond", "maps", "automorphism_ok",
               "indifferent_node"}

# The attacks with forged steps alone notice conditions in these functions.
of_reductions = {"sure", "determined", "impossible", "overrules", "commutes", "undisturbed", "leaves", "implies_cube", "continues",
                 "spared", "entry_ok", "passes"}

# Random attacks have not noticed that one of these is dropped. The proof in Coq needs them.
open_conditions = {"overrules: same region", "commutes: assigned by the other rule", "leaves: unchanged", "continues: rule", "spared: regions",
                   "entry_ok: first level", "entry_ok: tracked components", "entry_ok: components of the rule",
                   "plain: different components", "names_ok: tau", "names_ok: tick", "pull_ok: bound of states",
                   "pull_ok: restored events", "corresponds: level", "corresponds: event", "corresponds: old event",
                   "corresponds: different participants", "corresponds: number of requirements",
                   "corresponds: restored requirements", "rules_correspond: images of rules",
                   "rules_correspond: rules of images", "maps: components", "maps: inner regions", "automorphism_ok: targets",
                   "automorphism_ok: sources", "indifferent_node: arcs", "indifferent_node: acceptances"}


def without(text, function, pattern, replacement):
    start = re.search(r"^let (rec )?%s\b" % re.escape(function), text, re.M).start()
    stop = text.find("\n(** val", start)
    changed, count = re.subn(pattern, lambda _: replacement, text[start:stop], count=1)
    if count != 1:
        sys.exit("%s: `%s` was not found" % (function, pattern))
    return text[:start] + changed + text[stop:]


def limit_attack():
    """Without a condition, a search may not end. Such an attack ends by one of these limits, and so is noticed."""
    resource.setrlimit(resource.RLIMIT_AS, (2 << 30, 2 << 30))
    resource.setrlimit(resource.RLIMIT_CPU, (600, 600))


def noticed_by(folder, condition, most):
    """The number of trials after which the attack notices that the condition is dropped; none if it does not."""
    function, name, pattern, replacement = condition
    verified = (certifier / "verified.ml").read_text()
    copy = folder / "checker" / "certify" / "certifier"
    subprocess.run(["rm", "-rf", folder / "checker"], check=True)
    copy.parent.mkdir(parents=True)
    subprocess.run(["cp", "-r", certifier, copy], check=True)
    subprocess.run(["cp", "-r", certifier.parent / "coq", copy.parent / "coq"], check=True)
    (copy / "verified.ml").write_text(without(verified, function, pattern, replacement))
    subprocess.run(["sh", copy / "build.sh", folder, here / "attack.ml", "attack"], check=True)
    alone = ["symmetry"] if function in of_symmetry else []
    if function in of_reductions or name == "followed steps":
        alone = ["reductions"]
    seed, trials = 1, 100
    while seed * 100 <= most:
        if subprocess.run([folder / "attack", str(seed), str(trials), *alone], capture_output=True, preexec_fn=limit_attack).returncode != 0:
            return seed * trials
        seed += 1
    return None


def find_texts():
    """Exits with 1 if a text to be dropped is not in the extracted program: names in it change with what is extracted."""
    verified = (certifier / "verified.ml").read_text()
    for function, _, pattern, replacement in drops:
        without(verified, function, pattern, replacement)


def main():
    if sys.argv[1:] == ["--texts"]:
        return find_texts()
    folder = pathlib.Path(sys.argv[1])
    most = int(sys.argv[2]) if len(sys.argv) > 2 else 2000
    only = sys.argv[3] if len(sys.argv) > 3 else ""
    chosen = [condition for condition in drops if only in f"{condition[0]}: {condition[1]}"]
    noticed = unexpected = 0
    for condition in chosen:
        name = f"{condition[0]}: {condition[1]}"
        trials = noticed_by(folder, condition, most)
        noticed += trials is not None
        unexpected += trials is None and name not in open_conditions
        answer = f"noticed in {trials} trials" if trials is not None else "NOT NOTICED"
        print(f"{name}: {answer}", flush=True)
    print(f"{noticed} of {len(chosen)} dropped conditions are noticed, {unexpected} of the others should be")
    sys.exit(1 if unexpected else 0)


main()
