// SPDX-License-Identifier: Apache-2.0
// Finds robochart-verify, or explains why it is not found. This file does not use the API of VS Code, so Node can test
// it alone.
"use strict";

const fs = require("node:fs");
const path = require("node:path");

/** Whether `file` is an executable file. On Windows every file counts as executable. */
function isExecutable(file) {
    try {
        fs.accessSync(file, process.platform === "win32" ? fs.constants.F_OK : fs.constants.X_OK);
        return fs.statSync(file).isFile();
    } catch {
        return false;
    }
}

/** The names that the file of a program can have in a folder. */
function fileNames(program) {
    return process.platform === "win32" && path.extname(program) === "" ? [program, `${program}.exe`] : [program];
}

/** The first executable file with this name in the folders of a PATH; undefined if there is none. */
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

/** The default value of the setting, which is also the name of the program in the extension. */
const programName = "robochart-verify";

/** The program that the extension contains; undefined if it contains none. */
function bundledProgram(extensionFolder) {
    const program = path.join(extensionFolder, "server", programName);
    return isExecutable(program) ? program : undefined;
}

/**
 * Finds the program for the setting `robochart.server.path`.
 * A bare name is looked up in PATH. A relative path starts at the open folder, and `~` is the home folder.
 * The default name means the program in the extension, if there is one.
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
