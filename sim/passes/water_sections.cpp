#include "sim/passes/water_sections.h"

#include <algorithm>
#include <utility>

namespace talus {

void WaterSections::follow(const Grid& grid, const std::vector<Section>& sections) {
    for (const Section& section : sections) check_section(grid, section);
    std::list<Counted> next;
    for (const Section& section : sections) {
        const auto same = std::find_if(counted_.begin(), counted_.end(),
                                       [&](const Counted& one) { return one.section == section; });
        if (same != counted_.end()) {
            next.splice(next.end(), counted_, same);
            continue;
        }
        std::vector<SectionFace> list = faces_of(grid, section);
        std::vector<glm::ivec4> words;
        words.reserve(list.size());
        for (const SectionFace& face : list) words.emplace_back(face.at, face.is_row ? 1 : 0, 0);
        gpu::Buffer faces("section faces", words.size() * sizeof(glm::ivec4));
        faces.write_all(words);
        gpu::Buffer book("section book", words.size() * sizeof(double));
        book.fill(0);
        next.push_back({section, std::move(list), "water section " + std::to_string(++begun_),
                        std::move(faces), std::move(book)});
    }
    counted_ = std::move(next);
}

std::vector<double> WaterSections::volumes_m3(const Grid& grid) const {
    std::vector<double> volumes;
    volumes.reserve(counted_.size());
    for (const Counted& one : counted_) {
        const std::vector<double> over_faces = one.book.read_all<double>();
        double sum_m3 = 0;
        for (std::size_t i = 0; i < over_faces.size(); ++i)
            sum_m3 += over_faces[i] * one.list[i].sign * (one.list[i].is_row ? grid.dx : grid.dy);
        volumes.push_back(sum_m3);
    }
    return volumes;
}

std::vector<Book> WaterSections::books() {
    std::vector<Book> books;
    for (Counted& one : counted_)
        books.push_back(
            {one.name, &one.book, [](const gpu::Buffer&, const Grid&, const SolidWeights&, BudgetTerms&) {}});
    return books;
}

gpu::Program& WaterSections::program_of(int order) {
    auto found = programs_.find(order);
    if (found == programs_.end())
        found =
            programs_
                .emplace(order, gpu::Program({"sim/water_sections.comp"}, {"ORDER " + std::to_string(order)}))
                .first;
    return found->second;
}

}  // namespace talus
