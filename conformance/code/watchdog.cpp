// SPDX-License-Identifier: Apache-2.0
// Stops endless calls. A timer of the thread's processor time ticks while code is explored. If the same call is running
// at two consecutive ticks, the signal handler leaves the call with siglongjmp. The state of the watchdog is
// thread-local.
#include "conformance/code/watchdog.hpp"

#include <setjmp.h>
#include <signal.h>
#include <sys/syscall.h>
#include <time.h>
#include <unistd.h>

#include <cstdint>
#include <system_error>

#ifndef sigev_notify_thread_id
#define sigev_notify_thread_id _sigev_un._tid
#endif

namespace robochart::conformance {

namespace {

constexpr int alarm_signal = SIGVTALRM;

/// The call that runs in this thread.
struct Call {
    sigjmp_buf back;
    volatile sig_atomic_t running = 0;
    volatile std::uint64_t number = 0;
    volatile std::uint64_t at_tick = 0;  ///< number of the call that was running at the last tick
};
thread_local Call call;

void on_tick(int) {
    if (call.running == 0) return;
    if (call.at_tick != call.number) {
        call.at_tick = call.number;
        return;
    }
    siglongjmp(call.back, 1);
}

void handle_ticks() {
    struct sigaction action = {};
    action.sa_handler = on_tick;
    // The signal is not blocked during the handler, because the handler does not return when it leaves the call.
    action.sa_flags = SA_RESTART | SA_NODEFER;
    if (sigaction(alarm_signal, &action, nullptr) != 0)
        throw std::system_error(errno, std::generic_category(), "no watchdog");
}

/// Makes the timer tick for one thread during its lifetime.
class Ticks {
public:
    Ticks() {
        static const bool handled = (handle_ticks(), true);
        (void)handled;
        struct sigevent event = {};
        event.sigev_notify = SIGEV_THREAD_ID;
        event.sigev_signo = alarm_signal;
        event.sigev_notify_thread_id = static_cast<pid_t>(syscall(SYS_gettid));
        if (timer_create(CLOCK_THREAD_CPUTIME_ID, &event, &timer_) != 0)
            throw std::system_error(errno, std::generic_category(), "no watchdog");
        start_timer(patience_);
    }
    void set_patience(Patience patience) {
        if (patience != patience_) start_timer(patience);
    }
    ~Ticks() { timer_delete(timer_); }
    Ticks(const Ticks&) = delete;
    Ticks& operator=(const Ticks&) = delete;

private:
    /// Starts the timer. A call is stopped at its second tick.
    void start_timer(Patience patience) {
        const struct timespec between = patience == Patience::seconds ? timespec{1, 0} : timespec{0, 10'000'000};
        const struct itimerspec both = {between, between};
        timer_settime(timer_, 0, &both, nullptr);
        patience_ = patience;
    }

    timer_t timer_{};
    Patience patience_ = Patience::seconds;
};

/// Calls the code. This is a separate function, so that no variable of the caller is in a register across the jump.
[[gnu::noinline]] bool call_returns(Guarded guarded, void* arguments, rc_result& result) {
    if (sigsetjmp(call.back, 0) != 0) {
        call.running = 0;
        return false;
    }
    call.number = call.number + 1;
    call.running = 1;
    result = guarded(arguments);
    call.running = 0;
    return true;
}

struct StepArguments {
    const rc_interface* code;
    void* state;
    const rc_register* registers;
    rc_log* log;
};

rc_result run_code_step(void* arguments) {
    const auto* with = static_cast<const StepArguments*>(arguments);
    return with->code->step(with->state, with->registers, with->log);
}

}  // namespace

Stepped call_watched(Guarded guarded, void* arguments, Patience patience) {
    thread_local Ticks ticks;
    ticks.set_patience(patience);
    rc_result result = RC_STEP_BOUND;
    if (call_returns(guarded, arguments, result)) return {result, false};
    return {RC_STEP_BOUND, true};
}

Stepped step_watched(const rc_interface& code, void* state, const rc_register* registers, rc_log* log,
                     Patience patience) {
    StepArguments arguments{&code, state, registers, log};
    return call_watched(run_code_step, &arguments, patience);
}

}  // namespace robochart::conformance
