// SPDX-License-Identifier: Apache-2.0
// Runs the main loop over streams. A separate thread reads messages. So a request can be cancelled before it starts or
// while it is handled, and diagnostics are not sent while further messages arrive.
#include <condition_variable>
#include <exception>
#include <istream>
#include <mutex>
#include <ostream>
#include <thread>

#include "editors/server/protocol/transport.hpp"
#include "editors/server/server.hpp"

namespace robochart::lsp {

namespace {

/// An item from the reader thread: the end of input, a message, or a fault.
struct Arrival {
    bool end = false;
    Json message;
    std::string fault;
};

/// The messages from the reader thread.
class Inbox {
public:
    void put_arrival(Arrival arrival) {
        const std::lock_guard lock(mutex_);
        arrivals_.push_back(std::move(arrival));
        filled_.notify_one();
    }
    /// Takes all available items. If `wait` is true, waits until there is at least one.
    std::deque<Arrival> take_arrivals(bool wait) {
        std::unique_lock lock(mutex_);
        if (wait) filled_.wait(lock, [this] { return !arrivals_.empty(); });
        return std::exchange(arrivals_, {});
    }

private:
    std::mutex mutex_;
    std::condition_variable filled_;
    std::deque<Arrival> arrivals_;
};

Arrival arrival_of(Frame frame) {
    Arrival arrival;
    arrival.end = frame.kind == Frame::Kind::end;
    if (frame.kind == Frame::Kind::fault) arrival.fault = std::move(frame.text);
    if (frame.kind == Frame::Kind::message) arrival.message = read_json(frame.text, arrival.fault);
    return arrival;
}

/// True for `exit`, which is the last message. Reading after it could block forever.
bool is_exit(const Arrival& arrival) {
    const View message = arrival.message;
    return arrival.fault.empty() && message["method"].text() == "exit" && !message.has_key("id");
}

void read_all(std::istream& in, Inbox& inbox, Interruption& interruption) {
    FrameReader reader(in);
    while (true) {
        Arrival arrival = arrival_of(reader.next_frame());
        if (arrival.end)
            interruption.input_ended();
        else if (arrival.fault.empty())
            interruption.note_arrival(arrival.message);
        const bool last = arrival.end || is_exit(arrival);
        inbox.put_arrival(std::move(arrival));
        if (last) return;
    }
}

}  // namespace

int serve(std::istream& in, std::ostream& out) {
    Server server([&out](const std::string& text) { write_frame(out, text); });
    Inbox inbox;
    std::exception_ptr failure;  // an exception of the reader; the loop then ends as at the end of the input
    std::thread reader([&] {
        try {
            read_all(in, inbox, server.interruption());
        } catch (...) {
            failure = std::current_exception();
            Arrival end;
            end.end = true;
            inbox.put_arrival(std::move(end));
        }
    });
    bool ended = false;
    const auto receive = [&](bool wait) {
        for (Arrival& arrival : inbox.take_arrivals(wait)) {
            ended = ended || arrival.end;
            if (!arrival.end) server.receive_message(std::move(arrival.message), std::move(arrival.fault));
        }
    };
    while (!server.exit_code() && (!ended || server.has_work())) {
        receive(!server.has_work() && !ended);
        if (server.has_work()) server.handle_next();
        // Further messages may have arrived, and diagnostics of an outdated text would be useless.
        receive(false);
        if (!server.has_work() && !ended) server.use_idle_time();
    }
    reader.join();
    if (failure) std::rethrow_exception(failure);
    return server.exit_code().value_or(1);
}

}  // namespace robochart::lsp
