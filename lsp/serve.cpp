// The loop over streams. One thread reads, so that a cancellation is seen before the request that it cancels is begun,
// and so that diagnostics wait while the editor is still sending.
#include <condition_variable>
#include <istream>
#include <mutex>
#include <ostream>
#include <thread>

#include "lsp/server.hpp"
#include "lsp/transport.hpp"

namespace robochart::lsp {

namespace {

/// Frames on their way from the reading thread.
class Inbox {
public:
    void put(Frame frame) {
        const std::lock_guard lock(mutex_);
        frames_.push_back(std::move(frame));
        filled_.notify_one();
    }
    /// Everything there is; waits for something if `wait`.
    std::deque<Frame> take(bool wait) {
        std::unique_lock lock(mutex_);
        if (wait) filled_.wait(lock, [this] { return !frames_.empty(); });
        return std::exchange(frames_, {});
    }

private:
    std::mutex mutex_;
    std::condition_variable filled_;
    std::deque<Frame> frames_;
};

/// `exit` is the last message: reading behind it could wait for ever.
bool is_exit(const Frame& frame) {
    if (frame.kind != Frame::Kind::message || frame.text.find("\"exit\"") == std::string::npos) return false;
    std::string error;
    const Json message = read_json(frame.text, error);
    return message["method"].text() == "exit" && !message.has("id");
}

void read_all(std::istream& in, Inbox& inbox) {
    FrameReader reader(in);
    while (true) {
        Frame frame = reader.next();
        const bool last = frame.kind == Frame::Kind::end || is_exit(frame);
        inbox.put(std::move(frame));
        if (last) return;
    }
}

}  // namespace

int serve(std::istream& in, std::ostream& out) {
    Server server([&out](const std::string& text) { write_frame(out, text); });
    Inbox inbox;
    std::thread reader([&] { read_all(in, inbox); });
    bool ended = false;
    const auto receive = [&](bool wait) {
        for (Frame& frame : inbox.take(wait)) {
            if (frame.kind == Frame::Kind::message) server.receive(std::move(frame.text));
            if (frame.kind == Frame::Kind::fault) server.receive_fault(frame.text);
            ended = ended || frame.kind == Frame::Kind::end;
        }
    };
    while (!server.exit_code() && (!ended || server.has_work())) {
        receive(!server.has_work() && !ended);
        if (server.has_work()) server.step();
        // More may have come meanwhile; diagnostics of a text that is already old help nobody.
        receive(false);
        if (!server.has_work() && !ended) server.idle();
    }
    reader.join();
    return server.exit_code().value_or(1);
}

}  // namespace robochart::lsp
