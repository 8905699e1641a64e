#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Prints the log of a node with the messages that arrived, in place of the outputs that the node recorded.

Usage: messages_in_log.py LOG MESSAGES [swap|lose]

MESSAGES has a message in each line, such as `goTo!2`. The number of outputs of each cycle is that of the log. `swap` exchanges
two messages in the middle that are different; `lose` leaves one out. The result ends where the messages end, because the
last ones are lost if the node is killed."""

import sys


def with_fault(messages, fault):
    middle = next(i for i in range(len(messages) // 2, len(messages)) if messages[i] != messages[i + 1])
    if fault == "swap":
        messages[middle], messages[middle + 1] = messages[middle + 1], messages[middle]
    else:
        del messages[middle]


def main():
    log, name, *fault = sys.argv[1:]
    with open(name, encoding="utf-8") as file:
        messages = file.read().splitlines()
    if fault:
        with_fault(messages, fault[0])
    arrived = iter(messages)
    with open(log, encoding="utf-8") as file:
        for line in file:
            words = line.split()
            if words and words[-1] == "tock":
                outputs = [i for i, word in enumerate(words) if "!" in word]
                found = [message for _, message in zip(outputs, arrived)]
                if len(found) < len(outputs):
                    break
                for i, message in zip(outputs, found):
                    words[i] = message
                line = " ".join(words) + "\n"
            print(line, end="")


main()
