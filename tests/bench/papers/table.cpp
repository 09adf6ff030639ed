#include "tests/bench/papers/table.h"

#include <fmt/format.h>

namespace talus::bench {

Table::Table(const std::string& name, const std::string& columns)
    : file_(fmt::output_file("out/papers/" + name + ".csv")) {
    fmt::print("\n{}\n{}\n", name, columns);
    file_.print("{}\n", columns);
}

void Table::row(const std::string& line) {
    fmt::print("{}\n", line);
    std::fflush(stdout);
    file_.print("{}\n", line);
    file_.flush();
}

}  // namespace talus::bench
