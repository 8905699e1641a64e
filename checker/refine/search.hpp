// Breadth-first search of a system's states paired with the node of a monitor that watches its runs. States are
// expanded in the order of their discovery, so the first finding has a shortest run, the same every time.
#pragma once

#include <optional>
#include <vector>

#include "checker/lts/chunked_vector.hpp"
#include "checker/lts/state_store.hpp"
#include "checker/refine/budget.hpp"
#include "checker/refine/run.hpp"
#include "checker/refine/stability.hpp"

namespace robochart::refine {

/// What a question watches: nodes advance by visible events and tick; taus keep the node.
class Monitor {
public:
    using Node = lts::Word;
    enum class Effect { follow, ignore, violation };
    struct Advance {
        Effect effect;
        Node node = 0;
    };

    virtual ~Monitor() = default;
    virtual Node start() = 0;
    virtual Advance advance(Node node, process::Event event) = 0;
    /// What is wrong with a run that ends in this node and can go on like this.
    virtual std::optional<ViolationKind> examine(Node node, const Offer& offer) = 0;
};

/// A violation: the pair where the run ends, and for a forbidden event the event after it.
struct Finding {
    ViolationKind kind;
    lts::StateIndex pair;
    process::Event event = process::tau;
};

class Search final : private lts::SuccessorSink {
public:
    Search(lts::TransitionSystem& system, Monitor& monitor, Budget& budget, bool keep_taus = false);

    /// The first violation by length of run; among runs of one length a state's fault comes before a forbidden event.
    /// None when all pairs have been seen. Throws LimitReached.
    std::optional<Finding> first_violation();
    /// After a search without violation that kept taus: the first pair on a tau cycle.
    std::optional<lts::StateIndex> first_tau_cycle();
    /// A shortest cycle of taus through the pair, as pairs; ends with the pair itself.
    std::vector<lts::StateIndex> tau_cycle(lts::StateIndex pair);

    /// The run by which the pair was found.
    [[nodiscard]] std::vector<lts::StateIndex> path_to(lts::StateIndex pair) const;
    [[nodiscard]] Monitor::Node node(lts::StateIndex pair) const { return pairs_[pair][0]; }
    [[nodiscard]] lts::StateView state(lts::StateIndex pair) const { return pairs_[pair].subspan(1); }
    /// The run along these pairs, the first of which is where it starts.
    [[nodiscard]] Run run_along(const std::vector<lts::StateIndex>& pairs, bool by_taus_alone = false);

    [[nodiscard]] std::uint64_t states() const { return pairs_.size(); }
    [[nodiscard]] std::uint64_t transitions() const { return transitions_; }
    [[nodiscard]] std::uint64_t depth() const { return depth_; }

private:
    void add(process::Event event, lts::StateView target, process::Event revealed) override;
    void begin();
    std::optional<Finding> expand(lts::StateIndex pair);
    void visit(Monitor::Node node, lts::StateView target, process::Event event);

    lts::TransitionSystem& system_;
    Monitor& monitor_;
    Budget& budget_;
    lts::StateStore pairs_;
    lts::ChunkedVector<lts::StateIndex> parents_;
    bool keep_taus_;
    lts::ChunkedVector<std::uint64_t> first_tau_;  // per pair, where its targets begin; one more at the end
    lts::ChunkedVector<lts::StateIndex> tau_targets_;
    std::uint64_t transitions_ = 0;
    std::uint64_t depth_ = 0;

    lts::StateIndex current_ = 0;  // the pair being expanded
    Offer offer_;
    std::optional<Finding> forbidden_;  // the first forbidden event, while its level is finished
    std::vector<lts::Word> buffer_;
};

}  // namespace robochart::refine
