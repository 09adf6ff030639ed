#pragma once
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <utility>
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

    /// Books a stage. `bind` binds all but the sections' lists. `conveyance`: the inflow differs along an
    /// edge.
    void count(int order, bool conveyance, const std::function<void(gpu::Program&)>& bind);

    /// What passed each face of each section so far, doubles, as it is now; none: there is no section.
    std::optional<gpu::Buffer> copy_of_words() const;
    /// Of such words, what passed each section, m³: to the right of its line as positive; of none, nothing.
    std::vector<double> volumes_m3(const Grid& grid, std::span<const double> words) const;
    /// One a section, so that undo takes back what it counted, whatever became of the others. They add
    /// nothing to the ledger.
    std::vector<Book> books();

  private:
    struct Counted {
        Section section;
        std::vector<SectionFace> faces;
        std::string name;  // of its book
        gpu::Buffer list;
        gpu::Buffer book;
    };
    gpu::Program& program(int order, bool conveyance);
    static Counted begun(const Grid& grid, const Section& section, const std::string& name);

    std::vector<Counted> counted_;
    std::map<std::pair<int, bool>, gpu::Program> programs_;  // by order and conveyance
};

}  // namespace talus
