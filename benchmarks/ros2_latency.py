#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Measures the time from a message to the reaction of a ROS 2 node, with the timer and with immediate dispatch.

Usage: benchmarks/ros2_latency.py ROBOCHART_VERIFY [MESSAGES]

The nodes are compiled with the stub headers of the tests, so the time of the network and of the executor is not
included. The program calls the timer's function at multiples of 10 ms of real time, and sends messages at random times
in between."""

import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
STUB = ROOT / "tests/cpp_emit/ros2_stub/include"

MODEL = """package latency
interface Acts { go() halt() }
interface Ins { event clear event obstacle }
stm M { requires Acts uses Ins initial i
    state Driving { entry go() }
    state Held { entry halt() }
    transition t0 { from i to Driving }
    transition t1 { from Driving to Held trigger obstacle }
    transition t2 { from Held to Driving trigger clear } }
"""

PROGRAM = """#include "M_node.hpp"
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <thread>
using Clock = std::chrono::steady_clock;
int main(int, char** words) {
    using namespace std::chrono_literals;
    rclcpp::Network& network = rclcpp::Network::get();
    latency::MNode node;
    if (node.configure().label() != "inactive" || node.activate().label() != "active") return 1;
    network.tick();
    const auto count = [&] {
        return network.published["/m/out/go"].size() + network.published["/m/out/halt"].size();
    };
    std::mt19937 random(1);
    std::uniform_int_distribution<int> offset(0, 9999);
    std::vector<double> times;
    for (int i = 0; i < std::atoi(words[1]); ++i) {
        const auto begin = Clock::now();
        std::this_thread::sleep_until(begin + std::chrono::microseconds(offset(random)));
        const std::size_t before = count();
        const auto sent = Clock::now();
        network.send(i % 2 == 0 ? "/m/in/obstacle" : "/m/in/clear", std_msgs::msg::Empty{});
        if (count() == before) {
            std::this_thread::sleep_until(begin + 10ms);
            network.tick();
        }
        if (count() == before) return 2;
        times.push_back(std::chrono::duration<double, std::milli>(Clock::now() - sent).count());
        std::this_thread::sleep_until(begin + 10ms);
        network.tick();
    }
    std::sort(times.begin(), times.end());
    std::printf("median %.4f ms, 95 %% %.4f ms, most %.4f ms\\n", times[times.size() / 2], times[times.size() * 95 / 100],
                times.back());
}
"""


def measure(command, dispatch, messages):
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        (folder / "m.rct").write_text(MODEL)
        subprocess.run([command, "emit", "cpp", folder / "m.rct", "--target", "ros2", "--dispatch", dispatch, "--quiet",
                        "--out", folder / "out"], check=True, stdout=subprocess.DEVNULL)
        package = folder / "out/ros2/M"
        (package / "drive.cpp").write_text(PROGRAM)
        includes = [STUB, package / "include", *(package / "include").iterdir(), package / "controller"]
        sources = [*(package / "controller").glob("*.cpp"), *(package / "src").glob("*_node.cpp"), package / "drive.cpp"]
        subprocess.run(["c++", "-std=c++17", "-O2", *[f"-I{path}" for path in includes], *sources, "-o",
                        package / "drive"], check=True)
        found = subprocess.run([package / "drive", str(messages)], check=True, stdout=subprocess.PIPE,
                               stderr=subprocess.DEVNULL, text=True)
        print(f"{dispatch:10} {found.stdout}", end="")


def main():
    messages = int(sys.argv[2]) if len(sys.argv) > 2 else 300
    for dispatch in ("timer", "immediate"):
        measure(sys.argv[1], dispatch, messages)


if __name__ == "__main__":
    main()
