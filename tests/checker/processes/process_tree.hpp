// SPDX-License-Identifier: Apache-2.0
// Represents test processes as plain trees. They are input for the checker, as terms or as CSPM text, and for the naive
// reference.
#pragma once

#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace robochart::refine::naive {

enum class Kind {
    stop,
    skip,
    div,
    omega,
    run,
    chaos,
    call,
    prefix,
    external,
    internal,
    sequential,
    interrupt,
    sliding,
    exception,
    sync_external,
    sync_interrupt,
    parallel,
    alphabetised,
    linked,
    hide,
    project,
    rename,
    prioritise,
    prioritise_order,
    chase,
    compress
};

struct Tree;
using Process = std::shared_ptr<const Tree>;
using Letter = int;
inline constexpr Letter tau = -1;
inline constexpr Letter tick = -2;

struct Tree {
    Kind kind = Kind::stop;
    std::vector<Process> operands;
    std::vector<Letter> letters;                      ///< prefix: one per operand
    std::set<Letter> set;                             ///< prioritise_order: the events in the order
    std::vector<std::set<Letter>> sets;               ///< alphabets or levels; prioritise_order: maximal events
    std::vector<std::pair<Letter, Letter>> renaming;  ///< linked: the links; prioritise_order: pairs (higher, lower)
    int name = 0;                                     ///< call: the definition; compress: the compression
};

/// Named processes, and main processes that may call them.
struct Script {
    std::vector<Process> definitions;
    std::vector<Process> mains;
};

/// Prints the process as CSPM. CSPM cannot express OMEGA, the state after termination.
std::string show(const Process& process);
/// Prints the script as CSPM. The main processes are M0, M1 ...
std::string show(const Script& script);

}  // namespace robochart::refine::naive
