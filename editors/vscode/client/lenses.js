// The lenses above assertions: "check", and the verdict once there is one. A verdict is about the texts as they were,
// so any change of a text takes it away.
"use strict";

class Lenses {
    constructor() {
        this.verdicts = new Map();
        /** How often the verdicts were taken away: one of an older edition is not to be set. */
        this.edition = 0;
    }
    key(uri, name) {
        return JSON.stringify([uri, name]);
    }
    set(uri, name, verdict) {
        this.verdicts.set(this.key(uri, name), verdict);
    }
    forget() {
        this.verdicts.clear();
        this.edition += 1;
    }
    /** The server's lenses with verdicts in their titles. */
    titled(lenses) {
        for (const lens of lenses ?? []) {
            const verdict = lens.command && this.verdicts.get(this.key(...(lens.command.arguments ?? [])));
            if (verdict !== undefined) lens.command.title = `${verdict} (check again)`;
        }
        return lenses;
    }
}

module.exports = { Lenses };
