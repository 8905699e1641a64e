# SPDX-License-Identifier: Apache-2.0
"""Mutates texts: bytes, lines, words, names and literals with a meaning in other languages, deep nesting."""
import re

HOSTILE_NAMES = [
    "int", "class", "template", "union", "STOP", "SKIP", "card", "head", "tock", "Events", "assert", "BUFSIZ", "NULL", "errno",
    "EXIT_SUCCESS", "std", "step", "state", "value", "inputs", "Int", "_", "_x", "__x", "x__", "main", "within", "true", "D__",
    "O__", "core_nat", "printf", "stdin", "linux", "unix", "min", "max", "TIDS", "Timed", "WAIT", "module", "endmodule",
]
HOSTILE_LITERALS = [
    '"\\""', '"*/"', '"//\\"', '"??/"', '"%s%n"', '"{}"', '"${x}"', '"\\n"', '")\\""', '"</svg>"', '"\\\\"', "99999999999999999999",
    "-9223372036854775808", "9223372036854775807", "0.000000000000000000001", "1e999", "4294967296", "65536", "1/0",
]
HOSTILE_BYTES = [b"\x00", b"\xff\xfe", b"\xe2\x80\xae", b"\x1b[2J", b"\r", b"\xc0\xaf", b"\xef\xbb\xbf", b"\t" * 50]
HOSTILE_FILES = ["a b", "-x", "a'b", 'a"b', "a;b", "$(x)", "a\\b", "ä", "a%sb", "{}", "a\nb", "x" * 200]

OPERATOR = re.compile(rb"\[(?:T|F|FD)=|\[\]|\|~\||\|\|\||<=|>=|==|!=|=>|/\\|\\/|[-+*/%<>;?!.]")
WORD = re.compile(rb"[A-Za-z_][A-Za-z_0-9]*|[0-9]+(?:\.[0-9]+)?|\"[^\"\n]*\"|[^\sA-Za-z_0-9]")


def change_bytes(rng, text, words):
    at = rng.randrange(len(text) + 1)
    return text[:at] + rng.choice(HOSTILE_BYTES) + text[at + rng.randrange(3):]


def cut(rng, text, words):
    at = rng.randrange(len(text) + 1)
    return text[:at] if rng.random() < 0.3 else text[:at] + text[at + rng.randrange(1, 80):]


def repeat_lines(rng, text, words):
    lines = text.split(b"\n")
    first = rng.randrange(len(lines))
    block = lines[first:first + rng.randrange(1, 8)]
    where = rng.randrange(len(lines) + 1)
    return b"\n".join(lines[:where] + block * rng.choice([1, 1, 2, 30]) + lines[where:])


def remove_lines(rng, text, words):
    lines = text.split(b"\n")
    first = rng.randrange(len(lines))
    return b"\n".join(lines[:first] + lines[first + rng.randrange(1, 5):])


def replaced_word(rng, text, new, wanted=lambda word: True):
    found = [match for match in WORD.finditer(text) if wanted(match.group())]
    if not found:
        return text
    match = rng.choice(found)
    return text[:match.start()] + new(match.group()) + text[match.end():]


def other_word(rng, text, words):
    return replaced_word(rng, text, lambda _: rng.choice(words))


def swap_words(rng, text, words):
    mine = WORD.findall(text)
    return replaced_word(rng, text, lambda _: rng.choice(mine)) if mine else text


def alike_word(rng, text, words):
    """Replaces a word by one that follows the same word elsewhere in the text, so that the text may stay well-formed."""
    found = list(WORD.finditer(text))
    behind = {}
    for before, match in zip(found, found[1:]):
        behind.setdefault(before.group(), set()).add(match.group())
    choices = [(match, behind[before.group()]) for before, match in zip(found, found[1:]) if len(behind[before.group()]) > 1]
    if not choices:
        return text
    match, others = rng.choice(choices)
    like = [word for word in sorted(others - {match.group()}) if word[:1].isalpha() == match.group()[:1].isalpha()]
    return text[:match.start()] + rng.choice(like or [match.group()]) + text[match.end():]


def other_number(rng, text, words):
    numbers = [b"0", b"1", b"2", b"3", b"7", b"100", b"-1", b"0.5"]
    return replaced_word(rng, text, lambda _: rng.choice(numbers), lambda word: word.replace(b".", b"").isdigit())


def other_operator(rng, text, words):
    kinds = [[b"+", b"-", b"*", b"/", b"%"], [b"<", b">", b"<=", b">=", b"==", b"!="], [b"/\\", b"\\/", b"=>", b" and ", b" or "],
             [b"[]", b"|~|", b"|||", b";", b"[|{}|]", b"/\\", b"[>"], [b"?", b"!", b"."], [b"[T=", b"[F=", b"[FD="]]
    found = [(match, kind) for match in OPERATOR.finditer(text) for kind in kinds if match.group() in kind]
    if not found:
        return text
    match, kind = rng.choice(found)
    return text[:match.start()] + rng.choice(kind) + text[match.end():]


def hostile_name(rng, text, words):
    """Replaces one name by another in the whole text, so that the text may stay well-formed."""
    names = sorted(set(re.findall(rb"\b[A-Za-z_][A-Za-z_0-9]*\b", text)))
    if not names:
        return text
    new = rng.choice(HOSTILE_NAMES).encode()
    return re.sub(rb"\b" + rng.choice(names) + rb"\b", lambda _: new, text)


def hostile_literal(rng, text, words):
    return replaced_word(rng, text, lambda _: rng.choice(HOSTILE_LITERALS).encode(),
                         lambda word: word[:1] in b"\"0123456789" or rng.random() < 0.05)


def nest(rng, text, words):
    opening, closing = rng.choice([(b"(", b")"), (b"{", b"}"), (b"<", b">"), (b"not ", b""), (b"-", b""), (b"let x = ", b" within x")])
    depth = rng.choice([3, 300, 30000])
    return replaced_word(rng, text, lambda word: opening * depth + word + closing * depth)


# These often leave the text well-formed.
CAREFUL = [alike_word, alike_word, alike_word, other_number, other_operator, hostile_name, hostile_literal]
ANY = [change_bytes, cut, repeat_lines, remove_lines, other_word, other_word, swap_words, swap_words, swap_words, hostile_name,
       hostile_name, hostile_literal, hostile_literal, nest]


def changed(rng, original, words, carefully):
    text = original
    for _ in range(rng.choice([1, 2] if carefully else [1, 1, 1, 2, 3, 6])):
        text = rng.choice(CAREFUL if carefully or rng.random() < 0.5 else ANY)(rng, text, words)
    return text
