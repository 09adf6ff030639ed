#include "sim/passes/water_sections.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace talus {

void WaterSections::follow(const Grid& grid, const std::vector<Section>& sections) {
    for (const Section& section : sections) check_section(grid, section);
    const std::vector<double> before = lists_ ? lists_->book.read_all<double>() : std::vector<double>();
    std::vector<Counted> counted;
    counted.reserve(sections.size());
    std::vector<SectionFace> faces;
    std::vector<double> passed;
    std::string name = "water sections";
    for (const Section& section : sections) {
        const std::vector<SectionFace> list = faces_of(grid, section);
        counted.push_back({section, faces.size(), list.size()});
        faces.insert(faces.end(), list.begin(), list.end());
        const auto same = std::find_if(counted_.begin(), counted_.end(),
                                       [&](const Counted& one) { return one.section == section; });
        passed.resize(faces.size(), 0);
        if (same != counted_.end())
            std::copy_n(before.begin() + static_cast<std::ptrdiff_t>(same->first), same->count,
                        passed.begin() + static_cast<std::ptrdiff_t>(counted.back().first));
        name += fmt::format(" {},{},{},{}:{}", section.from_m.x, section.from_m.y, section.to_m.x,
                            section.to_m.y, list.size());
    }
    counted_ = std::move(counted);
    faces_ = std::move(faces);
    lists_.reset();
    if (faces_.empty()) return;
    std::vector<glm::ivec4> words;
    words.reserve(faces_.size());
    for (const SectionFace& face : faces_) words.emplace_back(face.at, face.is_row ? 1 : 0, 0);
    lists_.emplace(Lists{name, gpu::Buffer("section faces", words.size() * sizeof(glm::ivec4)),
                         gpu::Buffer("section book", passed.size() * sizeof(double))});
    lists_->faces.write_all(words);
    lists_->book.write_all(passed);
}

gpu::Program* WaterSections::program(int order) {
    if (!lists_) return nullptr;
    auto found = programs_.find(order);
    if (found == programs_.end())
        found =
            programs_
                .emplace(order, gpu::Program({"sim/water_sections.comp"}, {"ORDER " + std::to_string(order)}))
                .first;
    gpu::Program& program = found->second;
    program.bind_storage("SectionFaces", lists_->faces);
    program.bind_storage("SectionBook", lists_->book);
    program.set("face_count", static_cast<int>(faces_.size()));
    return &program;
}

std::vector<double> WaterSections::volumes_m3(const Grid& grid) const {
    std::vector<double> volumes;
    volumes.reserve(counted_.size());
    const std::vector<double> over_faces = lists_ ? lists_->book.read_all<double>() : std::vector<double>();
    for (const Counted& one : counted_) {
        double sum_m3 = 0;
        for (std::size_t i = one.first; i < one.first + one.count; ++i)
            sum_m3 += over_faces[i] * faces_[i].sign * (faces_[i].is_row ? grid.dx : grid.dy);
        volumes.push_back(sum_m3);
    }
    return volumes;
}

std::vector<Book> WaterSections::books() {
    if (!lists_) return {};
    return {{lists_->name, &lists_->book,
             [](const gpu::Buffer&, const Grid&, const SolidWeights&, BudgetTerms&) {}}};
}

}  // namespace talus
