// SPDX-License-Identifier: Apache-2.0
// Shows the lenses above assertions: "check", then the verdict, and "steps" if the assertion fails. A verdict applies
// only to the texts that were checked, so any change of a text removes the verdict.
"use strict";

class Lenses {
    /** `make(range, command)` returns a lens. */
    constructor(make) {
        this.make = make;
        this.verdicts = new Map();
        /** The number of times that the verdicts were removed. A verdict for an earlier edition is ignored. */
        this.edition = 0;
    }
    key(uri, name) {
        return JSON.stringify([uri, name]);
    }
    set(uri, name, verdict, failures = []) {
        this.verdicts.set(this.key(uri, name), { verdict, failures });
    }
    /** The failures of the last check of the assertion. */
    failures(uri, name) {
        return this.verdicts.get(this.key(uri, name))?.failures ?? [];
    }
    forget() {
        this.verdicts.clear();
        this.edition += 1;
    }
    /** The server's lenses with verdicts in their titles. After a failure, a lens with `command` shows the steps. */
    titled(lenses, checkCommand, stepsCommand) {
        return lenses?.flatMap((lens) => {
            const words = lens.command?.command === checkCommand ? lens.command.arguments : [];
            const known = this.verdicts.get(this.key(...words));
            if (known === undefined) return [lens];
            lens.command.title = `${known.verdict} (check again)`;
            if (!known.failures.some((each) => each.steps.length > 0)) return [lens];
            return [lens, this.make(lens.range, { title: "steps", command: stepsCommand, arguments: words })];
        });
    }
}

module.exports = { Lenses };
