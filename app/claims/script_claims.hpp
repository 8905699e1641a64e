// SPDX-License-Identifier: Apache-2.0
// The assertions of a CSPM script, decided in turns as the claims of a model are.
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
    /// Opens it if it is not open. Throws LimitReached.
    [[nodiscard]] cspm::Session& open_session();
    /// Frees the session. The next one has its events, with their numbers: answers refer to them.
    void give_back();

private:
    const LoadedScript& loaded_;
    const Options& options_;
    std::unique_ptr<cspm::Session> session_;
    std::vector<std::string> events_;
};

/// The assertion without its keyword, as printed.
[[nodiscard]] std::string text_of(const cspm::Decl& assertion);

/// The assertions of one script that are asked for.
class ScriptClaims {
public:
    /// Called once for each, when no turn will add to it.
    using Show = std::function<void(const ScriptAssertion&, const process::EventTable&)>;
    /// Lists those with these places among the script's assertions as not decided, in both reports. These are changed
    /// under Run::edit. Refers to all that it is given.
    ScriptClaims(OpenScript&, const LoadedScript&, const Options&, const std::vector<std::size_t>& chosen,
                 ScriptReport&, Report&);

    /// Throws nothing at a limit of the run: what is not decided by then says so.
    void decide_all(const Show& show);

private:
    bool decide_in(const driver::Turn&, std::size_t at, const Show& show);
    void decide_one(const driver::SearchContext&, const cspm::Decl& assertion, ScriptAssertion& one);
    void store_result(std::size_t at, ScriptAssertion one);
    void note_progress(const refine::Progress&, std::size_t at);
    void say_not_begun(const std::string& why);

    OpenScript& open_;
    const diagnostics::SourceManager& sources_;
    const Options& options_;
    ScriptReport& script_;
    Report& report_;
    std::vector<cspm::DeclPtr> assertions_;
    std::size_t first_ = 0;  ///< place of the first one in the report
    std::vector<bool> begun_, shown_;
};

}  // namespace robochart::app
