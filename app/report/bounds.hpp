// Bounds of the finite instantiation that were reached while assertions were checked: once for each expression and
// element.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "app/command/pipeline.hpp"
#include "app/report/report.hpp"
#include "checker/cspm/syntax/observed_call.hpp"

namespace robochart::app {

/// Listens to the evaluation of one script.
class BoundWatch {
public:
    BoundWatch(const Project& project, const csp_emit::Emission& emission, csp_emit::Time time,
               std::vector<BoundReport>& report);

    [[nodiscard]] cspm::CallObserver observer();

private:
    void note(const cspm::ObservedCall& call);

    const Project& project_;
    const csp_emit::Emission& emission_;
    std::string time_;
    std::vector<BoundReport>& report_;
    std::map<std::pair<std::string, std::uint64_t>, bool> known_;
};

}  // namespace robochart::app
