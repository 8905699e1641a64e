// SPDX-License-Identifier: Apache-2.0
// Decides claims of the model. If carriers may limit the answer to a claim, decides the claim with free data, too
// (docs/data.md, "Computed data").
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "driver/claims/class_project.hpp"
#include "driver/claims/time_claims.hpp"

namespace robochart::driver {

/// Makes the project with free data when a claim needs this project for the first time.
class FreeData {
public:
    /// All arguments must outlive the object. `classes` is the result for the same project.
    FreeData(const Project& project, const Settings& settings, const ClassProject& classes);

    /// Returns false if no data can be free, as far as this is known without making the project.
    [[nodiscard]] bool may_exist() const { return possible_ && (!made_ || made_->project); }
    /// Returns the project. Makes the project if it has not been made.
    [[nodiscard]] const FreeProject& project();
    /// Returns true if carriers are so large that claims should first be decided with free data. Only then does this
    /// function make the project with free data.
    [[nodiscard]] bool comes_first();

private:
    const Project& project_;
    const Settings& settings_;
    const ClassProject& classes_;
    bool possible_;
    std::optional<FreeProject> made_;
    std::optional<bool> large_;  ///< true if the model, or its class model, has a large carrier
};

/// Decides the claims of one list. If the carriers may limit the answer to a claim, the claim is also decided with free
/// data. The claims with free data are in a separate list that the results do not contain.
class FreeClaims {
public:
    /// All arguments must outlive the object.
    FreeClaims(TimeClaims& own, FreeData& data, const SearchContext& search, csp_emit::Time time)
        : own_(own), data_(data), search_(search), time_(time) {}

    void add_to(std::vector<WaitingClaim>& claims);
    /// Frees the session of the list with free data.
    void give_back() {
        if (free_) free_->give_back();
    }

private:
    /// Decides the claim and stores its answer. Returns true if the claim is decided.
    bool decide_in(const Turn& turn, const ListedClaim& claim);
    [[nodiscard]] AssertionReport decide_alone(const Turn& turn, const ListedClaim& claim);
    /// Decides the claim with free data. If the answer also applies to the model, writes it to the report and returns
    /// true.
    bool answer(const Turn& turn, const csp_emit::Obligation& obligation, AssertionReport& report);
    [[nodiscard]] std::optional<ListedClaim> free_claim(const csp_emit::Obligation& obligation);

    TimeClaims& own_;
    FreeData& data_;
    SearchContext search_;
    csp_emit::Time time_;
    ClaimResults results_;  ///< the results of the claims with free data
    std::unique_ptr<TimeClaims> free_;
    /// An answer with free data, and the run that shows it.
    struct Tried {
        Answer answer = Answer::inconclusive;
        std::string run;
    };
    std::map<std::string, Tried> tried_;  ///< by title
};

}  // namespace robochart::driver
