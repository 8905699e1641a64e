// SPDX-License-Identifier: Apache-2.0
// Follows events of machines through the connections of controllers and modules, to find their labels and buffers in
// PRISM (R2, R12, R13).
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "prism/emit/context.hpp"

namespace robochart::prism_emit {

/// A machine as the indices of its controller (in Module::controllers) and of itself (in Controller::machines).
struct Seat {
    std::uint32_t controller = 0, machine = 0;
    friend auto operator<=>(const Seat&, const Seat&) = default;
};

enum class Direction { out, in };  ///< direction from the point of view of the machine

/// Connects an event of a machine with another machine or with the platform.
struct Channel {
    enum class Kind { platform, buffer, joint };
    Kind kind = Kind::platform;
    std::string name;                     ///< "odsTick_18"
    std::optional<Carrier> carrier;       ///< the range of the value that the channel carries, if any
    bool sent = false, received = false;  ///< whether commands of machines that send or receive have been made

    /// Return the labels of the two ends.
    [[nodiscard]] std::string out_label() const;
    [[nodiscard]] std::string in_label() const;
    /// Return the variable with the value at an end, and the variable that is true between handshakes.
    [[nodiscard]] std::string value_at(Direction) const;
    [[nodiscard]] std::string ready_at(Direction) const;
};

class Channels {
public:
    explicit Channels(Context& context) : context_(context) {}

    /// Returns the channel of a machine's event in one direction. Returns null and reports a finding if the event
    /// cannot be encoded.
    [[nodiscard]] Channel* find_channel(Seat seat, const ir::Event& event, Direction direction, diagnostics::Span span);

    /// Adds the modules of buffers and of the platform (R12, R13) for all channels that were used.
    void emit_modules();

private:
    /// An event at one end of a connection. The event belongs to a machine, a controller or the platform.
    struct End {
        enum class Level { machine, controller, platform } level = Level::machine;
        Seat seat;
        std::string event;
        friend auto operator<=>(const End&, const End&) = default;
    };
    struct Hop {
        End to;
        bool async = false;
    };
    struct Route {
        End end;
        bool async = false;
    };

    [[nodiscard]] const ir::Controller& controller_at(std::uint32_t index) const;
    [[nodiscard]] std::vector<Hop> next_hops(const End& from, Direction direction, bool inside) const;
    void add_hops(const std::vector<ir::Connection>& connections, const End& from, Direction direction,
                  const std::function<End(const ir::ConnectionEnd&)>& place, std::vector<Hop>& result) const;
    [[nodiscard]] std::optional<Route> follow_route(const End& from, Direction direction, std::string& problem) const;
    [[nodiscard]] std::string describe_end(const End&) const;
    void emit_buffer(const Channel&);
    void emit_platform();

    Context& context_;
    std::vector<std::unique_ptr<Channel>> channels_;
    std::map<std::tuple<End, End>, Channel*> found_;  ///< by sender and receiver
};

}  // namespace robochart::prism_emit
