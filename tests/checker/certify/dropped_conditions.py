#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
# Is the attack any good? Drops the conditions of the extracted program, one at a time and in a copy, and runs the attack
# against each copy. dropped_conditions.py FOLDER [TRIALS]: builds in the folder; prints which drops are noticed.
import pathlib
import re
import subprocess
import sys

here = pathlib.Path(__file__).resolve().parent
certifier = here.parents[2] / "checker" / "certify" / "certifier"

# Not in the list are conditions that others imply: bounds of numbers, which OCaml's arrays check too; that a witness is
# stable, since no acceptance that a stable state offers contains tau; and that tau has no arc, since no run uses it.

# The function, what is dropped in it, the text (a regular expression), and its replacement.
drops = [
    ("steps_to", "event", r"if eqb \(fst m\) a then", "if true then"),
    ("steps_to", "state", r"then eqs \(snd m\) u", "then true"),
    ("derived", "seed", r"then seed o\.from \(e\.member k j\)", "then true"),
    ("derived", "depth", r"ltb0 \(source o\.from\)\.depth o\.depth", "true"),
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
    ("covered", "node", r"if eqb \(p\.node_of j\) k", "if true"),
    ("covered", "state", r"if eqi \(p\.state_of j\) u then", "if true then"),
    ("within", "rank", r"ltb0 r b", "true"),
    ("refusals_ok", "offers", r"then forallb offered \(n\.acceptance n0 i\)", "then true"),
    ("refusals_ok", "tick alone", r"then fits0 \(fun a -> eqb a tick\)", "then fits0 (offers moves)"),
    ("refusals_ok", "stable states", r"if offers moves tau then true else fits0 \(offers moves\)", "true"),
    ("check_move", "forbidden event", r"\| None -> false", "| None -> true"),
    ("check_move", "tau", r"then covered eqi p u n0 \(if ranked m then Some r else None\)", "then true"),
    ("check_move", "target", r"if stop n m k then true else covered eqi p u k None", "true"),
    ("check_pair", "refusals", r"\| _ -> refusals_ok n p n0 moves", "| _ -> true"),
    ("check_implementation", "initial pair", r"covered eqi p impl\.init n\.root None", "true"),
    ("check_state", "deadlock", r"\| \[\] -> false", "| [] -> true"),
    ("check_property", "initial pair", r"covered eqi p0 impl\.init \(Uint63\.of_int \(0\)\) None", "true"),
    ("ready", "priority", r"negb \(ltb0 k l\)", "true"),
    ("fast_fire", "assignments", r"\(app \(app first ch\) r\.puts\)", "(app first ch)"),
    ("fast_fire", "other participants", r"\(app \(app first ch\) r\.puts\)", "(app first r.puts)"),
]


def without(text, function, pattern, replacement):
    start = re.search(r"^let (rec )?%s\b" % re.escape(function), text, re.M).start()
    stop = text.find("\n(** val", start)
    changed, count = re.subn(pattern, lambda _: replacement, text[start:stop], count=1)
    if count != 1:
        sys.exit("%s: `%s` was not found" % (function, pattern))
    return text[:start] + changed + text[stop:]


def main():
    folder = pathlib.Path(sys.argv[1])
    trials = sys.argv[2] if len(sys.argv) > 2 else "100"
    verified = (certifier / "verified.ml").read_text()
    noticed = 0
    for function, condition, pattern, replacement in drops:
        copy = folder / "checker" / "certify" / "certifier"
        subprocess.run(["rm", "-rf", folder / "checker"], check=True)
        copy.parent.mkdir(parents=True)
        subprocess.run(["cp", "-r", certifier, copy], check=True)
        subprocess.run(["cp", "-r", certifier.parent / "coq", copy.parent / "coq"], check=True)
        (copy / "verified.ml").write_text(without(verified, function, pattern, replacement))
        subprocess.run(["sh", copy / "build.sh", folder, here / "attack.ml", "attack"], check=True)
        ran = subprocess.run([folder / "attack", "1", trials], capture_output=True, text=True)
        noticed += ran.returncode != 0
        print("%-12s %s: %s" % ("noticed" if ran.returncode != 0 else "NOT NOTICED", function, condition), flush=True)
    print("%d of %d dropped conditions are noticed" % (noticed, len(drops)))


main()
