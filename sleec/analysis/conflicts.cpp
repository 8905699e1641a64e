// See conflicts.hpp.
#include "sleec/analysis/conflicts.hpp"

#include <algorithm>
#include <set>

#include "checker/refine/verdict/check.hpp"
#include "sleec/analysis/rule_system.hpp"

namespace robochart::sleec {
namespace {

/// What the obligations of a rule demand and forbid.
struct Events {
    std::set<std::size_t> demanded, forbidden;
};

Events events_of(const std::vector<Obligation>& obligations) {
    Events result;
    for (const Obligation& obligation : obligations)
        for (const Demand& each : obligation.any)
            (each.forbids ? result.forbidden : result.demanded).insert(each.event);
    return result;
}

bool meet(const std::set<std::size_t>& a, const std::set<std::size_t>& b) {
    return std::any_of(a.begin(), a.end(), [&](std::size_t event) { return b.contains(event); });
}

/// Without an event that one demands and each of the others forbids there is no conflict, and nothing to search for.
bool may_clash(const Question& question) {
    std::vector<Events> all;
    for (std::size_t i = 0; i < question.judged; ++i) all.push_back(events_of(question.obligations[i]));
    for (std::size_t due = 0; due < all.size(); ++due) {
        bool every = true;
        for (std::size_t i = 0; i < all.size(); ++i)
            every = every && ((i == due && all.size() > 1) || meet(all[due].demanded, all[i].forbidden));
        if (every) return true;
    }
    return false;
}

/// Whether at some instant two demands are open for the last time at once: `A within 5 seconds otherwise B within 0
/// seconds`.
bool has_two_last(const std::vector<Obligation>& obligations) {
    for (const Obligation& obligation : obligations)
        for (const Demand& a : obligation.any)
            for (const Demand& b : obligation.any)
                if (&a < &b && !a.forbids && !b.forbids && a.end == b.end && a.end != forever && a.event != b.event)
                    return true;
    return false;
}

/// Goes through a run again, and knows of each obligation where it comes from.
class Replay {
public:
    Replay(const Question& question, const RuleSystem& system) : question_(question), system_(system) {}

    Conflict conflict(const std::vector<refine::Step>& steps) {
        for (const refine::Step& step : steps) take(step.event);
        std::vector<OpenObligation> open;
        for (const Opened& each : open_) open.push_back(each.open);
        const Clash found = clash(question_, open).value();
        Conflict result;
        result.instant = now_;
        std::set<std::size_t> triggers{find(found.due).id};
        for (const Clash::Forbidden& each : found.forbidden) {
            result.due.push_back(side(found.due, each.event, false));
            result.forbidding.push_back(side(each.by, each.event, true));
            result.for_ever = result.for_ever || result.due.back().demand.end == forever;
            triggers.insert(find(each.by).id);
        }
        for (const auto& [instant, event, id] : occurred_)
            if (!triggers.contains(id)) result.besides.emplace_back(instant, event);
        return result;
    }

private:
    struct Opened {
        OpenObligation open;
        std::int64_t began = 0;
        std::size_t occurrence = 0;
        std::size_t id = 0;  ///< of the trigger
    };
    struct Occurred {
        std::int64_t instant = 0;
        std::size_t event = 0, id = 0;
    };

    void take(lts::Event event) {
        const auto occurrence = system_.occurrence(event);
        std::vector<Opened> left;
        for (Opened each : open_) {
            const Obligation& obligation = question_.of(each.open);
            const Effect effect =
                occurrence ? take_event(obligation, each.open.progress, question_.occurrences[*occurrence].event)
                           : take_tock(obligation, each.open.progress);
            if (effect == Effect::open) left.push_back(each);
        }
        open_ = std::move(left);
        if (!occurrence) {
            ++now_;
            return;
        }
        const Occurrence& taken = question_.occurrences[*occurrence];
        occurred_.push_back({now_, taken.event, occurred_.size()});
        for (std::size_t rule = 0; rule < question_.rules.size(); ++rule)
            if (const auto opened = question_.opened(taken, rule))
                open_.push_back({*opened, now_, *occurrence, occurred_.size() - 1});
    }

    [[nodiscard]] const Opened& find(const OpenObligation& open) const {
        return *std::find_if(open_.begin(), open_.end(), [&](const Opened& each) { return each.open == open; });
    }

    [[nodiscard]] Side side(const OpenObligation& open, std::size_t event, bool forbids) const {
        const Opened& opened = find(open);
        Side result{
            question_.rules[open.rule], opened.began, question_.occurrences[opened.occurrence].sample.values, {}};
        // The last that speaks of the event: those before it are over.
        for (const Demand& each : question_.of(open).any)
            if (each.event == event && each.forbids == forbids) result.demand = each;
        return result;
    }

    const Question& question_;
    const RuleSystem& system_;
    std::vector<Opened> open_;
    std::vector<Occurred> occurred_;
    std::int64_t now_ = 0;
};

void search(const Question& question, const AnalysisOptions& options, ConflictAnswer& answer) {
    RuleSystem system(question);
    const refine::Verdict verdict = refine::deadlock_free(system, refine::Model::failures, options.limits);
    answer.states = verdict.statistics.states;
    if (verdict.outcome == refine::Outcome::fails && verdict.counterexample) {
        answer.conflict = Answer::yes;
        answer.example = Replay(question, system).conflict(verdict.counterexample->steps);
    } else if (verdict.outcome == refine::Outcome::inconclusive) {
        answer.conflict = Answer::not_decided;
        answer.reason = verdict.reason;
    } else if (system.left_out()) {
        answer.conflict = Answer::not_decided;
        answer.reason = "too many obligations can be open at once";
    }
}

}  // namespace

ConflictAnswer find_conflict(const CheckedRules& rules, std::vector<std::size_t> judged,
                             const AnalysisOptions& options) {
    ConflictAnswer answer;
    answer.rules = judged;
    try {
        const Question question = make_question(rules, std::move(judged), options.without_limit, options.budget);
        if (may_clash(question)) search(question, options, answer);
    } catch (const NotDecided& error) {
        answer.conflict = Answer::not_decided;
        answer.reason = error.what();
    }
    return answer;
}

void for_each_question(const CheckedRules& rules, const AnalysisOptions& options,
                       const std::function<void(const ConflictAnswer&)>& take) {
    const auto ask = [&](std::vector<std::size_t> asked) { take(find_conflict(rules, std::move(asked), options)); };
    std::vector<std::size_t> judged;
    std::vector<std::size_t> with_two;
    for (std::size_t rule = 0; rule < rules.rules.size(); ++rule) {
        if (rules.rules[rule].assumed) continue;
        try {
            const Question alone = make_question(rules, {rule}, options.without_limit, options.budget);
            judged.push_back(rule);
            if (has_two_last(alone.obligations[0])) with_two.push_back(rule);
            ask({rule});
        } catch (const NotDecided& error) {
            ConflictAnswer answer;
            answer.rules = {rule};
            answer.conflict = Answer::not_decided;
            answer.reason = std::string(error.what()) + "; no other rule is compared with it";
            take(answer);
        }
    }
    for (std::size_t i = 0; i < judged.size(); ++i)
        for (std::size_t k = i + 1; k < judged.size(); ++k) {
            ask({judged[i], judged[k]});
            for (const std::size_t due : with_two)
                if (due != judged[i] && due != judged[k]) ask({due, judged[i], judged[k]});
        }
}

/// For each sample of its trigger: nothing is asked for, or what the other asks for implies it. Measures are free, and
/// so is whether another trigger comes, so nothing but the same occurrence can imply it.
bool redundant(const CheckedRules& rules, std::size_t rule, std::size_t by, const AnalysisOptions& options) {
    const auto all = samples(rules, {rule, by}, rules.rules[rule].trigger, options.without_limit, options.budget);
    return std::all_of(all.begin(), all.end(), [](const Sample& sample) {
        if (!sample.obligations[0] || always_fulfilled(*sample.obligations[0])) return true;
        return sample.obligations[1] && implies(*sample.obligations[1], *sample.obligations[0]);
    });
}

bool asks_for_nothing(const CheckedRules& rules, std::size_t rule, const AnalysisOptions& options) {
    const auto all = samples(rules, {rule}, rules.rules[rule].trigger, options.without_limit, options.budget);
    return std::none_of(all.begin(), all.end(), [](const Sample& sample) {
        return sample.obligations[0] && !always_fulfilled(*sample.obligations[0]);
    });
}

}  // namespace robochart::sleec
