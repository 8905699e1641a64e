// Models that are nearly well-formed: an element is missing, stands twice or elsewhere, a name is another's, a rule is
// broken. For the parts behind the front end, which have to take or to refuse what comes through it.
#pragma once

#include "tests/random_models/models/project.hpp"
#include "tests/random_models/models/random.hpp"

namespace robochart::random_models {

/// The project with one to three such changes. Most results are refused by the front end; some are not.
[[nodiscard]] Project nearly(const Project& project, Random& random);

}  // namespace robochart::random_models
