#pragma once
#include <fmt/os.h>

#include <string>

namespace talus::bench {

/// A table as a file out/papers/NAME.csv, and on the terminal.
class Table {
  public:
    Table(const std::string& name, const std::string& columns);
    void row(const std::string& line);

  private:
    fmt::ostream file_;
};

}  // namespace talus::bench
