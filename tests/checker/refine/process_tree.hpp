// Processes of tests as plain trees: input both to the checker, through terms, and to the naive reference.
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
    hide,
    rename,
    prioritise,
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
    std::vector<Letter> letters;  ///< prefix: one per operand
    std::set<Letter> set;
    std::vector<std::set<Letter>> sets;  ///< alphabets or priority levels
    std::vector<std::pair<Letter, Letter>> renaming;
    int name = 0;  ///< call: the definition; compress: which compression
};

/// Named processes; main may call them.
struct Script {
    std::vector<Process> definitions;
    std::vector<Process> mains;
};

/// For failure messages, in CSPM's manner.
std::string show(const Process& process);
std::string show(const Script& script);

}  // namespace robochart::refine::naive
