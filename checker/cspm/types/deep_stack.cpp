// SPDX-License-Identifier: Apache-2.0
#include "checker/cspm/types/deep_stack.hpp"

#include <sys/mman.h>
#include <ucontext.h>

#include <exception>
#include <memory>
#include <new>
#include <utility>

#if defined(__SANITIZE_ADDRESS__)
#define CSPM_FIBER_ANNOTATIONS 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define CSPM_FIBER_ANNOTATIONS 1
#endif
#endif
#ifdef CSPM_FIBER_ANNOTATIONS
#include <sanitizer/common_interface_defs.h>
#endif

namespace robochart::cspm {

namespace {

// A separate stack for a thread. It is mapped on first use and never unmapped. A page takes memory only after it has
// been accessed.
class Stack {
public:
    Stack()
        : memory_(mmap(nullptr, deep_stack_bytes, PROT_READ | PROT_WRITE,
                       MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE | MAP_STACK, -1, 0)) {
        if (memory_ == MAP_FAILED) throw std::bad_alloc();
    }
    ~Stack() { munmap(memory_, deep_stack_bytes); }
    Stack(const Stack&) = delete;
    Stack& operator=(const Stack&) = delete;

    [[nodiscard]] void* memory() const { return memory_; }

    bool active = false;
    const std::function<void()>* work = nullptr;
    std::exception_ptr error;
    ucontext_t outside{};
    ucontext_t inside{};

private:
    void* memory_;
};

Stack& thread_stack() {
    thread_local std::unique_ptr<Stack> stack;
    if (!stack) stack = std::make_unique<Stack>();
    return *stack;
}

void body() {
    Stack& stack = thread_stack();
#ifdef CSPM_FIBER_ANNOTATIONS
    const void* bottom = nullptr;
    std::size_t size = 0;
    __sanitizer_finish_switch_fiber(nullptr, &bottom, &size);
#endif
    try {
        (*stack.work)();
    } catch (...) {
        stack.error = std::current_exception();
    }
#ifdef CSPM_FIBER_ANNOTATIONS
    __sanitizer_start_switch_fiber(nullptr, bottom, size);
#endif
}

}  // namespace

void on_deep_stack(const std::function<void()>& work) {
    Stack& stack = thread_stack();
    if (stack.active) return work();
    stack.active = true;
    stack.work = &work;
    stack.error = nullptr;
    getcontext(&stack.inside);
    stack.inside.uc_stack.ss_sp = stack.memory();
    stack.inside.uc_stack.ss_size = deep_stack_bytes;
    stack.inside.uc_link = &stack.outside;
    makecontext(&stack.inside, body, 0);
#ifdef CSPM_FIBER_ANNOTATIONS
    void* fake = nullptr;
    __sanitizer_start_switch_fiber(&fake, stack.memory(), deep_stack_bytes);
#endif
    swapcontext(&stack.outside, &stack.inside);
#ifdef CSPM_FIBER_ANNOTATIONS
    __sanitizer_finish_switch_fiber(fake, nullptr, nullptr);
#endif
    stack.active = false;
    if (stack.error) std::rethrow_exception(std::exchange(stack.error, nullptr));
}

}  // namespace robochart::cspm
