// SPDX-License-Identifier: Apache-2.0
// Decides the claims of one script.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "checker/cspm/session.hpp"
#include "driver/claims/bounds.hpp"
#include "driver/claims/second_look.hpp"
#include "driver/claims/taken_guards.hpp"
#include "driver/claims/turns.hpp"
#include "driver/model/pipeline.hpp"
#include "driver/results/results.hpp"
#include "driver/rules/rule_claims.hpp"
#include "driver/settings/search_context.hpp"

namespace robochart::driver {

/// The values for which claims are decided.
enum class Values {
    of_project,   ///< the values of all data of the project
    of_carriers,  ///< the values of the finite instantiation; other claims use classes of values
};

using ClaimFilter = std::function<bool(const csp_emit::Obligation&)>;

/// The project, script and services with which claims are decided.
struct ClaimContext {
    Project& project;
    const SearchContext& search;
    const csp_emit::Emission& emission;
    cspm::Session& session;
    const TakenGuards& guards;
    const ClaimFilter& takes;  ///< the claims that are decided in this context
};

/// Decides the premises of claims. If several claims share a premise, the premise is decided only once.
class Premises {
public:
    /// Decides the premise of a decided claim. If the premise does not hold, the claim becomes inconclusive and gets
    /// the run that refutes the premise.
    void apply_premise(const ClaimContext& context, const csp_emit::Obligation& obligation, AssertionReport& report);

private:
    AssertionReport answer_premise(const ClaimContext& context, const csp_emit::Obligation& claim);

    std::vector<std::pair<std::shared_ptr<const csp_emit::Premise>, AssertionReport>> decided_;
};

/// A claim that TimeClaims lists.
struct ListedClaim {
    const csp_emit::Obligation* obligation = nullptr;
    std::size_t number = 0;  ///< its position in the list
};

/// Decides claims in one semantics, timed or untimed.
class TimeClaims {
public:
    /// Adds the claims that `takes` selects to the results, as undecided. All arguments must outlive the object.
    TimeClaims(Project& project, const csp_emit::Emission& emission, const SearchContext& search, csp_emit::Time time,
               ClaimFilter takes, Values values, ClaimResults& results);

    [[nodiscard]] const std::vector<ListedClaim>& claims() const { return claims_; }
    /// Decides the claim within the turn. Until the report is stored, the results contain only the progress.
    [[nodiscard]] AssertionReport decide(const Turn& turn, const ListedClaim& claim);
    /// Returns the report about a claim that is still undecided.
    [[nodiscard]] const AssertionReport& undecided(const ListedClaim& claim) const { return announced_[claim.number]; }
    /// Stores the report of a claim in the results. Returns true if the claim is decided.
    bool store(AssertionReport report, const ListedClaim& claim);
    /// Returns the claim together with a function that decides it within a turn.
    [[nodiscard]] static WaitingClaim waiting(const ListedClaim& claim, std::function<bool(const Turn&)> decide);

    /// Claims that hold get certificates, if the settings name a folder for them.
    void write_certificates() { certifies_ = !search_.settings.claims.certificates.empty(); }
    /// Frees the session that the claims share. The next claim opens the script again.
    void give_back();
    void measure_if_asked();

private:
    [[nodiscard]] bool is_in_carriers() const { return values_ == Values::of_carriers; }
    bool open_session();
    /// If a limit has just ended a long evaluation, returns "; " and the place of this evaluation in the model.
    /// Otherwise returns "".
    [[nodiscard]] std::string stopped_evaluation() const;
    /// Decides the whole claim. Returns the assertions on which a positive answer is based. The list is empty if the
    /// claim is decided without assertions.
    std::vector<cspm::DeclPtr> decide_whole(const ClaimContext& context, const csp_emit::Obligation& obligation,
                                            AssertionReport& one);
    /// Writes the certificates of a claim that holds; `assertions` are its assertions.
    CertificateReport certificate_of(const ListedClaim& claim, const AssertionReport& one,
                                     const std::vector<cspm::DeclPtr>& assertions, const SearchContext& search);
    void note_progress(const refine::Progress& progress, std::size_t at);

    Project& project_;
    SearchContext search_;
    csp_emit::Time time_;
    ClaimFilter takes_;
    Values values_;
    const csp_emit::Emission& emission_;
    ClaimResults& results_;
    BoundWatch watch_;
    ReachedBounds reached_;
    TakenGuards guards_;
    RuleClaims rules_;
    Premises premises_;
    std::unique_ptr<cspm::Session> session_;
    bool given_back_ = false;
    bool certifies_ = false;  ///< true if claims that hold get certificates
    std::optional<SecondLook> second_look_;
    std::size_t first_ = 0;                   ///< index of the first claim in the results
    std::vector<AssertionReport> announced_;  ///< the reports of the claims before their decision began
    std::vector<ListedClaim> claims_;
};

}  // namespace robochart::driver
