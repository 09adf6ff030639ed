#pragma once
#include <stdexcept>
#include <string>

namespace talus {

/// What goes wrong for a reason that the user can mend. The text is one sentence that names the file or the
/// parameter, what is wrong with it and what would be right.
class Error : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

}  // namespace talus
