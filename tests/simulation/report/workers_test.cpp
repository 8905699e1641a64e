// SPDX-License-Identifier: Apache-2.0
// Tests that an exception in a worker ends the run with its cause.
#include <gtest/gtest.h>

#include <new>

#include "simulation/report/run.hpp"

namespace robochart::simulation {
namespace {

TEST(Workers, WhatOneThrowsReachesTheCaller) {
    Scenario scenario;
    scenario.trials = 8;
    Plan plan;
    plan.scenario = &scenario;
    RunOptions options;
    options.threads = 2;
    options.stage = [](const Scenario&, std::uint32_t trial, diagnostics::Diagnostics&) -> std::unique_ptr<Stage> {
        if (trial == 0) throw std::bad_alloc();
        return nullptr;
    };
    diagnostics::Diagnostics diagnostics;
    EXPECT_THROW((void)run_trials(plan, Drives({}, nullptr), options, diagnostics), std::bad_alloc);
}

}  // namespace
}  // namespace robochart::simulation
