// SPDX-License-Identifier: Apache-2.0
// Tests the micro-ROS node of docs/ros2.md with stub headers of rclc: it behaves like the model, and it compiles for a
// Cortex-M4 without a heap, exceptions, run-time type information and constructors before main.
#include <gtest/gtest.h>

#include <fstream>

#include "tests/contents.hpp"
#include "tests/cpp_emit/harness.hpp"
#include "tests/cpp_emit/models.hpp"
#include "tests/needed.hpp"
#include "tests/source_folder.hpp"

namespace robochart::cpp_emit::micro_ros_test {
namespace {

class MicroRos : public ::testing::Test {
protected:
    void SetUp() override {
        folder_.run(sources_ + "/tests/packaging/extract.sh " + sources_ + "/docs/ros2.md page");
        const ir::System system =
            testing::load_model(tests::read_contents(folder_.path() + "/page/roam.rct"), "roam.rct");
        ir::InstantiationOptions values;
        values.constants["SPEED"] = "0.3";
        folder_.write(testing::emit_ok(system, testing::component_named(system, "Roam"), {}, values));
    }

    const std::string sources_ = tests::source_folder().string();
    const std::string flags_ = " -std=c++17 -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror -I. -I" + sources_ +
                               "/tests/cpp_emit/rclc_stub ";
    testing::Folder folder_;
};

/// The functions of rclc for one node. rclc_executor_spin() plays the world.
const char* const board = R"(#include <cmath>
#include <cstdio>
#include <rclc/executor.h>
#include <rclc/rclc.h>
#include <geometry_msgs/msg/twist.h>
#include <sensor_msgs/msg/range.h>
#include <std_msgs/msg/empty.h>
rcl_timer_callback_t cycle;
rclc_subscription_callback_t take[2];
int taken = 0;
bool works = true;
extern "C" {
bool run_robot(void);
rcl_allocator_t rcl_get_default_allocator() { return {}; }
rcl_node_t rcl_get_zero_initialized_node() { return {}; }
rcl_publisher_t rcl_get_zero_initialized_publisher() { return {}; }
rcl_subscription_t rcl_get_zero_initialized_subscription() { return {}; }
rcl_timer_t rcl_get_zero_initialized_timer() { return {}; }
rclc_executor_t rclc_executor_get_zero_initialized_executor() { return {}; }
rcl_ret_t rcl_publish(const rcl_publisher_t*, const void* message, rmw_publisher_allocation_t*) {
    const auto* twist = static_cast<const geometry_msgs__msg__Twist*>(message);
    std::printf("%.1f %.1f\n", twist->linear.x, twist->angular.z);
    return 0;
}
rcl_ret_t rcl_timer_cancel(rcl_timer_t*) { std::puts("end"); return 0; }
rcl_ret_t rclc_support_init(rclc_support_t*, int, char const* const*, rcl_allocator_t*) { return 0; }
rcl_ret_t rclc_node_init_default(rcl_node_t*, const char*, const char*, rclc_support_t*) { return 0; }
rcl_ret_t rclc_publisher_init_default(rcl_publisher_t*, const rcl_node_t*, const rosidl_message_type_support_t*,
                                      const char*) { return works ? 0 : 1; }
rcl_ret_t rclc_subscription_init_default(rcl_subscription_t*, rcl_node_t*, const rosidl_message_type_support_t*,
                                         const char*) { return 0; }
rcl_ret_t rclc_subscription_init_best_effort(rcl_subscription_t*, rcl_node_t*, const rosidl_message_type_support_t*,
                                             const char*) { return 0; }
rcl_ret_t rclc_timer_init_default(rcl_timer_t*, rclc_support_t*, uint64_t period, rcl_timer_callback_t callback) {
    std::printf("%d ms\n", static_cast<int>(period / 1000000));
    cycle = callback;
    return 0;
}
rcl_ret_t rclc_executor_init(rclc_executor_t*, rcl_context_t*, size_t, const rcl_allocator_t*) { return 0; }
rcl_ret_t rclc_executor_add_subscription(rclc_executor_t*, rcl_subscription_t*, void*,
                                         rclc_subscription_callback_t callback, rclc_executor_handle_invocation_t) {
    take[taken++] = callback;
    return 0;
}
rcl_ret_t rclc_executor_add_timer(rclc_executor_t*, rcl_timer_t*) { return 0; }
const rosidl_message_type_support_t* rosidl_typesupport_c__get_message_type_support_handle__std_msgs__msg__Empty() { return nullptr; }
const rosidl_message_type_support_t* rosidl_typesupport_c__get_message_type_support_handle__sensor_msgs__msg__Range() { return nullptr; }
const rosidl_message_type_support_t* rosidl_typesupport_c__get_message_type_support_handle__geometry_msgs__msg__Twist() { return nullptr; }
}
void range(float distance) {
    sensor_msgs__msg__Range message = {};
    message.range = distance;
    take[0](&message);
}
rcl_ret_t rclc_executor_spin(rclc_executor_t*) {
    rcl_timer_t timer{};
    const auto run = [&] { cycle(&timer, 0); std::puts("cycle"); };
    run();
    range(2);
    run();
    range(INFINITY);
    range(NAN);
    run();
    range(0.25F);
    run();
    run();
    std_msgs__msg__Empty empty = {};
    take[1](&empty);
    run();
    return 0;
}
int main() {
    const bool ran = run_robot();
    works = false;
    return ran && !run_robot() ? 0 : 1;
}
)";

TEST_F(MicroRos, TheNodeBehavesLikeTheModel) {
    std::ofstream(folder_.path() + "/board.cpp") << board;
    folder_.run("c++" + flags_ + "page/roam_node.cpp board.cpp -o board");
    EXPECT_EQ(folder_.run("./board"), "100 ms\n0.3 0.0\ncycle\ncycle\ncycle\n0.0 0.0\ncycle\ncycle\n0.3 0.0\ncycle\n");
}

TEST_F(MicroRos, TheNodeCompilesForACortexM4) {
    std::string ignored;
    ROBOCHART_NEEDS(
        folder_.status("echo '#include <cstdint>' | arm-none-eabi-g++ -x c++ -fsyntax-only -", ignored) == 0,
        "arm-none-eabi-g++ (Debian: gcc-arm-none-eabi libstdc++-arm-none-eabi-dev libnewlib-dev)");
    folder_.run(
        "arm-none-eabi-g++ -mcpu=cortex-m4 -mthumb -mfloat-abi=hard -mfpu=fpv4-sp-d16 -Os -fno-exceptions -fno-rtti" +
        flags_ + "-c page/roam_node.cpp -o node.o");
    EXPECT_EQ(folder_.run("arm-none-eabi-nm -u node.o | grep -vE ' "
                          "(rcl_|rclc_|rosidl_typesupport_c_|__aeabi_f2d$|mem(set|cpy)$)' || true"),
              "");
    EXPECT_EQ(folder_.run("arm-none-eabi-nm node.o | grep -E ' (_GLOBAL__|__cxa_|_Znw|_Zdl)' || true"), "");
}

}  // namespace
}  // namespace robochart::cpp_emit::micro_ros_test
