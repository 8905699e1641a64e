// Printing of test processes.
#include "process_tree.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace robochart::refine::naive {
namespace {

std::string letter(Letter l) {
    return l == tau ? "tau" : l == tick ? "tick" : std::string(1, static_cast<char>('a' + l));
}

std::string letters(const std::set<Letter>& set) {
    std::vector<std::string> names;
    for (Letter l : set) names.push_back(letter(l));
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
        parts.push_back(letter(process->letters[i]) + "->" + show(process->operands[i]));
    return fmt::format("({})", fmt::join(parts, " | "));
}

std::string levels(const Process& process) {
    std::vector<std::string> parts;
    for (const auto& set : process->sets) parts.push_back(letters(set));
    return fmt::format("<{}>", fmt::join(parts, ","));
}

std::string renaming(const Process& process) {
    std::vector<std::string> parts;
    for (const auto& [from, to] : process->renaming) parts.push_back(letter(from) + "<-" + letter(to));
    return fmt::format("[[{}]]", fmt::join(parts, ","));
}

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
            return "RUN" + set;
        case Kind::chaos:
            return "CHAOS" + set;
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
            return joined(process, " [|" + set + "|] ");
        case Kind::alphabetised:
            return joined(process, " " + levels(process) + "|| ");
        case Kind::hide:
            return joined(process, "") + "\\" + set;
        case Kind::rename:
            return joined(process, "") + renaming(process);
        case Kind::prioritise:
            return "prioritise" + joined(process, "") + levels(process);
        case Kind::chase:
            return "chase" + joined(process, "");
        case Kind::compress:
            return fmt::format("compress{}{}", process->name, joined(process, ""));
    }
    return "?";
}

std::string show(const Script& script) {
    std::string text;
    for (std::size_t i = 0; i < script.definitions.size(); ++i)
        text += fmt::format("P{} = {}\n", i, show(script.definitions[i]));
    for (const Process& main : script.mains) text += "main: " + show(main) + "\n";
    return text;
}

}  // namespace robochart::refine::naive
