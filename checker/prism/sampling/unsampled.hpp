// Why a question is not answered by samples.
#pragma once

#include <stdexcept>

namespace robochart::prism {

/// The message says why.
class Unsampled : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

}  // namespace robochart::prism
