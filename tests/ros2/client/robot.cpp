// SPDX-License-Identifier: Apache-2.0
#include "robot.hpp"

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <stdexcept>

#include <ament_index_cpp/get_package_prefix.hpp>

namespace robochart::ros2_client {
namespace {

std::string program_of(const std::string& package) {
    return ament_index_cpp::get_package_prefix(package) + "/lib/" + package + "/run_" + package;
}

std::vector<std::string> command_of(const std::string& program, const std::vector<std::string>& parameters) {
    std::vector<std::string> words{program, "--ros-args"};
    for (const std::string& parameter : parameters) {
        words.push_back("-p");
        words.push_back(parameter);
    }
    return words;
}

template <class Service>
typename Service::Response call(rclcpp::Client<Service>& client, const typename Service::Request& request) {
    using namespace std::chrono_literals;
    if (!client.wait_for_service(10s)) throw std::runtime_error(std::string("no service ") + client.get_service_name());
    const auto answer = client.async_send_request(std::make_shared<typename Service::Request>(request)).future.share();
    if (answer.wait_for(10s) != std::future_status::ready)
        throw std::runtime_error(std::string("no answer of ") + client.get_service_name());
    return *answer.get();
}

}  // namespace

bool wait_until(const std::function<bool()>& condition, std::chrono::milliseconds limit) {
    const auto end = std::chrono::steady_clock::now() + limit;
    while (!condition()) {
        if (std::chrono::steady_clock::now() > end) return false;
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    return true;
}

Process::Process(const std::vector<std::string>& words) : id_(fork()) {
    if (id_ != 0) return;
    std::vector<char*> arguments;
    for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    execv(arguments[0], arguments.data());
    _exit(127);
}

Process::~Process() {
    if (id_ > 0) end(SIGINT);
}

int Process::end(int signal) {
    kill(id_, signal);
    int status = 0;
    waitpid(id_, &status, 0);
    id_ = 0;
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

Robot::Robot(const std::string& node, const std::vector<std::string>& parameters, const std::string& program)
    : process_(command_of(program.empty() ? program_of(node) : program, parameters)),
      client_(std::make_shared<rclcpp::Node>("client")),
      change_(client_->create_client<lifecycle_msgs::srv::ChangeState>("/" + node + "/change_state")),
      state_(client_->create_client<lifecycle_msgs::srv::GetState>("/" + node + "/get_state")) {
    executor_.add_node(client_);
    thread_ = std::thread([this] { executor_.spin(); });
}

Robot::~Robot() {
    executor_.cancel();
    thread_.join();
}

bool Robot::change(std::uint8_t transition) {
    lifecycle_msgs::srv::ChangeState::Request request;
    request.transition.id = transition;
    return call(*change_, request).success;
}

std::string Robot::state() {
    return call(*state_, lifecycle_msgs::srv::GetState::Request()).current_state.label;
}

}  // namespace robochart::ros2_client
