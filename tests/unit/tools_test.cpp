// What holds for every tool of the table, and for every kind of dab.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "app/core/app_parameters.h"
#include "app/core/icon.h"
#include "app/tools/tools.h"
#include "sim/error.h"
#include "sim/journal.h"
#include "sim/passes/dab.h"

namespace talus::tools_test {
namespace {

TEST(Tools, NameOnlyDeclaredParametersAndKeepTheirOwnInTheirSection) {
    const Parameters declared(app::all_parameters());
    for (const app::Tool& tool : app::tools()) {
        for (const std::string& name : tool.settings) EXPECT_NO_THROW(declared.value(name)) << tool.name;
        if (!tool.strength.empty()) {
            EXPECT_NE(std::find(tool.settings.begin(), tool.settings.end(), tool.strength),
                      tool.settings.end())
                << tool.name << ": the keys - and = change what its panel shows";
        }
        for (const Parameter& own : tool.parameters) {
            EXPECT_TRUE(own.name.starts_with(tool.name + ".")) << own.name;
            EXPECT_NO_THROW(declared.value(own.name)) << own.name;
        }
        EXPECT_FALSE(tool.how_to.empty()) << tool.name;
    }
}

TEST(Tools, HaveIconsThatDiffer) {
    std::set<std::string> seen;
    for (const app::Tool& tool : app::tools()) {
        ASSERT_FALSE(tool.icon.empty()) << tool.name;
        EXPECT_TRUE(seen.insert(tool.icon).second) << tool.name << " looks like another one";
        for (const std::vector<glm::vec2>& line : app::icon_lines(tool.icon))
            for (const glm::vec2& point : line) {
                EXPECT_TRUE(point.x >= 0 && point.x <= app::icon_side && point.y >= 0 &&
                            point.y <= app::icon_side)
                    << tool.name << ": " << point.x << "," << point.y;
            }
    }
    for (const char* wrong : {"1,2", "1,2 3", "1;2", "1,2 3,4; 5", "a,b c,d"})
        EXPECT_THROW(static_cast<void>(app::icon_lines(wrong)), Error) << wrong;
}

// Moves every field off its default, within its limits.
struct Vary {
    int salt = 0;
    template <typename Number>
    void operator()(const char*, Number& value, double low, double high) {
        value = static_cast<Number>(std::max(low, std::min(high, 2.0 + 0.25 * ++salt)));
    }
    void operator()(const char*, glm::dvec2& pair, double, double) { pair = {3.5, 4.25}; }
    void operator()(const char*, std::vector<glm::dvec3>& points, double, double) {
        points = {{1, 2, 3}, {4, 5.5, 6}, {7, 8, -9}};
    }
    template <typename Choice>
    void operator()(const char*, Choice& choice, const std::vector<std::string>& names) {
        choice = static_cast<Choice>(names.size() - 1);
    }
    void operator()(const char*, bool& on) { on = !on; }
};

TEST(Dab, ComesBackFromAJournalWithEveryFieldOfEveryMode) {
    for (std::size_t mode = 0; mode < brush_mode_names().size(); ++mode) {
        Dab dab;
        dab.effect = effect_of(static_cast<BrushMode>(mode));
        visit_footprint(dab, Vary());
        visit_own(dab, Vary());
        dab.falloff = dab.blend = 0.5;
        ASSERT_NO_THROW(check_dab(dab)) << brush_mode_names()[mode];
        Journal journal;
        journal.record(dab);
        const JournalFile read = read_journal(write_journal({}, journal), "a journal");
        ASSERT_EQ(read.operations.size(), 1U);
        EXPECT_EQ(std::get<Dab>(read.operations.front()), dab) << brush_mode_names()[mode];
    }
}

TEST(Dab, RefusesAFieldBeyondItsLimitsByItsName) {
    Dab dab;
    dab.effect = TerraceDab{.step_m = 0};
    try {
        check_dab(dab);
        FAIL() << "a terrace without a step";
    } catch (const Error& error) {
        EXPECT_STREQ(error.what(), "a dab's step_m cannot be 0, it must be 0.001 to 1000000");
    }
}

TEST(Dab, OfAnOlderJournalIsRead) {
    const std::string start = R"({"talus_journal":1,"input":"","import":"{}","parameters":"","hash":"00"})";
    const std::string dab =
        R"({"op":"dab","mode":"stamp","x_m":1,"y_m":2,"radius_m":3,"falloff":1,"amount_m":4,"blend":1,"target_m":0,)"
        R"("on_regolith":true,"stamp":{"mode":"add","half_m":[1,1],"turn_deg":0,"mirrored":false}})";
    const JournalFile read = read_journal(start + "\n" + dab + "\n", "a journal");
    const Dab& old = std::get<Dab>(read.operations.front());
    EXPECT_EQ(old.material, Material::regolith);
    EXPECT_EQ(old.curve, FalloffCurve::smooth);
    EXPECT_FALSE(old.masked);
    EXPECT_EQ(old.as<StampDab>()->zero, 0);
    EXPECT_THROW(read_journal(start + "\n" + R"({"op":"dab","mode":"raise","x_m":1})" + "\n", "a journal"),
                 Error);
}

}  // namespace
}  // namespace talus::tools_test
