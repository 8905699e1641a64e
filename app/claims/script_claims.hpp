// SPDX-License-Identifier: Apache-2.0
// Decides the assertions of a CSPM script in turns, in the same way as `verify` decides the claims of a model.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "app/command/script.hpp"
#include "app/report/script_report.hpp"
#include "driver/claims/turns.hpp"

namespace robochart::app {

/// The session of a script.
class OpenScript {
public:
    OpenScript(const LoadedScript&, const Options&);
    /// Returns the session, which is opened if necessary. Throws LimitReached.
    [[nodiscard]] cspm::Session& open_session();
    /// Frees the session to release its memory. The next session gives the same numbers to the same events, because
    /// results refer to events by number.
    void give_back();

private:
    const LoadedScript& loaded_;
    const Options& options_;
    std::unique_ptr<cspm::Session> session_;
    std::vector<std::string> events_;
};

/// Returns the assertion as printed, without its keyword.
[[nodiscard]] std::string text_of(const cspm::Decl& assertion);

/// The selected assertions of one script.
class ScriptClaims {
public:
    /// Called once for each assertion, when its result is final.
    using Show = std::function<void(const ScriptAssertion&, const process::EventTable&)>;
    /// Adds the assertions with the indices `chosen` to both reports as undecided. The reports are changed only under
    /// the lock Run::edit. The object stores references to all arguments except `chosen`.
    ScriptClaims(OpenScript&, const LoadedScript&, const Options&, const std::vector<std::size_t>& chosen,
                 ScriptReport&, Report&);

    /// Decides all assertions. Does not throw if a limit of the run is reached; the results of undecided assertions
    /// then contain the limit.
    void decide_all(const Show& show);

private:
    bool decide_in(const driver::Turn&, std::size_t at, const Show& show);
    void decide_one(const driver::SearchContext&, const cspm::Decl& assertion, ScriptAssertion& one);
    /// Writes the certificate of an assertion that holds.
    void certify(const cspm::Decl& assertion, const driver::SearchContext&, ScriptAssertion& one);
    void store_result(std::size_t at, ScriptAssertion one);
    void note_progress(const refine::Progress&, std::size_t at);
    void say_not_begun(const std::string& why);

    OpenScript& open_;
    const diagnostics::SourceManager& sources_;
    const Options& options_;
    ScriptReport& script_;
    Report& report_;
    std::vector<cspm::DeclPtr> assertions_;
    std::size_t first_ = 0;  ///< index of the first assertion in the report
    std::vector<bool> begun_, shown_;
};

}  // namespace robochart::app
