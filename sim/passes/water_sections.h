#pragma once
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "sim/budget.h"
#include "sim/gpu/buffer.h"
#include "sim/gpu/program.h"
#include "sim/terrain/section.h"

namespace talus {

/// Counts the water that passes sections while it moves. What it counts is what the stages move over their
/// faces, in double, and goes back with undo. It changes nothing in the water.
class WaterSections {
  public:
    /// From now on these. One that was there goes on counting, others begin with nothing. Waits for the
    /// device. Throws talus::Error where one lies off the map, and goes on with those before then.
    void follow(const Grid& grid, const std::vector<Section>& sections);

    /// The program that books a stage, with the lists bound: run it for groups() of 64. None: there is no
    /// section.
    gpu::Program* program(int order);
    int groups() const { return (static_cast<int>(faces_.size()) + 63) / 64; }

    /// What passed each so far, m³: to the right of its line as positive. Waits for the device.
    std::vector<double> volumes_m3(const Grid& grid) const;
    /// It adds nothing to the ledger, and undo takes it back.
    std::vector<Book> books();

  private:
    struct Counted {
        Section section;
        std::size_t first = 0;  ///< of its faces
        std::size_t count = 0;
    };

    std::vector<Counted> counted_;
    std::vector<SectionFace> faces_;  // of all, one section's behind the other's
    struct Lists {
        std::string name;  // tells these sections from others: undo knows the book by it
        gpu::Buffer faces;
        gpu::Buffer book;
    };
    std::optional<Lists> lists_;            // none: there is no section
    std::map<int, gpu::Program> programs_;  // by order
};

}  // namespace talus
