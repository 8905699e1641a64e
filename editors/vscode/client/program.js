// SPDX-License-Identifier: Apache-2.0
// Where robochart-verify is, and what to say when it is nowhere. Knows nothing of VS Code, so that plain Node tests it.
"use strict";

const fs = require("node:fs");
const path = require("node:path");

/** Is there a file at `file` that may be run? On Windows every file may. */
function isExecutable(file) {
    try {
        fs.accessSync(file, process.platform === "win32" ? fs.constants.F_OK : fs.constants.X_OK);
        return fs.statSync(file).isFile();
    } catch {
        return false;
    }
}

/** The names under which a program may stand in a folder. */
function fileNames(program) {
    return process.platform === "win32" && path.extname(program) === "" ? [program, `${program}.exe`] : [program];
}

/** The first runnable file of that name in the folders of a PATH; undefined if there is none. */
function searchPath(program, searchedFolders) {
    for (const folder of searchedFolders.split(path.delimiter)) {
        if (folder === "") continue;
        for (const name of fileNames(program)) {
            const candidate = path.join(folder, name);
            if (isExecutable(candidate)) return candidate;
        }
    }
    return undefined;
}

/** The name that the setting has by default, and that of the program that comes with the extension. */
const programName = "robochart-verify";

/** The program beside the client; undefined where the extension came without one. */
function bundledProgram(extensionFolder) {
    const program = path.join(extensionFolder, "server", programName);
    return isExecutable(program) ? program : undefined;
}

/**
 * The program that the setting `robochart.server.path` means.
 * A bare name is looked up in PATH; a relative path starts at the open folder; `~` is the home folder.
 * The default name means the program that came with the extension, if one did.
 * Returns `{ program }` or `{ problem }`, a sentence for the user.
 */
function findProgram(setting, openFolder, environment = process.env, extensionFolder = path.dirname(__dirname)) {
    const wanted = setting.trim();
    const bundled = wanted === programName ? bundledProgram(extensionFolder) : undefined;
    if (bundled !== undefined) return { program: bundled };
    if (wanted === "") return { problem: "The setting robochart.server.path is empty." };
    if (!wanted.includes("/") && !wanted.includes(path.sep)) {
        const program = searchPath(wanted, environment.PATH ?? environment.Path ?? "");
        if (program !== undefined) return { program };
        return { problem: `There is no program ${wanted} in PATH.` };
    }
    const home = environment.HOME ?? environment.USERPROFILE ?? "";
    const expanded = wanted.startsWith("~/") ? path.join(home, wanted.slice(2)) : wanted;
    const absolute = path.resolve(openFolder ?? home, expanded);
    if (isExecutable(absolute)) return { program: absolute };
    const why = fs.existsSync(absolute) ? "is not a program that can be run" : "does not exist";
    return { problem: `The setting robochart.server.path names ${absolute}, which ${why}.` };
}

module.exports = { findProgram };
