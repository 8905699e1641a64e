// SPDX-License-Identifier: Apache-2.0
// Computes probabilistic assertions in the selected encoding.
#include "driver/claims/probability_claims.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <memory>
#include <optional>
#include <utility>

#include "base/diagnostics/escape.hpp"
#include "driver/claims/probability_basis.hpp"
#include "driver/settings/usage_error.hpp"
#include "frontend/syntax/print.hpp"
#include "prism/assertions/process/process_encoding.hpp"
#include "prism/assertions/robotool/robotool_encoding.hpp"
#include "semantics/ir/query.hpp"

namespace robochart::driver {
namespace {

using prism::Result;
using probability::NotExpressed;
using probability::Row;

/// An assertion and its file, in whose scope its names are resolved.
struct Claim {
    const frontend::File* file = nullptr;
    const frontend::ProbabilisticAssertion* assertion = nullptr;
};

std::vector<Claim> claims_of(const Project& project, const SearchContext& search) {
    std::vector<Claim> result;
    for (const auto& file : project.model->files)
        for (const frontend::ProbabilisticAssertion& assertion : file->probabilistic_assertions)
            if (is_selected(search.settings.claims, assertion.name)) result.push_back({file.get(), &assertion});
    return result;
}

/// Returns the answer for a row. An error has priority over a failure, and a failure over an unknown answer.
Answer answer_of(const Row& row) {
    if (!row.error.empty()) return Answer::error;
    Answer answer = row.path ? Answer::computed : Answer::holds;
    for (const Result& result : row.results) {
        if (result.kind == Result::Kind::unknown) return Answer::inconclusive;
        if (result.kind != Result::Kind::truth) answer = Answer::computed;
        if (result.kind == Result::Kind::truth && !result.truth) return Answer::fails;
    }
    return answer;
}

Answer answer_of(const std::vector<Row>& rows) {
    Answer answer = rows.empty() ? Answer::inconclusive : answer_of(rows.front());
    for (const Answer worse : {Answer::inconclusive, Answer::fails, Answer::error})
        if (std::ranges::any_of(rows, [&](const Row& row) { return answer_of(row) == worse; })) answer = worse;
    return answer;
}

std::string subject_list(const std::vector<std::string>& subjects) {
    std::string text;
    for (const std::string& subject : subjects) text += fmt::format("{}`{}`", text.empty() ? "" : ", ", subject);
    return text;
}

/// Returns the component that a property is about. Names in the property begin with the name of this component. A
/// property without names is about the only component of the highest level.
ir::ComponentRef subject_of(const Project& project, const std::vector<std::string>& subjects) {
    if (subjects.size() > 1)
        throw NotExpressed(fmt::format("it speaks of several components: {}", subject_list(subjects)));
    const std::string subject = subjects.empty() ? "" : subjects.front();
    const std::vector<ir::ComponentRef> found = code_components(project.system, subject);
    if (found.size() == 1) return found.front();
    if (subjects.empty()) throw NotExpressed("it names no component, and the model has several");
    if (found.empty()) throw NotExpressed(fmt::format("`{}` has no process of its own", subject));
    throw NotExpressed(fmt::format("there are several components `{}`", subject));
}

std::string name_of(Scheduler scheduler) {
    constexpr std::array<const char*, 3> names{"any", "urgent", "uniform"};
    return names[static_cast<std::size_t>(scheduler)];
}

probability::Scheduler scheduler_of(const SearchContext& search) {
    switch (search.settings.probability.scheduler) {
        case Scheduler::any:
            break;
        case Scheduler::urgent:
            return probability::Scheduler::urgent;
        case Scheduler::uniform:
            return probability::Scheduler::uniform;
    }
    return probability::Scheduler::any;
}

/// True if the assertion is decided on RoboTool's Markov chain. Random paths always use this chain, because paths of a
/// decision process depend on the scheduler.
bool uses_robotool(const SearchContext& search, const frontend::ProbabilisticAssertion& assertion) {
    return search.settings.probability.encoding == Encoding::robotool || probability::is_simulated(assertion);
}

class Decider {
public:
    Decider(Project& project, const SearchContext& search, prism_emit::Preferences preferences)
        : project_(project),
          search_(search),
          preferences_(std::move(preferences)),
          all_(*project.model),
          budget_(limits_of_turn()) {}

    /// Throws LimitReached if a limit of the run is reached.
    void operator()(const Claim& claim, const Turn& turn, AssertionReport& report) {
        turn_ = turn;
        try {
            const probability::Question question = this->make_question(claim);
            report.reason.clear();
            RowBasis basis;
            probability::decide_question(*encoding_, question, deciding_options(), budget_, [&](Row row) {
                if (row.error.empty()) basis.add_row(row, basis_of(row));
                add_row(std::move(row), report);
            });
            if (report.answer != Answer::inconclusive) report.basis = basis.basis();
        } catch (const diagnostics::LimitReached& limit) {
            encoding_.reset();  // it may be incomplete
            if (run_is_over(search_.services.budget())) throw;
            report.answer = Answer::inconclusive;
            report.reason = turn_.is_over() ? "the time limit was reached" : limit.what();
        } catch (const NotExpressed& why) {
            report.answer = Answer::unchecked;
            report.reason =
                fmt::format("{}: not checked: {}", diagnostics::escape_for_display(report.place), why.what());
        } catch (const probability::Wrong& wrong) {
            report.answer = Answer::error;
            report.reason = wrong.what();
        }
    }

    /// Frees the encoding that claims share.
    void give_back() { encoding_.reset(); }

private:
    /// Returns the limits of the run, with an interruption at the end of the current turn. The encoding uses one budget
    /// in the turns of several claims.
    diagnostics::Limits limits_of_turn() {
        diagnostics::Limits limits = search_.services.budget().limits();
        limits.interrupted = [this] { return search_.services.budget().is_interrupted() || turn_.is_over(); };
        return limits;
    }

    probability::Question make_question(const Claim& claim) {
        const ir::ComponentRef subject =
            subject_of(project_, probability::subjects_of(all_, *claim.file, *claim.assertion));
        const auto functions = probability::functions_of(all_, *claim.file, *claim.assertion);
        // RoboTool's model contains the functions of the assertion. If the assertion has none, the model is reused for
        // the next property.
        const bool chain = uses_robotool(search_, *claim.assertion);
        const bool same = encoding_ && chain == chain_ && ir::qualified_name(subject) == ir::qualified_name(subject_);
        if (!same || (chain && (!functions.empty() || with_functions_))) {
            encoding_.reset();
            subject_ = subject;
            encoding_ = chain ? make_robotool_encoding(functions) : make_process_encoding();
            chain_ = chain;
            with_functions_ = !functions.empty();
        }
        return probability::translate_assertion(all_, *claim.file, *claim.assertion, encoding_->elements());
    }

    [[nodiscard]] probability::Deciding deciding_options() const {
        return {search_.settings.probability.epsilon, search_.settings.probability.exact,
                search_.settings.probability.seed, search_.settings.limits.threads};
    }

    std::unique_ptr<probability::Encoding> make_robotool_encoding(
        const std::map<std::string, probability::Function>& functions) {
        if (subject_.kind != ir::ComponentKind::module)
            throw NotExpressed(fmt::format("RoboTool's encoding is one of modules, and `{}` is none", subject_.path));
        probability::RoboToolOptions options;
        options.preferences = preferences_;
        options.constants = project_.asked.constants;
        options.max_states = search_.settings.limits.max_states;
        options.exact = search_.settings.probability.exact;
        options.budget = &budget_;
        return std::make_unique<probability::RoboToolEncoding>(
            project_.system, project_.system.modules[subject_.definition], options, functions);
    }

    std::unique_ptr<probability::Encoding> make_process_encoding() {
        probability::ProcessOptions options;
        options.scheduler = scheduler_of(search_);
        options.instantiation = project_.asked;
        options.max_states = search_.settings.limits.max_states;
        options.exact = search_.settings.probability.exact;
        options.budget = &budget_;
        options.on_session = [this](const csp_emit::Emission& emission, const ir::Instantiation& instantiation,
                                    cspm::Session& session) {
            watched_ = std::make_unique<WatchedProcess>(project_, search_, emission, instantiation, session);
        };
        return std::make_unique<probability::ProcessEncoding>(project_.system, subject_, project_.sources, options);
    }

    /// Returns the basis of a row. It must be computed before the encoding of the next row replaces the current one.
    [[nodiscard]] Basis basis_of(const Row& row) {
        const std::string subject = ir::qualified_name(subject_);
        Basis basis;
        if (!chain_) {
            basis = watched_->reached_bounds(subject);
            for (Ground& ground : chosen_constants(project_, watched_->instantiation(), subject, row))
                add(basis, std::move(ground));
        }
        for (Ground& ground : sampling_basis(row, search_.settings.probability.seed)) add(basis, std::move(ground));
        return basis;
    }

    static void add_row(Row row, AssertionReport& report) {
        ProbabilityReport& found = *report.probability;
        report.searched = true;
        report.statistics.states = std::max(report.statistics.states, row.states);
        report.statistics.transitions = std::max(report.statistics.transitions, row.transitions);
        report.statistics.seconds += row.seconds;
        found.rows.push_back(std::move(row));
        report.answer = answer_of(found.rows);
    }

    Project& project_;
    SearchContext search_;
    prism_emit::Preferences preferences_;
    probability::Assertions all_;
    Turn turn_;
    diagnostics::Budget budget_;
    std::unique_ptr<WatchedProcess> watched_;  ///< observes the session of the encoding, so it must outlive it
    std::unique_ptr<probability::Encoding> encoding_;
    ir::ComponentRef subject_;
    bool chain_ = false;  ///< true if RoboTool's chain is used
    bool with_functions_ = false;
};

}  // namespace

struct ProbabilityClaims::Impl {
    Impl(Project& project, const SearchContext& given, prism_emit::Preferences preferences)
        : search(given), claims(claims_of(project, given)), decide(project, given, std::move(preferences)) {}

    bool decide_in(const Turn& turn, std::size_t number, ClaimResults& results) {
        AssertionReport one = announced[number];
        decide(claims[number], turn, one);
        const bool decided = one.answer != Answer::inconclusive;
        if (!decided) one.reason = ended_turn(one.reason, {search.settings, search.services, turn});
        const auto edit = search.services.edit();
        results.assertions[first + number] = std::move(one);
        return decided;
    }

    SearchContext search;
    std::vector<Claim> claims;
    Decider decide;
    std::size_t first = 0;                   ///< index of the first claim in the report
    std::vector<AssertionReport> announced;  ///< the claims before anything was known about them
};

ProbabilityClaims::ProbabilityClaims(Project& project, const SearchContext& search, prism_emit::Preferences preferences,
                                     ClaimResults& results)
    : impl_(std::make_unique<Impl>(project, search, std::move(preferences))), results_(results) {
    const std::vector<Claim>& claims = impl_->claims;
    if (claims.empty()) return;
    const Scheduler scheduler = search.settings.probability.scheduler;
    if (search.settings.probability.encoding == Encoding::robotool && scheduler != Scheduler::any)
        throw UsageError("--scheduler does not apply to RoboTool's encoding, which has no choices");
    impl_->first = results.assertions.size();
    const auto edit = search.services.edit();
    for (const Claim& claim : claims) {
        AssertionReport one;
        one.title = fmt::format("{}{} {}", project.label, claim.assertion->name,
                                diagnostics::escape_for_display(frontend::claim_text(*claim.assertion)));
        one.name = claim.assertion->name;
        set_place(project.sources, claim.assertion->span, one);
        one.reason = undecided_at_limit;
        const bool chain = uses_robotool(search, *claim.assertion);
        one.probability = ProbabilityReport{chain ? "robotool" : "csp", chain ? "" : name_of(scheduler), {}};
        impl_->announced.push_back(one);
        results.assertions.push_back(std::move(one));
    }
}

ProbabilityClaims::~ProbabilityClaims() = default;

void ProbabilityClaims::add_to(std::vector<WaitingClaim>& claims) {
    for (std::size_t i = 0; i < impl_->claims.size(); ++i)
        claims.push_back({impl_->claims[i].assertion->name,
                          [this, i](const Turn& turn) { return impl_->decide_in(turn, i, results_); }});
}

void ProbabilityClaims::give_back() {
    impl_->decide.give_back();
}

}  // namespace robochart::driver
