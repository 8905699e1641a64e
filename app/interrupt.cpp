#include "app/interrupt.hpp"

#include <csignal>

namespace robochart::app {
namespace {

// The one mutable object at namespace scope: a signal handler can reach nothing else.
volatile std::sig_atomic_t signalled = 0;

extern "C" void on_signal(int signal) {
    if (signalled != 0) {
        std::signal(signal, SIG_DFL);
        std::raise(signal);
    }
    signalled = 1;
}

}  // namespace

InterruptScope::InterruptScope() {
    std::signal(SIGINT, on_signal);
    std::signal(SIGTERM, on_signal);
}

InterruptScope::~InterruptScope() {
    std::signal(SIGINT, SIG_DFL);
    std::signal(SIGTERM, SIG_DFL);
}

bool interrupted() { return signalled != 0; }

}  // namespace robochart::app
