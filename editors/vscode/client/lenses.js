// SPDX-License-Identifier: Apache-2.0
// The lenses above assertions: "check", and the verdict once there is one, with "steps" where it fails. A verdict is
// about the texts as they were, so any change of a text takes it away.
"use strict";

class Lenses {
    /** `make(range, command)` makes a lens. */
    constructor(make) {
        this.make = make;
        this.verdicts = new Map();
        /** How often the verdicts were taken away: one of an older edition is not to be set. */
        this.edition = 0;
    }
    key(uri, name) {
        return JSON.stringify([uri, name]);
    }
    set(uri, name, verdict, failures = []) {
        this.verdicts.set(this.key(uri, name), { verdict, failures });
    }
    /** What failed when the assertion was checked last. */
    failures(uri, name) {
        return this.verdicts.get(this.key(uri, name))?.failures ?? [];
    }
    forget() {
        this.verdicts.clear();
        this.edition += 1;
    }
    /** The server's lenses with verdicts in their titles; behind those of failures, `command` shows the steps. */
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
