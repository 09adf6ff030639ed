#include "sim/journal.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <sstream>

#include "sim/gpu/error.h"

namespace talus {
namespace {

using nlohmann::json;

constexpr std::array<const char*, 4> mode_names = {"raise", "lower", "smooth", "flatten"};

json to_json(const Operation& operation) {
    if (const auto* ticks = std::get_if<Ticks>(&operation)) return {{"op", "ticks"}, {"count", ticks->count}};
    if (const auto* set = std::get_if<SetParameter>(&operation)) {
        json line = {{"op", "set"}, {"name", set->name}};
        std::visit([&](const auto& v) { line["value"] = v; }, set->value);
        return line;
    }
    if (const auto* spring = std::get_if<PlaceSpring>(&operation))
        return {{"op", "spring"},
                {"x_m", spring->x_m},
                {"y_m", spring->y_m},
                {"rate_m3_per_s", spring->rate_m3_per_s}};
    const auto& dab = std::get<Dab>(operation);
    return {{"op", "dab"},
            {"mode", mode_names[static_cast<std::size_t>(dab.mode)]},
            {"x_m", dab.x_m},
            {"y_m", dab.y_m},
            {"radius_m", dab.radius_m},
            {"falloff", dab.falloff},
            {"amount_m", dab.amount_m},
            {"blend", dab.blend},
            {"target_m", dab.target_m},
            {"material", material_names()[static_cast<std::size_t>(dab.material)]}};
}

Operation to_operation(const json& line) {
    const std::string op = line.at("op");
    if (op == "ticks") {
        const std::int64_t count = line.at("count");
        if (count < 0 || count > 1000000000) throw Error("count must be 0 to 1000000000");
        return Ticks{count};
    }
    if (op == "set") {
        const json& value = line.at("value");
        const std::string name = line.at("name");
        if (value.is_boolean()) return SetParameter{name, value.get<bool>()};
        if (value.is_number()) return SetParameter{name, value.get<double>()};
        return SetParameter{name, value.get<std::string>()};
    }
    if (op == "spring") return PlaceSpring{line.at("x_m"), line.at("y_m"), line.at("rate_m3_per_s")};
    if (op != "dab") throw Error(fmt::format("unknown operation '{}'", op));
    Dab dab;
    const std::string mode = line.at("mode");
    const auto* found = std::find(mode_names.begin(), mode_names.end(), mode);
    if (found == mode_names.end()) throw Error(fmt::format("unknown brush mode '{}'", mode));
    dab.mode = static_cast<BrushMode>(found - mode_names.begin());
    dab.x_m = line.at("x_m");
    dab.y_m = line.at("y_m");
    dab.radius_m = line.at("radius_m");
    dab.falloff = line.at("falloff");
    dab.amount_m = line.at("amount_m");
    dab.blend = line.at("blend");
    dab.target_m = line.at("target_m");
    // Journals of 0.1.0 say on_regolith.
    const bool on_regolith = line.value("on_regolith", false);
    const std::string material = line.value("material", on_regolith ? "regolith" : "bedrock");
    const std::vector<std::string>& materials = material_names();
    const auto of = std::find(materials.begin(), materials.end(), material);
    if (of == materials.end()) throw Error(fmt::format("unknown material '{}'", material));
    dab.material = static_cast<Material>(of - materials.begin());
    check_dab(dab);
    return dab;
}

}  // namespace

void Journal::record(const Operation& operation) {
    if (const auto* ticks = std::get_if<Ticks>(&operation); ticks && !operations_.empty())
        if (auto* last = std::get_if<Ticks>(&operations_.back())) {
            last->count += ticks->count;
            return;
        }
    operations_.push_back(operation);
}

Journal::Mark Journal::mark() const {
    return {operations_.size(), operations_.empty() ? Operation(Ticks{0}) : operations_.back()};
}

std::vector<Operation> Journal::cut(const Mark& mark) {
    // The tail begins with the operation that stood last at the mark, as it is now.
    const auto from = operations_.begin() + static_cast<std::ptrdiff_t>(mark.count > 0 ? mark.count - 1 : 0);
    std::vector<Operation> tail(from, operations_.end());
    operations_.resize(mark.count);
    if (mark.count > 0) operations_.back() = mark.last;
    return tail;
}

void Journal::restore(const Mark& mark, const std::vector<Operation>& tail) {
    operations_.resize(mark.count > 0 ? mark.count - 1 : 0);
    operations_.insert(operations_.end(), tail.begin(), tail.end());
}

std::string write_journal(const JournalStart& start, const Journal& journal) {
    std::string text = json{{"talus_journal", 1},
                            {"input", start.input},
                            {"import", start.import_guess},
                            {"parameters", start.parameters},
                            {"hash", fmt::format("{:016x}", start.hash)}}
                           .dump(-1, ' ', false, json::error_handler_t::replace) +
                       '\n';
    for (const Operation& operation : journal.operations()) text += to_json(operation).dump() + '\n';
    return text;
}

JournalFile read_journal(const std::string& text, const std::string& source) {
    JournalFile file;
    std::istringstream lines(text);
    std::string line;
    for (int at = 1; std::getline(lines, line); ++at) {
        try {
            const json parsed = json::parse(line);
            if (at > 1) {
                file.operations.push_back(to_operation(parsed));
                continue;
            }
            if (parsed.at("talus_journal").get<int>() != 1) throw Error("a journal of another version");
            file.start.input = parsed.at("input");
            file.start.import_guess = parsed.at("import");
            file.start.parameters = parsed.at("parameters");
            file.start.hash = std::stoull(parsed.at("hash").get<std::string>(), nullptr, 16);
        } catch (const std::exception& error) {
            throw Error(
                fmt::format("{}: line {} is not part of a Talus journal: {}", source, at, error.what()));
        }
    }
    if (line.empty() && text.empty())
        throw Error(fmt::format("{}: is empty where a Talus journal was expected", source));
    return file;
}

}  // namespace talus
