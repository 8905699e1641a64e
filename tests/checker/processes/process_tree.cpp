// SPDX-License-Identifier: Apache-2.0
// Prints test processes as CSPM.
#include "process_tree.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>

namespace robochart::refine::naive {
namespace {

std::string letter_text(Letter l) {
    if (l == tau) return "tau";
    if (l == tick) return "tick";
    return {static_cast<char>('a' + l)};
}

std::string letters(const std::set<Letter>& set) {
    std::vector<std::string> names;
    for (Letter l : set) names.push_back(letter_text(l));
    return fmt::format("{{{}}}", fmt::join(names, ","));
}

std::string joined(const Process& process, const std::string& separator) {
    std::vector<std::string> parts;
    for (const Process& operand : process->operands) parts.push_back(show(operand));
    return fmt::format("({})", fmt::join(parts, separator));
}

std::string prefix(const Process& process) {
    std::vector<std::string> parts;
    for (std::size_t i = 0; i < process->letters.size(); ++i)
        parts.push_back(letter_text(process->letters[i]) + " -> " + show(process->operands[i]));
    return fmt::format("({})", fmt::join(parts, " [] "));
}

std::string levels(const Process& process) {
    std::vector<std::string> parts;
    for (const auto& set : process->sets) parts.push_back(letters(set));
    return fmt::format("{}", fmt::join(parts, ","));
}

std::string pairs(const Process& process, const char* pattern) {
    std::vector<std::string> parts;
    for (const auto& [from, to] : process->renaming)
        parts.push_back(fmt::format(fmt::runtime(pattern), letter_text(from), letter_text(to)));
    return fmt::format("{}", fmt::join(parts, ", "));
}

/// Prints the replicated form, because parallel composition of three operands is not associative in CSPM.
std::string replicated(const Process& process) {
    return fmt::format("([|{}|] i:{{0..2}} @ (if i == 0 then {} else if i == 1 then {} else {}))",
                       letters(process->set), show(process->operands[0]), show(process->operands[1]),
                       show(process->operands[2]));
}

std::string application_text(const std::string& function, const Process& process, const std::string& more = "") {
    return function + "(" + show(process->operands[0]) + more + ")";
}

constexpr std::array compressions{"normal",          "sbisim",         "dbisim",    "wbisim", "diamond",
                                  "tau_loop_factor", "model_compress", "explicate", "deter",  "lazyenumerate"};

}  // namespace

std::string show(const Process& process) {
    const std::string set = letters(process->set);
    switch (process->kind) {
        case Kind::stop:
            return "STOP";
        case Kind::skip:
            return "SKIP";
        case Kind::div:
            return "DIV";
        case Kind::omega:
            return "OMEGA";
        case Kind::run:
            return "RUN(" + set + ")";
        case Kind::chaos:
            return "CHAOS(" + set + ")";
        case Kind::call:
            return fmt::format("P{}", process->name);
        case Kind::prefix:
            return prefix(process);
        case Kind::external:
            return joined(process, " [] ");
        case Kind::internal:
            return joined(process, " |~| ");
        case Kind::sequential:
            return joined(process, " ; ");
        case Kind::interrupt:
            return joined(process, " /\\ ");
        case Kind::sliding:
            return joined(process, " [> ");
        case Kind::exception:
            return joined(process, " [|" + set + "|> ");
        case Kind::sync_external:
            return joined(process, " [+" + set + "+] ");
        case Kind::sync_interrupt:
            return joined(process, " /+" + set + "+\\ ");
        case Kind::parallel:
            if (process->operands.size() == 3) return replicated(process);
            return joined(process, " [|" + set + "|] ");
        case Kind::alphabetised:
            return joined(process, fmt::format(" [{} || {}] ", letters(process->sets[0]), letters(process->sets[1])));
        case Kind::linked:
            return joined(process, " [" + pairs(process, "{} <-> {}") + "] ");
        case Kind::hide:
            return "(" + show(process->operands[0]) + " \\ " + set + ")";
        case Kind::project:
            return "(" + show(process->operands[0]) + " |\\ " + set + ")";
        case Kind::rename:
            return show(process->operands[0]) + "[[" + pairs(process, "{} <- {}") + "]]";
        case Kind::prioritise:
            return application_text("prioritise", process, ", <" + levels(process) + ">");
        case Kind::prioritise_order:
            return application_text(
                "prioritisepo", process,
                fmt::format(", {}, {{{}}}, {}", set, pairs(process, "({}, {})"), letters(process->sets[0])));
        case Kind::chase:
            return application_text("chase", process);
        case Kind::compress:
            return application_text(compressions.at(static_cast<std::size_t>(process->name)), process);
    }
    return "?";
}

std::string show(const Script& script) {
    std::string text =
        "transparent normal, sbisim, dbisim, wbisim, diamond, tau_loop_factor, model_compress, explicate, "
        "lazyenumerate, chase\nexternal prioritise, prioritisepo\nchannel a, b, c\n";
    for (std::size_t i = 0; i < script.definitions.size(); ++i)
        text += fmt::format("P{} = {}\n", i, show(script.definitions[i]));
    for (std::size_t i = 0; i < script.mains.size(); ++i) text += fmt::format("M{} = {}\n", i, show(script.mains[i]));
    return text;
}

}  // namespace robochart::refine::naive
