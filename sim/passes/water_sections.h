#pragma once
#include <list>
#include <map>
#include <string>
#include <vector>

#include "sim/gpu/buffer.h"
#include "sim/gpu/program.h"
#include "sim/terrain/section.h"
#include "sim/terrain/terrain.h"

namespace talus {

/// Counts the water that passes sections while it moves. What it counts is what the stages move over their
/// faces, in double, and goes back with undo. It changes nothing in the water.
class WaterSections {
  public:
    /// From now on these. One that was there goes on counting, others begin with nothing.
    void follow(const Grid& grid, const std::vector<Section>& sections);

    /// Within a stage, before it runs: water_in is what it reads. `bind` binds the water's own buffers.
    template <typename Bind>
    void count(int order, const gpu::Texture& water_in, const gpu::Texture& bed, Bind&& bind) {
        for (Counted& one : counted_) {
            gpu::Program& program = program_of(order);
            program.bind_image("water_in", water_in);
            program.bind_image("bed_in", bed);
            program.bind_storage("SectionFaces", one.faces);
            program.bind_storage("SectionBook", one.book);
            program.set("face_count", static_cast<int>(one.list.size()));
            bind(program);
            program.dispatch((static_cast<int>(one.list.size()) + 63) / 64);
        }
    }

    /// What passed each so far, m³, by its book: to the right of its line as positive. Waits for the device.
    std::vector<double> volumes_m3(const Grid& grid) const;
    /// They add nothing to the ledger, and undo takes them back.
    std::vector<Book> books();
    bool empty() const { return counted_.empty(); }

  private:
    struct Counted {
        Section section;
        std::vector<SectionFace> list;
        std::string name;
        gpu::Buffer faces;
        gpu::Buffer book;
    };
    gpu::Program& program_of(int order);

    std::list<Counted> counted_;  // a book's buffer stays where it is
    int begun_ = 0;
    std::map<int, gpu::Program> programs_;  // by order
};

}  // namespace talus
