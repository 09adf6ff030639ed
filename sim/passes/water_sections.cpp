#include "sim/passes/water_sections.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace talus {

void WaterSections::follow(const Grid& grid, const std::vector<Section>& sections) {
    for (const Section& section : sections) check_section(grid, section);
    std::vector<Counted> next;
    next.reserve(sections.size());
    for (const Section& section : sections) {
        // Two of one line count each, in a book of its own.
        const auto equal = std::count_if(next.begin(), next.end(),
                                         [&](const Counted& one) { return one.section == section; });
        const std::string name = fmt::format("water section {},{},{},{} {}", section.from_m.x,
                                             section.from_m.y, section.to_m.x, section.to_m.y, equal);
        const auto same = std::find_if(counted_.begin(), counted_.end(),
                                       [&](const Counted& one) { return one.name == name; });
        next.push_back(same == counted_.end() ? begun(grid, section, name) : std::move(*same));
        if (same != counted_.end()) counted_.erase(same);
    }
    counted_ = std::move(next);
}

WaterSections::Counted WaterSections::begun(const Grid& grid, const Section& section,
                                            const std::string& name) {
    std::vector<SectionFace> faces = faces_of(grid, section);
    std::vector<glm::ivec4> words;
    words.reserve(faces.size());
    for (const SectionFace& face : faces) words.emplace_back(face.at, face.is_row ? 1 : 0, 0);
    gpu::Buffer list("section faces", words.size() * sizeof(glm::ivec4));
    list.write_all(words);
    gpu::Buffer book("section book", faces.size() * sizeof(double));
    book.fill(0);
    return {section, std::move(faces), name, std::move(list), std::move(book)};
}

gpu::Program& WaterSections::program(int order, bool conveyance) {
    auto found = programs_.find({order, conveyance});
    if (found == programs_.end()) {
        std::vector<std::string> defines = {"ORDER " + std::to_string(order)};
        if (conveyance) defines.emplace_back("CONVEYANCE 1");
        gpu::Program made({"sim/water_sections.comp"}, defines);
        found = programs_.emplace(std::pair(order, conveyance), std::move(made)).first;
    }
    return found->second;
}

void WaterSections::count(int order, bool conveyance, const std::function<void(gpu::Program&)>& bind) {
    for (const Counted& one : counted_) {
        gpu::Program& counting = program(order, conveyance);
        bind(counting);
        counting.bind_storage("SectionFaces", one.list);
        counting.bind_storage("SectionBook", one.book);
        counting.set("face_count", static_cast<int>(one.faces.size()));
        counting.dispatch((static_cast<int>(one.faces.size()) + 63) / 64);
        gpu::barrier({gpu::Use::storage, gpu::Use::buffer_transfer});
    }
}

std::optional<gpu::Buffer> WaterSections::copy_of_words() const {
    std::size_t bytes = 0;
    for (const Counted& one : counted_) bytes += one.book.bytes();
    if (bytes == 0) return std::nullopt;
    gpu::Buffer copy("copy of section books", bytes);
    std::size_t at = 0;
    for (const Counted& one : counted_) {
        copy.copy_part(at, one.book, 0, one.book.bytes());
        at += one.book.bytes();
    }
    return copy;
}

std::vector<double> WaterSections::volumes_m3(const Grid& grid, std::span<const double> words) const {
    std::vector<double> volumes;
    volumes.reserve(counted_.size());
    std::size_t word = 0;
    for (const Counted& one : counted_) {
        double sum_m3 = 0;
        for (const SectionFace& face : one.faces) {
            if (word < words.size()) sum_m3 += words[word] * face.sign * (face.is_row ? grid.dx : grid.dy);
            ++word;
        }
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

}  // namespace talus
