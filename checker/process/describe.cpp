// SPDX-License-Identifier: Apache-2.0
// Describes process terms for readers. Never evaluates a definition, because printing a report must not fail.
#include <string>
#include <string_view>

#include "checker/process/derivation.hpp"
#include "checker/process/operational_semantics.hpp"

namespace robochart::process {
namespace {

constexpr int deepest_description = 64;
constexpr int largest_description = 250;  // maximal number of visited terms

class Describer {
public:
    explicit Describer(const TermStore& terms) : terms_(terms) {}

    std::string describe(TermId id, int depth = 0) {
        if (depth > deepest_description || ++seen_ > largest_description) return "…";
        const Term& term = terms_[id];
        switch (term.op) {
            case Op::stop:
                return "STOP";
            case Op::skip:
                return "SKIP";
            case Op::div:
                return "DIV";
            case Op::omega:
                return "Ω";
            case Op::run:
                return "RUN(…)";
            case Op::chaos:
            case Op::chaos_offer:
                return "CHAOS(…)";
            case Op::call:
                return terms_.definitions().describe_call(term.payload);
            case Op::prefix:
                return prefix(term);
            case Op::parallel:
            case Op::alphabetised:
                return join_children(term, " ‖ ", depth);
            case Op::external_choice:
            case Op::sync_choice:
                return join_children(term, " □ ", depth);
            case Op::internal_choice:
                return join_children(term, " ⊓ ", depth);
            case Op::sync_interrupt:
                return join_children(term, " △ ", depth);
            // Until the first operand ends, these operators behave like it, so it describes them.
            case Op::sequential:
            case Op::interrupt:
            case Op::sliding:
            case Op::exception:
            case Op::hide:
            case Op::rename:
            case Op::prioritise:
            case Op::prioritise_order:
            case Op::chase:
                return describe(term.children.front(), depth + 1);
            case Op::compress:
                return std::string(name_of(Compression{term.payload})) + "(" +
                       describe(term.children.front(), depth + 1) + ")";
            case Op::machine:
                return machine_state(term, depth);
        }
        return "?";
    }

private:
    std::string join_children(const Term& term, const char* separator, int depth) {
        std::string text;
        for (TermId child : term.children) {
            if (seen_ > largest_description) return text + separator + "…";
            if (!text.empty()) text += separator;
            const bool grouped = needs_brackets(terms_[child].op) && terms_[child].op != term.op;
            text += grouped ? "(" + describe(child, depth + 1) + ")" : describe(child, depth + 1);
        }
        return text;
    }

    /// Describes the term that a state of a machine represents. If a machine was explored as a whole, its states have
    /// no terms and are described by their numbers.
    std::string machine_state(const Term& state, int depth) {
        const Term& compressed = terms_[state.children[1]];
        if (state.children[0] != compressed.children.front()) return describe(state.children[0], depth + 1);
        const std::string machine = describe(state.children[1], depth + 1);
        if (state.children.size() < 3) return machine;
        return machine + " state " + std::to_string(state.payload - terms_[state.children[2]].payload);
    }

    static bool needs_brackets(Op op) {
        return op == Op::parallel || op == Op::alphabetised || op == Op::external_choice || op == Op::sync_choice ||
               op == Op::internal_choice || op == Op::sync_interrupt;
    }

    /// Describes a prefix by the first events that it offers, because the name of its definition is unknown here.
    [[nodiscard]] std::string prefix(const Term& term) const {
        constexpr std::size_t shown = 3;
        const std::vector<Branch>* branches = terms_.known_branches(term.payload);
        if (branches == nullptr) return "… → …";
        std::string text;
        for (std::size_t i = 0; i < branches->size() && i < shown; ++i)
            text += (i > 0 ? " | " : "") + terms_.events().name((*branches)[i].event);
        if (branches->size() > shown) text += " | …";
        return text + " → …";
    }

    const TermStore& terms_;
    int seen_ = 0;
};

}  // namespace

std::string_view name_of(Compression kind) {
    switch (kind) {
        case Compression::normal:
            return "normal";
        case Compression::sbisim:
            return "sbisim";
        case Compression::dbisim:
            return "dbisim";
        case Compression::wbisim:
            return "wbisim";
        case Compression::diamond:
            return "diamond";
        case Compression::tau_loop_factor:
            return "tau_loop_factor";
        case Compression::model_compress:
            return "model_compress";
        case Compression::explicate:
            return "explicate";
        case Compression::deter:
            return "deter";
        case Compression::lazyenumerate:
            return "lazyenumerate";
        case Compression::trace_watchdog:
            return "trace_watchdog";
        case Compression::failure_watchdog:
            return "failure_watchdog";
    }
    return "";
}

std::string describe(const TermStore& terms, TermId term) {
    return Describer(terms).describe(term);
}

}  // namespace robochart::process
