// Process terms as people read them. Evaluates nothing, so that a report never fails.
#include <string>

#include "checker/process/operational_semantics.hpp"

namespace robochart::process {
namespace {

constexpr int deepest_description = 64;
constexpr int largest_description = 250;  // terms looked at

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
                return joined(term, " ‖ ", depth);
            case Op::external_choice:
            case Op::sync_choice:
                return joined(term, " □ ", depth);
            case Op::internal_choice:
                return joined(term, " ⊓ ", depth);
            case Op::sync_interrupt:
                return joined(term, " △ ", depth);
            // These act by their first operand until it is left for good.
            case Op::sequential:
            case Op::interrupt:
            case Op::sliding:
            case Op::exception:
            case Op::hide:
            case Op::rename:
            case Op::prioritise:
            case Op::prioritise_order:
            case Op::chase:
            case Op::machine:
            case Op::compress:
                return describe(term.children.front(), depth + 1);
        }
        return "?";
    }

private:
    std::string joined(const Term& term, const char* separator, int depth) {
        std::string text;
        for (TermId child : term.children) {
            if (seen_ > largest_description) return text + separator + "…";
            if (!text.empty()) text += separator;
            const bool grouped = needs_brackets(terms_[child].op) && terms_[child].op != term.op;
            text += grouped ? "(" + describe(child, depth + 1) + ")" : describe(child, depth + 1);
        }
        return text;
    }

    static bool needs_brackets(Op op) {
        return op == Op::parallel || op == Op::alphabetised || op == Op::external_choice || op == Op::sync_choice ||
               op == Op::internal_choice || op == Op::sync_interrupt;
    }

    /// The first events that a prefix offers: its definition's name is not at hand any more.
    std::string prefix(const Term& term) const {
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

std::string describe(const TermStore& terms, TermId term) {
    return Describer(terms).describe(term);
}

}  // namespace robochart::process
