// SPDX-License-Identifier: Apache-2.0
// An exchange that prevents the program of its rank from being killed while the rank waits for other ranks.
#pragma once

#include <functional>
#include <memory>

#include "checker/refine/levels/exchange.hpp"

namespace robochart::refine {

/// Forwards all calls to another exchange. During each call, this exchange holds the object that Limits::undisturbed
/// returns. If a limit was reached during a call, the exchange holds this object until its destructor. By then, all
/// ranks have learned of the limit and written their results.
class UndisturbedExchange final : public Exchange {
public:
    /// `over` returns whether a limit is reached. `real` must outlive the object.
    UndisturbedExchange(Exchange& real, std::function<std::shared_ptr<void>()> undisturbed, std::function<bool()> over)
        : real_(real), undisturbed_(std::move(undisturbed)), over_(std::move(over)) {}

    [[nodiscard]] unsigned rank() const override { return real_.rank(); }
    [[nodiscard]] unsigned ranks() const override { return real_.ranks(); }
    [[nodiscard]] unsigned ranks_here() const override { return real_.ranks_here(); }
    void all_to_all(const Messages& out, Messages& in) override;
    void sum(std::span<std::uint64_t> values) override;
    [[nodiscard]] std::vector<Words> gather(const Words& own) override;
    void broadcast(std::string& bytes) override;
    [[nodiscard]] std::uint64_t bytes() const override { return real_.bytes(); }
    void leave_together() override { real_.leave_together(); }
    void begin_together() override { real_.begin_together(); }
    [[nodiscard]] bool left_together() const override { return real_.left_together(); }

private:
    /// Exists while the rank waits for other ranks.
    class Wait;

    Exchange& real_;
    std::function<std::shared_ptr<void>()> undisturbed_;
    std::function<bool()> over_;
    std::shared_ptr<void> held_;
};

}  // namespace robochart::refine
