// SPDX-License-Identifier: Apache-2.0
// Follows the code in NF_c(M), one event after the other. Determinises NF_c(M) while it does so. Random walks and the
// search over partial readings use this class.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>

#include "checker/refine/search/budget.hpp"
#include "checker/refine/verdict/normal_form.hpp"
#include "conformance/check/result.hpp"
#include "conformance/model/normal_form_system.hpp"
#include "cpp_emit/runtime/explore_abi.h"

namespace robochart::conformance {

/// The point where code and model differ.
struct Mismatch {
    Outcome outcome = Outcome::differs;
    std::string reason;
    std::string expected;
    const diagnostics::Rule* rule = nullptr;  ///< only if the outcome is not_schedulable
};

class Follower {
public:
    using Node = refine::NormalForm::Node;

    Follower(ModelGraph& model, const Alphabet& alphabet, std::uint32_t cycle_length, const refine::Limits& limits,
             Frame frame = {});

    [[nodiscard]] Node initial_node() { return form_.initial(); }
    [[nodiscard]] std::size_t node_count() const { return form_.size(); }
    [[nodiscard]] const NormalFormSystem& system() const { return system_; }

    /// Follows an event that L(G) offers alone. With `read`, it is one of all readings of a register. NF_c(M) must
    /// allow the event and must not require any other. If this is so, advances `node` and returns no value. Otherwise
    /// returns the mismatch.
    [[nodiscard]] std::optional<Mismatch> follow_event(Node& node, process::Event event, bool read);
    /// Follows the end of a cycle, after its writes. `cut`: the code made more outputs than the log can contain. Then
    /// the outputs that are missing are not checked.
    [[nodiscard]] std::optional<Mismatch> finish_cycle(Node& node, rc_result outcome, bool cut);
    /// Returns whether the code has terminated in the cycle that was finished last.
    [[nodiscard]] bool has_terminated() const { return over_; }
    /// With Frame::unread: returns a register whose reading affects the model in this node, or no value if there is no
    /// such register.
    [[nodiscard]] std::optional<std::uint32_t> asked_register(Node node);
    /// Sets a function that returns true for states of the model whose steps are unknown. If the model may be in such a
    /// state, the mismatch has the outcome `inconclusive`.
    void end_where(std::function<bool(lts::StateView)> unknown) { unknown_ = std::move(unknown); }

private:
    [[nodiscard]] Mismatch make_mismatch(Node node, std::string reason);
    [[nodiscard]] bool is_unknown(Node node) const;
    [[nodiscard]] bool may_refuse(Node node, std::optional<process::Event> but);
    [[nodiscard]] std::optional<Mismatch> model_stops(Node node);
    [[nodiscard]] bool has_endless_run(Node from);
    [[nodiscard]] std::string describe_allowed(Node node);

    const ModelGraph& model_;
    const Alphabet& alphabet_;
    std::uint32_t cycle_length_;
    bool unread_;
    std::function<bool(lts::StateView)> unknown_;  ///< empty: all steps are known
    NormalFormSystem system_;
    refine::Budget budget_;
    refine::NormalForm form_;
    bool over_ = false;
};

}  // namespace robochart::conformance
